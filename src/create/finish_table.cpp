#include "finish_table.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/shape/program.h"
#include "shape/color.h"

namespace roomgen::create {

namespace {

constexpr const char* finish_path = "data/finishes.json";

Tone tone_of(const shape::Rgb& color) {
  return {static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2])};
}

class FinishTableReader {
 public:
  FinishTableReader(const Json& json, JsonReader::Problems& problems) : root_(json, problems) {}

  FinishTable read() {
    root_.allow_only({"about", "tones", "shades", "gloss", "patterns", "substances", "stuffs", "untouched",
                      "made_of", "parts"});
    for (const auto& [word, tone] : root_["tones"].members()) table_.tones[word] = read_tone(tone);
    for (const auto& [word, shade] : root_["shades"].members())
      table_.shades[word] = {read_tone(shade["towards"]), shade["by"].number(0.0, 1.0)};
    for (const auto& [word, gloss] : root_["gloss"].members()) table_.gloss[word] = gloss.number(0.0, 1.0);
    for (const auto& [word, pattern] : root_["patterns"].members()) table_.patterns[word] = read_pattern(pattern);
    read_substances();
    for (const auto& [stuff, entry] : root_["stuffs"].members()) read_stuff(stuff, entry);
    for (const auto& stuff : root_["untouched"].elements()) table_.untouched.insert(known_stuff(stuff));
    for (const auto& [part, stuff] : root_["parts"].members()) table_.parts[part] = known_stuff(stuff);
    for (const auto& entry : root_["made_of"].elements()) read_made_of(entry);
    return std::move(table_);
  }

 private:
  static Tone read_tone(const JsonReader& json) {
    const auto color = shape::parse_color(json.text());
    if (!color) json.report("is no colour; write \"#rrggbb\"");
    return tone_of(color.value_or(shape::Rgb{}));
  }

  static PaintedPattern read_pattern(const JsonReader& json) {
    json.allow_only({"paint", "first", "second", "scale"});
    PaintedPattern pattern;
    pattern.paint = json["paint"].text();
    const auto names = shape::pattern_names();
    const bool is_known = std::find(names.begin(), names.end(), pattern.paint) != names.end() ||
                          parse_texture_pattern(pattern.paint);
    if (!is_known) json["paint"].report("no pattern \"" + pattern.paint + "\"");
    if (json["first"].exists()) pattern.first = read_tone(json["first"]);
    if (json["second"].exists()) pattern.second = read_tone(json["second"]);
    pattern.scale = json["scale"].number_or(1.0, 0.05, 20.0);
    return pattern;
  }

  // The others stand in the words of descriptions.
  void read_substances() {
    if (built_in_words()) table_.substances = built_in_words()->materials;
    std::vector<std::pair<std::string, JsonReader>> same;
    for (const auto& [word, entry] : root_["substances"].members()) {
      if (entry.is_string()) same.emplace_back(word, entry);
      else table_.substances[word] = read_substance(word, entry);
    }
    for (const auto& [word, entry] : same) {
      const auto other = table_.substances.find(entry.text());
      if (other == table_.substances.end()) entry.report("no substance \"" + entry.text() + "\"");
      else table_.substances[word] = shape::Surface(other->second);
    }
  }

  void read_stuff(const std::string& stuff, const JsonReader& json) {
    json.allow_only({"substances", "surfaces"});
    known_.insert(stuff);
    for (const auto& substance : json["substances"].elements()) {
      if (!table_.substances.count(substance.text())) substance.report("no substance \"" + substance.text() + "\"");
      table_.stuffs[substance.text()] = stuff;
    }
    for (const auto& surface : json["surfaces"].elements()) table_.surfaces[surface.text()] = stuff;
  }

  std::string known_stuff(const JsonReader& json) const {
    if (!known_.count(json.text())) json.report("no stuff \"" + json.text() + "\"");
    return json.text();
  }

  void read_made_of(const JsonReader& json) {
    json.allow_only({"kinds", "main"});
    auto& [kinds, main] = table_.made_of.emplace_back();
    for (const auto& kind : json["kinds"].elements()) kinds.push_back(kind.text());
    main = json["main"].text().empty() ? std::string() : known_stuff(json["main"]);
  }

  JsonReader root_;
  FinishTable table_;
  WordSet known_;
};

}  // namespace

const std::string& FinishTable::main_stuff(std::string_view kind) const {
  static const std::string none, anything = "wood";
  for (const auto& [kinds, main] : made_of)
    if (KindTable::built_in().is_any_of(kind, kinds)) return main;
  return made_of.empty() ? none : anything;
}

Result<FinishTable> parse_finish_table(std::string_view text, const std::string& source) {
  const auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  FinishTable table = FinishTableReader(*json, problems).read();
  if (problems.first()) return *problems.first();
  return table;
}

const FinishTable& finish_table() {
  static const FinishTable table = [] {
    auto parsed = parse_finish_table(resource(finish_path).value_or("{}"), finish_path);
    return parsed ? *std::move(parsed) : FinishTable();  // a test parses the file
  }();
  return table;
}

}  // namespace roomgen::create
