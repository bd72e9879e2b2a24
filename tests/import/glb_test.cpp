#include "roomgen/import/import.h"

#include <Eigen/Geometry>

#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/export/exporter.h"
#include "support/damaged.h"
#include "support/furnished_room.h"
#include "support/random_mesh.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

// A room of things at other sizes than their models', one of them twice.
struct Furnished {
  Scene scene = test::furnished_room();
  ModelTable models;
};

Furnished furnished() {
  Furnished made;
  Random random(5);
  for (std::size_t i = 0; i < 3; ++i) {
    Model model = test::colored_box({1, 2, 0.5}, {200, 40, static_cast<float>(10 * i)});
    model.materials.push_back(model.materials[0]);
    model.materials[1].roughness = 0.25f;
    model.materials[1].double_sided = true;
    Mesh soup = shapes::random_soup(random, 40, 0.5);
    remove_degenerate(soup);  // as the writer does
    model.parts.push_back({std::move(soup), 1});
    test::use_model(made.scene.objects[i], made.models, "model-" + std::to_string(i), std::move(model));
  }
  made.scene.objects[4].asset = made.scene.objects[0].asset;
  return made;
}

std::string bytes_of(const Furnished& made, ExportOptions options = {}) {
  const auto bytes = make_glb(made.scene, made.models, options);
  REQUIRE(bytes);
  return *bytes;
}

Result<ModelTable> read_back(const std::string& bytes, const ImageDecoder& decode = {}) {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "scene.glb", bytes));
  return read_glb_models(folder / "scene.glb", decode);
}

double area_of(const Model& model) {
  double area = 0.0;
  const Mesh mesh = merged_mesh(model);
  for (const auto& t : mesh.triangles) {
    const Facet f = facet(mesh, t);
    area += 0.5 * (f.b - f.a).cross(f.c - f.a).norm();
  }
  return area;
}

}  // namespace

TEST_CASE("What was written is read back: each model by its key, where it was, with its materials") {
  const Furnished made = furnished();
  const auto read = read_back(bytes_of(made));
  REQUIRE(read);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string key = asset_key(made.scene.objects[i].asset);
    const auto expected = made.models.find(key), found = read->find(key);
    INFO(key);
    REQUIRE(found);
    CHECK((bounds(*found).low - bounds(*expected).low).norm() < 1e-5);
    CHECK((bounds(*found).high - bounds(*expected).high).norm() < 1e-5);
    CHECK(area_of(*found) == Approx(area_of(*expected)).epsilon(1e-4));
    REQUIRE(found->parts.size() == 2);
    const Material& first = found->materials[static_cast<std::size_t>(found->parts[0].material)];
    CHECK(first.base_color[0] == Approx(expected->materials[0].base_color[0]).margin(1e-4));
    const Material& second = found->materials[static_cast<std::size_t>(found->parts[1].material)];
    CHECK(second.roughness == Approx(0.25));
    CHECK(second.double_sided);
  }
}

TEST_CASE("Keys and names of materials come back whatever is in them") {
  Furnished made;
  Model model = test::colored_box({1, 1, 1}, {9, 9, 9});
  model.materials.push_back(model.materials[0]);
  model.parts.push_back({model.parts[0].mesh, 1});
  model.materials[0].name = "chêne: {oak}/1";
  model.materials[1].name = "_";
  auto& asset = made.scene.objects[0].asset;
  asset.procedural = ProceduralSource{"words", R"({"kind":"{}[0]: a/b"})", 3};
  made.models.add(asset_key(asset), std::make_shared<const Model>(model));
  const auto read = read_back(bytes_of(made));
  REQUIRE(read);
  const auto found = read->find(asset_key(asset));
  REQUIRE(found);
  CHECK(found->materials[0].name == "chêne: {oak}/1");
  CHECK(found->materials[1].name == "_");
}

TEST_CASE("Pictures go through the decoder, and are left out without one") {
  Furnished made;
  Model model = test::colored_box({1, 1, 1}, {255, 255, 255});
  model.materials[0].texture = test::checkerboard(false);
  test::use_model(made.scene.objects[0], made.models, "painted", std::move(model));
  ExportOptions options;
  options.encode_image = [](const Image&) -> Result<EncodedImage> { return EncodedImage{"image/png", "pixels"}; };
  const std::string bytes = bytes_of(made, options), key = asset_key(made.scene.objects[0].asset);
  CHECK_FALSE(read_back(bytes)->find(key)->materials[0].texture);
  std::string seen;
  const auto read = read_back(bytes, [&](std::string_view picture) -> Result<Image> {
    seen = picture;
    return Image(3, 2);
  });
  REQUIRE(read);
  CHECK(seen == "pixels");
  CHECK(read->find(key)->materials[0].texture->width == 3);
}

TEST_CASE("Damaged files are refused or read, whatever the damage") {
  const std::string sound = bytes_of(furnished());
  Random random(1);
  int refused = 0;
  for (int n = 0; n < 400; ++n) refused += !read_back(damaged(sound, random, 4000));
  for (std::size_t length = 0; length < sound.size(); length += 997) refused += !read_back(sound.substr(0, length));
  CHECK(refused > 100);
}

TEST_CASE("Errors name the file and what is wrong with it") {
  const auto none = read_back("nothing of the kind");
  REQUIRE_FALSE(none);
  CHECK(none.error().message.find("scene.glb: is no GLB file") != std::string::npos);
  CHECK_FALSE(read_glb_models("/nowhere/scene.glb"));
}
