#pragma once

#include <string>

#include "base/random.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// A room with so many boxes in a row.
inline Scene row_of_boxes(int count) {
  Scene scene;
  scene.prompt = "boxes";
  scene.room.type = "store";
  scene.room.polygon.points = {{0, 0}, {12, 0}, {12, 4}, {0, 4}};
  for (int i = 0; i < count; ++i) {
    Object box;
    box.id = "box-" + std::to_string(i);
    box.category = "box";
    box.size = {0.5, 0.5, 0.5};
    box.position = {0.5 + i, 2.0, 0.0};
    scene.objects.push_back(box);
  }
  RequirementVerdict asked;
  asked.requirement.id = "r1";
  asked.requirement.category = "box";
  asked.requirement.count = count;
  asked.requirement.clause = "boxes";
  asked.compliance = Compliance::met;
  scene.requirements.push_back(asked);
  return scene;
}

/// The scene otherwise: something moved, came, went, was locked, or another room.
inline Scene changed_by_chance(Scene scene, Random& random) {
  auto& objects = scene.objects;
  const int what = random.integer(0, 5);
  if (objects.empty() || what == 0) {
    Object box = row_of_boxes(1).objects.front();
    box.id = "box-" + std::to_string(random.integer(100, 1'000'000));
    if (find_object(scene, box.id)) return scene;
    const int at = random.integer(0, static_cast<int>(objects.size()));
    objects.insert(objects.begin() + at, box);
    return scene;
  }
  auto& one = objects[static_cast<std::size_t>(random.integer(0, static_cast<int>(objects.size()) - 1))];
  switch (what) {
    case 1: objects.erase(objects.begin() + (&one - objects.data())); break;
    case 2: one.locked = !one.locked; break;
    case 3: scene.room.materials.walls = "walls " + std::to_string(random.integer(0, 9)); break;
    case 4: scene.requirements.front().requirement.count = random.integer(0, 9); break;
    default: one.position.x() = 0.01 * random.integer(0, 1000); break;
  }
  return scene;
}

}  // namespace roomgen
