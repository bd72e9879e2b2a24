// Writes scenes with every feature of the GLB writer into the folder given.
#include <cstdio>

#include "roomgen/export/exporter.h"
#include "support/furnished_room.h"
#ifdef ROOMGEN_HAS_RENDER
#include "roomgen/render/pictures.h"
#endif

using namespace roomgen;

namespace {

Scene sample(ModelTable& models) {
  Scene scene = test::furnished_room();
  Model wood = test::colored_box({1, 1, 1}, {255, 255, 255});
  wood.materials[0].texture = test::checkerboard(false);
  test::use_model(scene.objects[0], models, "bed", wood);
  test::use_model(scene.objects[1], models, "desk", wood);
  Model leaves = wood;
  leaves.materials[0].texture = test::checkerboard(true);
  leaves.materials[0].double_sided = true;
  test::use_model(scene.objects[2], models, "plant", leaves);
  Model glass = test::colored_box({1, 1, 1}, {200, 220, 255}, 0.3f);
  glass.parts[0].mesh.triangles.push_back({0, 0, 1});  // no area
  glass.parts[0].mesh.normals[3].setZero();
  test::use_model(scene.objects[3], models, "glass", glass);
  scene.objects[3].description = "caf\xe9 table";  // not UTF-8
  test::use_model(scene.objects[4], models, "nothing", Model{});
  scene.objects.push_back(test::box("spot-0", {0.2, 0.3, 0.5}, {0.3, 1.7, 0.74}));
  scene.objects.back().category = "desk lamp";
  scene.room.materials = {"black and white checkerboard floor", "striped wallpaper", "", {{std::string(accent_name), "brick wall"}}};
  return scene;
}

// Things made from words, with ids and materials that have in them what breaks readers.
Scene created(ModelTable& models) {
  Scene scene = test::furnished_room();
  const char* ids[] = {"{0} bed", "bed_0", "bed 0", "кровать/0", "a \"chair\": [0]"};
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    auto& object = scene.objects[i];
    object.id = ids[i];
    object.asset.procedural = ProceduralSource{"words", R"({"kind":"bed","n":)" + std::to_string(i / 2) + "}", 1};
    Model model = test::colored_box({1, 1, 1}, {200, 220, 255});
    model.materials[0].name = "{wood}";
    model.materials.push_back(model.materials[0]);
    model.materials[1].roughness = 0.1f;
    model.parts.push_back({model.parts[0].mesh, 1});
    models.add(asset_key(object.asset), std::make_shared<const Model>(std::move(model)));
  }
  scene.objects[3].on = ids[1];
  return scene;
}

bool write(const std::string& path, const Scene& scene, const ModelTable& models) {
  ExportOptions options;
#ifdef ROOMGEN_HAS_RENDER
  options.encode_image = encode_texture;
#endif
  const auto status = GlbExporter(options).write(scene, models, path);
  if (!status) std::fprintf(stderr, "%s: %s\n", path.c_str(), status.error().message.c_str());
  return status.ok();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : ".";
  ModelTable models;
  const Scene furnished = sample(models), of_words = created(models);
  Scene empty;
  empty.room = test::l_shaped_room();
  const bool ok = write(folder + "/furnished.glb", furnished, models) &&
                  write(folder + "/created.glb", of_words, models) &&
                  write(folder + "/empty.glb", empty, models) &&
                  write(folder + "/boxes.glb", test::furnished_room(), {});
  return ok ? 0 : 1;
}
