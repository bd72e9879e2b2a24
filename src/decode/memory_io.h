#pragma once

#include <assimp/IOSystem.hpp>
#include <string>
#include <string_view>

#include "file_tree.h"

namespace roomgen::decode {

/// Gives assimp the files of a mesh's own folder, and nothing else: whatever path a mesh file names
/// is looked up there (FileTree::resolve).
class MemoryIo final : public Assimp::IOSystem {
 public:
  MemoryIo(const FileTree& tree, std::string folder) : tree_(tree), folder_(std::move(folder)) {}

  bool Exists(const char* file) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  std::string_view below_folder(std::string_view path) const;

  const FileTree& tree_;
  std::string folder_;
};

}  // namespace roomgen::decode
