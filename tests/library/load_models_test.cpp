#include "catch.h"
#include "roomgen/library/library.h"
#include "support/rooms.h"

using namespace roomgen;

namespace {

/// Has everything; each model has a texture of its own, of so many bytes.
class Everything final : public AssetLibrary {
 public:
  explicit Everything(std::size_t bytes = 0) : bytes_(bytes) {}
  Result<std::vector<AssetMatch>> search(const AssetQuery&) const override { return std::vector<AssetMatch>(); }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    if (ref.id == "missing") return Error{Error::Kind::not_found, "is missing"};
    Model model;
    auto image = std::make_shared<Image>();
    image->pixels.resize(bytes_);
    model.materials.push_back({});
    model.materials.back().texture = std::move(image);
    return std::make_shared<const Model>(std::move(model));
  }

 private:
  std::size_t bytes_;
};

Scene scene_of(std::size_t models) {
  Scene scene = rooms::scene(rooms::box(4, 4), {});
  for (std::size_t i = 0; i < models; ++i) {
    scene.objects.push_back(rooms::thing("a-" + std::to_string(i), "thing", {1, 1, 1}));
    scene.objects.back().asset.library = "l";
    scene.objects.back().asset.id = std::to_string(i);
  }
  return scene;
}

struct Loaded {
  std::size_t models = 0;
  std::vector<std::string> told;
};

Loaded loaded(const Scene& scene, const AssetLibrary& library, const ModelLimits& limits = {}) {
  Loaded loaded;
  const auto tell = [&](LogLevel, std::string_view text) { loaded.told.emplace_back(text); };
  const auto models = load_models(scene, library, tell, {}, limits);
  for (const auto& object : scene.objects) loaded.models += models.find(asset_key(object.asset)) ? 1 : 0;
  return loaded;
}

}  // namespace

TEST_CASE("A thousand different models are read, and what is beyond them is told once") {
  const auto all = loaded(scene_of(1000), Everything());
  CHECK(all.models == 1000);
  CHECK(all.told.empty());
  const auto most = loaded(scene_of(1500), Everything());
  CHECK(most.models == 1000);
  REQUIRE(most.told.size() == 1);
  CHECK(most.told[0].starts_with("a-1000 and what comes after it"));
  Scene same = scene_of(2000);
  for (auto& object : same.objects) object.asset.id = "one";
  CHECK(loaded(same, Everything()).models == 2000);
}

TEST_CASE("So many bytes of models are read") {
  const auto most = loaded(scene_of(20), Everything(100), {.models = 1000, .bytes = 1000});
  CHECK(most.models == 10);  // the one with which it is full is the last
  CHECK(most.told.size() == 1);
}

TEST_CASE("A model that is missing is told of each thing of it") {
  Scene scene = scene_of(3);
  for (auto& object : scene.objects) object.asset.id = "missing";
  CHECK(loaded(scene, Everything()).told.size() == 3);
}
