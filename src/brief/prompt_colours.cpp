#include <algorithm>

#include "language/lexicon.h"
#include "prompt_passes.h"
#include "roomgen/base/text.h"
#include "scene/finish_words.h"

namespace roomgen::brief {

namespace {

constexpr std::size_t fewest_shared = 3;

std::vector<std::string> colours_of(const Mention& mention) {
  std::vector<std::string> colours;
  for (const auto& look : mention.looks)
    if (language::lexicon().is(look, language::WordClass::color) || finish_words().basic_colors.count(look)) colours.push_back(look);
  return colours;
}

// Without some of its words.
template <typename Test>
void forget_looks(Mention& mention, Test test) {
  std::erase_if(mention.looks, test);
  auto words = split(mention.description, ' ');
  std::erase_if(words, test);
  mention.description = join(words, " ");
}

// Without the other colours.
void keep_colour(Mention& mention, const std::string& own, const std::vector<std::string>& colours) {
  forget_looks(mention, [&](const std::string& word) {
    return word != own && std::find(colours.begin(), colours.end(), word) != colours.end();
  });
}

// "alternating black and grey chairs", "chairs, alternating"
bool says_alternating(const std::string& word) { return word == "alternating" || word == "alternate" || word == "alternately"; }

bool alternate(const PromptReading& reading, std::size_t things) {
  const auto& looks = reading.talk.mention(things).looks;
  return std::any_of(looks.begin(), looks.end(), says_alternating) ||
         std::any_of(reading.parse.verbs.begin(), reading.parse.verbs.end(), [&](const language::VerbPhrase& verb) {
           return verb.base == "alternate" && reading.mention_of(verb.subject) == things;
         });
}

// Each colour to as many of them, the first to one more where they do not come out even.
void share_evenly(PromptReading& reading, std::size_t things, const std::vector<std::string>& colours) {
  const int all = reading.talk.mention(things).quantity, number = static_cast<int>(colours.size());
  for (int n = number - 1; n > 0; --n) {
    const int own = all / number + (n < all % number ? 1 : 0);
    if (const std::size_t part = reading.talk.part(things, own); part != things)
      keep_colour(reading.brief.mentions[part], colours[static_cast<std::size_t>(n)], colours);
  }
  keep_colour(reading.brief.mentions[things], colours.front(), colours);
}

}  // namespace

void share_colours(PromptReading& reading) {
  for (std::size_t i = 0, count = reading.brief.mentions.size(); i < count; ++i) {
    const Mention& whole = reading.talk.mention(i);
    const auto colours = colours_of(whole);
    const int number = static_cast<int>(colours.size());
    if (!whole.counted || whole.part_of != Demand::none || reading.talk.with_parts(i).size() != 1) continue;
    const bool one_each = colours.size() >= fewest_shared && whole.quantity == number;
    const bool do_alternate = number > 1 && whole.quantity >= number && alternate(reading, i);
    if (do_alternate) {
      forget_looks(reading.brief.mentions[i], says_alternating);
      reading.brief.notes.push_back("of the " + whole.noun + "s as many are of each colour; that they alternate is not planned");
    }
    if (one_each || do_alternate) share_evenly(reading, i, colours);
  }
}

}  // namespace roomgen::brief
