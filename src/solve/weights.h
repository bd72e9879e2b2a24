#pragma once

#include <cstddef>

/// What counts how much between candidates that lose equally many constraints. Degrees are in [0, 1]
/// unless said otherwise. Chosen by hand; kept because with them no rate of every fifth row of SceneEval
/// fell by more than a point. What each is worth by itself has not been measured.
namespace roomgen::weights {

// Of a thing that is not at a usual place of its kind (data/arrangements.json).
inline constexpr double relations = 1.0;
inline constexpr double rest = 0.8;
inline constexpr double walkway = 0.15;
inline constexpr double spread = 0.15;
inline constexpr double evenness = 0.3;
inline constexpr double closeness = 0.5;
/// Of the suggested yaw against the suggested centre.
inline constexpr double facing = 0.5;

// Of a metre off a designer's word: two centimetres outweigh any other degree of the poses about it.
inline constexpr double off = 100.0;
/// Ten degrees off what was said are as bad as 0.1 m.
inline constexpr double metres_a_radian = 0.573;

// The soft constraints of a way: the first counts most, so that one more outweighs preferences.
inline constexpr double first_habit = 6.0;
inline constexpr double habit_step = 0.5;
inline constexpr std::size_t most_steps = 6;
/// A partner that has all the company it wants already.
inline constexpr double burden = 4.0;
/// Preferences are dear to tell and never make up for more than this.
inline constexpr double most_preference = 8.0;

// Besides the preferences of its kind, which bring weights of their own.
inline constexpr double reserve_open = 2.4;   ///< the floor that its use will want is open
inline constexpr double reserve_taken = 1.2;  ///< of another's, for each
inline constexpr double crowded = 1.5;        ///< at the same side of the target as its like
inline constexpr double pair_gap = 0.6;       ///< as far from a partner as the pair prefers
inline constexpr double asked_pair_gap = 8.0;
inline constexpr double asked_middle = 4.0;   ///< what is to be in the middle is so by degrees
inline constexpr double askew = 8.0;          ///< a radian between the front and what it is to face
inline constexpr double beyond_opposite = 1.0;  ///< a metre farther than what is opposite
inline constexpr double seat_place = 2.0;     ///< at one of the places that a table has for so many
inline constexpr double over_place = 2.0;     ///< a rug lies as its group wants it
inline constexpr double plan_location = 3.0;  ///< where the plan wants it

}  // namespace roomgen::weights
