#include <algorithm>

#include "language/function_word.h"
#include "library/style_words.h"
#include "prompt_passes.h"
#include "scene/finish_words.h"

namespace roomgen::brief {

namespace {

using language::Run;

class PaletteReader {
 public:
  explicit PaletteReader(PromptReading& reading) : reading_(reading), used_(reading.tokens_with_sense()) {}

  void run() {
    std::uint32_t begin = 0;
    const auto count = static_cast<std::uint32_t>(used_.size());
    for (std::uint32_t i = 0; i <= count; ++i) {
      // "a bedroom in blue and white": what was heard before it ends a stretch too.
      const bool goes_on = i < count && reading_.text.plain[i].kind == Token::Kind::word &&
                           !reading_.is_word(i, "and") && !used_[i];
      if (goes_on) continue;
      read_segment({begin, i});
      begin = i + 1;
    }
  }

 private:
  // All is a word of the palette or frames one.
  void read_segment(const Run& segment) {
    std::vector<std::string> said;
    for (auto i = segment.begin; i < segment.end; ++i) {
      const std::string& word = reading_.word(i);
      if (reading_.taken[i] != Taken::no || reading_.is_denied(i)) return;
      const bool describes = finish_words().describes(word) || finish_words().surface_names.count(word) ||
                             StyleWords::built_in().worn_by_stuff(word);
      if (!describes && !reading_.words.palette_frames.count(word) && !finish_words().fillers.count(word) &&
          !language::is_function_word(reading_.parse.tokens[i]))
        return;
      if (describes) said.push_back(word);
    }
    if (said.empty()) return;
    std::string words;
    for (const auto& word : said) words += (words.empty() ? "" : " ") + word;
    hear(reading_.brief, segment, Heard::As::style, words);
    reading_.brief.palette.push_back(std::move(words));
  }

  PromptReading& reading_;
  const std::vector<bool> used_;
};

}  // namespace

void read_palette(PromptReading& reading) { PaletteReader(reading).run(); }

}  // namespace roomgen::brief
