#pragma once

#include <string>
#include <string_view>

#include "import_mesh.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"

namespace roomgen::decode {

/// A model as bytes, to be sent to another process of this machine.
std::string bytes_of(const Model& model);

/// Reads such bytes, whoever made them: counts and indices are in range, pictures no larger and triangles no
/// more than was asked for, numbers of materials finite. (Positions may be anything: remove_degenerate().)
Result<Model> model_from(std::string_view bytes, const ImportOptions& options);

/// The same for a picture of at most so many pixels a side.
std::string bytes_of(const Image& image);
Result<Image> image_from(std::string_view bytes, int max_side);

}  // namespace roomgen::decode
