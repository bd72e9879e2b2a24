#include "acceptance.h"

#include <algorithm>
#include <cmath>

#include "roomgen/base/text.h"
#include "rug_edges.h"
#include "scene/judgement.h"
#include "solve/propose.h"

namespace roomgen {

namespace {

constexpr double same_yaw = 0.02;  // radians, about a degree

std::vector<ResolvedRelation> resolved(const Draft& draft, const Object& root, const std::vector<Relation>& relations) {
  Object asked = root;
  asked.relations = relations;
  std::vector<Object> others;
  for (const auto& other : draft.scene.objects)
    if (other.room == root.room && other.id != root.id) others.push_back(other);
  return resolve(asked, room_of(draft.scene, root), others, draft.shop.kinds());
}

}  // namespace

Acceptance::Acceptance(const Draft& draft, const Layout& layout, const Object& root, const Aim& aim)
    : draft_(draft), layout_(layout), aim_(aim), object_(root), room_(room_of(draft.scene, root)),
      asked_(resolved(draft, root, aim.asked)) {}

bool Acceptance::operator()(const Pose& pose) {
  const Lack lack = lack_of(pose);
  most_ = std::max(most_, lack);
  return lack == Lack::nothing;
}

Acceptance::Lack Acceptance::lack_of(const Pose& pose) {
  if (!is_near_enough(pose)) return Lack::nearness;
  object_.position = {pose.position.x(), pose.position.y(), pose.bottom};
  object_.yaw = pose.yaw;
  if (!holds_what_is_asked()) return Lack::relations;
  return keeps_off_edges() ? Lack::nothing : Lack::floor_beside_rugs;
}

bool Acceptance::is_near_enough(const Pose& pose) const {
  const bool is_excepted = std::any_of(aim_.except.begin(), aim_.except.end(),
                                       [&](const Pose& other) { return are_alike(object_, pose, other); });
  if (is_excepted || !aim_.near_to) return !is_excepted;
  return (pose.position - aim_.near_to->position).norm() <= aim_.most_off &&
         (aim_.turns_freely || std::abs(wrap_angle(pose.yaw - aim_.near_to->yaw)) <= same_yaw);
}

bool Acceptance::keeps_off_edges() const {
  const ModelTable& models = draft_.shop.models();
  if (lies_on_floor(object_))
    return on_edge_of(object_, find_object(draft_.scene, object_.id), layout_.objects(), models).empty();
  return !stands_on_floor(object_) || height_on_rugs(object_, layout_.objects(), models).has_value();
}

bool Acceptance::holds_what_is_asked() const {
  const Subject subject{footprint(object_), bottom(object_), top(object_)};
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    const Relation& asked = aim_.asked[i];
    const bool carried = asked.kind == RelationKind::on && object_.on == asked.target;
    if (!carried && !judge(asked_[i], subject, room_).held) return false;
  }
  return true;
}

std::string Acceptance::why() const {
  switch (most_) {
    case Lack::nothing: return "";
    case Lack::nearness: return "there is no room near enough";
    case Lack::floor_beside_rugs: return object_.id + " would stand on the edge of a rug";
    case Lack::relations: break;
  }
  std::vector<std::string> texts;
  for (const auto& relation : aim_.asked)
    texts.push_back(std::string(name(relation.kind)) + (relation.target.empty() ? "" : " " + relation.target));
  return "there is no free place for " + object_.id + " " + join(texts, ", ");
}

}  // namespace roomgen
