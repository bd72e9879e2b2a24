#include <algorithm>
#include <utility>
#include <vector>

#include "asset_source.h"
#include "base/resource.h"
#include "base/sha256.h"
#include "index.h"
#include "roomgen/base/file.h"

namespace roomgen::assets {

namespace fs = std::filesystem;

namespace {

constexpr int format_version = 7;  // of the catalogue's tables and of what is worked out for them
constexpr std::size_t most_catalogue_bytes = std::size_t{1} << 30;
constexpr std::size_t key_digits = 16;
constexpr std::size_t most_versions = 4;

// Changes with what this program knows of furniture.
const std::string& knowledge() {
  static const std::string hash = [] {
    std::string text = std::to_string(format_version);
    for (const auto* name : {"data/furniture-seen.json", "data/vocabulary.json"})
      text += "\n" + sha256_hex(resource(name).value_or(""));
    for (const auto name : resources("data/kinds/")) text += "\n" + sha256_hex(*resource(name));
    return sha256_hex(text);
  }();
  return hash;
}

std::string stamp_of_file(const fs::path& path) {
  std::error_code code;
  const auto size = fs::file_size(path, code);
  const auto time = fs::last_write_time(path, code).time_since_epoch().count();
  return std::to_string(size) + " " + std::to_string(time);
}

fs::path seal_of(const fs::path& catalogue) { return fs::path(catalogue).replace_extension(".sha256"); }

// Of the file's name, what all versions share.
std::string library_part(const fs::path& catalogue) {
  const std::string name = catalogue.filename().string();
  return name.substr(0, name.rfind('-') + 1);
}

}  // namespace

fs::path catalogue_path(const fs::path& library, const fs::path& cache_dir) {
  std::error_code code;
  const fs::path whole = fs::weakly_canonical(library, code);
  const std::string key = sha256_hex((code ? library : whole).string()).substr(0, key_digits);
  return cache_dir / ("catalogue-" + library_name(library) + "-" + key + "-" +
                      knowledge().substr(0, key_digits) + ".sqlite");
}

Result<std::string> stamp_of(const fs::path& library) {
  std::string text = knowledge();
  std::error_code code;
  if (!fs::is_directory(library, code)) return sha256_hex(text + "\n" + stamp_of_file(library));
  auto tree = open_folder(library);
  if (!tree) return tree.error();
  for (const auto& name : tree->names) text += "\n" + name + " " + stamp_of_file(library / name);
  return sha256_hex(text);
}

Status seal(const fs::path& catalogue) {
  const auto bytes = read_file(catalogue, most_catalogue_bytes);
  if (!bytes) return bytes.error();
  return write_file(seal_of(catalogue), sha256_hex(*bytes) + "\n");
}

bool is_sealed(const fs::path& catalogue) {
  std::error_code code;
  return fs::exists(seal_of(catalogue), code);
}

bool is_whole(const fs::path& catalogue) {
  const auto bytes = read_file(catalogue, most_catalogue_bytes), seal = read_file(seal_of(catalogue));
  return bytes && seal && *seal == sha256_hex(*bytes) + "\n";
}

void drop_older(const fs::path& catalogue) {
  std::error_code code;
  std::vector<std::pair<fs::file_time_type, fs::path>> versions;
  for (const auto& entry : fs::directory_iterator(catalogue.parent_path(), code))
    if (entry.path().extension() == ".sqlite" && library_part(entry.path()) == library_part(catalogue))
      versions.emplace_back(entry.last_write_time(code), entry.path());
  std::sort(versions.rbegin(), versions.rend());
  for (std::size_t i = most_versions; i < versions.size(); ++i) {
    if (versions[i].second == catalogue) continue;
    fs::remove(versions[i].second, code);
    fs::remove(seal_of(versions[i].second), code);
  }
}

}  // namespace roomgen::assets
