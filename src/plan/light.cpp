#include <algorithm>

#include "looks.h"
#include "scene/finish_words.h"

namespace roomgen::plan {

namespace {

constexpr std::size_t reach_of_denial = 2;  ///< "not too bright"

bool is_denied(const brief::Brief& brief, std::size_t at) {
  static constexpr std::string_view denials[] = {"no", "not", "never", "without", "less"};
  for (std::size_t i = at - std::min(at, reach_of_denial); i < at; ++i)
    for (const auto word : denials)
      if (brief.tokens[i].is(word) || brief.tokens[i].clitic == "n't") return true;
  return false;
}

// A word may say something else of the room as well; "bright" of a rug says nothing of it.
bool is_of_things(const brief::Brief& brief, const language::Run& tokens) {
  return std::any_of(brief.heard.begin(), brief.heard.end(), [&](const brief::HeardWords& words) {
    const bool is_of_thing = words.as == Heard::As::thing || words.as == Heard::As::count ||
                             words.as == Heard::As::attribute || words.as == Heard::As::absence;
    return is_of_thing && words.tokens.begin < tokens.end && tokens.begin < words.tokens.end;
  });
}

}  // namespace

Lighting light_of(brief::Brief& brief) {
  Lighting light;
  std::vector<std::string> texts;
  for (const auto& token : brief.tokens) texts.push_back(token.text);
  for (std::size_t at = 0; at < texts.size(); ++at) {
    std::size_t length = 0;
    const Lighting* mood = finish_words().mood_at(texts, at, length);
    const language::Run run{static_cast<std::uint32_t>(at),
                            static_cast<std::uint32_t>(at + length)};
    if (!mood || is_denied(brief, at) || is_of_things(brief, run)) continue;
    fill(light, *mood);
    hear(brief, run, Heard::As::style);
    at = run.end - 1;
  }
  return light;
}

void fill(Lighting& light, const Lighting& more) {
  if (!light.hour) light.hour = more.hour;
  if (!light.sky) light.sky = more.sky;
  if (!light.lux) light.lux = more.lux;
  if (!light.kelvin) light.kelvin = more.kelvin;
}

}  // namespace roomgen::plan
