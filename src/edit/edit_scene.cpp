#include "edit_scene.h"

#include <algorithm>
#include <chrono>

#include "draft_changes.h"
#include "evaluate/violations.h"
#include "operations.h"
#include "placing.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

bool is_of_overlaps(const Violation& violation) {
  return violation.fault == Fault::overlap || violation.fault == Fault::too_crowded;
}

bool is_same(const Violation& a, const Violation& b) {
  return a.fault == b.fault && a.object == b.object && a.other == b.other;
}

std::string words_of(const Violation& violation) {
  std::string text = std::string(name(violation.fault));
  if (!violation.object.empty()) text = violation.object + ": " + text;
  return violation.other.empty() ? text : text + " (" + violation.other + ")";
}

// The edits of this module let nothing invalid in; what they do together is looked at once more as a whole.
Status check_new_faults(const Scene& before, const Draft& draft) {
  Solids& solids = draft.shop.solids();
  const auto now = violations(draft.scene, solids, draft.shop.kinds());
  if (now.empty()) return {};
  const auto was = violations(before, solids, draft.shop.kinds());
  // Of a room that was too crowded not all overlaps are known.
  const bool are_known = std::none_of(was.begin(), was.end(), [](const Violation& old) { return old.fault == Fault::too_crowded; });
  for (const auto& violation : now)
    if ((are_known || !is_of_overlaps(violation)) &&
        std::none_of(was.begin(), was.end(), [&](const Violation& old) { return is_same(old, violation); }))
      return cannot("the room would not be valid any more: " + words_of(violation));
  return {};
}

Error stopped(const SessionOptions& options) {
  if (options.cancel.cancelled()) return {Error::Kind::cancelled, "stopped; nothing is changed"};
  return {Error::Kind::limit, "this takes more than " + format_number(options.seconds, 1) +
                                  " s; nothing is changed: ask for less at once"};
}

double distance_between(const Object& a, const Object& b) {
  const bool same_height = bottom(a) < top(b) && bottom(b) < top(a);
  return same_height ? gap(footprint(a), footprint(b)) : 1e9;
}

double nearest_to(const Scene& scene, const Cluster& cluster) {
  double nearest = distance_to_boundary(room_of(scene, cluster.root).polygon, footprint(cluster.root));
  const auto own = cluster.ids();
  for (const auto& other : scene.objects)
    if (other.room == cluster.root.room && !own.count(other.id) && !other.traits.flat)
      nearest = std::min(nearest, distance_between(cluster.root, other));
  return nearest;
}

}  // namespace

Result<EditedScene> edit_scene(Workshop& shop, const Scene& scene, const Scene* earlier,
                               std::span<const edit::Operation> operations, const SessionOptions& options) {
  Draft draft(shop, scene, options.repair, options.cancel.within(std::chrono::duration<double>(options.seconds)));
  draft.earlier = earlier;
  for (const auto& operation : operations) {
    auto status = carry_out(draft, operation);
    if (draft.cancel.cancelled()) return stopped(options);
    if (!status) return status.error();
  }
  shop.fetch_models(draft.scene);
  if (auto status = check_new_faults(scene, draft); !status) return status.error();
  EditedScene edited;
  edited.report.broken = update_ledger(draft, scene);
  for (auto& edge : new_rug_edges(scene, draft)) edited.report.broken.push_back(std::move(edge));
  if (auto status = check(draft.scene); !status) return status.error();
  edited.report.added = std::move(draft.added);
  edited.report.repairs = std::move(draft.repairs);
  edited.report.changes = differences(scene, draft.scene);
  edited.report.changes.insert(edited.report.changes.end(), draft.told.begin(), draft.told.end());
  edited.scene = std::move(draft.scene);
  return edited;
}

Result<Preview> preview_pose(Workshop& shop, const Scene& scene, std::string_view id, const WantedPose& wanted) {
  Draft draft(shop, scene, false, {});
  const auto object = object_named(draft, id);
  if (!object) return object.error();
  Cluster cluster = cluster_of(scene, *object);
  if (!wanted.on.empty()) cluster.root.on = wanted.on;
  const Pose pose{wanted.position, wanted.bottom.value_or(object->position.z()), wanted.yaw};
  Preview preview;
  preview.object = moved_to(cluster, pose).root;
  auto there = exactly_at(draft, cluster, pose);
  preview.feasible = there.ok();
  if (!there) preview.reason = there.error().message;
  else cluster = *there, preview.object = there->root;
  preview.nearest = nearest_to(scene, moved_to(cluster, pose_of(preview.object)));
  if (!there) return preview;
  draft.put(*there);
  preview.broken = broken_relations(scene, draft);
  return preview;
}

}  // namespace roomgen
