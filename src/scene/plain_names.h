#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/scene/scene.h"

namespace roomgen {

/// What any program that reads 3D files takes as a name: letters and digits of ASCII, blanks, '-', '_'
/// and '.'; a run of anything else becomes one '_'. It begins and ends with neither a blank nor a
/// dot, and is short enough for Blender, which cuts names at 63 bytes. Empty if nothing is left to
/// tell it by.
std::string plain_name(std::string_view text);

/// What is left of a name when three.js has loaded it: white space becomes '_', and "[].:/" go.
std::string threejs_name(std::string_view name);

/// Gives each thing of a kind a plain name that no other has, also after three.js or a program to
/// which upper and lower case are the same.
class PlainNames {
 public:
  /// The plain form of a text, or of `otherwise` where it has none, with a number if it is taken.
  std::string take(std::string_view text, std::string_view otherwise);

 private:
  std::set<std::string> taken_;             ///< as readers confuse them
  std::map<std::string, int> last_number_;  ///< behind a name that was wanted again
};

/// The names of the objects' nodes in exported files, in the scene's order: their ids wherever
/// those are plain.
std::vector<std::string> node_names(const Scene& scene, PlainNames& names);

}  // namespace roomgen
