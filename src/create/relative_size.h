#pragma once

#include <optional>
#include <string>

#include "kinds.h"
#include "roomgen/create/maker.h"

namespace roomgen::create {

/// What a sentence says of a size without a measure (data/create/relative_sizes.json).
struct RelativeSize {
  std::optional<double> height;   ///< metres: "knee height", "taller than a child"
  Vec3 factor = Vec3::Ones();     ///< against the usual: "twice as wide", "half the normal height"
  std::optional<int> people;      ///< "for ten", "six-seater"

  bool empty() const { return !height && factor == Vec3::Ones() && !people; }
};

/// Words about a part ("a waist-high back") say nothing of the whole.
RelativeSize read_relative_size(const std::string& prompt);

/// The description's lengths, and those that its words give by comparison with the kind's usual ones;
/// NaN: not said. Measures in numbers go first. Nothing is said: nullopt. `kind` may be null.
std::optional<Vec3> said_size(const Description& description, const ShapeKind* kind);

}  // namespace roomgen::create
