#include <map>
#include <optional>

#include "language/number.h"
#include "place_readers.h"

namespace roomgen::brief {

namespace {

// "the other" without a number: the one that was not spoken of.
int which_pronoun(const std::string& noun) {
  if (noun == "one") return 0;
  return noun == "other" ? 1 : -1;
}

// Where it stands in the order of them all.
std::optional<int> place_in_order(const PromptReading& reading, std::uint32_t token, int all) {
  static const std::map<std::string, int, std::less<>> sides = {{"left", 0}, {"leftmost", 0}, {"middle", 1}, {"right", 2}, {"rightmost", 2}, {"last", 2}};
  if (const auto number = language::ordinal_at(reading.parse.tokens, token))
    return *number - 1;
  const auto side = sides.find(reading.word(token));
  if (side == sides.end()) return std::nullopt;
  return side->second * (all - 1) / 2;
}

}  // namespace

int which_of(const PromptReading& reading, std::int32_t id) {
  if (id == language::none) return -1;
  const auto& phrase = reading.phrase(id);
  const auto mention = reading.mention_of(id);
  const int all = mention ? reading.talk.mention(*mention).quantity : 0;
  if (phrase.determiner == language::Determiner::definite && all > 1)
    for (auto token = phrase.tokens.begin; token <= phrase.head; ++token)
      if (const auto place = place_in_order(reading, token, all); place && *place < all) return *place;
  const bool is_each = phrase.head > 0 && (reading.is_word(phrase.head - 1, "each") || reading.is_word(phrase.head - 1, "every"));
  return phrase.is_pronoun && !is_each ? which_pronoun(reading.word(phrase.head)) : -1;
}

}  // namespace roomgen::brief
