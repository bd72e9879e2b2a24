#pragma once

#include <string>
#include <vector>

#include "roomgen/view/view.h"

namespace roomgen::cli {

/// The pictures of a room by the names that people and agents give them.
inline const std::vector<std::string>& view_names() {
  static const std::vector<std::string> names = {"marks", "top", "iso", "eye", "elevation"};
  return names;
}

/// marks: from above with coordinates, ids and fronts.
inline View view_named(const std::string& name, int pixels) {
  View view;
  view.kind = name == "iso"         ? View::Kind::isometric
              : name == "eye"       ? View::Kind::eye
              : name == "elevation" ? View::Kind::elevation
                                    : View::Kind::top;
  view.marks = name == "marks";
  view.pixels = pixels;
  return view;
}

}  // namespace roomgen::cli
