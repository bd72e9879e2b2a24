#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <string_view>

#include "roomgen/scene/scene.h"

namespace roomgen {

/// A calm colour for things of one category, sRGB 0 to 255; the same for the same word.
Eigen::Vector3f category_color(std::string_view category);

/// What stands for an object without a mesh: a box (a cylinder if it is round) of exactly its size
/// in its category's colour; a darker band marks the front.
Model box_model(const Object& object);

/// The object's model from the table, or its box; never null.
std::shared_ptr<const Model> model_or_box(const Object& object, const ModelTable& models);
/// Objects of one key have one geometry: asset_key(), or for a box its category, size and traits.
std::string model_key(const Object& object, const ModelTable& models);

}  // namespace roomgen
