#pragma once

#include <string>

#include "chat/interview.h"
#include "roomgen/shape/evaluate.h"

namespace roomgen::create {

inline constexpr std::size_t max_reply_triangles = 20'000;

/// {"vertices": [[x, y, z]], "triangles": [[a, b, c]], "parts": [{"label", "first", "count",
/// "color"}]} as a shape of one body a part. Nothing is made of triangles that are not there:
/// bodies may be open, which the repairs say. An error is what to tell the model, with the JSON
/// pointer.
Result<Reading<shape::Shape>> read_mesh_reply(const std::string& text, const std::string& noun);

}  // namespace roomgen::create
