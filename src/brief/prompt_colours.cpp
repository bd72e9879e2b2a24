#include "prompt_colours.h"

#include <algorithm>

#include "language/lexicon.h"
#include "roomgen/base/text.h"

namespace roomgen::design {

namespace {

constexpr std::size_t fewest_shared = 3;

std::vector<std::string> colours_of(const Mention& mention) {
  std::vector<std::string> colours;
  for (const auto& look : mention.looks)
    if (language::lexicon().is(look, language::WordClass::color)) colours.push_back(look);
  return colours;
}

// Without the other colours.
void keep_colour(Mention& mention, const std::string& own, const std::vector<std::string>& colours) {
  const auto is_other = [&](const std::string& word) {
    return word != own && std::find(colours.begin(), colours.end(), word) != colours.end();
  };
  std::erase_if(mention.looks, is_other);
  auto words = split(mention.description, ' ');
  std::erase_if(words, is_other);
  mention.description = join(words, " ");
}

}  // namespace

void share_colours(PromptReading& reading) {
  for (std::size_t i = 0, count = reading.brief.mentions.size(); i < count; ++i) {
    const auto colours = colours_of(reading.talk.mention(i));
    const Mention& whole = reading.talk.mention(i);
    const bool is_shared = colours.size() >= fewest_shared && whole.counted && whole.quantity == static_cast<int>(colours.size()) &&
                           whole.part_of == Demand::none && reading.talk.with_parts(i).size() == 1;
    if (!is_shared) continue;
    for (std::size_t n = 1; n < colours.size(); ++n)
      if (const std::size_t part = reading.talk.part(i, 1); part != i) keep_colour(reading.brief.mentions[part], colours[n], colours);
    keep_colour(reading.brief.mentions[i], colours.front(), colours);
  }
}

}  // namespace roomgen::design
