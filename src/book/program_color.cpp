#include "program_color.h"

#include <map>
#include <nlohmann/json.hpp>

#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "shape/color.h"

namespace roomgen::book {

namespace {

using Tones = std::map<std::string, std::string, std::less<>>;

void add_colors(const Json& table, Tones& tones) {
  for (const auto& [word, entry] : table.items()) {
    if (entry.is_string())
      tones.try_emplace(word, entry.get<std::string>());
    else if (entry.is_object() && entry.contains("color"))
      tones.try_emplace(word, entry["color"].get<std::string>());
  }
}

// The tones and stuffs of data/finishes.json and data/create/words.json.
const Tones& tones() {
  static const Tones all = [] {
    Tones found;
    const auto finishes =
        parse_json(resource("data/finishes.json").value_or("{}"), "data/finishes.json");
    const auto words =
        parse_json(resource("data/create/words.json").value_or("{}"), "data/create/words.json");
    if (finishes)
      add_colors(finishes->value("tones", Json::object()), found),
          add_colors(finishes->value("substances", Json::object()), found);
    if (words) add_colors(words->value("materials", Json::object()), found);
    return found;
  }();
  return all;
}

}  // namespace

std::string program_color(const std::string& said) {
  for (std::string rest = lower(said); !rest.empty();) {
    if (shape::parse_color(rest)) return rest;
    // "oak" may stand for "wood" there: one step more.
    if (const auto tone = tones().find(rest); tone != tones().end()) {
      if (shape::parse_color(tone->second)) return tone->second;
      const auto further = tones().find(tone->second);
      if (further != tones().end() && shape::parse_color(further->second)) return further->second;
    }
    const std::size_t space = rest.find(' ');
    rest = space == std::string::npos ? "" : rest.substr(space + 1);
  }
  return said;
}

}  // namespace roomgen::book
