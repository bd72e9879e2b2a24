#include "consult.h"

#include <algorithm>

#include "geometry/free_rectangles.h"
#include "order.h"
#include "roomgen/base/text.h"
#include "solve/support.h"
#include "support.h"

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

// What stands otherwise than was said of it.
std::vector<std::string> elsewhere(const Work& work) {
  constexpr double told_from = 0.05;  // metres
  std::vector<std::string> told;
  for (const auto& task : work.state.tasks) {
    const Object* standing = work.layout().find(task.object.id);
    if (!standing || !task.location || !task.binding) continue;
    const double away = (standing->position.head<2>() - *task.location).norm();
    if (away > told_from) told.push_back(standing->id + " stands " + format_number(away, 2) + " m from where you put it");
  }
  return told;
}

// The room, and half as large the top of the carrier.
Result<std::vector<Image>> pictures(const Workplace& place, const Scene& scene,
                                    const std::vector<Bounds2>& free_floor,
                                    const Object* carrier) {
  View view = place.options.marks_view;
  view.free_floor = free_floor;
  auto room = place.options.renderer->render(scene, place.models, view);
  if (!room) return room.error();
  std::vector<Image> all = {*std::move(room)};
  if (!carrier || view.paper_frame) return all;
  view.free_floor.clear();
  view.part = footprint(*carrier).bounds();
  view.pixels = std::max(view.pixels / 2, least_part_pixels);
  auto top = place.options.renderer->render(scene, place.models, view);
  if (!top) return top.error();
  all.push_back(*std::move(top));
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
  request.elsewhere = elsewhere(work);
  request.cancel = work.cancel;
  if (!earlier.refusals.empty()) request.free_floor = free_floor(place.layout, task.object);
  if (place.options.renderer)
    request.marks = [&] {
      return pictures(place, scene, request.free_floor, carrier_of(work, planned, task));
    };
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
