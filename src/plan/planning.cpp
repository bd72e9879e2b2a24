#include "planning.h"

#include <algorithm>
#include <limits>
#include <string>

#include "base/random.h"
#include "brief/room_type.h"
#include "floor_plan.h"
#include "composition/plan_groups.h"
#include "grouping.h"
#include "inventory.h"
#include "ledger.h"
#include "looks.h"
#include "room_makers.h"
#include "order.h"
#include "room_openings.h"
#include "solve/dry_run.h"

namespace roomgen::plan {

namespace {

constexpr int usual_attempts = 5;
constexpr int max_attempts = 9;  ///< while something of the prompt is not heeded
constexpr double growth = 1.05;  ///< of the sides from attempt to attempt
constexpr double floor_of_groups = 1.15;  ///< of a room, for the floor that its groups take with what is between them
constexpr std::size_t enough_things = 2;  ///< named, to furnish a room of no known kind
constexpr std::size_t most_tried = 80;  ///< things; larger plans are taken as they are
constexpr double none_of_its_kind =
    1e6;  ///< fault of a room without what makes it what it is: any other is better
constexpr double most_work = 24'000;    ///< things times square metres, over all attempts: a full hall of 180 m2 is tried thrice
constexpr std::size_t most_corners = 64;  ///< of a room in which plans are tried: each wall offers places, and each is held against all walls

/// One plan and what was wrong with it.
struct Attempt {
  Plan plan;
  std::vector<Draft> wanted;          ///< before they were put in groups and in order
  std::vector<Draft> drafts;          ///< of plan.items
  std::vector<PlannedObject> missed;  ///< found no place
  double fault = 0.0;
  bool heeds_prompt = true;  ///< what was asked for has its place
  bool is_of_its_kind = true;  ///< something that makes the room what it is has its place
};

class Planner {
 public:
  Planner(const PlanRequest& request, brief::Brief brief, const brief::RoomKinds& kinds,
          const KindTable& table, const Arrangements& arrangements)
      : request_(request),
        kinds_(kinds),
        table_(table),
        arrangements_(arrangements),
        grouping_(table, arrangements),
        brief_(std::move(brief)),
        random_(request.seed),
        light_(light_of(brief_)) {
    choose_kind();
  }

  Result<Plan> plan() const {
    Attempt best = attempt(0, std::numeric_limits<double>::infinity());
    double work = work_of(best.plan);
    for (int n = 1; n < max_attempts && best.fault > 0 && work < most_work && !request_.cancel.cancelled(); ++n) {
      if (n >= usual_attempts && best.heeds_prompt && best.is_of_its_kind) break;
      Attempt next = attempt(n, best.fault);
      work += work_of(next.plan);
      if (next.fault < best.fault) best = std::move(next);
    }
    if (!best.is_of_its_kind) return too_small(best.plan.room);
    if (!best.missed.empty()) leave_out(best);
    if (best.plan.items.empty())
      best.plan.notes.push_back("nothing that such a room usually holds fits into it");
    auto ledger = ledger_of(request_, brief_, best.drafts, best.plan);
    best.plan.requirements = std::move(ledger.requirements);
    best.plan.heard = std::move(ledger.heard);
    return std::move(best.plan);
  }

  // Whether plan() would give a room that is what it is called.
  bool is_of_its_kind() const {
    for (int n = 0; n < max_attempts && !request_.cancel.cancelled(); ++n)
      if (attempt(n, none_of_its_kind).is_of_its_kind) return true;
    return false;
  }

 private:
  // The kind of room, under the prompt's own name for it.
  void choose_kind() {
    if (brief_.type.empty() && request_.room) {
      brief_.type = request_.room->type;
      brief_.type_known = kinds_.types.count(brief_.type) > 0;
    }
    if (brief_.type.empty() && brief_.mentions.size() >= enough_things) {
      brief_.type = "room";
      brief_.notes.push_back("the prompt names no kind of room; little was added to what it names");
    }
    const bool is_called = !brief_.type.empty();
    if (!is_called) {
      brief_.type = brief::default_room_type;
      brief_.type_known = true;
      brief_.notes.push_back(std::string("the prompt names no kind of room; taken for a ") +
                             brief::default_room_type);
    }
    kind_ = kinds_.get(brief_.type);
    kind_.type = brief_.type;
    if (is_called) kind_.made_by = needed_makers(kind_, brief_, table_);
    else kind_.made_by.clear();
    if (brief_.height) kind_.height = *brief_.height;
  }

  Error too_small(const Room& room) const {
    const auto works = [&](const Vec2& size) {
      PlanRequest request = request_;
      request.size = size;
      request.room.reset();
      return Planner(request, brief_, kinds_, table_, arrangements_).is_of_its_kind();
    };
    return with_least(no_place_for(usual_makers(kind_, table_), room),
                      least_size(bounds(room.polygon).size(), works));
  }

  static double work_of(const Plan& plan) {
    return static_cast<double>(planned_objects(plan).size()) * area(plan.room.polygon);
  }

  RoomOpenings openings(Random random) const {
    return {window_count(random), brief_.windows.has_value(), brief_.wide_windows, brief_.openings, brief_.told_from_door};
  }

  int window_count(Random random) const {
    if (brief_.windows) return std::min(3, *brief_.windows);
    int count = random.integer(kind_.windows.low, kind_.windows.high);
    for (const auto& word : brief_.styles)
      if (const brief::Style* style = kinds_.style(word)) count += style->windows;
    return std::min(3, count);
  }

  Room given_room(Plan& plan) const {
    Room room = *request_.room;
    if (room.type.empty()) room.type = brief_.type;
    if (!brief_.openings.empty())
      plan.notes.push_back("the doors and windows of the floor plan were kept");
    ensure_door(room, kind_, plan.notes);
    return room;
  }

  Room make_the_room(const std::vector<Draft>& drafts, const Looks& looks, const Random& random, int n, Plan& plan) const {
    if (request_.room) return given_room(plan);
    double scale = size_factor(kinds_, brief_.styles);
    for (int i = 0; i < n; ++i) scale *= growth;
    const Vec2 size = request_.size ? *request_.size : size_for(drafts, looks, scale, random);
    const brief::Outline outline =
        choose_outline(brief_, size, request_.size || brief_.size, plan.notes, random.fork("outline"));
    return make_room(kind_, outline, openings(random.fork("windows")), random.fork("openings"), plan.notes);
  }

  // Large enough for what is asked for, and for the groups that it and what usually comes with it make.
  Vec2 size_for(const std::vector<Draft>& drafts, const Looks& looks, double scale, const Random& random) const {
    const Vec2 size = choose_size(kind_, brief_, scale, floor_area(drafts, table_), {0, 0}, random.fork("size"));
    auto all = drafts;
    complete(all, brief_, kinds_, kind_, size, table_, looks, random.fork("contents"));
    const auto floor = grouping_.floor_of(std::move(all), brief_);
    const double furniture = std::max(floor_area(drafts, table_), kind_.share.high * floor_of_groups * floor.area);
    return choose_size(kind_, brief_, scale, furniture, floor.largest, random.fork("size"));
  }

  // Tried no further than it takes to see that its fault is not below `bar`.
  Attempt attempt(int n, double bar) const {
    const Random random = n == 0 ? random_ : random_.fork("attempt " + std::to_string(n));
    Attempt result;
    Plan& plan = result.plan;
    plan.prompt = request_.prompt;
    plan.seed = request_.seed;
    plan.excluded = brief_.excluded;
    plan.notes = brief_.notes;
    const StyleMeaning palette = style_of_palette(brief_.palette);
    const Looks looks(kinds_, table_, brief_.styles, palette, unwanted_looks(brief_),
                      random_.fork("looks"));
    auto drafts = asked_items(brief_, table_);
    for (auto& draft : drafts)
      draft.item.description = looks.in_style(draft.item.category, draft.item.description);
    plan.room = make_the_room(drafts, looks, random, n, plan);
    if (const auto* style = style_named(kinds_, brief_.styles); style && !request_.room)
      put_on(plan.room, *style, random_.fork("style"));
    if (!request_.room) put_on(plan.room, palette, random_.fork("palette"));
    put_on(plan.room, brief_.materials);
    fill(plan.room.light, light_);
    one_for_each_window(drafts, brief_, plan.room, table_);
    const Vec2 box = bounds(plan.room.polygon).size();
    // Of a room that is no rectangle, one of its area.
    const Vec2 usable(box.x(), area(plan.room.polygon) / box.x());
    complete(drafts, brief_, kinds_, kind_, usable, table_, looks, random.fork("contents"));
    result.wanted = std::move(drafts);
    set_in_order(result);
    judge(result, bar);
    return result;
  }

  void judge(Attempt& attempt, double bar) const {
    const auto planned = planned_objects(attempt.plan);
    if (planned.size() > most_tried || attempt.plan.room.polygon.size() > most_corners) return;
    const auto on_floor = std::count_if(planned.begin(), planned.end(), [&](const auto& object) {
      return attempt.plan.items[object.item].mount == Mount::floor;
    });
    const auto fault = [&](const DryRun& run) {
      return fault_of(attempt, static_cast<int>(on_floor), run);
    };
    DryRun run = dry_run(attempt.plan, table_, arrangements_,
                         [&](const DryRun& so_far) { return fault(so_far) >= bar; });
    attempt.fault = fault(run);
    attempt.is_of_its_kind = holds_maker(attempt.plan, run);
    attempt.heeds_prompt =
        run.broken == 0 && std::none_of(run.missed.begin(), run.missed.end(), [&](const auto& object) {
          return attempt.plan.items[object.item].asked;
        });
    attempt.missed = std::move(run.missed);
  }

  // Grows with everything that goes wrong.
  double fault_of(const Attempt& attempt, int on_floor, const DryRun& run) const {
    double fault = 2.0 * run.broken + (holds_maker(attempt.plan, run) ? 0.0 : none_of_its_kind);
    for (const auto& object : run.missed) {
      const PlanItem& item = attempt.plan.items[object.item];
      on_floor -= item.mount == Mount::floor;
      fault += item.asked ? 20.0 : attempt.drafts[object.item].core ? 5.0 : 1.0;
    }
    return brief_.bare ? fault : fault + 3.0 * std::max(0, fewest_things - on_floor);
  }

  // Whether something that makes the room what it is found a place, if it needs that.
  bool holds_maker(const Plan& plan, const DryRun& run) const {
    if (kind_.made_by.empty()) return true;
    for (std::size_t i = 0; i < plan.items.size(); ++i) {
      const auto missed =
          std::count_if(run.missed.begin(), run.missed.end(),
                        [&](const PlannedObject& object) { return object.item == i; });
      if (plan.items[i].quantity > missed &&
          table_.is_any_of(plan.items[i].category, kind_.made_by))
        return true;
    }
    return false;
  }

  // Drops what found no place and was not asked for.
  void leave_out(Attempt& attempt) const {
    for (const auto& object : attempt.missed)
      if (const auto origin = attempt.drafts[object.item].origin; origin && !attempt.plan.items[object.item].asked)
        --attempt.wanted[*origin].item.quantity;
    std::erase_if(attempt.wanted, [](const Draft& draft) { return draft.item.quantity < 1; });
    set_in_order(attempt);
  }

  // The drafts in groups and in the order of placing, as items of the plan; what completes the groups comes after them.
  void set_in_order(Attempt& attempt) const {
    Plan& plan = attempt.plan;
    plan.items.clear();
    attempt.drafts = attempt.wanted;
    for (std::size_t i = 0; i < attempt.drafts.size(); ++i) attempt.drafts[i].origin = i;
    grouping_.run(attempt.drafts, brief_, plan);
    attempt.drafts = order_items(std::move(attempt.drafts), table_, arrangements_, plan);
    composition::complete_groups(plan, table_);
    attempt.drafts.resize(plan.items.size());  // what groups bring along no mention asks for
  }

  const PlanRequest& request_;
  const brief::RoomKinds& kinds_;
  const KindTable& table_;
  const Arrangements& arrangements_;
  mutable Grouping grouping_;  ///< what it remembers changes no plan
  brief::Brief brief_;
  Random random_;
  Lighting light_;
  brief::RoomKind kind_;
};

}  // namespace

Result<Plan> make_plan(const PlanRequest& request, const brief::Brief& brief,
                       const brief::RoomKinds& kinds, const KindTable& table,
                       const Arrangements& arrangements) {
  return Planner(request, brief, kinds, table, arrangements).plan();
}

}  // namespace roomgen::plan
