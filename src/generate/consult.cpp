#include "consult.h"

#include <algorithm>

#include "attempts.h"
#include "geometry/free_rectangles.h"
#include "order.h"
#include "roomgen/base/text.h"
#include "solve/refusal.h"
#include "solve/support.h"
#include "support.h"
#include "told.h"

namespace roomgen {

namespace {

// Of the free parts of the floor that a designer is told of: metres, and how many.
constexpr double least_free_side = 0.3;
constexpr std::size_t most_free_parts = 6;
constexpr int least_part_pixels = 256;

// Where there is room left for a thing of this height, for a designer whose answer did not fit.
std::vector<Bounds2> free_floor(const Layout& layout, const Object& object) {
  const auto doors = layout.door_areas();
  std::vector<Footprint> taken(doors.begin(), doors.end());
  for (const auto& area : layout.areas_before_windows(object)) taken.push_back(area);
  for (const auto& thing : layout.things())
    if (blocks_floor(*thing.object, *thing.category)) taken.push_back(thing.footprint);
  return free_rectangles(layout.room().polygon, taken, least_free_side, most_free_parts);
}

// A thing that is to carry the object, as far as that is known before the answer.
const Object* carrier_of(const Work& work, const PlannedObject& planned,
                         const PlacementTask& task) {
  if (task.object.mount != Mount::surface) return nullptr;
  for (const auto& relation : task.object.relations)
    if (relation.kind == RelationKind::on) return work.layout().find(relation.target);
  const std::string& wanted = work.item(planned).on;
  for (const auto& object : work.layout().objects())
    if (object.id == wanted || (!wanted.empty() && could_carry(work.place.categories,
                                                               object.category, wanted)))
      return &object;
  return nullptr;
}

// A thing of a group that stands, or was not tried yet, takes its place there when its turn comes.
std::set<std::string> coming_with_groups(const Work& work) {
  std::set<std::string> ids;
  for (const auto& planned : work.state.left) {
    const auto* role = work.role_of(planned.id);
    const bool has_post = std::any_of(work.state.groups.begin(), work.state.groups.end(), [&](const StandingGroup& group) {
      const auto post = group.posts.find(planned.id);
      return post != group.posts.end() && post->second.refused == 0;
    });
    if (has_post || (role && !role->is_anchor && work.state.tried_groups.count(role->group) == 0)) ids.insert(planned.id);
  }
  return ids;
}

// Where the last answer would have it, turned as it says, else as the least would be in its way.
void show_refused(Work& work, const PlaceRequest& request, const PlacementTask& task, View& view) {
  const PlaceAdvice& answer = request.earlier.back();
  if (request.refusals.empty() || !request.objections.empty() || !answer.location) return;
  const PlacementTask whole = with_companions(work, request.planned, task);
  for (const double yaw : meant_yaws(work.layout(), answer.yaw)) {
    Object standing = task.object;
    standing.position.head<2>() = *answer.location;
    standing.yaw = yaw;
    std::vector<Object> things = companions_of(whole, standing);
    things.insert(things.begin(), standing);
    std::vector<std::string> ids;
    for (const auto& thing : things)
      for (auto& id : in_the_way(work.layout(), thing)) ids.push_back(std::move(id));
    if (view.refused.empty() || ids.size() < view.in_the_way.size())
      view.refused = std::move(things), view.in_the_way = std::move(ids);
  }
}

// Is it about something that hangs on a wall, or may the answer place such a thing too?
bool is_about_walls(const Plan& plan, const PlaceRequest& request) {
  if (request.object.mount != Mount::ceiling) return request.object.mount == Mount::wall;
  const auto all = planned_objects(plan);
  return std::any_of(all.begin(), all.end(), [&](const PlannedObject& other) {
    return plan.items[other.item].mount == Mount::wall &&
           std::find(request.later.begin(), request.later.end(), other.id) != request.later.end();
  });
}

// The room; of what hangs its walls, of what stands on something the top of that, half as large.
Result<std::vector<Image>> pictures(Work& work, const PlaceRequest& request,
                                    const PlacementTask& task) {
  const Workplace& place = work.place;
  View view = place.options.marks_view;
  view.free_floor = request.free_floor;
  view.asked = task.object.mount;
  if (!request.earlier.empty()) show_refused(work, request, task, view);
  std::vector<View> views = {view};
  if (is_about_walls(place.plan, request)) {
    views.push_back(view);
    views.back().kind = View::Kind::elevation;
  }
  if (const Object* carrier = carrier_of(work, request.planned, task);
      carrier && !view.paper_frame) {
    views.push_back(view);
    views.back().free_floor.clear();
    views.back().part = footprint(*carrier).bounds();
    views.back().pixels = std::max(view.pixels / 2, least_part_pixels);
  }
  std::vector<Image> all;
  for (const auto& one : views) {
    auto picture = place.options.renderer->render(request.scene, place.models, one);
    if (!picture) return picture.error();
    all.push_back(*std::move(picture));
  }
  return all;
}

// What the plan asks for, before what the designer adds; how many they are.
int put_wishes_first(const PlanItem& item, std::vector<Relation>& relations) {
  const auto end =
      std::stable_partition(relations.begin(), relations.end(), [&](const Relation& relation) {
        return std::find(item.relations.begin(), item.relations.end(), relation) !=
               item.relations.end();
      });
  return item.asked ? static_cast<int>(end - relations.begin()) : 0;
}

}  // namespace

void tally(const Consultation& consultation, ModelUse& use) {
  use.calls += consultation.calls;
  use.input_tokens += consultation.input_tokens;
  use.output_tokens += consultation.output_tokens;
  use.seconds += consultation.seconds;
  use.fallbacks += consultation.fell_back ? 1 : 0;
}

Result<PlaceAdvice> consult(Work& work, const PlannedObject& planned, const PlacementTask& task,
                            const EarlierAnswers& earlier) {
  const Workplace& place = work.place;
  const Scene scene = scene_of(place, place.layout.objects());
  PlaceRequest request{place.plan, scene, planned, task.object, earlier.refusals};
  request.earlier = earlier.answers;
  request.objections = earlier.objections;
  request.standing_at = earlier.standing_at;
  request.later = may_come_next(work);
  request.with_group = [&] { return coming_with_groups(work); };
  const auto* role = work.role_of(planned.id);
  request.lost_place_in_group = role && !role->is_anchor;
  request.elsewhere = [&] { return told_of(work); };
  request.cancel = work.cancel;
  if (!earlier.refusals.empty()) request.free_floor = free_floor(place.layout, task.object);
  if (place.options.renderer) request.marks = [&] { return pictures(work, request, task); };
  auto advice = place.designer.place(request);
  if (!advice) {
    if (advice.error().kind == Error::Kind::limit) work.state.stopped = advice.error().message;
    return advice;
  }
  tally(advice->consultation, work.state.model_use);
  work.state.next = advice->next;
  return advice;
}

Status follow(const Work& work, const PlaceAdvice& advice, const PlannedObject& planned,
              std::size_t refused, PlacementTask& task) {
  const PlanItem& item = work.item(planned);
  Object& object = task.object;
  object.relations = advice.relations;
  task.location = advice.location;
  task.facing = advice.yaw;
  task.usual = advice.usual;
  task.binding = advice.location || advice.yaw;
  task.anywhere = item.asked || refused > 0;
  task.of_its_kind = quantity_of(work.place.plan, item.category);
  if (task.usual && object.mount == Mount::surface)
    choose_support(work.layout(), item.on, refused, task);
  task.wishes = put_wishes_first(item, object.relations);
  return object.mount == Mount::surface ? put_on_support(work, item, refused, object) : Status();
}

}  // namespace roomgen
