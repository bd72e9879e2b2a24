// Times the pictures of a furnished room: the first one, marks images as the step loop asks for
// them, and those of a large room for questions of each sort.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "roomgen/assets/catalogue.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "roomgen/render/pictures.h"

namespace {

using namespace roomgen;

double milliseconds(Renderer& renderer, const Scene& scene, const ModelTable& models,
                    const View& view) {
  const auto start = std::chrono::steady_clock::now();
  const auto image = renderer.render(scene, models, view);
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start;
  return image ? elapsed.count() : -1.0;
}

Object thing(const std::string& id, const Vec3& size, const Vec3& position, double degrees = 0.0) {
  Object object;
  object.id = id;
  object.category = id.substr(0, id.rfind('-'));
  object.size = size;
  object.position = position;
  object.yaw = radians(degrees);
  object.traits.front = true;
  return object;
}

void add_on(const Object& carrier, const std::string& id, const Vec3& size, Scene& scene) {
  Object object = thing(id, size, carrier.position + Vec3(0.2, 0.1, carrier.size.z()));
  object.mount = Mount::surface;
  object.on = carrier.id;
  scene.objects.push_back(object);
}

void add_hanging(const std::string& id, Mount mount, const Vec3& size, const Vec3& position,
                 Scene& scene) {
  scene.objects.push_back(
      thing(id, size, position, mount == Mount::wall && position.y() < 1.0 ? 180.0 : 0.0));
  scene.objects.back().mount = mount;
}

// 10 x 8 m, 60 things: 18 desks with their chairs, small things, lamps and pictures, a sideboard at
// a window.
Scene large_room() {
  Scene scene;
  scene.room.type = "classroom";
  scene.room.polygon.points = {{0, 0}, {10, 0}, {10, 8}, {0, 8}};
  Opening door, window;
  door.id = "door-0", door.wall = 1, door.from = 6.5, door.to = 7.4;
  window.id = "window-0", window.type = OpeningType::window, window.wall = 3, window.from = 2.0,
  window.to = 5.0;
  window.sill = default_sill, window.head = default_window_head;
  scene.room.openings = {door, window};
  for (int i = 0; i < 18; ++i) {
    const Vec3 at(1.6 + 1.3 * (i % 6), 2.0 + 1.7 * (i / 6), 0.0);
    scene.objects.push_back(thing("student desk-" + std::to_string(i), {0.7, 0.5, 0.74}, at));
    if (i % 3 == 0)
      add_on(scene.objects.back(), "book-" + std::to_string(i / 3), {0.2, 0.28, 0.04}, scene);
    scene.objects.push_back(
        thing("chair-" + std::to_string(i), {0.42, 0.44, 0.8}, at - Vec3(0.0, 0.4, 0.0), 180.0));
  }
  for (int i = 0; i < 6; ++i)
    add_hanging("pendant lamp-" + std::to_string(i), Mount::ceiling, {0.4, 0.4, 0.6},
                {2.5 + 2.5 * (i % 3), 2.6 + 2.6 * (i / 3), 2.1}, scene);
  for (int i = 0; i < 8; ++i)
    add_hanging("poster-" + std::to_string(i), Mount::wall, {0.6, 0.03, 0.8},
                {1.0 + 1.1 * i, i % 2 ? 0.015 : 7.985, 1.3}, scene);
  scene.objects.push_back(thing("sideboard-0", {1.6, 0.45, 0.8}, {0.23, 6.2, 0.0}, 90.0));
  scene.objects.push_back(thing("cupboard-0", {1.2, 0.45, 1.9}, {9.3, 0.23, 0.0}, 180.0));
  scene.objects.push_back(thing("kitchen island-0", {1.6, 0.9, 0.9}, {8.6, 5.6, 0.0}));
  scene.objects.back().traits.front = false;
  scene.objects.push_back(thing("rug-0", {2.2, 1.4, 0.01}, {5.2, 7.0, 0.0}));
  scene.objects.back().traits = {false, true, false};
  return scene;
}

struct Asked {
  const char* name;
  View view;
};

std::vector<Asked> asked_of(const Scene& scene) {
  View floor;
  floor.marks = true;
  floor.asked = Mount::floor;
  View again = floor, top = floor, walls = floor;
  again.free_floor = {{Vec2(6.8, 6.2), Vec2(9.0, 7.6)}};
  again.refused = {thing("sofa-0", {2.1, 0.9, 0.8}, {3.4, 5.9, 0.0}, 0.0),
                   thing("coffee table-0", {0.9, 0.5, 0.4}, {3.4, 4.9, 0.0})};
  again.in_the_way = {"student desk-13", "student desk-14"};
  top.asked = Mount::surface;
  top.part = footprint(scene.objects.front()).bounds();
  top.pixels = 512;
  walls.asked = Mount::wall;
  View elevation = walls;
  elevation.kind = View::Kind::elevation;
  return {
      {"floor", floor}, {"again", again}, {"top", top}, {"walls", walls}, {"elevation", elevation}};
}

// With a folder the pictures are written there.
void time_questions(Renderer& renderer, const char* folder) {
  const Scene scene = large_room();
  std::printf("\n| %zu things in 80 m2, 1024 px: asked | ms |\n|---|---|\n", scene.objects.size());
  for (const auto& [name, view] : asked_of(scene)) {
    std::vector<double> times;
    for (int i = 0; i < 5; ++i) times.push_back(milliseconds(renderer, scene, {}, view));
    std::printf("| %s: the first, then | %.0f, %.0f |\n", name, times.front(), times.back());
    const auto image = renderer.render(scene, {}, view);
    if (folder && image)
      if (auto status = write_png(std::string(folder) + "/" + name + ".png", *image); !status)
        std::puts(status.error().message.c_str());
  }
}

}  // namespace

int main(int count, char** arguments) {
  auto library = assets::open_catalogue({});
  auto renderer = make_osmesa_renderer();
  auto designer = make_rule_designer();
  PlanRequest request;
  request.prompt = "a large living room";
  request.seed = 3;  // 15 objects or more
  auto plan = designer->plan(request);
  if (!library || !renderer || !plan) return std::puts("(no furniture or no OSMesa)"), 0;
  auto room = generate(*plan, *designer, **library, KindTable::built_in());
  if (!room) return 1;
  time_questions(**renderer, count > 1 ? arguments[1] : nullptr);

  View marks;
  marks.marks = true;
  const double first = milliseconds(**renderer, room->scene, room->models, marks);
  // As in the step loop: one object more each time.
  Scene partial = room->scene;
  std::vector<double> steps;
  for (std::size_t count = 0; count <= room->scene.objects.size(); ++count) {
    partial.objects.assign(room->scene.objects.begin(),
                           room->scene.objects.begin() + static_cast<std::ptrdiff_t>(count));
    steps.push_back(milliseconds(**renderer, partial, room->models, marks));
  }
  std::vector<double> again;
  for (int i = 0; i < 9; ++i)
    again.push_back(milliseconds(**renderer, room->scene, room->models, marks));
  std::sort(again.begin(), again.end());
  std::sort(steps.begin(), steps.end());
  std::printf("| marks image, %zu objects, 1024 px | ms |\n|---|---|\n", room->scene.objects.size());
  std::printf("| the first | %.0f |\n| the same room again | %.0f |\n", first, again[again.size() / 2]);
  std::printf("| step by step, one object more each time: median | %.0f |\n| worst | %.0f |\n",
              steps[steps.size() / 2], steps.back());
}
