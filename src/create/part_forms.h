#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "words.h"

namespace roomgen::create {

/// What a part looks like and where it stands when no recipe says it.
struct PartForm {
  std::string form;  ///< a name in PartForms::forms
  Place place = Place::top;
  Vec3 size = Vec3::Constant(0.2);  ///< shares of the whole's width, depth, height
  std::string same;                 ///< sides that are equal: "xy", "xyz"; the least of them counts
  int count = 1;                    ///< unless told
  bool spread = false;              ///< outward parts at many heights instead of one
  std::string material;             ///< a material's or colour's name; empty: the whole's
  bool known = true;                ///< false: nothing is known of such a part
};

/// The parts of data/create/parts.json.
struct PartForms {
  WordMap<PartForm> parts;  ///< by label
  /// Any spelling to the labels that it may mean, the likeliest first: "arms" to "arm", "armrest".
  WordMap<std::vector<std::string>> labels;
  WordMap<std::string> shapes;  ///< a shape's word to the form that has it: "spherical" to "ball"
  WordMap<Json> forms;          ///< recipes that fill the box of their width, depth and height

  /// Of a part of which nothing is known, its place follows from how many there are.
  PartForm of(std::string_view label, int count) const;
};

const Result<PartForms>& built_in_parts();

}  // namespace roomgen::create
