#include "plan_reply.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "brief/room_kinds.h"
#include "brief/room_type.h"
#include "chat/loose_json.h"
#include "plan/floor_plan.h"
#include "plan/order.h"
#include "plan/room_openings.h"
#include "composition/plan_groups.h"
#include "plan_answers.h"
#include "reply_groups.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "solve/arrangement.h"

namespace roomgen::design {

namespace {

constexpr std::size_t max_excluded = 60;
constexpr std::size_t max_plan_repairs = 60;
constexpr std::size_t max_concept = 2000;  ///< bytes

const std::vector<std::string> object_keys = {"objects", "items", "inventory", "furniture"};
const WantedKeys plan_keys = {{"objects", "groups"}, object_keys};
const std::vector<std::string> excluded_keys = {"excluded", "exclude", "forbidden", "not wanted"};

Error invalid(const std::string& message) {
  return {Error::Kind::invalid_input, message};
}

std::string choose_type(const Json& json, const PlanRequest& request, const brief::Brief& brief,
                        std::vector<std::string>& repairs) {
  for (const auto& type :
       {room_type_in(json), brief.type, request.room ? request.room->type : std::string()})
    if (!type.empty()) return type;
  repairs.push_back(std::string("the answer names no kind of room; taken for a ") +
                    brief::default_room_type);
  return brief::default_room_type;
}

// What the prompt and the answer forbid.
std::vector<std::string> read_excluded(const Json& json, const brief::Brief& brief,
                                       const ItemLexicon& lexicon) {
  std::vector<std::string> excluded = brief.excluded;
  const Json* list = member(json, excluded_keys);
  if (!list || !list->is_array()) return excluded;
  for (const auto& element : *list) {
    if (!element.is_string() || excluded.size() >= max_excluded) continue;
    const std::string kind = kind_of({element.get<std::string>()}, lexicon);
    if (!kind.empty() && std::find(excluded.begin(), excluded.end(), kind) == excluded.end())
      excluded.push_back(kind);
  }
  return excluded;
}

bool is_mentioned(const PlanItem& item, const brief::Brief& brief, const KindTable& table) {
  return std::any_of(brief.mentions.begin(), brief.mentions.end(),
                     [&](const brief::Mention& mention) {
                       return table.is_a(item.category, mention.category) ||
                              table.is_a(mention.category, item.category);
                     });
}

void leave_out_excluded(std::vector<plan::Draft>& drafts, const std::vector<std::string>& excluded,
                        const KindTable& table, std::vector<std::string>& repairs) {
  std::erase_if(drafts, [&](const plan::Draft& draft) {
    const bool forbidden = table.is_any_of(draft.item.category, excluded);
    if (forbidden)
      repairs.push_back("the " + draft.item.category + " is excluded and was left out");
    return forbidden;
  });
  // What stood on it goes elsewhere.
  for (auto& draft : drafts)
    std::erase_if(draft.demands, [&](const brief::Demand& demand) {
      return std::none_of(drafts.begin(), drafts.end(), [&](const plan::Draft& other) {
        return other.mention == demand.mention;
      });
    });
}

// Nothing is larger than its room.
void fit_into(const Room& room, std::vector<plan::Draft>& drafts,
              std::vector<std::string>& repairs) {
  const double room_side = bounds(room.polygon).size().maxCoeff();
  const Vec3 most(room_side, room_side, room.height);
  for (auto& draft : drafts) {
    if (!draft.item.size || (draft.item.size->array() <= most.array()).all()) continue;
    draft.item.size = draft.item.size->cwiseMin(most);
    repairs.push_back("the size of the " + draft.item.category + " was bounded by the room");
  }
}

// Answers know no pointers: "/openings/1" is the second.
std::string by_number(std::string note, std::size_t openings) {
  for (std::size_t i = 0; i < openings; ++i) {
    const std::string pointer = "\"/openings/" + std::to_string(i) + "\"";
    for (std::size_t at; (at = note.find(pointer)) != std::string::npos;)
      note.replace(at, pointer.size(), std::to_string(i + 1));
  }
  return note;
}

// Openings that the answer names stand in place of the usual ones.
void open_as_said(const Json& json, const PlanRequest& request, const brief::RoomKind& kind, Plan& plan,
                  std::vector<std::string>& repairs) {
  if (request.room) return;
  plan.openings = read_reply_openings(json, plan.room, repairs);
  if (plan.openings.empty()) return;
  plan.room.openings.clear();
  const std::size_t told = plan.openings.size();
  settle(plan);
  for (auto& note : plan.notes) repairs.push_back(by_number(std::move(note), told));
  plan.notes.clear();
  const auto& all = plan.room.openings;
  if (std::none_of(all.begin(), all.end(), [](const Opening& one) { return one.is_entrance(); }))
    plan::ensure_door(plan.room, kind, repairs);
}

}  // namespace

Result<PlanParts> read_plan_parts(const Json& json, const PlanRequest& request,
                                  const brief::Brief& brief, const KindTable& categories) {
  const Json* objects = member(json, object_keys);
  PlanParts parts;
  auto& repairs = parts.repairs;
  const brief::RoomKind kind =
      kind_of_room(choose_type(json, request, brief, repairs), *brief::built_in_room_kinds());
  const ItemLexicon lexicon{categories, kind};

  const Json* said_groups = member(json, {"groups"});
  const Json groups = said_groups ? *said_groups : Json();
  parts.drafts = read_reply_items(objects ? *objects : Json(), groups, lexicon, repairs);
  parts.groups = read_reply_groups(groups, lexicon, parts.drafts, repairs);
  parts.excluded = read_excluded(json, brief, lexicon);
  leave_out_excluded(parts.drafts, parts.excluded, categories, repairs);
  parts.room = read_reply_room(json, request, kind, brief,
                               plan::floor_area(parts.drafts, categories), repairs);
  plan::put_on(parts.room, brief.materials);
  read_reply_look(json, parts.room, repairs);
  Plan opened;
  opened.seed = request.seed;
  opened.room = parts.room;
  open_as_said(json, request, kind, opened, repairs);
  parts.room = std::move(opened.room);
  fit_into(parts.room, parts.drafts, repairs);
  return parts;
}

Result<PlanReply> read_plan_reply(std::string_view text, const PlanRequest& request,
                                  const brief::Brief& brief, const KindTable& categories) {
  if (!brief::built_in_room_kinds()) return brief::built_in_room_kinds().error();
  if (!brief::built_in_vocabulary()) return brief::built_in_vocabulary().error();
  if (!built_in_arrangements()) return built_in_arrangements().error();
  auto found = find_json(text, plan_keys);
  if (!found) return found.error();
  const Json& json = found->json;
  if (!member(json, object_keys) && !member(json, {"groups"}))
    return invalid(
        "the answer lists no objects; give \"objects\": [{\"name\": \"bed\", "
        "\"description\": \"…\", \"size_cm\": [160, 210, 90], \"quantity\": 1}, …]");
  auto parts = read_plan_parts(json, request, brief, categories);
  if (!parts) return parts.error();
  if (parts->drafts.empty())
    return invalid("the answer's \"objects\" name nothing that can be placed: " +
                   join(parts->repairs, "; "));
  for (auto& draft : parts->drafts) draft.item.asked = is_mentioned(draft.item, brief, categories);

  PlanReply reply{{}, std::move(found->repairs)};
  Plan& plan = reply.plan;
  plan.prompt = request.prompt;
  plan.seed = request.seed;
  plan.room = std::move(parts->room);
  plan.groups = std::move(parts->groups);
  plan.excluded = std::move(parts->excluded);
  plan::order_items(std::move(parts->drafts), categories, *built_in_arrangements(), plan);
  composition::complete_groups(plan, categories);
  auto& repairs = reply.repairs;
  repairs.insert(repairs.end(), parts->repairs.begin(), parts->repairs.end());
  repairs.insert(repairs.end(), plan.notes.begin(), plan.notes.end());
  plan.notes.clear();
  if (const Json* idea = member(json, {"concept"}); idea && idea->is_string())
    reply.concept_text = shortened(idea->get<std::string>(), max_concept);
  if (repairs.size() > max_plan_repairs) repairs.resize(max_plan_repairs);
  return reply;
}

Status check_floor(const Plan& plan, const KindTable& categories) {
  double covered = 0.0;
  for (const auto& item : plan.items) covered += plan::floor_area(item, categories);
  const double floor = area(plan.room.polygon);
  if (covered <= floor) return {};
  return invalid("the objects cover " + format_number(covered, 1) + " m2, but the room has only " +
                 format_number(floor, 1) + " m2 of floor; list fewer things, and each kind once");
}

}  // namespace roomgen::design
