#pragma once

#include <map>
#include <string>

#include "decode/file_tree.h"

/// A library in memory.
inline roomgen::decode::FileTree tree_of(std::map<std::string, std::string> files) {
  roomgen::decode::FileTree tree;
  for (const auto& [name, bytes] : files) tree.names.push_back(name);
  tree.read = [files = std::move(files)](const std::string& name) -> roomgen::Result<std::string> {
    return files.at(name);
  };
  return tree;
}

/// A cube of one unit, in two materials.
inline std::string cube_obj() {
  return "mtllib cube.mtl\n"
         "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
         "usemtl red\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nusemtl blue\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}
