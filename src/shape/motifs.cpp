#include "motifs.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/json_values.h"
#include "base/resource.h"
#include "roomgen/base/text.h"
#include "roomgen/shape/program.h"

namespace roomgen::shape {

namespace {

constexpr std::size_t longest_name = 4;  // words

struct MotifTable {
  std::map<std::string, Motif, std::less<>> motifs;
  std::map<std::string, std::vector<std::string>, std::less<>> palettes;
  std::map<std::string, std::string> motif_of, palette_of, text_of;  ///< by what people call them
  std::set<std::string, std::less<>> says, shows;  ///< words before letters, before pictures
  std::set<std::string, std::less<>> tints;        ///< motifs that may name but a colour
};

std::string in_singular(std::string_view text) {
  auto pieces = words(text);
  for (auto& piece : pieces) piece = singular(piece);
  return join(pieces, " ");
}

void add_names(const Json& json, std::map<std::string, std::string>& names) {
  const auto name = json["name"].get<std::string>();
  names.emplace(in_singular(name), name);
  for (const auto& other : json["words"])
    names.emplace(in_singular(other.get<std::string>()), name);
}

const MotifTable& motif_table() {
  static const MotifTable built_in = [] {
    static const Json file = json_literal(*resource("data/motifs.json"));
    MotifTable result;
    for (const auto& json : file["motifs"]) {
      const auto name = json["name"].get<std::string>();
      result.motifs[name] = {name, !json.value("fixed", false), &json};
      add_names(json, result.motif_of);
    }
    for (const auto& phrase : file["no_motifs"])
      result.motif_of[in_singular(phrase.get<std::string>())];
    for (const auto& json : file["texts"])
      for (const auto& phrase : json["words"])
        result.text_of.emplace(in_singular(phrase.get<std::string>()),
                               json["text"].get<std::string>());
    result.says = file["says"].get<std::set<std::string, std::less<>>>();
    result.shows = file["shows"].get<std::set<std::string, std::less<>>>();
    result.tints = file["tints"].get<std::set<std::string, std::less<>>>();
    for (const auto& json : file["palettes"]) {
      result.palettes[json["name"]] = json["colors"].get<std::vector<std::string>>();
      add_names(json, result.palette_of);
    }
    return result;
  }();
  return built_in;
}

// What the words call by one of these names, the longest names first.
std::vector<std::string> names_said(std::string_view text,
                                    const std::map<std::string, std::string>& names) {
  const auto pieces = words(in_singular(text));
  std::vector<std::string> result;
  for (std::size_t from = 0; from < pieces.size();) {
    std::size_t count = std::min(longest_name, pieces.size() - from);
    for (; count > 0; --count) {
      const auto found = names.find(join({pieces.begin() + static_cast<long>(from),
                                          pieces.begin() + static_cast<long>(from + count)},
                                         " "));
      if (found == names.end()) continue;
      if (!found->second.empty() &&
          std::find(result.begin(), result.end(), found->second) == result.end())
        result.push_back(found->second);
      break;
    }
    from += std::max<std::size_t>(count, 1);
  }
  return result;
}

}  // namespace

Json figure_of(const Motif& motif) {
  constexpr double reach = 0.12, most_side = 1.1;
  static constexpr const char* lines[] = {"polygon", "curve", "line"};
  const auto is_out = [](const Json& point) {
    return std::any_of(point.begin(), point.end(), [](const Json& one) {
      return one.is_number() && (one < -reach || one > 1.0 + reach);
    });
  };
  const auto is_backdrop = [&](const Json& shape) {
    if (const auto sides = shape.find("rectangle"); sides != shape.end())
      return std::any_of(sides->begin(), sides->end(),
                         [](const Json& side) { return side.is_number() && side > most_side; });
    return !shape.contains("at") &&
           std::any_of(std::begin(lines), std::end(lines), [&](const char* line) {
             const auto points = shape.find(line);
             return points != shape.end() && std::any_of(points->begin(), points->end(), is_out);
           });
  };
  const Json& all = (*motif.drawing)["shapes"];
  Json figure = Json::array();
  for (const auto& shape : all)
    if (!is_backdrop(shape)) figure.push_back(shape);
  return 2 * figure.size() > all.size() ? figure : all;
}

const Motif* find_motif(std::string_view name) {
  const auto found = motif_table().motifs.find(name);
  return found == motif_table().motifs.end() ? nullptr : &found->second;
}

std::vector<std::string> motif_names() {
  std::vector<std::string> names;
  for (const auto& [name, ignored] : motif_table().motifs) names.push_back(name);
  return names;
}

std::vector<std::string> motifs_in(std::string_view words) {
  return names_said(words, motif_table().motif_of);
}

std::vector<std::string> motifs_on_cloth(std::string_view text) {
  const auto said = words(text);
  auto motifs = motifs_in(text);
  if (std::none_of(said.begin(), said.end(),
                   [](const std::string& word) { return motif_table().shows.count(word) > 0; }))
    std::erase_if(motifs,
                  [](const std::string& motif) { return motif_table().tints.count(motif) > 0; });
  return motifs;
}

bool says_letters(std::string_view word) {
  return motif_table().says.count(word) > 0;
}

std::string palette_in(std::string_view words) {
  const auto found = names_said(words, motif_table().palette_of);
  return found.empty() ? "" : found.front();
}

std::string text_in(std::string_view words) {
  const auto found = names_said(words, motif_table().text_of);
  return found.empty() ? "" : found.front();
}

const std::vector<std::string>* find_palette(std::string_view name) {
  const auto found = motif_table().palettes.find(name);
  return found == motif_table().palettes.end() ? nullptr : &found->second;
}

}  // namespace roomgen::shape
