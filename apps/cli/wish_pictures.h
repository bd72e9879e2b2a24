#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "designers.h"

namespace roomgen::cli {

/// Adds --image.
CLI::Option* add_image_option(CLI::App& command, std::vector<std::string>& files);

/// PlanRequest::pictures of PNG and JPEG files, as a model is shown them: at most 1024 pixels a
/// side. A file of more than 30 MB or, by its header, 40 megapixels is refused.
Result<std::vector<std::string>> read_wish_pictures(const std::vector<std::string>& files,
                                                    const DesignerOptions& options);

}  // namespace roomgen::cli
