#include "library/style_words.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr const char* styles_path = "data/styles.json";
constexpr std::size_t longest_style = 3;  // words

std::vector<std::string> read_names(const JsonReader& json) {
  std::vector<std::string> names;
  for (const auto& name : json.elements_or_none(60)) names.push_back(name.text(80));
  return names;
}

StyleWords::Groups read_groups(const JsonReader& json) {
  StyleWords::Groups groups;
  for (const auto& kinds : json.elements_or_none(20)) groups.push_back(read_names(kinds));
  return groups;
}

StyleMeaning read_style_meaning(const std::string& name, const JsonReader& json) {
  json.allow_only({"names", "walls", "floors", "accents", "looks", "more", "fewer", "sheen", "colors", "materials"});
  StyleMeaning style;
  style.name = name;
  style.walls = read_names(json["walls"]);
  style.floors = read_names(json["floors"]);
  style.accents = read_names(json["accents"]);
  for (const auto& look : json["looks"].elements()) {
    look.allow_only({"kinds", "words"});
    style.looks.push_back({read_names(look["kinds"]), read_names(look["words"])});
    if (style.looks.back().words.empty()) look["words"].report("expected words");
  }
  style.more = read_names(json["more"]);
  style.fewer = read_names(json["fewer"]);
  style.sheen = json["sheen"].text_or("", 40);
  style.colors = read_names(json["colors"]);
  style.materials = read_names(json["materials"]);
  return style;
}

std::string spelled(std::string_view name) { return join(words(name), " "); }

}  // namespace

Result<StyleWords> StyleWords::parse(std::string_view text, const std::string& source) {
  const auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "styles", "palette"});
  StyleWords result;
  root["palette"].allow_only({"colors", "walls", "woods", "stuffs"});
  result.worn_by_colors_ = read_groups(root["palette"]["colors"]);
  for (const auto& [color, walls] : root["palette"]["walls"].members()) result.walls_by_color_[color] = walls.text();
  result.worn_by_woods_ = read_groups(root["palette"]["woods"]);
  for (const auto& stuff : root["palette"]["stuffs"].elements_or_none(20))
    for (const auto& word : read_names(stuff["words"]))
      result.worn_by_stuffs_[word] = read_groups(stuff["kinds"]);
  for (const auto& [name, entry] : root["styles"].members()) {
    result.styles_[name] = read_style_meaning(name, entry);
    result.names_[spelled(name)] = name;
    for (const auto& other : read_names(entry["names"]))
      if (!result.names_.emplace(spelled(other), name).second)
        entry["names"].report("\"" + other + "\" is another style's name too");
  }
  if (problems.first()) return *problems.first();
  return result;
}

const StyleWords& StyleWords::built_in() {
  static const StyleWords styles = [] {
    auto parsed = parse(resource(styles_path).value_or("{}"), styles_path);
    return parsed ? *std::move(parsed) : StyleWords();  // a test parses the file
  }();
  return styles;
}

const StyleMeaning* StyleWords::find(std::string_view word) const {
  const auto name = names_.find(spelled(word));
  return name == names_.end() ? nullptr : &styles_.at(name->second);
}

std::string StyleWords::walls_with(const std::string& color) const {
  const auto found = walls_by_color_.find(color);
  if (found != walls_by_color_.end()) return found->second;
  const auto any = walls_by_color_.find("any");
  return any == walls_by_color_.end() ? "" : any->second + " " + color + " walls";
}

const StyleWords::Groups* StyleWords::worn_by_stuff(std::string_view word) const {
  const auto found = worn_by_stuffs_.find(word);
  return found == worn_by_stuffs_.end() ? nullptr : &found->second;
}

const StyleMeaning* StyleWords::named_in(std::string_view text) const {
  const auto all = words(text);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t count = std::min(longest_style, all.size() - i); count > 0; --count) {
      const auto from = all.begin() + static_cast<std::ptrdiff_t>(i);
      const auto* style = find(join({from, from + static_cast<std::ptrdiff_t>(count)}, " "));
      if (style) return style;
    }
  return nullptr;
}

}  // namespace roomgen
