#include "read_so_far.h"

#include <algorithm>

namespace roomgen {

using Which = NamedThing::Which;

void ReadSoFar::note_remark(std::size_t begin, std::size_t end) { remarks.push_back(text.words_from(begin, end)); }

void ReadSoFar::remember_names(std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const auto thing = named_thing_at(text, i);
    if (!thing || thing->which != Which::definite || thing->end > end) continue;
    for (const bool with_places : {true, false}) {
      const auto ids = things_at(text, i, with_places);
      if (!ids || !*ids || (*ids)->value.size() != 1 || (*ids)->end > end) continue;
      text.mentioned.push_back((*ids)->value.front());
      break;
    }
  }
}

void ReadSoFar::speak_of(std::size_t begin, std::size_t end) {
  const std::size_t known = text.mentioned.size();
  const auto first = named_thing_at(text, begin);
  remember_names(begin, end);
  Ids named(text.mentioned.begin() + static_cast<std::ptrdiff_t>(known), text.mentioned.end());
  std::sort(named.begin(), named.end());
  named.erase(std::unique(named.begin(), named.end()), named.end());
  if (named.empty()) return;
  const bool is_about_first = first && first->kind.category && first->which == Which::definite;
  text.latest = is_about_first ? Ids{text.mentioned[known]} : named;
}

void ReadSoFar::take(const Clause& clause, std::size_t begin) {
  remember_names(begin, clause.end);
  if (gathered.fold_looks(clause, text) || gathered.fold_place(clause, text)) return;
  gathered.add(clause);
  if (!clause.gone.empty()) text.gone = clause.gone;
  text.mentioned.insert(text.mentioned.end(), clause.about.begin(), clause.about.end());
  if (!clause.about.empty()) text.latest = clause.about;
  text.coming.insert(text.coming.end(), clause.coming.begin(), clause.coming.end());
}

}  // namespace roomgen
