#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kinds.h"
#include "roomgen/create/maker.h"
#include "words.h"

namespace roomgen::create {

/// What a recipe is told so that it makes what a description asks for.
struct Settings {
  shape::Values values;
  Vec3 size = Vec3::Ones();  ///< width, depth, height
  /// For each part of the description, what no parameter could say.
  struct Unmet {
    bool count = false, lean = false, course = false, shape = false;
    Vec3 size = Vec3::Constant(std::nan(""));  ///< metres; NaN: said by a parameter, or not asked for
  };
  std::vector<Unmet> unmet;
  std::vector<std::string> notes;
};

/// What makes the kind as it usually is, without any wish.
shape::Values usual_values(const ShapeKind& kind, const std::vector<shape::Parameter>& parameters);

/// The kind's own settings, what the seed varies, the style's, then what the description says.
Settings choose_settings(const Description& description, const ShapeKind& kind,
                         const std::vector<shape::Parameter>& parameters, const Words& words,
                         std::uint64_t seed);

}  // namespace roomgen::create
