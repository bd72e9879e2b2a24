#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/lab/tour.h"

namespace roomgen::lab {

/// A picture of a tour, at one of its keyframes.
struct TourFrame {
  std::size_t number = 0;    ///< counted from 0
  std::size_t keyframe = 0;
  double time = 0.0;         ///< seconds
  CameraPose pose;
  std::string target;        ///< of the view that is reached here; empty: none
};

/// The keyframes that become frames: of each part of a second the first, and all at which a view is reached. Fails
/// unless `per_second` is 0.1 to 120.
Result<std::vector<TourFrame>> frames_of(const Tour& tour, double per_second);

/// Pixels from the upper left corner of the picture; right and bottom are one past the last.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// What a frame shows of an object.
struct SeenObject {
  std::string id;
  std::size_t pixels = 0;  ///< 0: it is not seen, and the box is empty
  PixelBox box;            ///< around them
};

/// A frame and what it shows, as frames.jsonl has it (docs/frames.md).
struct FrameRecord {
  TourFrame frame;
  int width = 0, height = 0;
  std::string picture;  ///< file of the RGB picture, relative to the folder of frames.jsonl; empty: there is none
  std::vector<SeenObject> objects;
};

/// A line of frames.jsonl: `camera` is that of the frame, `files` are the names by layer.
Json to_json(const FrameRecord& record, const Scene& scene, const Camera& camera, const Json& files);

/// frames.jsonl as a whole. The error names the line.
Result<std::vector<FrameRecord>> read_frames(const std::filesystem::path& path);

}  // namespace roomgen::lab
