#include "index.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "asset_source.h"
#include "base/resource.h"
#include "base/sha256.h"
#include "classify.h"
#include "import_mesh.h"
#include "index_file.h"
#include "library/shown_colors.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"

namespace roomgen::assets {

namespace fs = std::filesystem;

namespace {

constexpr int format_version = 4;  // of the catalogue's tables and of what is worked out for them
constexpr int sample_side = 32;    // pixels: enough of a texture to know its colour

std::string stamp_of_file(const fs::path& path) {
  std::error_code code;
  const auto size = fs::file_size(path, code);
  const auto time = fs::last_write_time(path, code).time_since_epoch().count();
  return std::to_string(size) + " " + std::to_string(time);
}

// Changes when a file of the library does, or what this program knows.
Result<std::string> stamp_of(const fs::path& library) {
  std::string text = std::to_string(format_version);
  for (const auto* name : {"data/furniture-labels.json", "data/vocabulary.json"})
    text += "\n" + sha256_hex(resource(name).value_or(""));
  for (const auto name : resources("data/kinds/")) text += "\n" + sha256_hex(*resource(name));
  std::error_code code;
  if (!fs::is_directory(library, code)) return sha256_hex(text + "\n" + stamp_of_file(library));
  auto tree = open_folder(library);
  if (!tree) return tree.error();
  for (const auto& name : tree->names) text += "\n" + name + " " + stamp_of_file(library / name);
  return sha256_hex(text);
}

// Words for materials, as the author called them.
std::string material_words(const Model& model, const Vocabulary& vocabulary) {
  std::string result;
  for (const auto& material : model.materials)
    for (const auto& word : words(material.name))
      if (!vocabulary.family_name(word).empty()) result += " " + word;
  return result;
}

Result<IndexedAsset> index_asset(const AssetSource& source, const SourceAsset& asset,
                                 const LogSink& sink) {
  const auto bytes = source.tree.read(asset.mesh);
  if (!bytes) return bytes.error();
  ImportOptions options;
  options.max_texture_side = sample_side;
  options.log = sink;
  auto model = import_mesh(source.tree, asset.mesh, options);
  if (!model) return model.error();
  const auto size = fit_to_frame(*model, asset.frame, Normals::leave);
  if (!size) return with_context(size.error(), asset.mesh);

  SourceAsset measured = asset;
  measured.info.size = *size;
  measured.info.triangles = triangle_count(*model);
  measured.info.ref.sha256 = sha256_hex(*bytes);
  measured.info.colors = main_colors(*model);
  const auto& vocabulary = Vocabulary::built_in();
  const Label* label = Labels::built_in().find(source.library, asset.info.ref.id);
  IndexedAsset row;
  row.info = classify(measured, label, vocabulary);
  row.mesh = asset.mesh;
  row.ours_from_source = asset.frame.ours_from_source;
  row.looks = join(row.info.colors, " ") + material_words(*model, vocabulary);
  return row;
}

// Reads all meshes of a library, several at a time; the result is in the library's order whoever
// was first.
class Indexer {
 public:
  Indexer(const AssetSource& source, const CatalogueOptions& options)
      : source_(source), options_(options), rows_(source.assets.size()) {
    log_ = [this](LogLevel level, std::string_view message) {
      const std::lock_guard lock(mutex_);
      log(options_.log, level, source_.library + ": " + std::string(message));
    };
  }

  std::vector<IndexedAsset> run() {
    const unsigned count = std::clamp(std::thread::hardware_concurrency(), 1u, max_threads);
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < count; ++i) threads.emplace_back([this] { work(); });
    work();
    for (auto& thread : threads) thread.join();
    std::vector<IndexedAsset> result;
    for (auto& row : rows_)
      if (row) result.push_back(*std::move(row));
    return result;
  }

 private:
  static constexpr unsigned max_threads = 4;

  void work() {
    for (std::size_t i; (i = next_++) < rows_.size() && !options_.cancel.cancelled();) {
      const Label* label =
          Labels::built_in().find(source_.library, source_.assets[i].info.ref.id);
      if (label && label->unsteady) {
        report();
        continue;
      }
      auto row = index_asset(source_, source_.assets[i], log_);
      if (row)
        rows_[i] = *std::move(row);
      else
        log_(LogLevel::warning, row.error().message + "; left out");
      report();
    }
  }

  void report() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (options_.progress) options_.progress({source_.library, done_, rows_.size()});
  }

  const AssetSource& source_;
  const CatalogueOptions& options_;
  LogSink log_;
  std::mutex mutex_;
  std::atomic<std::size_t> next_ = 0;
  std::size_t done_ = 0;
  std::vector<std::optional<IndexedAsset>> rows_;
};

void drop_doubled_ids(std::vector<IndexedAsset>& rows) {
  const auto by_id = [](const IndexedAsset& a, const IndexedAsset& b) {
    return a.info.ref.id < b.info.ref.id;
  };
  const auto same_id = [](const IndexedAsset& a, const IndexedAsset& b) {
    return a.info.ref.id == b.info.ref.id;
  };
  std::stable_sort(rows.begin(), rows.end(), by_id);
  rows.erase(std::unique(rows.begin(), rows.end(), same_id), rows.end());
}

Status build_index(const fs::path& library, const fs::path& target, const std::string& stamp,
                   const CatalogueOptions& options) {
  const auto source = open_source(library, options.log);
  if (!source) return source.error();
  auto rows = Indexer(*source, options).run();
  if (options.cancel.cancelled()) return Error{Error::Kind::cancelled, "indexing was stopped"};
  if (rows.empty())
    return Error{Error::Kind::invalid_input, library.string() + ": none of its meshes is usable"};
  drop_doubled_ids(rows);

  return replace_file(target, [&](const fs::path& aside) { return write_index(aside, stamp, rows); });
}

}  // namespace

fs::path index_path(const fs::path& library, const CatalogueOptions& options) {
  std::error_code code;
  const fs::path whole = fs::weakly_canonical(library, code);
  const std::string key = sha256_hex((code ? library : whole).string()).substr(0, 16);
  return options.cache_dir / ("catalogue-" + library_name(library) + "-" + key + ".sqlite");
}

Result<fs::path> ensure_index(const fs::path& library, const CatalogueOptions& options) {
  std::error_code code;
  if (!fs::exists(library, code))
    return Error{Error::Kind::not_found, library.string() + ": no such furniture library"};
  const auto stamp = stamp_of(library);
  if (!stamp) return stamp.error();
  const fs::path path = index_path(library, options);
  if (!options.rebuild && read_stamp(path) == *stamp) return path;
  if (auto status = make_folder(options.cache_dir); !status)
    return Error{status.error().kind, status.error().message + "; choose another cache folder"};
  if (auto status = build_index(library, path, *stamp, options); !status) return status.error();
  return path;
}

}  // namespace roomgen::assets
