#include "planner.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "brief/room_kinds.h"
#include "brief/room_type.h"
#include "choice.h"
#include "composition/plan_groups.h"
#include "design/plan_answers.h"
#include "design/plan_reply.h"
#include "merge.h"
#include "plan/floor_plan.h"
#include "plan/grouping.h"
#include "plan/ledger.h"
#include "plan/looks.h"
#include "plan/order.h"
#include "plan/room_makers.h"
#include "plan/room_openings.h"
#include "roomgen/base/text.h"
#include "solve/dry_run.h"
#include "suit.h"

namespace roomgen::book {

namespace {

using plan::Draft;

constexpr int most_attempts = 5;
constexpr double growth = 1.06;        ///< of the sides from attempt to attempt
constexpr double about_as_good = 2.0;  ///< of the score: by seed another design
constexpr double floor_beside =
    2.2;  ///< of a thing that is added: its floor with what is around it
constexpr double none_of_its_kind = 1e6;
constexpr double of_asked = 20.0, of_design = 5.0, of_spare = 1.0, of_broken = 2.0,
                 of_dropped = 0.6;         ///< faults
constexpr std::size_t most_dry_run = 160;  ///< things; larger plans are taken as they are
constexpr std::size_t most_designs_tried = 2;
constexpr double enough_things = 3.0;  ///< asked for that a design of another kind has, to be taken

/// One plan and what was wrong with it.
struct Attempt {
  Plan plan;
  std::vector<Draft> drafts;  ///< of plan.items
  double fault = 0.0;
  bool is_of_its_kind = true;
  double added_floor = 0.0;  ///< square metres that the wish adds to the design
};

/// Of one design in one room.
struct Try {
  const Candidate& candidate;
  Setting setting;
  const Room* given = nullptr;  ///< the room that there is; null: the design's
  int dropped = 0;              ///< what has no higher "spare" is left out
};

class Planner {
 public:
  Planner(const PlanRequest& request, const brief::Brief& brief,
          const std::vector<const Design*>& designs, bool is_probe = false)
      : request_(request),
        brief_(brief),
        designs_(designs),
        rooms_(*brief::built_in_room_kinds()),
        kinds_(KindTable::built_in()),
        arrangements_(*built_in_arrangements()),
        grouping_(kinds_, arrangements_),
        random_(request.seed),
        light_(plan::light_of(brief_)),
        is_probe_(is_probe) {
    choose_kind();
  }

  Result<Plan> plan() {
    std::vector<std::string> notes;
    const auto shell = shell_of(notes);
    const Wanted wanted{brief_, brief_.type,
                        shell ? std::optional(bounds(shell->polygon).size()) : said_size()};
    auto all = candidates(designs_, wanted, kinds_);
    if (all.empty()) return Error{Error::Kind::invalid_input, "the book of designs is empty"};
    if (!all.front().is_of_kind) take_nearest(all);
    choose_by_seed(all);
    std::optional<Attempt> best;
    for (std::size_t d = 0; d < std::min(all.size(), most_designs_tried); ++d) {
      if (best && (best->fault < of_asked || !all[d].is_of_kind)) break;
      auto attempt = best_of(all[d], shell ? &*shell : nullptr);
      if (!attempt) return attempt.error();
      if (!best || attempt->fault < best->fault)
        best = *std::move(attempt), tell_design(all[d], best->plan);
    }
    best->plan.notes.insert(best->plan.notes.end(), notes.begin(), notes.end());
    return finished(*std::move(best));
  }

 private:
  void choose_kind() {
    is_called_ = !brief_.type.empty() || (request_.room && !request_.room->type.empty());
    brief_.type = room_type_of(request_, brief_);
    if (!is_called_)
      brief_.notes.push_back(
          brief_.type == "room"
              ? "the prompt names no kind of room; little was added to what it names"
              : "the prompt names no kind of room; taken for a " + brief_.type);
    kind_ = design::kind_of_room(brief_.type, rooms_);
    if (is_called_ && !brief_.type_guessed)
      kind_.made_by = plan::needed_makers(kind_, brief_, kinds_);
    else
      kind_.made_by.clear();
    if (brief_.height) kind_.height = *brief_.height;
  }

  std::optional<Vec2> said_size() const {
    if (request_.size) return request_.size;
    if (brief_.size) return brief_.size;
    if (!brief_.area) return std::nullopt;
    return plan::choose_size(kind_, brief_, 1.0, 0.0, {0, 0}, random_.fork("size"));
  }

  // The room that is given, or whose outline or openings the wish describes.
  std::optional<Room> shell_of(std::vector<std::string>& notes) const {
    if (request_.room) {
      Room room = *request_.room;
      if (room.type.empty()) room.type = brief_.type;
      if (!brief_.openings.empty())
        notes.push_back("the doors and windows of the floor plan were kept");
      plan::ensure_door(room, kind_, notes);
      return room;
    }
    if (brief_.openings.empty() && brief_.shape.is_rectangle() && !brief_.windows &&
        !brief_.wide_windows)
      return std::nullopt;
    Random random = random_.fork("windows");
    const int windows = brief_.windows ? std::min(3, *brief_.windows)
                                       : random.integer(kind_.windows.low, kind_.windows.high);
    const auto said = said_size();
    const Vec2 size = said ? *said : size_by_designs();
    const auto outline = plan::choose_outline(brief_, size, request_.size || brief_.size, notes,
                                              random_.fork("outline"));
    return plan::make_room(kind_, outline,
                           {windows, brief_.windows.has_value(), brief_.wide_windows,
                            brief_.openings, brief_.told_from_door},
                           random_.fork("openings"), notes);
  }

  Vec2 size_by_designs() const {
    auto all = candidates(designs_, {brief_, brief_.type, std::nullopt}, kinds_);
    if (all.empty()) return {4.5, 4.0};
    return scaled(usual_size(*all.front().design, all.front().values));
  }

  // A small room, a grand one.
  Vec2 scaled(Vec2 size) const {
    size *= plan::size_factor(rooms_, brief_.styles);
    return {std::round(size.x() * 20.0) / 20.0, std::round(size.y() * 20.0) / 20.0};
  }

  // The book lacks the kind: what has several of the things that are asked for, else an empty room.
  void take_nearest(std::vector<Candidate>& all) const {
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.things > b.things; });
    if (all.front().things >= enough_things) return;
    const auto plain = std::find_if(all.begin(), all.end(),
                                    [](const Candidate& one) { return one.design->is_plain; });
    if (plain != all.end()) std::rotate(all.begin(), plain, plain + 1), all.resize(1);
  }

  void choose_by_seed(std::vector<Candidate>& all) const {
    std::size_t good = 1;
    while (good < all.size() && all[good].is_of_kind == all.front().is_of_kind &&
           all[good].score >= all.front().score - about_as_good)
      ++good;
    Random random = random_.fork("design");
    const auto chosen = static_cast<std::ptrdiff_t>(random.integer(0, static_cast<int>(good) - 1));
    std::rotate(all.begin(), all.begin() + chosen, all.begin() + chosen + 1);
  }

  void tell_design(const Candidate& chosen, Plan& plan) const {
    std::string note = "designed after \"" + chosen.design->name + "\" (" + chosen.why + ")";
    if (!chosen.is_of_kind && is_called_)
      note += "; the book has no design of a " + brief_.type + ", this is the nearest";
    plan.notes.push_back(note);
  }

  Result<Attempt> best_of(const Candidate& candidate, const Room* given) {
    std::optional<Attempt> best;
    double extra = 0.0;
    for (int n = 0; n < most_attempts && !request_.cancel.cancelled(); ++n) {
      Try one{candidate, setting_for(candidate, given, n, extra), given, 0};
      const bool is_fixed = given || said_size();
      if (is_fixed) one.dropped = n;
      auto attempt = try_out(one, best ? best->fault : std::numeric_limits<double>::infinity());
      if (!attempt) return attempt.error();
      const bool needs_more = n == 0 && !is_fixed && attempt->added_floor > 0.0;
      if (needs_more) extra = attempt->added_floor;
      if (!best || attempt->fault < best->fault) best = *std::move(attempt);
      if (best->fault < of_design && !needs_more) break;
      if (needs_more) best->fault += 1e3;  // only where the room has not grown for what is added
    }
    return *std::move(best);
  }

  Setting setting_for(const Candidate& candidate, const Room* given, int n, double extra) const {
    Setting setting;
    setting.values = candidate.values;
    setting.height = candidate_height(*candidate.design);
    Random random = random_.fork("setting");
    const auto& palettes = candidate.design->palettes;
    if (!palettes.empty())
      setting.palette = palettes[static_cast<std::size_t>(
          random.integer(0, static_cast<int>(palettes.size()) - 1))];
    if (given) {
      setting.size = bounds(given->polygon).size();
      setting.height = given->height;
      suit(*candidate.design, *given, setting);
      return setting;
    }
    setting.is_mirrored = random.chance(0.5);
    setting.turns = random.integer(0, 3);
    const Vec2 usual = usual_size(*candidate.design, candidate.values);
    if (const auto said = said_size()) {
      setting.size = *said;
      // Long rooms are long the way the design is.
      const bool is_across = (usual.x() >= usual.y()) != (said->x() >= said->y());
      setting.turns = 2 * (setting.turns / 2) + (is_across ? 1 : 0);
      return setting;
    }
    double scale = std::sqrt(1.0 + extra / usual.prod());
    for (int i = extra > 0.0 ? 1 : 0; i < n; ++i) scale *= growth;
    setting.size = scaled(usual * scale);
    if (setting.turns % 2 != 0) std::swap(setting.size.x(), setting.size.y());
    return setting;
  }

  double candidate_height(const Design& design) const {
    if (brief_.height) return *brief_.height;
    const Json room = design.body.value("room", Json::object());
    return room.contains("height_m") && room["height_m"].is_number()
               ? room["height_m"].get<double>()
               : kind_.height;
  }

  Result<Attempt> try_out(const Try& one, double bar) {
    auto answer = answer_of(*one.candidate.design, one.setting);
    if (!answer) return answer.error();
    const int dropped = drop_spare(*answer, one.dropped);
    PlanRequest request = request_;
    request.size = one.setting.size;
    if (one.given) request.room = *one.given;
    (*answer)["room"]["type"] = brief_.type;
    (*answer)["room"]["height_m"] = one.setting.height;
    auto parts = design::read_plan_parts(*answer, request, brief_, kinds_);
    if (!parts) return parts.error();
    Attempt result;
    Plan& plan = result.plan;
    plan.prompt = request_.prompt;
    plan.seed = request_.seed;
    plan.excluded = brief_.excluded;
    plan.notes = brief_.notes;
    plan.room = std::move(parts->room);
    dress_shell(plan.room);
    auto merged = merge(*std::move(parts), brief_, kinds_);
    const plan::Looks looks = looks_for();
    for (auto& draft : merged.drafts)
      if (draft.item.asked)
        draft.item.description = looks.in_style(draft.item.category, draft.item.description);
    plan::one_for_each_window(merged.drafts, brief_, plan.room, kinds_);
    for (const auto& draft : merged.drafts)
      if (draft.item.asked && draft.item.group.empty() && !draft.item.location)
        result.added_floor += floor_beside * plan::floor_area(draft.item, kinds_);
    plan.groups = std::move(merged.groups);
    grouping_.gather(merged.drafts, brief_, plan);
    set_in_order(std::move(merged.drafts), result);
    judge(result, bar);
    result.fault += of_dropped * dropped;
    return result;
  }

  // How many things that are.
  static int drop_spare(Json& answer, int most) {
    int dropped = 0;
    for (const char* list : {"groups", "objects"}) {
      if (!answer.contains(list) || !answer[list].is_array()) continue;
      Json kept = Json::array();
      for (const auto& one : answer[list]) {
        const int spare = one.is_object() && one.contains("spare") && one["spare"].is_number()
                              ? one["spare"].get<int>()
                              : 0;
        if (spare == 0 || spare > most)
          kept.push_back(one);
        else
          dropped += 1 + static_cast<int>(one.value("things", Json::array()).size());
      }
      answer[list] = std::move(kept);
    }
    return dropped;
  }

  plan::Looks looks_for() const {
    return {rooms_,
            kinds_,
            brief_.styles,
            plan::style_of_palette(brief_.palette),
            plan::unwanted_looks(brief_),
            random_.fork("looks")};
  }

  void dress_shell(Room& room) const {
    if (!request_.room) {
      if (const auto* style = plan::style_named(rooms_, brief_.styles))
        plan::put_on(room, *style, random_.fork("style"));
      plan::put_on(room, plan::style_of_palette(brief_.palette), random_.fork("palette"));
    }
    plan::put_on(room, brief_.materials);
    Lighting said = light_;
    plan::fill(said, room.light);
    room.light = said;
  }

  void set_in_order(std::vector<Draft> drafts, Attempt& attempt) const {
    Plan& plan = attempt.plan;
    plan.items.clear();
    attempt.drafts = plan::order_items(std::move(drafts), kinds_, arrangements_, plan);
    composition::complete_groups(plan, kinds_);
    attempt.drafts.resize(plan.items.size());  // what groups bring along no mention asks for
  }

  void judge(Attempt& attempt, double bar) const {
    if (planned_objects(attempt.plan).size() > most_dry_run) return;
    const auto fault = [&](const DryRun& run) { return fault_of(attempt.plan, run); };
    const DryRun run = dry_run(attempt.plan, kinds_, arrangements_,
                               [&](const DryRun& so_far) { return fault(so_far) >= bar; });
    attempt.fault = fault(run);
    attempt.is_of_its_kind = holds_maker(attempt.plan, run);
  }

  double fault_of(const Plan& plan, const DryRun& run) const {
    double fault = of_broken * run.broken + (holds_maker(plan, run) ? 0.0 : none_of_its_kind);
    for (const auto& object : run.missed) {
      const PlanItem& item = plan.items[object.item];
      const bool is_of_wish = item.asked && is_said(plan, object);
      fault += item.spare > 0 ? of_spare : is_of_wish ? of_asked : of_design;
    }
    return fault;
  }
  bool is_said(const Plan& plan, const PlannedObject& object) const {
    const auto& category = plan.items[object.item].category;
    return std::any_of(brief_.mentions.begin(), brief_.mentions.end(),
                       [&](const brief::Mention& mention) { return mention.category == category; });
  }

  bool holds_maker(const Plan& plan, const DryRun& run) const {
    // A design without any of them makes it in its own way.
    bool has_any = false;
    for (std::size_t i = 0; i < plan.items.size(); ++i) {
      if (!kinds_.is_any_of(plan.items[i].category, kind_.made_by)) continue;
      has_any = true;
      const auto missed =
          std::count_if(run.missed.begin(), run.missed.end(),
                        [&](const PlannedObject& object) { return object.item == i; });
      if (plan.items[i].quantity > missed) return true;
    }
    return !has_any;
  }

  // With the least size that would do.
  Error too_small(const Plan& plan) const {
    std::vector<std::string> makers;
    for (const auto& item : plan.items)
      if (kinds_.is_any_of(item.category, kind_.made_by) &&
          !std::count(makers.begin(), makers.end(), item.category))
        makers.push_back(item.category);
    const Error error = plan::no_place_for(makers, plan.room);
    if (is_probe_) return error;
    const auto works = [&](const Vec2& size) {
      PlanRequest request = request_;
      request.size = size;
      request.room.reset();
      return static_cast<bool>(Planner(request, brief_, designs_, true).plan());
    };
    return plan::with_least(error, plan::least_size(bounds(plan.room.polygon).size(), works));
  }

  Result<Plan> finished(Attempt best) const {
    if (!best.is_of_its_kind) return too_small(best.plan);
    auto ledger = plan::ledger_of(request_, brief_, best.drafts, best.plan);
    best.plan.requirements = std::move(ledger.requirements);
    best.plan.heard = std::move(ledger.heard);
    return std::move(best.plan);
  }

  const PlanRequest& request_;
  brief::Brief brief_;
  const std::vector<const Design*>& designs_;
  const brief::RoomKinds& rooms_;
  const KindTable& kinds_;
  const Arrangements& arrangements_;
  plan::Grouping grouping_;
  Random random_;
  Lighting light_;
  brief::RoomKind kind_;
  bool is_called_ = false;
  bool is_probe_;  ///< only whether there is a plan is asked
};

}  // namespace

std::string room_type_of(const PlanRequest& request, const brief::Brief& brief) {
  if (!brief.type.empty()) return brief.type;
  if (request.room && !request.room->type.empty()) return request.room->type;
  return brief.mentions.size() >= 2 ? "room" : brief::default_room_type;
}

Result<Plan> plan_by_book(const PlanRequest& request, const brief::Brief& brief,
                          const std::vector<const Design*>& designs) {
  return Planner(request, brief, designs).plan();
}

}  // namespace roomgen::book
