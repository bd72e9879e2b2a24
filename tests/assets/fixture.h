#pragma once

#include <filesystem>
#include <string>

#include "roomgen/assets/catalogue.h"

/// The installed furniture, its catalogue kept in the build folder between runs. Null, with a note,
/// where sweethome3d-furniture is not installed: such tests cannot tell anything then.
const roomgen::assets::Catalogue* furniture();

/// An empty folder of its own for a test, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& bytes) const;

 private:
  std::filesystem::path path_;
};

/// An OBJ cube of one unit, its corner at the origin.
std::string cube_obj();

struct ZipEntry {
  std::string name;
  std::string bytes;
};
/// Writes a ZIP archive without compression, whatever its entries are called.
void write_zip(const std::filesystem::path& path, const std::vector<ZipEntry>& entries);
