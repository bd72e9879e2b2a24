#pragma once

#include <string>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/lab/frames.h"
#include "roomgen/view/view.h"

namespace roomgen::lab::detail {

/// Pixels and box of each object, in the scene's order.
std::vector<SeenObject> seen_objects(const Layers& layers, std::size_t objects);

/// The masks of the seen objects as COCO's run lengths, column by column: [{"value", "counts"}].
Json run_lengths(const Layers& layers, const std::vector<SeenObject>& seen);

/// What is known of a frame when all are put together.
struct FrameLabels {
  FrameRecord record;
  Json runs;
};

/// One COCO file of all frames (cocodataset.org, object detection; masks as uncompressed run lengths).
Json coco_json(const Scene& scene, const std::vector<FrameLabels>& frames);

/// A frame's objects as lines like those of KITTI's object benchmark (Geiger et al. 2012).
std::string kitti_text(const Scene& scene, const FrameRecord& record, const Camera& camera);

}  // namespace roomgen::lab::detail
