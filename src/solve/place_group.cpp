#include "place_group.h"

#include <algorithm>

#include "propose.h"

namespace roomgen {

namespace {

// What hangs does so at the height that is said, as far as the room allows.
double bottom_of(const composition::Member& member, const Object& object, const Room& room) {
  if (!member.height || object.mount == Mount::floor || object.mount == Mount::surface)
    return object.position.z();
  return std::clamp(*member.height - 0.5 * object.size.z(), 0.0,
                    std::max(0.0, room.height - object.size.z()));
}

// Whichever way it is turned; in a room of four walls square to them.
bool may_fit(const Vec2& group, const Polygon& room) {
  const Vec2 box = bounds(room).size();
  const double longest = room.size() == 4 ? box.maxCoeff() : box.norm();
  return group.minCoeff() <= box.minCoeff() && group.maxCoeff() <= longest &&
         group.prod() <= box.prod();
}

// To leave the place that was said is a loss as well.
int loss(const PlacementTerms& terms) {
  constexpr double elsewhere = 0.5;
  return terms.lost + (terms.off > elsewhere ? 1 : 0);
}

}  // namespace

std::vector<PlacementTask::Companion> companions(const composition::Arranged& arranged,
                                                 const ThingOf& thing_of, const Room& room,
                                                 std::vector<std::size_t>& members) {
  std::vector<PlacementTask::Companion> found;
  for (std::size_t i = 1; i < arranged.members.size(); ++i) {
    const auto& member = arranged.members[i];
    const Object* object = member.mount == Mount::surface ? nullptr : thing_of(member);
    if (!object) continue;
    found.push_back({*object, member.place.position, member.place.yaw});
    found.back().object.position.z() = bottom_of(member, *object, room);
    members.push_back(i);
  }
  return found;
}

Result<PlacedGroup> place_group(Layout& layout, const PlacementTask& anchor,
                                const WaysToPlace& group, const PlaceOptions& options,
                                Random& random) {
  std::optional<PlacedGroup> best;
  std::optional<Error> refused;
  for (std::size_t way = 0; way < group.ways.size(); ++way) {
    PlacementTask task = anchor;
    std::vector<std::size_t> members;
    task.companions = companions(group.ways[way], group.thing_of, layout.room(), members);
    if (!may_fit(box_with_companions(task).size(), layout.room().polygon)) continue;
    auto placed = place(layout, task, {}, options, random);
    if (options.cancel.cancelled()) return Error{Error::Kind::cancelled, "stopped"};
    if (!placed) {
      if (!refused) refused = placed.error();
      continue;
    }
    const bool is_better = !best || loss(placed->terms) < loss(best->placement.terms);
    if (is_better) best = PlacedGroup{way, *std::move(placed), std::move(task)};
    if (loss(best->placement.terms) == 0) break;
  }
  if (best) return *std::move(best);
  if (refused) return *refused;
  return Error{Error::Kind::not_found,
               "the room is too small for the group of " + anchor.object.id};
}

}  // namespace roomgen
