#include "lexicon.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

#include "lexicon_layout.h"

extern "C" {
extern const unsigned char roomgen_lexicon[];
extern const std::uint64_t roomgen_lexicon_size;
}

namespace roomgen::language {

namespace {

using layout::Section;

// A sense that is met at least a tenth as often as the commonest one is common.
constexpr double common_share = 0.1;

std::size_t read(std::string_view bytes, std::size_t at, std::size_t width) {
  std::size_t value = 0;
  for (std::size_t i = 0; i < width; ++i)
    value |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

std::size_t section_start(std::string_view bytes, std::size_t section) {
  return read(bytes, layout::magic.size() + layout::offset_width * section, layout::offset_width);
}

std::string_view section_bytes(std::string_view bytes, Section section) {
  const auto k = static_cast<std::size_t>(section);
  const std::size_t from = section_start(bytes, k);
  return bytes.substr(from, section_start(bytes, k + 1) - from);
}

std::size_t entries(std::string_view bytes, Section section) {
  return section_bytes(bytes, section).size() / layout::width;
}

// What a sense weighs against others of its word: rare ones by their rank.
double weight(const Sense& sense) {
  return sense.tagged + 1.0 / sense.rank;
}

// The first number in [0, count) of which `less` does not hold.
template <typename Less>
std::size_t first_not(std::size_t count, const Less& less) {
  std::size_t from = 0;
  while (count > 0) {
    const std::size_t half = count / 2;
    if (less(from + half)) {
      from += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  return from;
}

}  // namespace

Lexicon::Lexicon(std::string_view bytes) : bytes_(bytes) {
  assert(bytes.starts_with(layout::magic));
  lemma_count_ = entries(bytes, Section::lemma_starts) - 1;
  irregular_count_ = entries(bytes, Section::irregular_bases);
}

std::size_t Lexicon::number(Section section, std::size_t index) const {
  return read(bytes_,
              section_start(bytes_, static_cast<std::size_t>(section)) + layout::width * index,
              layout::width);
}

std::string_view Lexicon::text(Section starts, Section texts, std::size_t index) const {
  const std::size_t from = number(starts, index);
  return bytes_.substr(section_start(bytes_, static_cast<std::size_t>(texts)) + from,
                       number(starts, index + 1) - from);
}

std::string_view Lexicon::lemma(std::size_t at) const {
  return text(Section::lemma_starts, Section::lemma_text, at);
}

std::optional<std::size_t> Lexicon::find(std::string_view word) const {
  const auto at = first_not(lemma_count_, [&](std::size_t i) { return lemma(i) < word; });
  if (at == lemma_count_ || lemma(at) != word) return std::nullopt;
  return at;
}

PartOfSpeech Lexicon::part_of(std::size_t synset) const {
  int part = 0;
  while (part < 3 && synset >= number(Section::parts, static_cast<std::size_t>(part + 1))) ++part;
  return static_cast<PartOfSpeech>(part);
}

std::vector<Sense> Lexicon::senses(std::string_view word) const {
  std::vector<Sense> result;
  const auto found = find(word);
  if (!found) return result;
  const auto starts = Section::lemma_senses;
  const std::string_view frequencies = section_bytes(bytes_, Section::frequencies);
  const std::string_view classes = section_bytes(bytes_, Section::classes);
  const std::string_view masks = section_bytes(bytes_, Section::masks);
  for (std::size_t i = number(starts, *found), end = number(starts, *found + 1); i < end; ++i) {
    Sense sense;
    sense.synset = static_cast<std::uint32_t>(number(Section::senses, i));
    sense.part = part_of(sense.synset);
    if (!result.empty() && result.back().part == sense.part) sense.rank = result.back().rank + 1;
    sense.tagged =
        std::exp2(static_cast<double>(read(frequencies, i, 1)) / layout::frequency_scale) - 1.0;
    sense.classes = static_cast<std::uint32_t>(
        read(masks, 4 * read(classes, layout::class_width * sense.synset, layout::class_width), 4));
    result.push_back(sense);
  }
  return result;
}

std::vector<Sense> Lexicon::senses(std::string_view word, PartOfSpeech part) const {
  auto all = senses(word);
  std::erase_if(all, [&](const Sense& sense) { return sense.part != part; });
  return all;
}

bool Lexicon::has(std::string_view word, PartOfSpeech part) const {
  return !senses(word, part).empty();
}

double Lexicon::tagged(std::string_view word, PartOfSpeech part) const {
  double sum = 0.0;
  for (const auto& sense : senses(word, part)) sum += sense.tagged;
  return sum;
}

double Lexicon::share(std::string_view word, WordClass word_class, PartOfSpeech part) const {
  double of_class = 0.0, all = 0.0;
  for (const auto& sense : senses(word, part)) {
    all += weight(sense);
    if (sense.is(word_class)) of_class += weight(sense);
  }
  return all > 0.0 ? of_class / all : 0.0;
}

bool Lexicon::is(std::string_view word, WordClass word_class) const {
  const auto all = senses(word, PartOfSpeech::noun);
  return !all.empty() && (all.front().is(word_class) || share(word, word_class) >= 0.5);
}

bool Lexicon::may_be(std::string_view word, WordClass word_class) const {
  const auto common = common_senses(word, PartOfSpeech::noun);
  return std::any_of(common.begin(), common.end(),
                     [&](const Sense& s) { return s.is(word_class); });
}

std::vector<Sense> Lexicon::common_senses(std::string_view word, PartOfSpeech part) const {
  auto all = senses(word, part);
  double most = 0.0;
  for (const auto& sense : all) most = std::max(most, weight(sense));
  std::erase_if(all, [&](const Sense& sense) { return weight(sense) < common_share * most; });
  return all;
}

bool Lexicon::are_synonyms(std::string_view a, std::string_view b, PartOfSpeech part) const {
  return steps_up(a, b, 0, part).has_value();
}

std::optional<std::uint32_t> Lexicon::synset(std::string_view sense) const {
  const auto mark = sense.rfind(".n.");
  if (mark == std::string_view::npos) return std::nullopt;
  int rank = 0;
  std::from_chars(sense.data() + mark + 3, sense.data() + sense.size(), rank);
  for (const auto& one : senses(sense.substr(0, mark), PartOfSpeech::noun))
    if (one.rank == rank) return one.synset;
  return std::nullopt;
}

std::vector<std::string_view> Lexicon::members(std::uint32_t synset) const {
  std::vector<std::string_view> result;
  const auto starts = Section::member_starts;
  for (std::size_t i = number(starts, synset); i < number(starts, synset + 1); ++i)
    result.push_back(lemma(number(Section::members, i)));
  return result;
}

std::vector<std::uint32_t> Lexicon::more_general(std::uint32_t synset) const {
  std::vector<std::uint32_t> result;
  const auto starts = Section::general_starts;
  for (std::size_t i = number(starts, synset); i < number(starts, synset + 1); ++i)
    result.push_back(static_cast<std::uint32_t>(number(Section::general, i)));
  return result;
}

std::optional<int> Lexicon::steps_up(std::string_view word, std::string_view general, int most,
                                     PartOfSpeech part) const {
  const auto tops = common_senses(general, part);
  if (tops.empty()) return std::nullopt;
  std::vector<std::uint32_t> level, above;
  for (const auto& sense : common_senses(word, part)) level.push_back(sense.synset);
  for (int steps = 0; steps <= most && !level.empty(); ++steps) {
    for (const auto synset : level)
      for (const auto& top : tops)
        if (synset == top.synset) return steps;
    above.clear();
    for (const auto synset : level)
      for (const auto general : more_general(synset)) above.push_back(general);
    std::sort(above.begin(), above.end());
    above.erase(std::unique(above.begin(), above.end()), above.end());
    level.swap(above);
  }
  return std::nullopt;
}

std::vector<std::string_view> Lexicon::synonyms(std::string_view word, PartOfSpeech part) const {
  std::vector<std::string_view> result;
  for (const auto& sense : common_senses(word, part))
    for (const auto member : members(sense.synset))
      if (member != word && std::find(result.begin(), result.end(), member) == result.end())
        result.push_back(member);
  return result;
}

std::vector<std::string_view> Lexicon::hypernyms(std::string_view word, PartOfSpeech part) const {
  std::vector<std::string_view> result;
  for (const auto& sense : common_senses(word, part))
    for (const auto general : more_general(sense.synset))
      for (const auto member : members(general)) result.push_back(member);
  return result;
}

std::vector<std::string_view> Lexicon::irregular_bases(std::string_view form,
                                                       PartOfSpeech part) const {
  const auto starts = Section::irregular_starts;
  const auto texts = Section::irregular_text;
  std::vector<std::string_view> result;
  auto at =
      first_not(irregular_count_, [&](std::size_t i) { return text(starts, texts, i) < form; });
  for (; at < irregular_count_ && text(starts, texts, at) == form; ++at) {
    const std::size_t key = number(Section::irregular_bases, at);
    if (key % 4 == static_cast<std::size_t>(part)) result.push_back(lemma(key / 4));
  }
  return result;
}

std::vector<std::string_view> Lexicon::irregular_forms(std::string_view word,
                                                       PartOfSpeech part) const {
  std::vector<std::string_view> result;
  const auto found = find(word);
  if (!found) return result;
  const std::size_t key = 4 * *found + static_cast<std::size_t>(part);
  const auto form = [&](std::size_t i) { return number(Section::by_base, i); };
  const auto base = [&](std::size_t i) { return number(Section::irregular_bases, form(i)); };
  auto at = first_not(irregular_count_, [&](std::size_t i) { return base(i) < key; });
  for (; at < irregular_count_ && base(at) == key; ++at)
    result.push_back(text(Section::irregular_starts, Section::irregular_text, form(at)));
  return result;
}

std::string_view Lexicon::licence() const {
  return section_bytes(bytes_, Section::licence);
}

const Lexicon& lexicon() {
  static const Lexicon built_in(std::string_view(reinterpret_cast<const char*>(roomgen_lexicon),
                                                 static_cast<std::size_t>(roomgen_lexicon_size)));
  return built_in;
}

}  // namespace roomgen::language
