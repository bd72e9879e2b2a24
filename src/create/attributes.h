#pragma once

#include <optional>
#include <string>

#include "roomgen/create/maker.h"

namespace roomgen::create {

/// What adjectives say before their noun is known.
struct Attributes {
  std::optional<int> count;
  std::string shape, construction, material, color, style, direction;
  std::optional<double> lean;
  std::optional<Course> course;
  std::optional<Strength> strength;
  Vec3 scale = Vec3::Ones();
  bool article = false;  ///< "a", "the", a number: a noun is to come
  bool any = false;      ///< something beside an article was said
};

/// A number that was said of the part before stays.
void apply(const Attributes& from, PartWish& part);
/// What is said of the shape of the whole is kept as a part without a label: whatever shows most of
/// it.
void apply(const Attributes& from, Description& object);

}  // namespace roomgen::create
