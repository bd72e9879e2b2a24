#include "models.h"

#include <algorithm>
#include <optional>

#include "print.h"
#include "roomgen/import/import.h"
#ifdef ROOMGEN_HAS_ASSETS
#include "roomgen/assets/catalogue.h"
#endif

namespace roomgen::cli {

namespace {

ImageDecoder image_decoder() {
#ifdef ROOMGEN_HAS_ASSETS
  return assets::picture_decoder({.libraries = {}, .cache_dir = {}});
#else
  return {};
#endif
}

bool is_all_boxes(const Scene& scene) {
  const auto rooms = rooms_of(scene);
  return std::all_of(scene.objects.begin(), scene.objects.end(),
                     [](const Object& object) { return object.asset.is_box(); }) &&
         std::all_of(rooms.begin(), rooms.end(), [](const Room& room) {
           return std::all_of(
               room.openings.begin(), room.openings.end(),
               [](const Opening& opening) { return opening.joinery.asset.is_box(); });
         });
}

// The meshes that were written with the scene, read when one is first asked for.
class WrittenModels {
 public:
  explicit WrittenModels(const std::filesystem::path& scene_file)
      : path_(scene_file.parent_path() / "scene.glb") {}

  std::shared_ptr<const Model> operator()(const std::string& key) {
    if (!models_) models_ = read();
    return models_->find(key);
  }

 private:
  ModelTable read() const {
    std::error_code code;
    if (!std::filesystem::is_regular_file(path_, code)) return {};
    auto models = read_glb_models(path_, image_decoder());
    if (models) return *std::move(models);
    warn(models.error().message);
    return {};
  }

  std::filesystem::path path_;
  std::optional<ModelTable> models_;
};

// Without libraries nothing is found, and only what was written with the scene is there.
class NoLibrary final : public AssetLibrary {
 public:
  Result<std::vector<AssetMatch>> search(const AssetQuery&) const override {
    return std::vector<AssetMatch>();
  }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    return Error{Error::Kind::not_found, asset_key(ref) + ": no library is open"};
  }
};

Result<std::unique_ptr<AssetLibrary>> open_for(const ModelOptions& options,
                                               const Context& context) {
#ifdef ROOMGEN_HAS_ASSETS
  return open_all_libraries(options.libraries, context);
#else
  static_cast<void>(options), static_cast<void>(context);
  return std::unique_ptr<AssetLibrary>(std::make_unique<NoLibrary>());
#endif
}

}  // namespace

void add_model_options(CLI::App& command, ModelOptions& options) {
#ifdef ROOMGEN_HAS_ASSETS
  add_library_options(command, options.libraries);
#else
  static_cast<void>(command), static_cast<void>(options);
#endif
}

SpareModels written_models(const std::filesystem::path& scene_file) { return WrittenModels(scene_file); }

Result<ModelTable> models_of(const Scene& scene, const std::filesystem::path& file,
                             const ModelOptions& options, const Context& context) {
  if (is_all_boxes(scene)) return ModelTable();
  auto library = open_for(options, context);
  if (!library) return library.error();
  const auto tell = [](LogLevel, std::string_view message) { warn(std::string(message) + "; taken as a box"); };
  ModelTable models = load_models(scene, **library, tell, written_models(file));
  if (context.cancel.cancelled()) return Error{Error::Kind::cancelled, "stopped while meshes were read"};
  return models;
}

}  // namespace roomgen::cli
