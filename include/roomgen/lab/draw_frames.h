#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/lab/tour.h"
#include "roomgen/scene/scene.h"
#include "roomgen/view/view.h"

namespace roomgen::lab {

/// A scene from above with the way of a tour on it, where its views are, numbered from 1, and where they look.
Result<Image> tour_picture(Renderer& renderer, const Scene& scene, const ModelTable& models,
                           const Tour& tour, int pixels = 1024);

/// How the frames of a tour are drawn (docs/frames.md).
struct FrameOptions {
  int width = 640, height = 480;  ///< what they show from side to side is the tour's
  double per_second = 4.0;        ///< of the tour's time
  std::vector<std::string> layers = {"rgb", "depth", "instance", "category", "normal"};
  int threads = 2;   ///< one of them draws (OSMesa with threads of its own), the others make files
                     ///< of what is drawn
  int quality = 92;  ///< of the JPEG pictures, 1 to 100
  CancelToken cancel;
};

struct FrameFigures {
  std::size_t frames = 0;
  std::size_t drawn = 0;  ///< of them, the others were there
  std::string video;      ///< path of the MP4; empty: there is none
  std::string no_video;   ///< why not
};

/// Draws what is missing of FOLDER/frames and writes FOLDER/frames.jsonl, coco.json, kitti/*.txt and, where ffmpeg is
/// installed, tour.mp4. A file of a frame is written as a whole and its NNNNNN.json last: what was interrupted goes
/// on from there. Frames of another scene, tour or other options go first. Each file depends on the frame alone, not
/// on the number of threads. Fails on options that make no sense, and as make_osmesa_renderer() does.
Result<FrameFigures> draw_frames(const Scene& scene, const ModelTable& models, const Tour& tour,
                                 const FrameOptions& options, const std::filesystem::path& folder);

/// The layers that frames may have: rgb, depth, instance, category, normal.
const std::vector<std::string>& frame_layers();

}  // namespace roomgen::lab
