#include "clause.h"

#include <algorithm>

#include "operations.h"

namespace roomgen {

Error what_at(const EditText& text, std::size_t at, const std::string& what) {
  const std::string rest = text.words_from(at, std::min(at + 6, text.tokens.size()));
  return not_understood(what + (rest.empty() ? "" : " at \"" + rest + "\""));
}

Result<Read<Ids>> things(const EditText& text, std::size_t at, bool with_places) {
  auto found = things_at(text, at, with_places);
  // What follows may be no place at all: "have both armchairs face the TV".
  if (with_places && found && !*found)
    if (const auto plain = things_at(text, at, false); plain && *plain) found = plain;
  if (!found) return what_at(text, at, "it is not clear what is meant");
  return *found;
}

ReadClause of_each(const Read<Ids>& read, std::size_t end, const std::function<edit::Operation(const std::string&)>& make) {
  Clause clause;
  clause.about = read.value;
  clause.end = end;
  for (const auto& id : read.value) clause.operations.push_back(make(id));
  return clause;
}

bool goes_to_its_end(const EditText& text, const ReadClause& clause) {
  return clause && (text.ends(clause->end) || longest_in(text.edits.closers, text.tokens, clause->end) > 0 ||
                    longest_in(text.edits.reasons, text.tokens, clause->end) > 0);
}

}  // namespace roomgen
