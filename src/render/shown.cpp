#include "shown.h"

#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"
#include "view/layer_things.h"
#include "view/marks.h"

namespace roomgen::detail {

namespace {

const Eigen::Vector3f plan_wall_color(74, 76, 82), wall_top_color(214, 209, 200);
// Under marks: planks and shadows look like lines and furniture to who reads the picture.
const Eigen::Vector3f marked_floor_color(226, 223, 216);

ShellOptions shell_options(const View& view) {
  const bool plan = view.kind == View::Kind::top;
  ShellOptions options;
  options.top_color = plan ? plan_wall_color : wall_top_color;
  if (is_marked(view)) options.floor_color = marked_floor_color;
  options.door_leaves = !plan;  // drawn open, as a symbol
  options.ceiling = options.inner_doors_open = view.kind == View::Kind::eye;
  return options;
}

}  // namespace

bool is_marked(const View& view) { return view.marks && view.kind == View::Kind::top; }

std::vector<ShellPart> shown_shell(std::span<const Room> rooms, const ModelTable& models, const View& view,
                                   const Camera& camera) {
  ShellOptions options = shell_options(view);
  std::vector<ShellPart> parts;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    options.wall_heights = wall_heights(rooms, i, view, camera);
    for (auto& part : room_shell(rooms, i, options, models))
      parts.push_back({part_id(rooms[i], part.name), std::move(part.model)});
  }
  return parts;
}

std::string shell_key(std::span<const Room> rooms, const View& view, const Camera& camera) {
  Json key;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    key["rooms"].push_back(to_json(rooms[i]));
    key["heights"].push_back(wall_heights(rooms, i, view, camera));
  }
  key["kind"] = static_cast<int>(view.kind);
  key["marks"] = is_marked(view);
  return key.dump();
}

std::function<bool(const Object&)> shown_objects(const Scene& scene, const View& view, const Camera& camera) {
  if (is_marked(view))
    return [&scene, &view](const Object& object) { return !is_outline_only(scene, view, object); };
  // From above, lamps would hide what stands under them; their ceiling is off as well.
  if (view.kind == View::Kind::top) return [](const Object& object) { return object.mount != Mount::ceiling; };
  // What hangs on a lowered wall would float before the room.
  const auto rooms = rooms_of(scene);
  std::vector<std::vector<double>> heights;
  for (std::size_t i = 0; i < rooms.size(); ++i) heights.push_back(wall_heights(rooms, i, view, camera));
  return [&scene, rooms, heights](const Object& object) {
    const Room& room = room_of(scene, object);
    return !hangs_on_lowered_wall(room, object, heights[static_cast<std::size_t>(&room - rooms.data())]);
  };
}

std::shared_ptr<const Model> merged(std::vector<ShellPart> parts) {
  auto whole = std::make_shared<Model>();
  for (auto& part : parts) {
    const int first = static_cast<int>(whole->materials.size());
    for (auto& piece : part.model.parts)
      whole->parts.push_back({std::move(piece.mesh), piece.material + first});
    for (auto& material : part.model.materials) whole->materials.push_back(std::move(material));
  }
  return whole;
}

}  // namespace roomgen::detail
