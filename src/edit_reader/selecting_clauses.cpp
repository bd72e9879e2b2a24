#include "clause.h"

#include <algorithm>

namespace roomgen {

namespace {

using Which = NamedThing::Which;

// "of the three stools": among these the words behind choose.
Read<Ids> partitive_at(const EditText& text, std::size_t at) {
  if (!text.is_word(at, "of")) return {{}, at};
  const auto all = things_at(text, at + 1, true);
  if (!all || !*all) return {{}, at};
  std::size_t end = (*all)->end;
  end = text.behind_comma(end);
  return {(*all)->value, end};
}

// All things of the kind go but for these.
Clause others_go(const EditText& text, const NamedThing& thing, const Ids& kept, std::size_t end) {
  Ids gone = fitting(text, thing);
  std::erase_if(gone, [&](const std::string& id) { return std::count(kept.begin(), kept.end(), id) > 0; });
  Clause clause{{}, {}, {}, end, gone};
  if (!gone.empty()) clause.operations.push_back(edit::Remove{gone, false});
  return clause;
}

struct Kept {
  NamedThing thing;
  Ids ids;
  std::size_t end = 0;
};

// "the middle one", "a single chair at the table", "two chairs": of a mere number the first ones.
Result<Kept> kept_at(const EditText& text, std::size_t at) {
  auto thing = named_thing_at(text, at);
  if (!thing || !thing->kind.category) return what_at(text, at, "it is not clear what shall stay");
  if (thing->which != Which::indefinite) {
    const auto ids = things(text, at, true);
    if (!ids) return ids.error();
    return Kept{*thing, ids->value, ids->end};
  }
  Ids all = fitting(text, *thing);
  std::size_t end = thing->end;
  if (const auto place = destination_at(text, end, all); place && *place && !(*place)->spot) end = (*place)->end;
  const auto number = static_cast<std::size_t>(std::max(1, thing->count));
  if (all.size() <= number) return not_understood("there are no more than " + std::to_string(all.size()) + " of them");
  all.resize(number);
  return Kept{*thing, all, end};
}

}  // namespace

ReadClause read_only_these(const EditText& text, std::size_t at) {
  const auto kept = kept_at(text, at);
  if (!kept) return kept.error();
  return others_go(text, kept->thing, kept->ids, kept->end + longest_in(text.edits.stays, text.tokens, kept->end));
}

ReadClause read_enough(const EditText& text, std::size_t at) {
  const auto group = partitive_at(text, at);
  std::size_t begin = group.end;
  const auto only = longest_in(text.edits.only_these, text.tokens, begin);
  begin += only;
  const auto kept = kept_at(text, begin);
  if (!kept) return kept.error();
  const auto length = longest_in(only > 0 ? text.edits.stays : text.edits.suffices, text.tokens, kept->end);
  if (length == 0) return what_at(text, kept->end, "not understood");
  // "six chairs are plenty, remove those by the door": which of them go is said.
  if (kept->thing.which == Which::indefinite && kept->end + length + 1 < text.tokens.size())
    return not_understood("it is not clear which of them shall go");
  return others_go(text, kept->thing, kept->ids, kept->end + length);
}

}  // namespace roomgen
