#pragma once

#include <span>
#include <string>
#include <vector>

#include "layer_pass.h"
#include "view/camera.h"

namespace roomgen::detail {

/// The parts of the rooms, each a thing of its own. Keeps those of the last picture: the next camera mostly looks at
/// the same ones.
class NumberedShell {
 public:
  void update(std::span<const Room> rooms, const ModelTable& models, const View& view, const Camera& camera);
  /// Things that the view shows; the first of `things` has the number `first`.
  void append_items(std::span<const LayerThing> things, std::size_t first, GpuCache& cache,
                    std::vector<NumberedItem>& items) const;

 private:
  struct Part {
    std::string id;
    std::shared_ptr<const Model> model;
  };
  std::string key_;
  std::vector<Part> parts_;
};

}  // namespace roomgen::detail
