#pragma once

#include <filesystem>
#include <string>

#include "roomgen/base/result.h"
#include "roomgen/generate/generate.h"
#include "roomgen/scene/plan.h"

namespace roomgen {

/// Makes `folder` ready for a room's files: creates it, or accepts it when it is empty or holds an
/// earlier output of ours. Anything else is refused unless `force` is set; nothing is deleted.
Status prepare_output_folder(const std::filesystem::path& folder, bool force);

/// A short folder name for a prompt: "a-cosy-bedroom-for-two".
std::string folder_name(const std::string& prompt);

/// scene.json, plan.json and trace.jsonl of a finished (or interrupted) generation; `plan` is that
/// of a room or of a dwelling.
Status write_documents(const std::filesystem::path& folder, const Json& plan,
                       const Generation& generation);

}  // namespace roomgen
