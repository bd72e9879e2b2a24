#pragma once

#include <functional>
#include <string>
#include <vector>

#include "clause_parts.h"

namespace roomgen {

inline constexpr double usual_lift = 0.2;  ///< metres, where nobody says how far

/// One clause: what it asks for, and what it spoke of.
struct Clause {
  std::vector<edit::Operation> operations;
  Ids about;
  std::vector<Object> coming;  ///< that it adds
  std::size_t end = 0;
  Ids gone = {};               ///< that it removes
  std::string in_place_of = {};  ///< where its one thing goes stands this now
};
using ReadClause = Result<Clause>;

/// That words are not understood, with the words from a token on.
Error what_at(const EditText& text, std::size_t at, const std::string& what);

/// Behind "should be", "would look better", "could maybe go".
std::size_t behind_modals(const EditText& text, std::size_t at);

/// What things are meant there; with words of place behind them only where these tell.
Result<Read<Ids>> things(const EditText& text, std::size_t at, bool with_places);

/// An operation for each of the things.
ReadClause of_each(const Read<Ids>& read, std::size_t end,
                   const std::function<edit::Operation(const std::string&)>& make);

/// Whether nothing is left behind the clause but words that end one.
bool goes_to_its_end(const EditText& text, const ReadClause& clause);

/// "the walls"
std::optional<Read<std::string>> room_part_at(const EditText& text, std::size_t at);

/// "white oak", "20 cm wider": as what stands there says.
ReadClause recolored(const EditText& text, const Read<Ids>& what, std::size_t at);
ReadClause read_size(const EditText& text, const Read<Ids>& what, std::size_t at);

/// What stands behind a verb of data/edits.json, by what the verb means.
ReadClause read_verb(const EditText& text, const std::string& meaning, const std::string& verb, std::size_t at);
/// Behind "I want": "the desk wider", "the lamp moved to the window".
ReadClause read_wish(const EditText& text, std::size_t at);
/// "bin by the door", "walls sage green", "rug 20 % smaller": what it is about, and how that shall
/// be.
ReadClause read_fragment(const EditText& text, std::size_t at);

// The same for one meaning each. Of adding:
ReadClause read_add(const EditText& text, std::size_t at);
/// "bigger bed": another one than the one that there is.
ReadClause read_better(const EditText& text, std::size_t at);
/// Whether a new thing is named there: "a keyboard", and "keyboard" where there is none yet.
bool brings_something(const EditText& text, std::size_t at);
/// "give the desk a second monitor"
ReadClause read_give(const EditText& text, std::size_t at);

// Of what stays:

/// "only the middle one stays", "keep only two chairs", behind the first words; the others of the
/// kind go.
ReadClause read_only_these(const EditText& text, std::size_t at);
/// "a single chair is enough"
ReadClause read_enough(const EditText& text, std::size_t at);

// Of moving and turning:

/// "put the vase on the table", and "move the vase on the table to the shelf": what is said last is
/// where to.
ReadClause read_put(const EditText& text, std::size_t at, bool may_add);
/// "raise the mirror 15 cm", by a verb that says which way: 1 is up.
ReadClause read_lift(const EditText& text, std::size_t at, double way);
/// "push the chairs in": to what they stand at; "pull them out a bit": away from it.
ReadClause read_tuck(const EditText& text, std::size_t at);
ReadClause read_untuck(const EditText& text, std::size_t at);
/// "line the stools up along the bar"
ReadClause read_line(const EditText& text, std::size_t at);
ReadClause read_centre(const EditText& text, std::size_t at);
ReadClause read_turn(const EditText& text, std::size_t at);
ReadClause read_turn_first(const EditText& text, std::size_t at);
/// "everything should be white oak", "the desk must be 10 cm wider", "the table has to be a round
/// one"
ReadClause read_being(const EditText& text, std::size_t at);

// Of other things, other looks and other sizes:
ReadClause read_replace(const EditText& text, std::size_t at);
/// "instead of the table, a round one"; `wanted`: "a pouf instead of the table".
ReadClause read_instead(const EditText& text, std::size_t at, const std::optional<NamedThing>& wanted = {});
ReadClause read_swap(const EditText& text, std::size_t at);
ReadClause read_looks(const EditText& text, std::size_t at);
ReadClause read_change(const EditText& text, std::size_t at);
ReadClause read_make(const EditText& text, std::size_t at);
/// "emerald tiles for the walls", "a white finish on the desk"
ReadClause read_looks_first(const EditText& text, std::size_t at);
/// "an arched one with a gold frame": in place of what was spoken of last.
ReadClause read_another(const EditText& text, std::size_t at);
/// "in cream", "20 cm to the left", "a bit wider": of what was spoken of last.
ReadClause read_ellipsis(const EditText& text, std::size_t at);
/// "increase the height of the stool by 10 cm", "set the desk's width to 1.6 m"; nothing if no side
/// is named.
std::optional<ReadClause> read_property(const EditText& text, std::size_t at, const std::string& verb);
/// "widen the desk by 20 cm"
ReadClause read_resize(const EditText& text, std::size_t at, const std::string& verb);

/// "lock the bed", "leave the lamp where it is"
ReadClause read_lock(const EditText& text, std::size_t at, bool locked, bool must_say_where);

// Of the room itself, and of the form of things; nothing where the words are about something else.

/// "a second door in the left wall", "the window 20 cm wider", "the ceiling to 3 m", behind a verb.
std::optional<ReadClause> read_room_order(const EditText& text, const std::string& meaning, const std::string& verb,
                                          std::size_t at);
/// "a thicker mattress and a higher headboard": nothing but parts of things.
std::optional<Read<std::string>> parts_at(const EditText& text, std::size_t at);
/// "the crib's legs shorter", "the backs of the armchairs taller"
std::optional<ReadClause> read_form(const EditText& text, std::size_t at);

/// "a gap of 5 cm from the nightstand to the bed", "60 cm of free space to the wardrobe": a
/// distance that shall be left between things. `subjects` are what the clause is about, none where
/// the words name both.
struct KeptGap {
  double metres = 0.0;
  Ids first;           ///< that moves
  std::string second;  ///< a thing, a wall or an opening
};
MayRead<KeptGap> gap_at(const EditText& text, std::size_t at, const Ids& subjects);

/// Moves the first ones straight to or from the second until that is left between them.
ReadClause keep_gap(const EditText& text, const Read<KeptGap>& gap);

/// Where a thing or a part of the room lies, as seen from an object.
Vec2 middle_of_target(const EditText& text, const Object& object, const std::string& target);

/// Each of the things by so much, or nearer to what it says, or farther from it.
ReadClause read_shift(const EditText& text, const Ids& ids, const Shifting& how, bool group);

/// "to face each other", "side by side against the wall"
std::optional<ReadClause> read_mutual(const EditText& text, const Read<Ids>& what);
/// "with its back to the bed": the front away from it.
std::optional<ReadClause> read_facing_away(const EditText& text, const Read<Ids>& what);
/// Where things shall go, behind their names.
ReadClause put_there(const EditText& text, Read<Ids> what);

/// What is wrong with a thing, which says how it shall be: "the sofa is too close to the TV", "the
/// table is too small for us", "the lamp is in the way of the door". Nothing where nobody
/// complains.
std::optional<ReadClause> complaint_at(const EditText& text, std::size_t at);

/// "except the bed", behind a clause that is about several things: these are left as they are.
void leave_out_exceptions(const EditText& text, Clause& clause);

}  // namespace roomgen
