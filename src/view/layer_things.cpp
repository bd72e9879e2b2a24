#include "layer_things.h"

#include <algorithm>
#include <array>
#include <set>

namespace roomgen {

namespace {

// Numbers of what rooms are made of; kinds of things come after some that are kept free.
constexpr std::array<std::string_view, 6> room_categories = {"floor", "wall", "ceiling", "door", "window", "passage"};
constexpr std::size_t first_kind = 16;
constexpr std::size_t most_things = 65535;

// Of a part of a room or a known kind the same in every scene; 0 for others.
std::size_t known_category(const std::string& category) {
  const auto part = std::find(room_categories.begin(), room_categories.end(), category);
  if (part != room_categories.end()) return static_cast<std::size_t>(part - room_categories.begin()) + 1;
  const auto& kinds = KindTable::built_in().all();
  const auto kind = kinds.find(category);
  if (kind == kinds.end()) return 0;
  return first_kind + static_cast<std::size_t>(std::distance(kinds.begin(), kind));
}

// What no table knows comes after what it does, by name.
void number_categories(std::vector<LayerThing>& things) {
  std::set<std::string> others;
  for (auto& thing : things) {
    thing.category_id = static_cast<std::uint16_t>(known_category(thing.category));
    if (thing.category_id == 0) others.insert(thing.category);
  }
  const std::size_t first = first_kind + KindTable::built_in().all().size();
  for (auto& thing : things)
    if (thing.category_id == 0)
      thing.category_id =
          static_cast<std::uint16_t>(first + static_cast<std::size_t>(std::distance(
                                                 others.begin(), others.find(thing.category))));
}

}  // namespace

std::string part_id(const Room& room, const std::string& part) {
  return room.id.empty() ? part : room.id + "/" + part;
}

Result<std::vector<LayerThing>> layer_things(const Scene& scene) {
  std::vector<LayerThing> things;
  for (const auto& object : scene.objects) things.push_back({object.id, object.category});
  for (const auto& room : rooms_of(scene)) {
    const auto add = [&](const std::string& part, std::string_view category) {
      things.push_back({part_id(room, part), std::string(category)});
    };
    add("floor", "floor");
    for (std::size_t wall = 0; wall < room.polygon.size(); ++wall) add("wall-" + std::to_string(wall), "wall");
    add("ceiling", "ceiling");
    for (const auto& opening : room.openings) add(opening.id, name(opening.type));
  }
  if (things.size() >= most_things)
    return Error{Error::Kind::invalid_input, "the scene has " + std::to_string(things.size()) +
                                                 " things; layers number " + std::to_string(most_things) + " at most"};
  number_categories(things);
  return things;
}

void count_pixels(Layers& layers) {
  layers.categories.assign(layers.objects.size(), 0);
  for (std::size_t i = 0; i < layers.objects.size(); ++i) {
    if (layers.objects[i] == 0) continue;
    LayerThing& thing = layers.things[layers.objects[i] - 1u];
    layers.categories[i] = thing.category_id;
    ++thing.pixels;
  }
}

}  // namespace roomgen
