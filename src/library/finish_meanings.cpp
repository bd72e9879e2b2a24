#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "attribute_words.h"
#include "base/json_reader.h"
#include "base/resource.h"
#include "roomgen/base/json.h"
#include "shape/color.h"
#include "shown_colors.h"

namespace roomgen {

namespace {

constexpr double lightness_tolerance = 0.2;
constexpr double matte_from = 0.45;  // roughness
// A colour keeps its word in a little less and a little more light.
constexpr float dimmed = 0.85f, lit = 1.15f;

const std::vector<std::string> any_color = {"white", "grey",   "black", "brown", "beige",  "red",
                                            "orange", "yellow", "green", "blue",  "purple", "pink"};

void add_new(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

void be_near(const shape::Rgb& rgb, AttributeMeaning& meaning) {
  const auto component = [&](std::size_t i, float light) {
    return std::min(255.0f, light * static_cast<float>(rgb[i]));
  };
  for (const float light : {1.0f, dimmed, lit})
    add_new(meaning.colors, color_name(component(0, light), component(1, light), component(2, light)));
  const double middle = lightness({component(0, 1.0f), component(1, 1.0f), component(2, 1.0f)});
  meaning.lightness = Interval{middle - lightness_tolerance, middle + lightness_tolerance};
}

class FinishMeanings {
 public:
  FinishMeanings(const JsonReader& finishes, const JsonReader& words) : finishes_(finishes), words_(words) {}

  std::map<std::string, AttributeMeaning, std::less<>> read() {
    for (const auto& [word, tone] : finishes_["tones"].members())
      if (const auto rgb = shape::parse_color(tone.text())) be_near(*rgb, meanings_[word]);
    for (const auto& [word, gloss] : finishes_["gloss"].members()) {
      const double roughness = gloss.number(0.0, 1.0);
      if (roughness > matte_from) meanings_[word].roughness = Interval{matte_from};
      else meanings_[word].roughness = Interval{0.0, matte_from};
    }
    for (const auto& [word, pattern] : finishes_["patterns"].members()) meanings_[word].drawings = {word};
    for (const auto& [word, shade] : finishes_["shades"].members()) {
      meanings_[word].materials = {word};
      meanings_[word].colors = any_color;
    }
    for (const auto& [stuff, entry] : finishes_["stuffs"].members())
      for (const auto& substance : entry["substances"].elements()) read_substance(substance.text(), stuff);
    return std::move(meanings_);
  }

 private:
  // What is woven or cast comes in all colours; wood, metal and stone in their own.
  void read_substance(const std::string& word, const std::string& stuff) {
    AttributeMeaning meaning;
    meaning.materials = {word};
    const auto rgb = stuff == "wood" || stuff == "metal" ? own_color(word) : std::nullopt;
    if (rgb) be_near(*rgb, meaning);
    else meaning.colors = any_color;
    if (rgb && word != stuff) meaning.family = stuff;
    meanings_[word] = std::move(meaning);
  }

  std::optional<shape::Rgb> own_color(const std::string& word) const {
    for (const auto& table : {words_["materials"], finishes_["substances"]}) {
      const JsonReader entry = table[word];
      if (!entry.exists()) continue;
      return entry.is_string() ? own_color(entry.text()) : shape::parse_color(entry["color"].text());
    }
    return std::nullopt;
  }

  const JsonReader finishes_, words_;
  std::map<std::string, AttributeMeaning, std::less<>> meanings_;
};

}  // namespace

std::map<std::string, AttributeMeaning, std::less<>> finish_meanings() {
  const auto finishes = parse_json(resource("data/finishes.json").value_or("{}"), "data/finishes.json");
  const auto words = parse_json(resource("data/create/words.json").value_or("{}"), "data/create/words.json");
  if (!finishes || !words) return {};
  JsonReader::Problems problems("");
  return FinishMeanings({*finishes, problems}, {*words, problems}).read();
}

}  // namespace roomgen
