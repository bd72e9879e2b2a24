#pragma once

#include <filesystem>
#include <string>

#include "roomgen/base/file.h"
#include "roomgen/base/result.h"
#include "roomgen/generate/generate.h"
#include "roomgen/scene/plan.h"

namespace roomgen {

/// A folder for a room's files. One that is empty or holds an earlier output of ours is taken; anything else
/// is refused unless `force` is set. An earlier room goes when the new one is committed, what else is in the
/// folder stays.
Result<OutputFolder> open_room_folder(const std::filesystem::path& folder, bool force);

/// Does scene.json of this name hold a scene that is not marked as incomplete? A stopped run leaves it there.
bool holds_whole_scene(const std::filesystem::path& scene_file);

/// A short folder name for a prompt: "a-cosy-bedroom-for-two".
std::string folder_name(const std::string& prompt);

/// scene.json, plan.json and trace.jsonl of a finished (or interrupted) generation; `plan` is that
/// of a room or of a dwelling.
Status write_documents(const OutputFolder& folder, const Json& plan, const Generation& generation);

}  // namespace roomgen
