#pragma once

#include "chat/interview.h"
#include "roomgen/base/result.h"
#include "roomgen/create/maker.h"
#include "roomgen/shape/evaluate.h"

namespace roomgen::create {

/// The objects of a decomposition. What cannot be meant is left out or bounded, and said; an error
/// is what to tell the model. `prompt`: the whole sentence; `kinds`: those that an answer may name.
Result<Reading<std::vector<Description>>> read_decompose_reply(
    const std::string& text, const std::string& prompt, const std::vector<std::string>& kinds);

/// The concrete program of an answer, which may be a recipe. It was tried: it makes bodies of a
/// size that furniture has. An error is what to tell the model, with the JSON pointer where there
/// is one; the complaint says where the program is not what was described.
Result<Reading<shape::Program>> read_program_reply(const std::string& text,
                                                   const Description& wanted, std::uint64_t seed);

inline constexpr std::size_t max_reply_triangles = 20'000;

/// {"vertices": [[x, y, z]], "triangles": [[a, b, c]], "parts": [{"label", "first", "count",
/// "color"}]} as a shape of one body a part. Nothing is made of triangles that are not there:
/// bodies may be open, which the repairs say. An error is what to tell the model, with the JSON
/// pointer.
Result<Reading<shape::Shape>> read_mesh_reply(const std::string& text, const std::string& noun);

/// {"passes": true, "reason": "a chair"}. An error is what to tell the model.
Result<Reading<Verdict>> read_verdict_reply(const std::string& text);

/// Is it as large as things in rooms are? The error says how large it is.
Status check_extent(const shape::Shape& shape);

}  // namespace roomgen::create
