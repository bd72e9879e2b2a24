#include "appearances.h"

#include <algorithm>

namespace roomgen::lab::detail {

std::vector<Appearance> appearances(const Scene& scene, const std::vector<FrameRecord>& frames,
                                    const SightLimits& limits) {
  std::vector<Appearance> list(scene.objects.size());
  std::vector<double> most(scene.objects.size(), 0.0);
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    const double pixels = static_cast<double>(frames[frame].width) * frames[frame].height;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const double share = static_cast<double>(frames[frame].objects[k].pixels) / pixels;
      Appearance& one = list[k];
      if (share >= limits.faint) one.first_faint = std::min(one.first_faint, frame);
      if (share >= limits.seen) one.first_seen = std::min(one.first_seen, frame);
      if (share > most[k]) most[k] = share, one.best = frame;
      one.clear = one.clear || share >= limits.clear;
    }
  }
  return list;
}

}  // namespace roomgen::lab::detail
