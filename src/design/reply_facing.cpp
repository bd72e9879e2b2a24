#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "brief/reply_measure.h"
#include "place_answers.h"
#include "reply_words.h"
#include "roomgen/base/text.h"
#include "scene/judgement.h"
#include "scene/room_part.h"

namespace roomgen::design {

namespace {

constexpr double most_degrees = 3600.0;
constexpr double least_distance = 1e-3;

struct CompassPoint {
  std::string_view name;
  double x, y;
};
constexpr std::array compass = {CompassPoint{"north", 0, 1},      CompassPoint{"south", 0, -1},
                                CompassPoint{"east", 1, 0},       CompassPoint{"west", -1, 0},
                                CompassPoint{"northeast", 1, 1},  CompassPoint{"northwest", -1, 1},
                                CompassPoint{"southeast", 1, -1}, CompassPoint{"southwest", -1, -1},
                                CompassPoint{"+y", 0, 1},         CompassPoint{"-y", 0, -1},
                                CompassPoint{"+x", 1, 0},         CompassPoint{"-x", -1, 0}};

constexpr std::array facing_fillers = {"face", "facing",  "faces",  "look", "looking", "looks",
                                       "to",   "towards", "toward", "at",   "the"};
constexpr std::array degree_words = {"", "deg", "degree", "degrees", "yaw", "rotation"};

std::optional<double> compass_yaw(const std::string& text) {
  for (const std::string& name : {lower(trim(text)), join(words(text), "")})
    for (const auto& point : compass)
      if (point.name == name) return yaw_facing({point.x, point.y});
  return std::nullopt;
}

// A number with nothing but words for degrees around it.
std::optional<double> degrees_in(const Json& value) {
  if (value.is_string())
    for (const auto& word : words(value.get_ref<const std::string&>())) {
      const bool digit = word.find_first_not_of("0123456789\xC2\xB0") == std::string::npos;
      if (!digit && !is_one_of(word, degree_words)) return std::nullopt;
    }
  const auto measure = brief::single_measure(value);
  if (!measure || measure->has_unit) return std::nullopt;
  return measure->value;
}

// "facing the desk-0" is "desk-0".
std::string target_text(const std::string& text) {
  std::vector<std::string> pieces = words(text);
  std::size_t skipped = 0;
  while (skipped < pieces.size() && is_one_of(pieces[skipped], facing_fillers)) ++skipped;
  if (skipped == 0) return text;
  return join({pieces.begin() + static_cast<std::ptrdiff_t>(skipped), pieces.end()}, " ");
}

std::optional<Vec2> centre_of(const Scene& scene, const std::string& id) {
  if (const Object* object = find_object(scene, id)) return Vec2(object->position.head<2>());
  if (const auto part = part_of_room(scene.room, id)) return part->center();
  return std::nullopt;
}

ReplyFacing facing_target(const std::string& id, const Scene& scene,
                          const std::optional<Vec2>& location) {
  const auto part = part_of_room(scene.room, id);
  if (part && !find_opening(scene.room, id)) return {yaw_facing(-part->front()), std::nullopt};
  const auto centre = centre_of(scene, id);
  if (location && centre && (*centre - *location).norm() > least_distance)
    return {yaw_facing(*centre - *location), std::nullopt};
  return {std::nullopt, Relation{RelationKind::face_to, id}};
}

}  // namespace

ReplyFacing read_reply_facing(const Json& value, const Scene& scene, const TargetNames& targets,
                              const std::optional<Vec2>& location,
                              ReplyNotes& notes) {
  if (const auto angle = degrees_in(value)) {
    if (std::abs(*angle) <= most_degrees) return {wrap_angle(radians(*angle)), std::nullopt};
    notes.lose("a facing of more than ten turns was dropped");
    return {};
  }
  if (!value.is_string()) {
    notes.lose("the facing is neither degrees nor the id of a target");
    return {};
  }
  const std::string text = value.get<std::string>();
  const std::string name = target_text(text);
  for (const auto& spelling : {text, name})
    if (const auto yaw = compass_yaw(spelling)) return {yaw, std::nullopt};
  const NamedTarget target = targets.find(name);
  if (target.id.empty()) return notes.lose("facing: " + target.repair), ReplyFacing();
  if (!target.repair.empty()) notes.repair("facing: " + target.repair);
  return facing_target(target.id, scene, location);
}

}  // namespace roomgen::design
