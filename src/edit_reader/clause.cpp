#include "clause.h"

#include <algorithm>

#include "edit/operations.h"
#include "wording.h"

namespace roomgen {

Error what_at(const EditText& text, std::size_t at, const std::string& what) {
  const std::string rest = text.words_from(at, std::min(at + 6, text.tokens.size()));
  return not_understood(what + (rest.empty() ? "" : " at \"" + rest + "\""));
}

std::size_t behind_modals(const EditText& text, std::size_t at) {
  for (;;) {
    const auto modal = longest_in(text.edits.modals, text.tokens, at),
               auxiliary = longest_in(text.edits.auxiliaries, text.tokens, at);
    // "to the window" is no infinitive.
    const bool is_place =
        longest(text.edits.places, text.tokens, at) || longest(text.words.placements, text.tokens, at);
    if (std::max(modal, auxiliary) == 0 || (modal == 0 && (is_place || text.is_word(at, "to")))) return at;
    at += std::max(modal, auxiliary);
  }
}

Result<Read<Ids>> things(const EditText& text, std::size_t at, bool with_places) {
  auto found = things_at(text, at, with_places);
  // What follows may be no place at all: "have both armchairs face the TV".
  if (with_places && found && !*found)
    if (const auto plain = things_at(text, at, false); plain && *plain) found = plain;
  if (!found) return what_at(text, at, "it is not clear what is meant");
  return *found;
}

ReadClause of_each(const Read<Ids>& read, std::size_t end,
                   const std::function<edit::Operation(const std::string&)>& make) {
  Clause clause;
  clause.about = read.value;
  clause.end = end;
  for (const auto& id : read.value) clause.operations.push_back(make(id));
  return clause;
}

bool goes_to_its_end(const EditText& text, const ReadClause& clause) {
  return clause &&
         (text.ends(end_of_tail(text, clause->end)) || longest_in(text.edits.besides, text.tokens, clause->end) > 0);
}

}  // namespace roomgen
