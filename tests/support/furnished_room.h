#pragma once

#include <string>

#include "base/random.h"
#include "roomgen/scene/scene.h"
#include "scene/finish.h"

// Scenes and models for tests of pictures and files. They need not make sense to live in.
namespace roomgen::test {

inline Object box(const std::string& id, const Vec3& size, const Vec3& position, double yaw = 0.0) {
  Object object;
  object.id = id;
  object.category = id.substr(0, id.find('-'));
  object.size = size;
  object.position = position;
  object.yaw = yaw;
  return object;
}

inline Opening opening(const std::string& id, std::size_t wall, double from, double to) {
  Opening result;
  result.id = id;
  result.wall = wall;
  result.from = from;
  result.to = to;
  if (id.starts_with("window")) {
    result.type = OpeningType::window;
    result.sill = default_sill;
    result.head = default_window_head;
  }
  return result;
}

/// 4 x 3 m, a door in the south wall, a window in the north wall.
inline Room plain_room() {
  Room room;
  room.type = "bedroom";
  room.polygon.points = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  room.openings = {opening("door-0", 0, 0.5, 1.4), opening("window-0", 2, 1.0, 3.0)};
  return room;
}

inline Room l_shaped_room() {
  Room room;
  room.type = "living room";
  room.polygon.points = {{0, 0}, {6, 0}, {6, 3}, {4, 3}, {4, 5}, {0, 5}};
  room.openings = {opening("door-0", 0, 4.6, 5.5), opening("window-0", 4, 1.0, 3.0),
                   opening("window-1", 5, 1.5, 3.5)};
  return room;
}

/// A bed, a turned desk with a chair, a lamp on the desk, a round rug.
inline Scene furnished_room() {
  Scene scene;
  scene.room = plain_room();
  scene.objects = {box("bed-0", {1.6, 2.0, 0.5}, {2.6, 2.0, 0}),
                   box("desk-0", {1.2, 0.6, 0.74}, {0.3, 2.0, 0}, radians(90)),
                   box("chair-0", {0.45, 0.5, 0.9}, {0.9, 2.0, 0}, radians(-80)),
                   box("lamp-0", {0.2, 0.2, 0.4}, {0.3, 2.4, 0.74}),
                   box("rug-0", {1.2, 1.2, 0.02}, {2.6, 0.6, 0})};
  scene.objects[3].traits = {false, false, true};
  scene.objects[3].mount = Mount::surface;
  scene.objects[3].on = "desk-0";
  scene.objects[4].traits = {false, true, true};
  return scene;
}

/// Up to 40 objects anywhere in a room of 3 to 12 m, overlapping as they like.
inline Scene random_scene(std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const double width = random.uniform(3, 12), depth = random.uniform(3, 12);
  scene.room.polygon.points = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  const int count = random.integer(1, 40);
  for (int i = 0; i < count; ++i) {
    const Vec3 size(random.uniform(0.1, 2.2), random.uniform(0.1, 1.2), random.uniform(0.1, 2.0));
    const Vec3 position(random.uniform(0.3, width - 0.3), random.uniform(0.3, depth - 0.3), 0);
    const char* kinds[] = {"bed", "chair", "dining-table", "nightstand", "lamp", "bookshelf"};
    scene.objects.push_back(box(std::string(kinds[random.integer(0, 5)]) + "-" + std::to_string(i),
                                size, position, random.uniform(-pi, pi)));
    scene.objects.back().traits.front = random.chance(0.7);
  }
  return scene;
}

/// A box of one material that fills this size.
inline Model colored_box(const Vec3& size, const Eigen::Vector3f& srgb, float alpha = 1.0f) {
  Model model;
  Material material;
  material.base_color = material_color(srgb, alpha);
  model.materials = {material};
  const Vec3 half(0.5 * size.x(), 0.5 * size.y(), 0);
  model.parts = {{make_box(-half, half + Vec3(0, 0, size.z())), 0}};
  return model;
}

/// A checkerboard of two colours; every other square is hollow if `hollow`.
inline std::shared_ptr<const Image> checkerboard(bool hollow) {
  auto image = std::make_shared<Image>(16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const bool odd = (x / 4 + y / 4) % 2 == 1;
      const std::uint8_t pixel[4] = {255, static_cast<std::uint8_t>(odd ? 255 : 0), 0,
                                     static_cast<std::uint8_t>(odd && hollow ? 0 : 255)};
      std::copy(pixel, pixel + 4, image->at(x, y));
    }
  return image;
}

/// Gives an object a model under a key of its own.
inline void use_model(Object& object, ModelTable& models, const std::string& id, Model model) {
  object.asset.library = "test";
  object.asset.id = id;
  object.asset.license = "CC0";
  object.asset.creator = "nobody";
  models.add(asset_key(object.asset), std::make_shared<Model>(std::move(model)));
}

}  // namespace roomgen::test
