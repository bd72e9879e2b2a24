#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/create/description.h"
#include "roomgen/shape/program.h"

namespace roomgen::create {

template <typename T>
using WordMap = std::map<std::string, T, std::less<>>;

using WordSet = std::set<std::string, std::less<>>;

/// The words of data/create/words.json.
struct Words {
  WordMap<std::string> shapes, constructions, styles;
  WordMap<double> leans;
  WordMap<Course> courses;
  WordMap<Strength> strengths;
  WordMap<Vec3> scales;
  WordMap<shape::Surface> materials;
  WordMap<Vec3> comparatives;  ///< "taller": factors against what it was
  WordMap<std::string> parts;  ///< any spelling to the label: "legs" to "leg"
  WordSet directions, far_things, beings, no_objects;
  WordSet negations;   ///< "without"
  WordSet boundaries;  ///< end a noun phrase; what was said before belongs to the noun before
  WordSet fillers;     ///< say nothing by themselves
  WordSet orders;      ///< verbs with which no description begins
  WordSet rooms, distances;
  /// "around it": how what was named before stands to the first thing; the longest of several first.
  std::vector<std::pair<std::vector<std::string>, std::string>> relations;
};

const Result<Words>& built_in_words();

}  // namespace roomgen::create
