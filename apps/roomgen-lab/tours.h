#pragma once

#include <string>

#include "roomgen/base/result.h"
#include "roomgen/lab/tour.h"

namespace roomgen::cli {

/// "640x480"
Status read_picture_size(const std::string& text, int& width, int& height);

/// The tour.json of a folder, whose targets must be objects of the scene.
Result<lab::Tour> read_tour(const std::string& folder, const Scene& scene);

}  // namespace roomgen::cli
