#include "attribute_words.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "style_words.h"

namespace roomgen {

namespace {

constexpr std::array<std::pair<std::string_view, SizeMeasure>, 11> measure_names = {{
    {"width", SizeMeasure::width},
    {"depth", SizeMeasure::depth},
    {"height", SizeMeasure::height},
    {"longest", SizeMeasure::longest},
    {"usual width", SizeMeasure::usual_width},
    {"usual depth", SizeMeasure::usual_depth},
    {"usual height", SizeMeasure::usual_height},
    {"usual volume", SizeMeasure::usual_volume},
    {"slimness", SizeMeasure::slimness},
    {"elongation", SizeMeasure::elongation},
    {"steadiness", SizeMeasure::steadiness},
}};
constexpr std::array known_outlines = {"round", "oval", "square", "rectangular", "l-shaped"};
constexpr double most = 1000.0;
constexpr std::size_t longest_phrase = 4;

// [low, high]; null is no limit.
Interval read_range(const JsonReader& json) {
  const auto ends = json.elements(2);
  Interval range;
  if (ends.size() != 2) {
    json.report("expected [low, high], null for no limit");
    return range;
  }
  if (ends[0].exists() && !ends[0].raw()->is_null()) range.low = ends[0].number(0.0, most);
  if (ends[1].exists() && !ends[1].raw()->is_null()) range.high = ends[1].number(0.0, most);
  return range;
}

std::vector<std::string> read_words(const JsonReader& json) {
  std::vector<std::string> result;
  for (const auto& word : json.elements_or_none(200)) result.push_back(word.text(60));
  return result;
}

std::map<SizeMeasure, Interval> read_size(const JsonReader& json) {
  std::map<SizeMeasure, Interval> size;
  for (const auto& [name, range] : json.members()) {
    if (const auto measure = parse_size_measure(name)) size[*measure] = read_range(range);
    else range.report("no measure \"" + name + "\"");
  }
  return size;
}

AttributeMeaning read_meaning(const JsonReader& json) {
  json.allow_only({"colors", "lightness", "least_colors", "materials", "family", "outlines", "sizes",
                   "most_colors", "roughness", "drawings", "mounts", "kinds", "kinds_of_its_color", "said", "parts",
                   "ways"});
  AttributeMeaning meaning;
  meaning.colors = read_words(json["colors"]);
  if (json["lightness"].exists()) meaning.lightness = read_range(json["lightness"]);
  if (json["least_colors"].exists())
    meaning.least_colors = static_cast<int>(json["least_colors"].integer_or(2, 1, 12));
  if (json["most_colors"].exists())
    meaning.most_colors = static_cast<int>(json["most_colors"].integer_or(2, 1, 12));
  meaning.materials = read_words(json["materials"]);
  meaning.family = json["family"].text_or("", 60);
  meaning.outlines = read_words(json["outlines"]);
  for (const auto& outline : meaning.outlines)
    if (std::find(known_outlines.begin(), known_outlines.end(), outline) == known_outlines.end())
      json["outlines"].report("no outline \"" + outline + "\"");
  for (const auto& size : json["sizes"].elements_or_none(8)) meaning.sizes.push_back(read_size(size));
  if (json["roughness"].exists()) meaning.roughness = read_range(json["roughness"]);
  for (const auto& mount : json["mounts"].elements_or_none(4)) {
    if (const auto known = parse_mount(mount.text(20))) meaning.mounts.push_back(*known);
    else mount.report("expected floor, wall, ceiling or surface");
  }
  meaning.drawings = read_words(json["drawings"]);
  meaning.kinds = read_words(json["kinds"]);
  meaning.kinds_of_its_color = read_words(json["kinds_of_its_color"]);
  meaning.said = read_words(json["said"]);
  for (const auto& part : json["parts"].elements_or_none(8)) {
    auto& counts = meaning.parts.emplace_back();
    for (const auto& [label, range] : part.members()) counts[label] = read_range(range);
  }
  meaning.ways = read_words(json["ways"]);
  return meaning;
}

// "drawers", "six drawer", "#door" only as "double door": the part alone, and behind each number. A name of several
// parts means any of them.
std::map<std::string, AttributeMeaning, std::less<>> part_phrases(const JsonReader& parts, const JsonReader& counts) {
  std::map<std::string, AttributeMeaning, std::less<>> phrases;
  if (!parts.exists() || !counts.exists()) return phrases;
  for (const auto& [label, names] : parts.members())
    for (auto name : read_words(names)) {
      if (name.starts_with('#')) name.erase(0, 1);
      else phrases[name].parts.push_back({{label, Interval{1.0}}});
      for (const auto& [word, count] : counts.members()) {
        phrases[word + " " + name].parts.push_back({{label, read_range(count)}});
      }
    }
  return phrases;
}

}  // namespace

std::optional<SizeMeasure> parse_size_measure(std::string_view text) {
  for (const auto& [name, measure] : measure_names)
    if (name == text) return measure;
  return std::nullopt;
}

Result<AttributeWords> AttributeWords::parse(std::string_view text, const std::string& source) {
  const auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "says_nothing", "attributes", "parts", "counts", "demands", "needs"});
  AttributeWords result;
  for (const auto& word : read_words(root["says_nothing"])) result.empty_words_[word] = true;
  std::vector<std::pair<std::string, JsonReader>> synonyms;
  for (const auto& [word, meaning] : root["attributes"].members()) {
    if (meaning.is_string()) synonyms.emplace_back(word, meaning);
    else result.meanings_[word] = read_meaning(meaning);
  }
  for (const auto& [word, other] : synonyms) {
    const auto found = result.meanings_.find(other.text(60));
    if (found == result.meanings_.end()) other.report("no attribute \"" + other.text(60) + "\"");
    else result.meanings_[word] = AttributeMeaning(found->second);
  }
  // What is said of a phrase itself goes before.
  result.meanings_.merge(part_phrases(root["parts"], root["counts"]));
  result.demands_ = read_words(root["demands"]);
  if (root["needs"].exists())
    for (const auto& [kind, phrase] : root["needs"].members()) {
      result.needs_[kind] = phrase.text(60);
      if (!result.find(result.needs_[kind])) phrase.report("is no attribute");
    }
  if (problems.first()) return *problems.first();
  return result;
}

const AttributeWords& AttributeWords::built_in() {
  static const AttributeWords words = [] {
    auto parsed = parse(resource("data/evaluate/attributes.json").value_or("{}"),
                        "data/evaluate/attributes.json");
    if (!parsed) return AttributeWords();  // a test parses the file
    // What can be painted can be judged; words that are styles too are judged as such.
    for (auto& [word, meaning] : finish_meanings())
      if (!StyleWords::built_in().find(word)) parsed->meanings_.try_emplace(word, std::move(meaning));
    return *std::move(parsed);
  }();
  return words;
}

bool is_made_so(const Making& making, const AttributeMeaning& meaning) {
  const bool is_built = std::any_of(making.ways.begin(), making.ways.end(), [&](const auto& way) {
    return std::find(meaning.ways.begin(), meaning.ways.end(), way.second) != meaning.ways.end();
  });
  const auto number = [&](const std::string& label) {
    const auto found = making.parts.find(label);
    return found == making.parts.end() ? 0 : found->second;
  };
  const auto has_parts = [&](const std::map<std::string, Interval>& counts) {
    return std::all_of(counts.begin(), counts.end(),
                       [&](const auto& entry) { return entry.second.contains(number(entry.first)); });
  };
  return is_built || (making.known() && std::any_of(meaning.parts.begin(), meaning.parts.end(), has_parts));
}

const AttributeMeaning* AttributeWords::find(std::string_view phrase) const {
  const auto found = meanings_.find(phrase);
  return found == meanings_.end() ? nullptr : &found->second;
}

bool AttributeWords::is_demand(const AttributeMeaning& meaning) const {
  return std::any_of(meaning.parts.begin(), meaning.parts.end(), [&](const auto& counts) {
    return std::find(demands_.begin(), demands_.end(), counts.begin()->first) != demands_.end();
  });
}

std::string AttributeWords::need_of(std::string_view kind) const {
  const auto found = needs_.find(kind);
  return found == needs_.end() ? std::string() : found->second;
}

std::vector<std::string> AttributeWords::phrases(const std::vector<std::string>& words) const {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < words.size();) {
    std::size_t count = std::min(longest_phrase, words.size() - i);
    const auto text = [&] {
      const auto from = words.begin() + static_cast<std::ptrdiff_t>(i);
      return join({from, from + static_cast<std::ptrdiff_t>(count)}, " ");
    };
    while (count > 1 && !find(text()) && !StyleWords::built_in().find(text())) --count;
    result.push_back(text());
    i += count;
  }
  return result;
}

bool AttributeWords::says_nothing(std::string_view word) const {
  return empty_words_.find(word) != empty_words_.end();
}

}  // namespace roomgen
