// What the compositions of data/compositions make, a line of JSON each: at the default values of their parameters, at
// each number's least and most and at each word's choices. bench/compositions.py draws and checks the lines.
//
//     bench_compositions [FILE...]     the built-in compositions, or those of these files
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "composition/arrange.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"

namespace {

using namespace roomgen;
using namespace roomgen::composition;

Result<Compositions> read_files(int count, char** paths) {
  Compositions all;
  for (int i = 0; i < count; ++i) {
    const auto text = read_file(paths[i]);
    if (!text) return text.error();
    const auto json = parse_json(*text, paths[i]);
    if (!json) return json.error();
    for (const auto& [name, value] : json->items()) {
      auto one = read_composition(value, name, std::string(paths[i]) + ": " + name);
      if (!one) return one.error();
      all.emplace(name, *std::move(one));
    }
  }
  return all;
}

std::vector<Values> settings(const Composition& composition) {
  std::vector<Values> all = {Values{}};
  for (const auto& parameter : composition.parameters) {
    if (parameter.choices.empty())
      for (double value : {parameter.least, parameter.most}) all.push_back({{parameter.name, value}});
    for (const auto& choice : parameter.choices) all.push_back({{parameter.name, choice}});
  }
  return all;
}

Json json_of(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::get<std::string>(value);
}

Json json_of(const Member& member, const Kind& kind) {
  Json json = {{"part", member.part},
               {"category", member.category},
               {"kinds", kind.lineage},
               {"tucks_under", kind.tucks_under},
               {"round", kind.traits.round},
               {"flat", kind.traits.flat},
               {"size", {rounded(member.size.x()), rounded(member.size.y()), rounded(member.size.z())}},
               {"position", {rounded(member.place.position.x()), rounded(member.place.position.y())}},
               {"yaw", rounded(member.place.yaw)},
               {"mount", name(member.mount)},
               {"spare", member.spare}};
  if (member.height) json["height"] = rounded(*member.height);
  if (member.mount == Mount::surface) json["on"] = member.on;
  return json;
}

bool print(const Composition& composition, const Values& values, const composition::Making& making) {
  const auto arranged = arrange(composition, values, making);
  if (!arranged)
    return std::fprintf(stderr, "%s: %s\n", composition.name.c_str(), arranged.error().message.c_str()), false;
  Json line = {{"composition", composition.name}, {"with", Json::object()}, {"for", composition.uses}};
  for (const auto& [name, value] : values) line["with"][name] = json_of(value);
  line["alternatives"] = alternatives(composition, values, {}, making)->size();
  line["members"] = Json::array();
  for (const auto& member : arranged->members)
    line["members"].push_back(json_of(member, making.kinds.get(member.category)));
  return std::puts(json_line(line).c_str()), true;
}

}  // namespace

int main(int argc, char** argv) {
  const auto all = argc > 1 ? read_files(argc - 1, argv + 1) : built_in_compositions();
  if (!all) return std::fprintf(stderr, "%s\n", all.error().message.c_str()), 1;
  const composition::Making making{*all, KindTable::built_in()};
  bool whole = true;
  for (const auto& [name, composition] : *all)
    for (const auto& values : settings(composition)) whole = print(composition, values, making) && whole;
  return whole ? 0 : 1;
}
