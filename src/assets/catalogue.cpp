#include "roomgen/assets/catalogue.h"

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <optional>

#include "asset_source.h"
#include "base/private_folder.h"
#include "decode/image_decode.h"
#include "index.h"
#include "index_file.h"
#include "search.h"

namespace roomgen::assets {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kept_models = 64;

// One library: its catalogue, and its files once a mesh is wanted.
struct Shelf {
  std::string library;
  fs::path path;
  Database database;
  std::unique_ptr<FileTree> tree;  // stays where it is while the decoder reads from it
};

// The models that were asked for last.
class ModelCache {
 public:
  std::shared_ptr<const Model> find(const std::string& key) const {
    for (const auto& [name, model] : models_)
      if (name == key) return model;
    return nullptr;
  }
  void add(const std::string& key, std::shared_ptr<const Model> model) {
    models_.emplace_front(key, std::move(model));
    if (models_.size() > kept_models) models_.pop_back();
  }

 private:
  std::deque<std::pair<std::string, std::shared_ptr<const Model>>> models_;
};

Error unknown(const std::string& name) {
  return {Error::Kind::not_found, name + ": no open library has this asset"};
}

std::optional<IndexedAsset> find_row(const Database& database, const std::string& id) {
  Statement statement =
      database.prepare(std::string("SELECT ") + row_columns + " FROM assets WHERE asset = ?");
  statement.bind(1, id);
  if (!statement.step()) return std::nullopt;
  return row_of(statement);
}

fs::path environment_folder(const char* variable) {
  const char* value = std::getenv(variable);
  const fs::path path = value ? value : "";
  return path.is_absolute() ? path : fs::path();  // the XDG rules ignore relative ones
}

}  // namespace

struct Catalogue::Impl {
  /// Where the mesh of an asset is.
  struct Found {
    const Shelf& shelf;
    IndexedAsset asset;
  };

  mutable std::mutex
      mutex;  // SQLite handles, the cache and idle decoders are used by one thread at a time
  mutable std::vector<Shelf> shelves;
  mutable ModelCache models;
  mutable std::vector<std::unique_ptr<decode::Decoder>> idle;  ///< each reads one mesh at a time
  LogSink log;
  decode::DecoderOptions decoding;

  explicit Impl(const CatalogueOptions& options)
      : log(options.log), decoding(decoder_options(options)) {}

  Result<Found> find(const AssetRef& ref, const std::string& key) const;
  Result<std::shared_ptr<const Model>> read_model(const Found& found) const;
  std::unique_ptr<decode::Decoder> take_decoder() const;
};

// With the mutex held.
Result<Catalogue::Impl::Found> Catalogue::Impl::find(const AssetRef& ref,
                                                     const std::string& key) const {
  for (auto& shelf : shelves) {
    if (shelf.library != ref.library || ref.procedural) continue;
    auto row = find_row(shelf.database, ref.id);
    if (!row) break;
    if (!ref.sha256.empty() && ref.sha256 != row->info.ref.sha256)
      roomgen::log(log, LogLevel::warning, key + ": its mesh has changed since it was chosen");
    if (!shelf.tree) {
      auto tree = open_tree(shelf.path, {});  // warnings were given while indexing
      if (!tree) return tree.error();
      shelf.tree = std::make_unique<FileTree>(*std::move(tree));
    }
    return Found{shelf, *std::move(row)};
  }
  return unknown(key);
}

std::unique_ptr<decode::Decoder> Catalogue::Impl::take_decoder() const {
  const std::lock_guard lock(mutex);
  if (idle.empty()) return std::make_unique<decode::Decoder>(decoding);
  auto decoder = std::move(idle.back());
  idle.pop_back();
  return decoder;
}

Result<std::shared_ptr<const Model>> Catalogue::Impl::read_model(const Found& found) const {
  const auto& [shelf, asset] = found;
  auto decoder = take_decoder();
  auto model = decoder->decode(*shelf.tree, asset.mesh, {});
  {
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(decoder));
  }
  if (!model) return with_context(model.error(), shelf.library);
  SourceFrame frame;
  frame.ours_from_source = asset.ours_from_source;
  frame.size = asset.info.size;
  const auto size = fit_to_frame(*model, frame);
  if (!size) return with_context(size.error(), shelf.library + "/" + asset.info.ref.id);
  return std::make_shared<const Model>(*std::move(model));
}

Catalogue::Catalogue(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Catalogue::~Catalogue() = default;

Result<std::vector<AssetMatch>> Catalogue::search(const AssetQuery& query) const {
  if (query.made) return std::vector<AssetMatch>();
  const auto& vocabulary = Vocabulary::built_in();
  const SearchPlan plan = plan_search(query, vocabulary);
  const std::lock_guard lock(impl_->mutex);
  std::vector<const Database*> databases;
  for (const auto& shelf : impl_->shelves) databases.push_back(&shelf.database);
  return run_search(databases, plan, vocabulary);
}

Result<std::shared_ptr<const Model>> Catalogue::load(const AssetRef& ref) const {
  const std::string key = asset_key(ref);
  std::unique_lock lock(impl_->mutex);
  if (auto model = impl_->models.find(key)) return model;
  const auto found = impl_->find(ref, key);
  lock.unlock();  // meshes are read beside each other
  if (!found) return found.error();
  auto model = impl_->read_model(*found);
  lock.lock();
  if (model) impl_->models.add(key, *model);
  return model;
}

Result<std::vector<AssetInfo>> Catalogue::all() const {
  const std::lock_guard lock(impl_->mutex);
  std::vector<AssetInfo> result;
  for (const auto& shelf : impl_->shelves) {
    Statement rows = shelf.database.prepare(std::string("SELECT ") + row_columns +
                                            " FROM assets ORDER BY asset");
    while (rows.step()) result.push_back(row_of(rows).info);
    if (auto status = rows.status(); !status) return with_context(status.error(), shelf.library);
  }
  return result;
}

Result<std::vector<LeftOutMesh>> Catalogue::left_out() const {
  const std::lock_guard lock(impl_->mutex);
  std::vector<LeftOutMesh> result;
  for (const auto& shelf : impl_->shelves) {
    auto rows = read_left_out(shelf.database, shelf.library);
    if (!rows) return with_context(rows.error(), shelf.library);
    result.insert(result.end(), rows->begin(), rows->end());
  }
  return result;
}

Result<AssetInfo> Catalogue::find(std::string_view name) const {
  const std::string whole(name);
  const std::lock_guard lock(impl_->mutex);
  for (const auto& shelf : impl_->shelves) {
    const std::string prefix = shelf.library + "/";
    if (whole.starts_with(prefix))
      if (auto row = find_row(shelf.database, whole.substr(prefix.size()))) return row->info;
    if (auto row = find_row(shelf.database, whole)) return row->info;
  }
  return unknown(whole);
}

std::vector<fs::path> installed_libraries() {
  const fs::path folder = "/usr/share/sweethome3d/furniture";
  std::vector<fs::path> result;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    // Reallusion holds human figures only.
    if (entry.path().extension() == ".sh3f" && entry.path().stem() != "Reallusion")
      result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

fs::path default_cache_dir() {
  const fs::path cache = environment_folder("XDG_CACHE_HOME"), home = environment_folder("HOME");
  const fs::path usual = !cache.empty()  ? cache / "roomgen"
                         : !home.empty() ? home / ".cache" / "roomgen"
                                         : fs::path();
  if (!usual.empty() && may_write_below(usual)) return usual;
  const auto closed = private_folder("roomgen");
  return closed ? *closed : usual;
}

Result<std::unique_ptr<Catalogue>> open_catalogue(const CatalogueOptions& options) {
  auto impl = std::make_unique<Catalogue::Impl>(options);
  for (const auto& path : options.libraries) {
    const std::string name = library_name(path);
    const bool doubled = std::any_of(impl->shelves.begin(), impl->shelves.end(),
                                     [&](const Shelf& shelf) { return shelf.library == name; });
    if (doubled)
      return Error{Error::Kind::invalid_input,
                   path.string() + ": another library is called \"" + name + "\", too; rename one"};
    const auto index = ensure_index(path, options);
    if (!index) return index.error();
    auto database = Database::open_read_only(*index);
    if (!database) return database.error();
    impl->shelves.push_back({name, path, *std::move(database), nullptr});
  }
  return std::make_unique<Catalogue>(std::move(impl));
}

Result<std::vector<std::string>> decoder_report(const CatalogueOptions& options) {
  return decode::decoder_confinement(decoder_options(options));
}

Result<Image> decode_image(std::string_view bytes, int max_side) {
  return decode::decode_image(bytes, max_side);
}

std::function<Result<Image>(std::string_view bytes)> picture_decoder(const CatalogueOptions& options, int max_side) {
  return [decoder = std::make_shared<decode::Decoder>(decoder_options(options)), max_side](std::string_view bytes) {
    return decoder->decode_picture(bytes, max_side);
  };
}

}  // namespace roomgen::assets
