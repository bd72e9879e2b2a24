#pragma once

#include <optional>
#include <string>
#include <vector>

#include "destinations.h"
#include "edit_text.h"
#include "references.h"
#include "roomgen/edit/operation.h"

namespace roomgen {

template <typename T>
using MayRead = std::optional<Result<Read<T>>>;  ///< nothing: the words say no such thing

using Ids = std::vector<std::string>;

/// "the vase on the coffee table", "the printer and both plants", "everything on the desk except
/// the lamp". With `with_places` words of place that follow a thing tell which is meant.
MayRead<Ids> things_at(const EditText& text, std::size_t at, bool with_places);

/// "dark oak", "in bottle-green leather": up to the end of the clause, if it means a look.
/// `of_room`: of floors and walls.
bool describes_looks(const std::string& words);
MayRead<std::string> looks_at(const EditText& text, std::size_t at, bool of_room);

/// "a small round table", "taller ones with backs", as the library is asked for it instead of a
/// thing.
struct Substitute {
  std::string category;  ///< empty: another of the same kind
  std::string description;
  std::vector<language::Measure> measures = {};  ///< "a 3 m one"
};
MayRead<Substitute> substitute_at(const EditText& text, std::size_t at);

/// "a keyboard", "another keyboard", "keyboard" where there is none yet, with what is said of it
/// behind the name: "a vase of tulips", "a round one in pale ash that seats six", "a second crib,
/// identical to the first". `may_be_bare`: what no kind is called may stand without an article, as
/// behind "add".
std::optional<NamedThing> new_thing_at(const EditText& text, std::size_t at, bool may_be_bare = false);

/// "a monitor and a keyboard"
std::vector<NamedThing> new_things_at(const EditText& text, std::size_t at, bool may_be_bare = false);

/// Words behind a name that say what such a thing is like, and the token behind them; `at` if there
/// are none. `kind`: what is described, null for another of a kind that is known.
Read<std::string> description_behind(const EditText& text, std::size_t at, const Kind* kind = nullptr);

/// Words behind a noun that tell which of the things is meant: "nearest the door", "on the coffee
/// table", "that isn't at the bar", "we just put in", "on the left". Nothing where such words do
/// not follow.
MayRead<Ids> told_by_tail(const EditText& text, const NamedThing& thing);

/// Places of which each takes one thing, or one lot of things: "at either end of the table", "on
/// every desk", "one in each corner", with what each has for relations. `is_small`: what goes there
/// stands on other things.
struct SharedPlaces {
  std::vector<std::vector<Relation>> places;
  bool flanks = false;  ///< both sides of one thing
  bool each = false;    ///< as many on each of them: "two on each side"
};
MayRead<SharedPlaces> shared_places_at(const EditText& text, std::size_t at, bool is_small);

}  // namespace roomgen
