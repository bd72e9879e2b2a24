#include "decode/model_bytes.h"

#include "base/random.h"
#include "catch.h"
#include "support/damaged.h"

using namespace roomgen;

namespace {

std::shared_ptr<const Image> random_image(Random& random) {
  const int width = random.integer(1, 8), height = random.integer(1, 8);
  auto image = std::make_shared<Image>(width, height);
  for (auto& value : image->pixels) value = static_cast<std::uint8_t>(random.integer(0, 255));
  return image;
}

Model random_model(Random& random) {
  Model model;
  const auto shared = random_image(random);
  const int parts = random.integer(1, 4);
  for (int i = 0; i < parts; ++i) {
    Material material;
    material.name = "material " + std::to_string(i);
    material.roughness = static_cast<float>(random.uniform());
    material.double_sided = random.chance(0.5);
    if (random.chance(0.6)) material.texture = random.chance(0.5) ? shared : random_image(random);
    model.materials.push_back(material);
    ModelPart part;
    part.material = i;
    part.mesh = make_box(Vec3(0, 0, 0), Vec3(1, 1, random.uniform(0.1, 2.0)));
    if (random.chance(0.3)) part.mesh.uvs.clear();
    model.parts.push_back(part);
  }
  return model;
}

// What the rest of the program relies on.
void check_sound(const Model& model) {
  for (const auto& part : model.parts) {
    REQUIRE(part.material >= 0);
    REQUIRE(static_cast<std::size_t>(part.material) < model.materials.size());
    const std::size_t count = part.mesh.positions.size();
    CHECK((part.mesh.normals.empty() || part.mesh.normals.size() == count));
    CHECK((part.mesh.uvs.empty() || part.mesh.uvs.size() == count));
    for (const auto& triangle : part.mesh.triangles)
      for (const auto index : triangle) REQUIRE(index < count);
  }
  for (const auto& material : model.materials) {
    CHECK((material.roughness >= 0.0f && material.roughness <= 1.0f));
    if (!material.texture) continue;
    const Image& image = *material.texture;
    CHECK(image.pixels.size() == 4 * static_cast<std::size_t>(image.width) * image.height);
  }
}

}  // namespace

TEST_CASE("A model comes back from its bytes as it was") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Model model = random_model(random);
    const auto back = decode::model_from(decode::bytes_of(model), {});
    REQUIRE(back);
    REQUIRE(back->parts.size() == model.parts.size());
    for (std::size_t k = 0; k < model.parts.size(); ++k) {
      CHECK(back->parts[k].mesh.positions == model.parts[k].mesh.positions);
      CHECK(back->parts[k].mesh.uvs == model.parts[k].mesh.uvs);
      CHECK(back->parts[k].mesh.triangles == model.parts[k].mesh.triangles);
      CHECK(back->materials[k].name == model.materials[k].name);
      const auto &before = model.materials[k].texture, &after = back->materials[k].texture;
      CHECK(!before == !after);
      if (before && after) CHECK(before->pixels == after->pixels);
    }
    check_sound(*back);
  }
}

TEST_CASE("A picture comes back from its bytes, if it is no larger than asked for") {
  Random random(4);
  const auto image = random_image(random);
  const auto bytes = decode::bytes_of(*image);
  const auto back = decode::image_from(bytes, 8);
  REQUIRE(back);
  CHECK(back->pixels == image->pixels);
  CHECK_FALSE(decode::image_from(bytes, std::max(image->width, image->height) - 1));
  CHECK_FALSE(decode::image_from(bytes + "x", 8));
  for (int i = 0; i < 500; ++i)
    if (const auto one = decode::image_from(damaged(bytes, random, 40), 8))
      CHECK(one->pixels.size() == 4 * static_cast<std::size_t>(one->width) * one->height);
}

TEST_CASE("Damaged bytes give an error or a sound model") {
  Random random(2);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto back = decode::model_from(damaged(decode::bytes_of(random_model(random)), random, 40), {});
    if (back)
      check_sound(*back);
    else
      ++refused;
  }
  CHECK(refused > 1000);
}

TEST_CASE("A model with more triangles or larger pictures than asked for is refused") {
  Random random(3);
  Model model = random_model(random);
  model.materials[0].texture = std::make_shared<Image>(16, 4);
  const auto bytes = decode::bytes_of(model);
  CHECK(decode::model_from(bytes, {.max_texture_side = 16}));
  CHECK_FALSE(decode::model_from(bytes, {.max_texture_side = 15}));
  CHECK_FALSE(decode::model_from(bytes, {.max_triangles = triangle_count(model) - 1}));
}
