#include <algorithm>

#include "evaluate/clauses.h"
#include "library/shown_colors.h"
#include "roomgen/base/text.h"
#include "scene/finish.h"

namespace roomgen {

namespace {

constexpr double same_tone = 15.0;  // CIELAB: farther apart they have other names

std::string shown_text(const DrawnFinish& drawn, bool has_colors) {
  if (has_colors) return drawn.surface.pattern ? drawn.surface.name : "plain paint";
  std::vector<std::string> colors;
  for (const Tone& tone : drawn.tones()) colors.push_back(color_name(tone.x(), tone.y(), tone.z()));
  return join(colors, " and ") + (drawn.surface.pattern ? " " + drawn.surface.name : ", plain");
}

// Cobalt blue is some blue, however far it is from the usual one.
bool says_basic(std::string_view asked, std::string_view worn) {
  const auto all = words(worn);
  const auto& basic = finish_words().basic_colors;
  const auto wanted = words(asked);
  return std::any_of(wanted.begin(), wanted.end(), [&](const std::string& word) {
    return basic.count(word) && std::find(all.begin(), all.end(), word) != all.end();
  });
}

// "Parquet" is worn as herringbone parquet, too.
bool shows_surface(const SaidFinish& asked, const DrawnFinish& as_asked, std::string_view worn,
                   const DrawnFinish& drawn) {
  if (!asked.surface) return true;
  if (asked.surface->pattern && !drawn.surface.pattern) return false;
  const SaidFinish said = said_finish(worn);
  const auto names = words(worn);
  const auto names_it = [&](const std::string& word) {
    const auto found = finish_words().surface_names.find(word);
    return found != finish_words().surface_names.end() && found->second == asked.surface->name;
  };
  return drawn.surface.name == as_asked.surface.name || said.surface == asked.surface ||
         asked.surface_is_of_stuff || std::any_of(names.begin(), names.end(), names_it);
}

}  // namespace

std::string finish_fault(std::string_view asked, std::string_view worn, RoomPart part,
                         std::string_view room_type) {
  const SaidFinish said = said_finish(asked);
  const DrawnFinish drawn = drawn_finish(worn, part, room_type);
  const DrawnFinish as_asked = drawn_finish(asked, part, room_type);
  const auto shown = drawn.tones();
  const auto tones = as_asked.tones().size() > 1 ? as_asked.tones() : said.tones;
  const auto is_shown = [&](const Tone& tone) {
    return std::any_of(shown.begin(), shown.end(),
                       [&](const Tone& other) { return tone_distance(tone, other) <= same_tone; });
  };
  const auto count = static_cast<std::size_t>(std::count_if(tones.begin(), tones.end(), is_shown));
  const bool has_colors = said.tones.empty() || count == tones.size() ||
                          (said.tones.size() == 1 && says_basic(asked, worn));
  const bool has_surface = shows_surface(said, as_asked, worn, drawn);
  if (has_colors && has_surface && said.unknown.empty()) return "";
  const bool is_part = (said.surface && has_surface) || (!said.tones.empty() && count > 0);
  return (is_part ? "partly: drawn as " : "drawn as ") +
         shown_text(drawn, !said.tones.empty() && has_colors) +
         (said.unknown.empty() ? "" : "; nothing draws \"" + join(said.unknown, " ") + "\"");
}

}  // namespace roomgen
