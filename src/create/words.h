#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/create/description.h"
#include "roomgen/shape/program.h"

namespace roomgen::create {

template <typename T>
using WordMap = std::map<std::string, T, std::less<>>;

/// The words of data/create/words.json.
struct Words {
  WordMap<std::string> shapes, constructions, styles;
  WordMap<double> leans;
  WordMap<Course> courses;
  WordMap<Strength> strengths;
  WordMap<Vec3> scales;
  WordMap<shape::Surface> materials;
  WordMap<std::string> parts;  ///< any spelling to the label: "legs" to "leg"
  std::set<std::string, std::less<>> directions, far_things, beings, no_objects;
};

const Result<Words>& built_in_words();

}  // namespace roomgen::create
