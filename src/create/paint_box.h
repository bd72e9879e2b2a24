#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "roomgen/geometry/model.h"
#include "scene/finish_words.h"

namespace roomgen::create {

/// The mean of an image's pixels.
Tone mean_of(const Image& image);

/// Textures that were painted, each once: things of one look share their images. Not for use by several
/// threads at once.
class PaintBox {
 public:
  struct Drawing {
    std::shared_ptr<const Image> image;
    double extent = 1.0;  ///< metres that it covers
  };
  /// By the name of a pattern of shape/pattern.h or geometry/texture.h.
  Drawing drawing(const std::string& pattern, double scale, const Tone& first, const Tone& second);
  /// The same drawing in another mean tone.
  std::shared_ptr<const Image> toned(const std::shared_ptr<const Image>& image, const Tone& tone);

 private:
  using Pair = std::tuple<int, int, int, int, int, int>;  ///< two tones

  std::map<std::pair<std::string, Pair>, std::shared_ptr<const Image>> drawings_;
  /// With what they were made of, so that no other image takes its address.
  std::map<std::pair<std::shared_ptr<const Image>, Pair>, std::shared_ptr<const Image>> toned_;
};

}  // namespace roomgen::create
