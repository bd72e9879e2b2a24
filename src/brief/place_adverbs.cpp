#include "place_adverbs.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "place_readers.h"

namespace roomgen::brief {

using language::none;
using language::Run;

namespace {

// Words that no phrase has and no attachment.
std::vector<bool> words_left(const language::Parse& parse) {
  std::vector<bool> left(parse.tokens.size(), true);
  const auto use = [&](const Run& run) {
    std::fill(left.begin() + run.begin, left.begin() + run.end, false);
  };
  for (const auto& one : parse.attachments) use(one.tokens);
  for (const auto& one : parse.phrases) use({one.tokens.begin, one.head + 1});
  return left;
}

}  // namespace

PlaceAdverbs::PlaceAdverbs(PromptReading& reading, PlaceTeller& teller)
    : reading_(reading), teller_(teller), left_(words_left(reading.parse)) {}

void PlaceAdverbs::read_up_to(std::size_t end) {
  for (; next_ < end; ++next_) {
    const std::size_t i = next_;
    const auto match = longest(reading_.words.placements, reading_.text.plain, i);
    if (!left_[i] && !(match && is_doubled(i, match.length))) continue;
    const auto first = static_cast<std::uint32_t>(i);
    reading_.look_back_from(i);
    teller_.come_to(first);
    if (!match || (!match.value->pronoun && !match.value->adverb && !match.value->mutual))
      continue;
    // "Between sofa and console: a table" names what it is between.
    const bool goes_on = i + match.length < reading_.text.plain.size() && reading_.text.plain[i + match.length].kind == Token::Kind::word;
    if (goes_on && match.value->relations.front() == RelationKind::between) continue;
    const Indices subjects = subjects_at(i);
    const auto heard = hear(reading_.brief, {first, first + static_cast<std::uint32_t>(match.length)},
                            Heard::As::relation);
    reading_.talk.told_by(heard);
    if (!subjects.empty() && match.value->mutual)
      relate_listed(reading_, i, *match.value, heard);
    else if (!subjects.empty())
      teller_.say_of_implied(subjects, *match.value);
    next_ += match.length - 1;
  }
}

// "back to back", whatever noun it is made of.
bool PlaceAdverbs::is_doubled(std::size_t first, std::size_t length) const {
  return length == 3 && reading_.text.plain[first].text == reading_.text.plain[first + 2].text;
}

// Of what an adverb is said: the subject of the verb before it, what was named last in its
// sentence, or what it is said before ("Above hangs a lantern").
Indices PlaceAdverbs::subjects_at(std::size_t token) const {
  for (const auto& verb : reading_.parse.verbs)
    if (verb.tokens.end == token && verb.subject != none)
      if (const auto subjects = reading_.mentions_of_list(verb.subject); !subjects.empty())
        return subjects;
  std::optional<std::size_t> before, after;
  for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
    const std::size_t head = reading_.parse.phrases[i].head;
    if (!reading_.mentions[i] || reading_.sentence_of(head) != reading_.sentence_of(token))
      continue;
    if (head < token)
      before = reading_.mentions[i];
    else if (!after)
      after = reading_.mentions[i];
  }
  if (!before) before = after;
  return before ? Indices{*before} : Indices{};
}

}  // namespace roomgen::brief
