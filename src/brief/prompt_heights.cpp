#include "mention_shape.h"
#include "prompt_passes.h"

namespace roomgen::brief {

namespace {

using language::Measure;
using language::Run;

/// A length above the floor, with the words that say so.
struct SaidHeight {
  Measure measure;
  Run tokens;
};

class HeightReader {
 public:
  explicit HeightReader(PromptReading& reading) : reading_(reading) {}

  void run() {
    const auto count = static_cast<std::uint32_t>(reading_.text.plain.size());
    for (std::uint32_t i = 0; i < count; ++i)
      if (const auto height = height_at(i)) {
        if (const auto thing = what_hangs(height->tokens)) set(*thing, *height);
        i = height->tokens.end - 1;
      }
  }

 private:
  // "at 1.8 m", "no more than 1.5 m above the floor"; "at 2 m intervals" tells none.
  std::optional<SaidHeight> height_at(std::uint32_t i) const {
    const auto measure = language::bounded_measure_at(reading_.parse.tokens, i);
    if (!measure || measure->kind != Measure::Kind::length || !measure->has_unit) return std::nullopt;
    const auto end = i + static_cast<std::uint32_t>(measure->length);
    const std::size_t behind = longest_in(reading_.words.height_endings, reading_.text.plain, end);
    const std::size_t before = words_before(i);
    const bool is_named = before > 0 && says_height(i - static_cast<std::uint32_t>(before), i);
    const bool is_distance = !is_named && end < reading_.text.plain.size() && reading_.words.distances.count(reading_.word(end)) > 0;
    if (behind == 0 && (before == 0 || is_distance)) return std::nullopt;
    return SaidHeight{*measure, {i - static_cast<std::uint32_t>(before), end + static_cast<std::uint32_t>(behind)}};
  }
  // "at a height of 1.6 m above the bench": whatever follows.
  bool says_height(std::uint32_t begin, std::uint32_t end) const {
    for (auto i = begin; i < end; ++i)
      if (reading_.is_word(i, "height")) return true;
    return false;
  }
  std::size_t words_before(std::uint32_t i) const {
    constexpr std::uint32_t longest = 4;
    for (std::uint32_t n = std::min(i, longest); n > 0; --n)
      if (longest_in(reading_.words.height_beginnings, reading_.text.plain, i - n) == n) return n;
    return 0;
  }

  // Of the things named in the same sentence the nearest before it that hangs or may, else the nearest behind it.
  std::optional<std::size_t> what_hangs(const Run& height) const {
    std::optional<std::size_t> before, behind;
    const int sentence = reading_.sentence_of(height.begin);
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const auto& phrase = reading_.parse.phrases[i];
      const auto mention = reading_.mentions[i];
      if (!mention || reading_.sentence_of(phrase.head) != sentence || !may_hang(*mention)) continue;
      if (phrase.head < height.begin) before = mention;
      if (phrase.head >= height.end && !behind) behind = mention;
    }
    return before ? before : behind;
  }
  bool may_hang(std::size_t index) const {
    const Mention& mention = reading_.talk.mention(index);
    return hangs(mention) || reading_.text.table.by_name(reading_.text.table.get(mention.category).forms.wall);
  }
  static bool hangs(const Mention& mention) { return mention.mount == Mount::wall || mention.mount == Mount::ceiling; }

  void set(std::size_t thing, const SaidHeight& height) {
    Mention& mention = reading_.brief.mentions[thing];
    if (!hangs(mention)) hang(mention, Mount::wall, reading_.text.table);
    set_hanging_height(mention, height.measure);
    reading_.hearing.length(height.tokens, thing);
    const auto& attachments = reading_.parse.attachments;
    for (std::size_t i = 0; i < attachments.size(); ++i)
      if (height.tokens.begin <= attachments[i].tokens.begin && attachments[i].tokens.begin < height.tokens.end)
        reading_.placements[i].reset();
  }

  PromptReading& reading_;
};

}  // namespace

void read_heights(PromptReading& reading) { HeightReader(reading).run(); }

}  // namespace roomgen::brief
