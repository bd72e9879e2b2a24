#include <algorithm>
#include <cmath>
#include <set>

#include "evaluate/clauses.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double hours_apart = 2.0;
constexpr double times_as_bright = 2.0, times_as_warm = 1.25;
constexpr double usual_lux = 300.0;

// Dim is what is no brighter, bright what is no darker.
bool is_as_bright(double asked, double lit) {
  return asked < usual_lux ? lit <= times_as_bright * asked : asked <= times_as_bright * lit;
}

bool is_as_warm(double asked, double lit) {
  return lit <= times_as_warm * asked && asked <= times_as_warm * lit;
}

bool is_so(const Lighting& asked, const Lighting& light) {
  const double hours = asked.hour && light.hour ? std::abs(*asked.hour - *light.hour) : 0.0;
  const bool is_hour = !asked.hour || (light.hour && std::min(hours, 24.0 - hours) <= hours_apart);
  return is_hour && (!asked.sky || asked.sky == light.sky) &&
         (!asked.lux || (light.lux && is_as_bright(*asked.lux, *light.lux))) &&
         (!asked.kelvin || (light.kelvin && is_as_warm(*asked.kelvin, *light.kelvin)));
}

std::string lit_text(const Lighting& light) {
  std::vector<std::string> said;
  if (light.hour) said.push_back(format_number(*light.hour, 1) + " h");
  if (light.sky) said.emplace_back(name(*light.sky));
  if (light.lux) said.push_back(format_number(*light.lux, 0) + " lx");
  if (light.kelvin) said.push_back(format_number(*light.kelvin, 0) + " K");
  return said.empty() ? "as usual" : "at " + join(said, ", ");
}

// What neither says nor changes how it is lit.
bool is_plain(const std::string& word) {
  static const std::set<std::string_view> small = {"and", "in", "the", "a", "of", "with", "soft"};
  return small.count(word) > 0 || finish_words().fillers.count(word) > 0;
}

bool is_noun_of_light(const std::string& word) {
  static const std::set<std::string_view> nouns = {"light",    "lighting", "lamplight", "daylight",
                                                   "sunlight", "gaslight", "glow",      "lit"};
  return nouns.count(word) > 0;
}

struct SaidLight {
  bool is_of_light = false;  // "long polar twilight" is, "evening dresses on a rail" is not
  bool holds = true;
  std::vector<std::string> all, unknown;
};

SaidLight read_light(const std::string& said, const Lighting& light) {
  SaidLight read{.all = words(said)};
  for (std::size_t at = 0, length = 1; at < read.all.size(); at += length, length = 1) {
    const Lighting* mood = finish_words().mood_at(read.all, at, length);
    const std::string& word = read.all[at];
    const bool is_noun = is_noun_of_light(word);
    read.is_of_light = read.is_of_light || is_noun || (mood && at + length == read.all.size());
    read.holds = read.holds && (!mood || is_so(*mood, light));
    if (!mood && !is_noun && !is_plain(word)) read.unknown.push_back(word);
  }
  return read;
}

}  // namespace

Finding judge_light(const std::string& said, const Lighting& light) {
  const auto [is_of_light, holds, all, unknown] = read_light(said, light);
  if (!is_of_light) return {Compliance::not_judged, "nothing measures it"};
  if (holds && unknown.empty()) return {};
  return by_fault((unknown.size() < all.size() && holds ? "partly: lit " : "lit ") +
                  lit_text(light) +
                  (unknown.empty() ? "" : "; nothing shows \"" + join(unknown, " ") + "\""));
}

}  // namespace roomgen
