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
  scene.room.materials = {"black and white checkerboard floor", "striped wallpaper", "", "brick wall"};
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
  const Scene furnished = sample(models);
  Scene empty;
  empty.room = test::l_shaped_room();
  const bool ok = write(folder + "/furnished.glb", furnished, models) &&
                  write(folder + "/empty.glb", empty, models) &&
                  write(folder + "/boxes.glb", test::furnished_room(), {});
  return ok ? 0 : 1;
}
