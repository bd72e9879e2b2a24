#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brief/placement_phrase.h"
#include "edit_text.h"
#include "references.h"
#include "roomgen/scene/relation.h"

namespace roomgen {

/// What was read, and the token behind it.
template <typename T>
struct Read {
  T value;
  std::size_t end = 0;
};

/// A point on the floor or on a thing.
struct Spot {
  Vec2 position = Vec2::Zero();
  std::string on;         ///< id of what is below, for things that stand on others
  std::string of;         ///< id of the thing by which it is told
  bool is_place = false;  ///< where that thing stands now
};

/// Where words say that something is or shall go.
struct Whereabouts {
  std::vector<Relation> relations;  ///< "next to the bed"
  std::optional<Spot> spot;         ///< instead: "where the lamp is now", "on the left edge of the desk"
  std::size_t end = 0;              ///< token behind it
  std::string room = {};            ///< of a dwelling: "in the bedroom"
};

/// "next to the bed", "against the wall under the window", "in the corner", from `at` on; nothing
/// if no place is named there, an error if it is not clear which. What is placed (`subjects`) is
/// none of the targets.
std::optional<Result<Whereabouts>> destination_at(const EditText& text, std::size_t at,
                                                  const std::vector<std::string>& subjects);

/// The windows or doors that a place may mean: of one wall where it says which.
std::vector<std::string> openings_at_place(const EditText& text, const brief::PlacePhrase& place);
/// What words of place mean, and the token behind them: "under", "to".
std::optional<Read<std::vector<RelationKind>>> placed_by(const EditText& text, std::size_t at);

/// The wall that is nearest to a thing: "wall-2".
std::string nearest_wall(const EditText& text, const Object& object);

/// The wall that lies to a side as the vocabulary counts them: south, east, north, west.
std::optional<std::size_t> wall_to(const Room& room, int side);

/// A part of the room: "the window", "the left wall"; but not where a thing is named before it:
/// "the desks face the window".
std::optional<brief::PlacePhrase> place_named_at(const EditText& text, std::size_t at);

/// A single target of a relation: the id of a thing or a part of the room.
struct Target {
  std::string id;
  std::size_t end = 0;
};
std::optional<Result<Target>> target_at(const EditText& text, std::size_t at, const std::vector<std::string>& subjects);

/// The things that a place is relative to; where their name alone does not decide, words behind it
/// may: "the desk closest to the door".
Result<Read<std::vector<std::string>>> targets_of(const EditText& text, const NamedThing& thing,
                                                  const std::vector<std::string>& subjects);

/// "by 20 cm", "a bit": metres, and `at` behind them.
std::optional<double> amount_at(const EditText& text, std::size_t& at);

/// Instead of an id in Shifting: the wall that is nearest to what moves.
inline constexpr const char* nearest_of_walls = "wall";

/// "30 cm to the left", "a bit away from the window by 0.2 m", of each of the subjects.
struct Shifting {
  std::optional<Vec3> direction;       ///< in the scene's frame, a unit vector
  double forward = 0.0;                ///< 1 to where its front looks, -1 back
  std::vector<std::string> from;       ///< away from these; or nearest_of_walls
  std::vector<std::string> towards;    ///< closer to these
  std::optional<double> metres;
  std::size_t end = 0;
};
std::optional<Result<Shifting>> shifting_at(const EditText& text, std::size_t at,
                                            const std::vector<std::string>& subjects);

/// Places that words tell by the pose of a thing: "where the lamp is now", "in the place of the
/// chair", "the left edge of the desk", "the foot of the bed". `subjects` shall go there; for what
/// stands on the floor the sides of a thing are relations.
std::optional<Result<Whereabouts>> spot_at(const EditText& text, std::size_t at,
                                           const std::vector<std::string>& subjects);

/// A wall that words name, and where on it.
struct NamedWall {
  std::size_t wall = 0;
  std::optional<double> at;
  std::size_t end = 0;
};

/// "in the left wall", "the wall behind the sofa"
std::optional<NamedWall> wall_at(const EditText& text, std::size_t at);
/// "behind the sink", "opposite the door", "with the window", after "the wall"; `may_be_near`: "by
/// the bed" too.
std::optional<NamedWall> wall_by_target(const EditText& text, std::size_t at, bool may_be_near);
/// The one that looks at it.
std::size_t wall_opposite(const Room& room, std::size_t wall);

}  // namespace roomgen
