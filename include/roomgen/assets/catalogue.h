#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/library/library.h"

namespace roomgen::assets {

struct IndexProgress {
  std::string_view library;
  std::size_t done = 0;
  std::size_t total = 0;
};

/// The furniture packages that this system has, in order; empty if it has none.
std::vector<std::filesystem::path> installed_libraries();

/// $XDG_CACHE_HOME/roomgen, else ~/.cache/roomgen; where these cannot be written, a folder below the system's
/// temporary one that is closed to others (made now).
std::filesystem::path default_cache_dir();

struct CatalogueOptions {
  /// Sweet Home 3D archives (.sh3f) and folders of meshes (docs/assets.md). An asset is known by
  /// its library's name (file name without extension, folder name) and its id.
  std::vector<std::filesystem::path> libraries = installed_libraries();
  std::filesystem::path cache_dir = default_cache_dir();
  bool rebuild = false;  ///< even if the cached catalogue still holds
  /// Meshes are read by the program roomgen-decode, in a process that can do nothing else, since a broken one
  /// may crash what reads it. Empty: the one that $ROOMGEN_DECODER names, beside the running program, or where
  /// this library was installed.
  std::filesystem::path decoder;
  bool trusted = false;          ///< meshes are read in this process: only for files of your own
  bool require_sandbox = false;  ///< Error::Kind::unavailable where the decoder cannot be shut in wholly
  LogSink log;           ///< what was repaired or left out while indexing
  std::function<void(const IndexProgress&)> progress;  ///< after each mesh, one call at a time
  CancelToken cancel;
};

/// A mesh of a library that cannot be used.
struct LeftOutMesh {
  std::string library;
  std::string mesh;    ///< its file
  std::string reason;
  std::string sha256;  ///< of the file; empty if it could not be read
  bool too_much = false;  ///< it crashed or overran what read it: not tried again while it stays the same
};

/// What holds the decoder on this machine, a line each, for people.
Result<std::vector<std::string>> decoder_report(const CatalogueOptions& options);

/// Furniture libraries as one AssetLibrary. Safe to use from several threads.
class Catalogue final : public AssetLibrary {
 public:
  struct Impl;
  explicit Catalogue(std::unique_ptr<Impl> impl);
  ~Catalogue() override;

  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override;
  /// Meshes are read when asked for; the last few stay in memory.
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override;
  /// All assets, by library and id.
  Result<std::vector<AssetInfo>> all() const;
  /// Meshes that were left out when the libraries were read, and why.
  Result<std::vector<LeftOutMesh>> left_out() const;
  /// By "Scopia/leather_sofa", or by the id alone: the first library that has it.
  Result<AssetInfo> find(std::string_view name) const override;

 private:
  std::unique_ptr<Impl> impl_;
};

/// Opens libraries, indexing those whose catalogue is missing or out of date: seconds for hundreds
/// of meshes the first time, milliseconds later. A library that cannot be read is an error; a
/// broken asset in it is left out with a warning.
///
///     auto catalogue = roomgen::assets::open_catalogue({});
///     if (!catalogue) return catalogue.error();
///     auto desks = (*catalogue)->search({.category = "desk", .description = "white, modern"});
Result<std::unique_ptr<Catalogue>> open_catalogue(const CatalogueOptions& options);

/// Decodes PNG or JPEG bytes (told apart by their first bytes), at most 16384 pixels a side, and
/// shrinks the picture by averaging until no side is longer than `max_side`. In this process: for pictures of your own.
Result<Image> decode_image(std::string_view bytes, int max_side = 1024);

/// The same for pictures of anybody, in a process of its own as with meshes, started when one is first asked for. Of the options those
/// about the decoder matter. For one thread at a time.
std::function<Result<Image>(std::string_view bytes)> picture_decoder(const CatalogueOptions& options,
                                                                     int max_side = 1024);

}  // namespace roomgen::assets
