#include "fixture.h"

#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <fstream>

#include "catch.h"

namespace fs = std::filesystem;

const roomgen::assets::Catalogue* furniture() {
  roomgen::assets::CatalogueOptions options;
  if (options.libraries.empty()) {
    WARN("skipped: sweethome3d-furniture is not installed");
    return nullptr;
  }
  options.cache_dir = fs::path(ROOMGEN_BINARY_DIR) / "test-cache";
  static const auto catalogue = roomgen::assets::open_catalogue(options);
  REQUIRE(catalogue);
  return catalogue->get();
}

TemporaryFolder::TemporaryFolder() {
  static std::atomic<int> counter = 0;
  path_ = fs::temp_directory_path() /
          ("roomgen-test-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
  fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path TemporaryFolder::write(const std::string& name, const std::string& bytes) const {
  const fs::path file = path_ / name;
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

std::string cube_obj() {
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
         "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

namespace {

std::uint32_t crc32_of(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const unsigned char byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320u : 0u);
  }
  return ~crc;
}

void put(std::string& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>((value >> (8 * i)) & 0xFF);
}

// The fields that local and central headers share: flags, method (stored), time, checksum, sizes.
void put_common(std::string& out, const ZipEntry& entry) {
  put(out, 20, 2);
  put(out, 0, 2);
  put(out, 0, 2);
  put(out, 0x00210000u, 4);
  put(out, crc32_of(entry.bytes), 4);
  put(out, static_cast<std::uint32_t>(entry.bytes.size()), 4);
  put(out, static_cast<std::uint32_t>(entry.bytes.size()), 4);
  put(out, static_cast<std::uint32_t>(entry.name.size()), 2);
  put(out, 0, 2);
}

}  // namespace

void write_zip(const fs::path& path, const std::vector<ZipEntry>& entries) {
  std::string out, central;
  for (const auto& entry : entries) {
    const auto offset = static_cast<std::uint32_t>(out.size());
    put(out, 0x04034b50u, 4);
    put_common(out, entry);
    out += entry.name + entry.bytes;
    put(central, 0x02014b50u, 4);
    put(central, 20, 2);
    put_common(central, entry);
    put(central, 0, 2);  // comment
    put(central, 0, 2);  // disk
    put(central, 0, 2);
    put(central, 0, 4);
    put(central, offset, 4);
    central += entry.name;
  }
  const auto start = static_cast<std::uint32_t>(out.size());
  out += central;
  put(out, 0x06054b50u, 4);
  put(out, 0, 4);
  put(out, static_cast<std::uint32_t>(entries.size()), 2);
  put(out, static_cast<std::uint32_t>(entries.size()), 2);
  put(out, static_cast<std::uint32_t>(central.size()), 4);
  put(out, start, 4);
  put(out, 0, 2);
  std::ofstream(path, std::ios::binary) << out;
}
