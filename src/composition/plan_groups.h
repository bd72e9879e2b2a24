#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "arrange.h"
#include "roomgen/scene/plan.h"

namespace roomgen::composition {

/// Makes the groups of a plan and its items agree: each thing of a group has an item that says how
/// it looks, which is added where none does; items of a part beyond what the group has stand for
/// themselves; what is said of where a group goes is said of its anchor. A group that cannot be
/// made is told in the notes, and its things stand for themselves.
void complete_groups(Plan& plan, const KindTable& kinds);
Plan completed(Plan plan, const KindTable& kinds);

/// The objects of a completed plan in the order in which they are placed: the plan's, but the
/// things of a group follow its anchor, and what has a location comes before what has none.
std::vector<PlannedObject> placing_order(const Plan& plan);

/// Puts what is late, and what depends on that, behind the others.
void postpone(const Plan& plan, std::span<PlannedObject> order,
              const std::function<bool(const PlannedObject&)>& is_late);

/// What a plan's object is in its group: the part, and which of its things.
struct Role {
  std::string group, part;
  std::size_t number = 0;
  int unit = -1;  ///< of the groups within that group
  bool is_anchor = false;
};

/// Who plays which role in the groups of a plan.
class Roles {
 public:
  explicit Roles(const Plan& plan);

  /// Null: it is in no group.
  const Role* of(const std::string& id) const;
  /// The other way round. Empty: no thing of the plan.
  std::string id_of(const std::string& group, const Member& member) const;
  const std::map<std::string, Role>& by_id() const { return by_id_; }

 private:
  std::map<std::string, Role> by_id_;
  std::map<std::tuple<std::string, std::string, std::size_t>, std::string> ids_;
};

/// Null: there is none of this id.
const PlanGroup* find_group(const Plan& plan, const std::string& id);

/// What the things of the groups of a completed plan stand on, by id, of those that stand on others.
std::map<std::string, std::string> carriers(const Plan& plan, const KindTable& kinds);

/// The things of a group as they will be.
struct RealThings {
  SizeOf size_of = {};  ///< as far as it is known
  double tuck = 1.0;    ///< Making::tuck
};

/// The ways in which a group of a completed plan may stand (alternatives()).
Result<std::vector<Arranged>> ways_to_stand(const Plan& plan, const PlanGroup& group,
                                            const KindTable& kinds, const RealThings& real);

}  // namespace roomgen::composition
