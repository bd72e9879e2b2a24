#pragma once

#include <optional>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/geometry/polygon.h"
#include "roomgen/scene/model_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// How to look at a room. The picture's longer side is `pixels` long.
struct View {
  enum class Kind {
    top,        ///< orthographic from above, walls cut at 1.2 m, ceiling off, +Y up the page
    isometric,  ///< from a corner, the walls towards the viewer left out
    eye,        ///< as a standing person sees it: from a door or a corner, ceiling on, lamps and sun lit
  };
  Kind kind = Kind::top;
  int pixels = 1024;
  bool marks = false;       ///< top only: coordinate grid, axes, ids and fronts (set-of-mark)
  bool paper_frame = false; ///< marks count x' = ymax - y down and y' = xmax - x to the left
  std::vector<Bounds2> free_floor = {};  ///< with marks: parts of the floor to be shaded as free
  /// Top only: this part of the room alone, with finer marks in the scene's own coordinates.
  std::optional<Bounds2> part = {};
};

/// Draws a scene.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// Equal arguments give equal pixels. Objects without a model are drawn as boxes.
  virtual Result<Image> render(const Scene& scene, const ModelTable& models, const View& view) = 0;
};

}  // namespace roomgen
