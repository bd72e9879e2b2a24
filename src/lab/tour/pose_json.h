#pragma once

#include "base/json_reader.h"
#include "roomgen/lab/tour.h"

namespace roomgen::lab::detail {

/// position, yaw_deg and pitch_deg of an object of JSON.
void add_pose(Json& json, const CameraPose& pose);
CameraPose pose_from_json(const JsonReader& reader);

}  // namespace roomgen::lab::detail
