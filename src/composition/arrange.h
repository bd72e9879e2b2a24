#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "composition.h"
#include "patterns.h"

namespace roomgen::composition {

/// One thing of a group, in the frame of its anchor.
struct Member {
  std::string part;        ///< by names from the outside in: "unit/chair"
  std::size_t number = 0;  ///< of the things of that part
  std::string category, description;
  Vec3 size = Vec3::Ones();
  Place place;
  Mount mount = Mount::floor;
  std::size_t on = 0;            ///< of what stands on another: which member
  std::optional<double> height;  ///< of what hangs: metres from the floor to its middle
  bool varied = false;
  bool spread = false;  ///< nobody says where on its carrier it stands
  int spare = 0;
  int unit = -1;  ///< which of the groups within the group, or of the copies of its anchor, it belongs to; -1: none
};

/// A group with its numbers put in. The first member is the anchor, at the origin.
struct Arranged {
  std::vector<Member> members;
};

/// The real size of the things of a part, where it is known by now; else the planned one is taken.
using SizeOf = std::function<std::optional<Vec3>(const std::string& part)>;

/// What a composition is made with. `known` and `kinds` must outlive it.
struct Making {
  const Compositions& known;
  const KindTable& kinds;
  SizeOf size_of = {};
  /// The kind of thing that a plan has in the place of a part's; empty: the part's own.
  std::function<std::string(const std::string& part)> kind_of = {};
  std::function<bool(const std::string& part)> leans = {};  ///< whether the plan leans it at a wall
  std::set<std::string> without = {};  ///< parts that are left out
  double tuck =
      1.0;  ///< how much of what is drawn under another is so: meshes may not allow all of it
};

/// The members of a composition with these values of its parameters (others as by default). Errors
/// name the part.
Result<Arranged> arrange(const Composition& composition, const Values& values,
                         const Making& making);

/// The groups within a group, each in the frame of its own anchor: tables with their chairs, of a
/// block of tables.
std::vector<Arranged> units_of(const Arranged& arranged);

/// Its mirror image: left and right change places.
Arranged mirrored(Arranged arranged);

/// The box of what stands on the floor, in the anchor's frame; flat things count where the anchor is one.
Bounds2 box_of(const Arranged& arranged, const KindTable& kinds);

/// What stands beside the anchor and is deeper is drawn forward, so that all backs meet a wall;
/// what hangs over the anchor goes back to the wall behind those who sit there. Nothing: all is so
/// already.
std::optional<Arranged> with_backs_in_line(Arranged arranged, const KindTable& kinds);

inline constexpr std::size_t most_alternatives = 48;

/// The ways in which a group may stand, those that lose least first: as asked, mirrored, with other
/// values of its parameters ("try"), without what may be left out, and smaller down to its least
/// size. Values of `fixed` parameters stay: somebody asked for them. Fails as arrange() does where
/// the first way does.
Result<std::vector<Arranged>> alternatives(const Composition& composition, const Values& values,
                                           const std::set<std::string>& fixed,
                                           const Making& making);

}  // namespace roomgen::composition
