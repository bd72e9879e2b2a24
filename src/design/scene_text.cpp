#include "scene_text.h"

#include <cmath>

#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"
#include "scene/judgement.h"

namespace roomgen::design {

namespace {

std::string metres(double value) {
  return format_number(value, 2);
}

std::string_view kind_of(const Opening& opening) {
  if (!opening.kind.empty()) return opening.kind;
  switch (opening.type) {
    case OpeningType::door:
      return "door";
    case OpeningType::window:
      return "window";
    case OpeningType::passage:
      return "passage";
  }
  return "opening";
}

double shown_degrees(double yaw) {
  return std::fmod(std::round(degrees(yaw)) + 360.0, 360.0);
}

std::string with_verdicts(const Object& object, const Room& room,
                          const std::vector<Object>& objects) {
  const auto resolved = resolve(object, room, objects, KindTable::built_in());
  const Subject subject{footprint(object), bottom(object), top(object)};
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < resolved.size(); ++i)
    texts.push_back(to_text(object.relations[i]) +
                    (judge(resolved[i], subject, room).held ? "" : " (does not hold)"));
  return join(texts, " | ");
}

}  // namespace

SceneText::SceneText(const Room& room, bool paper_frame)
    : room_(room), paper_frame_(paper_frame), bounds_(bounds(room.polygon)) {}

std::string SceneText::point(const Vec2& position) const {
  const Vec2 shown = paper_frame_
                         ? Vec2(bounds_.high.y() - position.y(), bounds_.high.x() - position.x())
                         : position;
  return "(" + metres(shown.x()) + ", " + metres(shown.y()) + ")";
}

std::string SceneText::frame() const {
  if (paper_frame_)
    return "Metres. The origin is the top right corner of the room in the picture; x grows "
           "downwards, y grows "
           "to the left.";
  return "Metres. x grows to the right of the picture, y grows upwards; the bottom left corner of "
         "the room is " +
         point(bounds_.low) + ", its top right corner " + point(bounds_.high) + ".";
}

std::string SceneText::room() const {
  const Vec2 size = bounds_.size();
  std::string text = room_.type + ", " + metres(size.x()) + " m from left to right, " +
                     metres(size.y()) + " m from bottom to top, " + metres(room_.height) +
                     " m high; corners";
  for (const auto& corner : room_.polygon.points) text += " " + point(corner);
  return text;
}

std::string SceneText::parts() const {
  std::string text;
  for (std::size_t k = 0; k < room_.polygon.size(); ++k) {
    const Segment wall = room_.polygon.edge(k);
    text += "wall-" + std::to_string(k) + " from " + point(wall.a) + " to " + point(wall.b) + "\n";
  }
  for (const auto& opening : room_.openings) {
    const Segment line = segment(room_, opening);
    text += opening.id + ": a " + std::string(kind_of(opening)) + " in wall-" +
            std::to_string(opening.wall) + " from " + point(line.a) + " to " + point(line.b) + "\n";
  }
  return text;
}

std::string SceneText::placed(const std::vector<Object>& objects, bool places) const {
  if (objects.empty()) return "nothing yet";
  std::string text;
  for (const auto& object : objects) {
    text += object.id + "; " + object.category + "; " + size_text(object.size) + "; ";
    if (places)
      text += point(object.position.head<2>()) + "; " + metres(shown_degrees(object.yaw)) + "; ";
    text += with_verdicts(object, room_, objects) + "\n";
  }
  text.pop_back();
  return text;
}

std::string SceneText::free_floor(const std::vector<Bounds2>& parts) const {
  std::vector<std::string> texts;
  for (const auto& part : parts) {
    const Vec2 size = paper_frame_ ? Vec2(part.size().y(), part.size().x()) : part.size();
    texts.push_back(metres(size.x()) + " x " + metres(size.y()) + " about " +
                    point(0.5 * (part.low + part.high)));
  }
  return texts.empty() ? "none" : join(texts, "; ");
}

std::string SceneText::answer(const PlaceAdvice& advice) const {
  std::string text = advice.relations.empty() ? "no constraints" : to_text(advice.relations);
  if (advice.location) text += "; at " + point(*advice.location);
  if (advice.yaw) text += "; facing " + metres(shown_degrees(*advice.yaw));
  return text;
}

std::string size_text(const Vec3& size) {
  return metres(size.x()) + " x " + metres(size.y()) + " x " + metres(size.z());
}

}  // namespace roomgen::design
