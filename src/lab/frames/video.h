#pragma once

#include <filesystem>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen::lab::detail {

/// JPEG pictures as an MP4 (H.264), encoded by the system's ffmpeg through a pipe. Fails with
/// Error::Kind::unavailable where there is none.
Status write_video(const std::filesystem::path& path, const std::vector<std::filesystem::path>& pictures,
                   double per_second);

}  // namespace roomgen::lab::detail
