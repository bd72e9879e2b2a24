#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "collision/usability.h"

namespace roomgen {

/// Which use zones of the things of a layout are free, brought up to date with each thing that comes or goes: who
/// tries a newcomer at many places asks only whether it stands in a zone itself.
class FreeZones {
 public:
  /// Of things without zones of their own there are none.
  struct Zone {
    Footprint area;
    bool is_inside = false;  ///< of the room
    int blockers = 0;        ///< things in it that may not stand there
  };

  /// The last of the things has come.
  void add(const Room& room, std::span<const FloorThing> things);
  /// The i-th of the things is about to go.
  void remove(std::span<const FloorThing> things, std::size_t i);

  /// The i-th thing has no zones, or what stands already leaves none of them free: no newcomer is to blame.
  bool has_lost_all(std::size_t i) const {
    return std::ranges::none_of(zones_[i], [](const Zone& zone) { return zone.is_inside && zone.blockers == 0; });
  }
  /// The zones of the i-th thing, `owner`, that are free while the newcomer stands there too: does `suits` hold for one?
  template <typename Suits>
  bool has_free(const FloorThing& owner, std::size_t i, const FloorThing& newcomer,
                Suits&& suits) const {
    for (std::size_t z = 0; z < zones_[i].size(); ++z) {
      const Zone& zone = zones_[i][z];
      if (zone.is_inside && zone.blockers == 0 &&
          !blocks_zone(newcomer, owner, owner.category->zones[z], zone.area) && suits(zone.area))
        return true;
    }
    return false;
  }

 private:
  std::vector<std::vector<Zone>> zones_;  ///< by thing, in the order of its kind's
};

}  // namespace roomgen
