#include "on_top.h"

#include <algorithm>

#include "targets.h"

namespace roomgen::design {

namespace {

// Where on its carrier a small thing stands: the middle, or wherever is still free.
std::optional<Pose> on_top(const Sketch& sketch, const Object& self, const Target& carrier) {
  const Footprint& fp = carrier.footprint;
  const Vec2 room = (fp.half() - 0.5 * self.size.head<2>()).cwiseMax(0.0);
  for (double y : {0.0, 0.6, -0.6})
    for (double x : {0.0, 0.5, -0.5, 0.85, -0.85}) {
      const Pose pose{fp.to_world({x * room.x(), y * room.y()}), fp.yaw()};
      const Footprint own = footprint_at(self, pose);
      if (std::none_of(sketch.standing().begin(), sketch.standing().end(),
                       [&](const Standing& one) {
                         return one.object->on == carrier.id && overlaps(own, one.footprint, 0.005);
                       }))
        return pose;
    }
  return std::nullopt;
}

}  // namespace

PlaceAdvice advise_on(const Sketch& sketch, const Object& self, const Arrangement& arrangement,
                      std::vector<Relation> asked, const std::string& on, std::size_t refused) {
  auto ways = arrangement.ways;
  if (!on.empty()) ways.insert(ways.begin(), {Relation{RelationKind::on, on}});
  const bool told = std::any_of(asked.begin(), asked.end(), [](const Relation& relation) {
    return relation.kind == RelationKind::on;
  });
  if (told) ways = {{}};
  std::size_t skip = refused;
  for (const auto& way : ways) {
    std::vector<Choice> choices = resolve(sketch, self, way);
    if (choices.empty() && !way.empty() && !sketch.find(way.front().target).empty())
      choices.push_back({way, 0.0});
    for (const auto& choice : choices) {
      auto relations = asked;
      relations.insert(relations.end(), choice.relations.begin(), choice.relations.end());
      for (const auto& relation : relations) {
        if (relation.kind != RelationKind::on) continue;
        for (const auto& carrier : sketch.find(relation.target)) {
          const auto pose = on_top(sketch, self, carrier);
          if (!pose || skip-- > 0) continue;
          return {relations, pose->position, pose->yaw, "on " + carrier.id};
        }
      }
    }
  }
  return {asked, std::nullopt, std::nullopt, "nothing is there to carry it"};
}

}  // namespace roomgen::design
