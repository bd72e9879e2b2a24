#include "index.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <thread>

#include "asset_source.h"
#include "base/sha256.h"
#include "base/threads.h"
#include "index_file.h"
#include "library/shown_colors.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"

namespace roomgen::assets {

namespace fs = std::filesystem;

namespace {

constexpr int sample_side = 32;    // pixels: enough of a texture to know its colour

// Words for materials, as the author called them.
std::string material_words(const Model& model, const Vocabulary& vocabulary) {
  std::string result;
  for (const auto& material : model.materials)
    for (const auto& word : words(material.name))
      if (!vocabulary.family_name(word).empty()) result += " " + word;
  return result;
}

Result<IndexedAsset> index_asset(const AssetSource& source, const SourceAsset& asset, const std::string& sha256,
                                 decode::Decoder& decoder, const LogSink& sink) {
  decode::ImportOptions options;
  options.max_texture_side = sample_side;
  options.log = sink;
  auto model = decoder.decode(source.tree, asset.mesh, options);
  if (!model) return model.error();
  const SeenAsset* seen = seen_asset(asset.info.ref);
  SourceAsset measured = asset;
  if (seen && seen->true_size) {
    if (measured.info.support_height && measured.frame.size)
      *measured.info.support_height *= seen->true_size->z() / measured.frame.size->z();
    measured.frame.size = seen->true_size;
  }
  const auto size = fit_to_frame(*model, measured.frame, Normals::leave);
  if (!size) return with_context(size.error(), asset.mesh);

  measured.info.size = *size;
  measured.info.triangles = triangle_count(*model);
  measured.info.ref.sha256 = sha256;
  measured.info.colors = main_colors(*model);
  const auto& vocabulary = Vocabulary::built_in();
  IndexedAsset row;
  row.info = classify(measured, seen, vocabulary);
  row.mesh = asset.mesh;
  row.ours_from_source = asset.frame.ours_from_source;
  row.looks = join(row.info.colors, " ") + material_words(*model, vocabulary);
  return row;
}

// What came of one mesh; neither when it is not to be used at all.
struct IndexedMesh {
  std::optional<IndexedAsset> asset;
  std::optional<LeftOutMesh> left_out;
};

// Reads all meshes of a library, several at a time; the result is in the library's order whoever
// was first.
class Indexer {
 public:
  // `too_much`: reasons not to try again, by content.
  Indexer(const AssetSource& source, const CatalogueOptions& options,
          const std::map<std::string, std::string>& too_much)
      : source_(source), options_(options), too_much_(too_much), results_(source.assets.size()) {
    log_ = [this](LogLevel, std::string_view message) {
      const std::lock_guard lock(mutex_);
      log(options_.log, LogLevel::info, source_.library + ": " + std::string(message));
    };
  }

  // Fails only when there can be no decoder.
  Result<std::vector<IndexedMesh>> run() {
    on_threads(std::clamp(std::thread::hardware_concurrency(), 1u, max_threads), [this](std::size_t) { work(); });
    if (!failure_.ok()) return failure_.error();
    return std::move(results_);
  }

 private:
  static constexpr unsigned max_threads = 4;

  void work() {
    decode::Decoder decoder(decoder_options(options_));
    for (std::size_t i; (i = next_++) < results_.size() && !options_.cancel.cancelled();) {
      const SeenAsset* seen = seen_asset(source_.assets[i].info.ref);
      if (!seen || !seen->unsteady) read(source_.assets[i], decoder, results_[i]);
      report();
    }
  }

  void read(const SourceAsset& asset, decode::Decoder& decoder, IndexedMesh& result) {
    const auto bytes = source_.tree.read(asset.mesh);
    if (!bytes) return leave_out(asset, "", bytes.error(), result);
    const std::string sha256 = sha256_hex(*bytes);
    if (const auto known = too_much_.find(sha256); known != too_much_.end())
      return leave_out(asset, sha256, {Error::Kind::limit, known->second}, result);
    auto row = index_asset(source_, asset, sha256, decoder, log_);
    if (row)
      result.asset = *std::move(row);
    else if (row.error().kind == Error::Kind::unavailable)
      stop(row.error());
    else
      leave_out(asset, sha256, row.error(), result);
  }

  void leave_out(const SourceAsset& asset, const std::string& sha256, const Error& error,
                 IndexedMesh& result) {
    log_(LogLevel::info, error.message + "; left out");
    result.left_out = LeftOutMesh{source_.library, asset.mesh, error.message, sha256,
                                  error.kind == Error::Kind::limit};
  }

  void stop(const Error& error) {
    const std::lock_guard lock(mutex_);
    failure_ = error;
    next_ = results_.size();
  }

  void report() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (options_.progress) options_.progress({source_.library, done_, results_.size()});
  }

  const AssetSource& source_;
  const CatalogueOptions& options_;
  const std::map<std::string, std::string>& too_much_;
  LogSink log_;
  std::mutex mutex_;
  std::atomic<std::size_t> next_ = 0;
  std::size_t done_ = 0;
  std::vector<IndexedMesh> results_;
  Status failure_;
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

// What an older catalogue of the same library knows to be too much for whoever reads it.
std::map<std::string, std::string> known_as_too_much(const fs::path& catalogue) {
  std::map<std::string, std::string> reasons;
  std::error_code code;
  if (!fs::exists(catalogue, code)) return reasons;
  const auto database = Database::open_read_only(catalogue);
  const auto rows = database ? read_left_out(*database, "") : Result<std::vector<LeftOutMesh>>(database.error());
  if (!rows) return reasons;
  for (const auto& mesh : *rows)
    if (mesh.too_much && !mesh.sha256.empty()) reasons[mesh.sha256] = mesh.reason;
  return reasons;
}

void tell_of_left_out(const std::string& library, const std::vector<LeftOutMesh>& left_out,
                      const LogSink& sink) {
  if (left_out.empty()) return;
  log(sink, LogLevel::warning,
      library + ": " + std::to_string(left_out.size()) +
          (left_out.size() == 1 ? " mesh is" : " meshes are") + " left out; roomgen assets check says why");
}

Status build_index(const fs::path& library, const fs::path& target, const std::string& stamp,
                   const CatalogueOptions& options) {
  const auto source = open_source(library, options.log);
  if (!source) return source.error();
  auto meshes = Indexer(*source, options, known_as_too_much(target)).run();
  if (options.cancel.cancelled()) return Error{Error::Kind::cancelled, "indexing was stopped"};
  if (!meshes) return meshes.error();
  std::vector<IndexedAsset> rows;
  std::vector<LeftOutMesh> left_out;
  for (auto& mesh : *meshes) {
    if (mesh.asset) rows.push_back(*std::move(mesh.asset));
    if (mesh.left_out) left_out.push_back(*std::move(mesh.left_out));
  }
  if (rows.empty())
    return Error{Error::Kind::invalid_input, library.string() + ": none of its meshes is usable"};
  drop_doubled_ids(rows);
  tell_of_left_out(source->library, left_out, options.log);

  if (auto status = replace_file(target, [&](const fs::path& aside) { return write_index(aside, stamp, rows, left_out); });
      !status)
    return status;
  return seal(target);
}

}  // namespace

decode::DecoderOptions decoder_options(const CatalogueOptions& options) {
  decode::DecoderOptions decoder;
  decoder.program = options.decoder;
  decoder.in_process = options.trusted;
  decoder.require_sandbox = options.require_sandbox;
  decoder.cancel = options.cancel;
  return decoder;
}

Result<fs::path> ensure_index(const fs::path& library, const CatalogueOptions& options) {
  std::error_code code;
  if (!fs::exists(library, code))
    return Error{Error::Kind::not_found, library.string() + ": no such furniture library"};
  const auto stamp = stamp_of(library);
  if (!stamp) return stamp.error();
  const fs::path path = catalogue_path(library, options.cache_dir);
  const bool whole = is_whole(path);
  if (!options.rebuild && whole && read_stamp(path) == *stamp) return path;
  if (!whole && is_sealed(path))
    log(options.log, LogLevel::warning, path.string() + " is damaged, and made anew");
  if (auto status = make_folder(options.cache_dir); !status)
    return Error{status.error().kind, status.error().message + "; choose another cache folder"};
  if (auto status = build_index(library, path, *stamp, options); !status) return status.error();
  drop_older(path);
  return path;
}

}  // namespace roomgen::assets
