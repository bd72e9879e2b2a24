#include "place_group.h"

#include <algorithm>

namespace roomgen {

namespace {

// What hangs does so at the height that is said, as far as the room allows.
double bottom_of(const composition::Member& member, const Object& object, const Room& room) {
  if (!member.height || object.mount == Mount::floor || object.mount == Mount::surface) return object.position.z();
  return std::clamp(*member.height - 0.5 * object.size.z(), 0.0, std::max(0.0, room.height - object.size.z()));
}

}  // namespace

std::vector<PlacementTask::Companion> companions(const composition::Arranged& arranged, const ThingOf& thing_of,
                                                 const Room& room, std::vector<std::size_t>& members) {
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
                                std::span<const composition::Arranged> ways, const ThingOf& thing_of,
                                const PlaceOptions& options, Random& random) {
  std::optional<PlacedGroup> best;
  std::optional<Error> refused;
  for (std::size_t way = 0; way < ways.size(); ++way) {
    PlacementTask task = anchor;
    std::vector<std::size_t> members;
    task.companions = companions(ways[way], thing_of, layout.room(), members);
    auto placed = place(layout, task, {}, options, random);
    if (options.cancel.cancelled()) return Error{Error::Kind::cancelled, "stopped"};
    if (!placed) {
      if (!refused) refused = placed.error();
      continue;
    }
    const bool is_better = !best || placed->terms.lost < best->placement.terms.lost;
    if (is_better) best = PlacedGroup{way, *std::move(placed), std::move(task)};
    if (best->placement.terms.lost == 0) break;
  }
  if (best) return *std::move(best);
  return *refused;
}

}  // namespace roomgen
