#pragma once

#include <cstddef>
#include <string_view>

#include "roomgen/base/result.h"

struct aiScene;

namespace roomgen::decode {

// What a mesh file may hold at most; furniture stays far below.
inline constexpr std::size_t most_nodes = 100000;
inline constexpr std::size_t most_depth = 256;     // of nodes in nodes
inline constexpr std::size_t most_corners = 4096;  // of a face: cutting it costs their square
inline constexpr std::size_t most_materials = 4096;
inline constexpr std::size_t most_name_bytes = 256;

/// What is said of a file that had all the memory there is for one.
inline constexpr std::string_view too_much_memory = "takes more memory than a mesh may";

/// Refuses a scene that is over one of these limits, or has more than `max_triangles` faces with each mesh
/// counted as often as nodes show it. To be asked before anything is done with the scene.
Status check_limits(const aiScene& scene, std::size_t max_triangles);

/// "48000 faces or more are over the limit of 40000 triangles; simplify the mesh"
Error too_many_faces(std::size_t count, std::size_t limit);

}  // namespace roomgen::decode
