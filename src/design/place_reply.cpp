#include "place_reply.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "brief/reply_measure.h"
#include "chat/loose_json.h"
#include "chat/plain_reply.h"
#include "place_answers.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "target_names.h"

namespace roomgen::design {

namespace {

constexpr std::size_t max_place_repairs = 150;
constexpr std::size_t max_repair = 300;      ///< bytes
constexpr std::size_t max_reasoning = 4000;  ///< bytes
constexpr double shortest = 0.01, longest = 50.0;  ///< metres

// The keys that tell an answer from other objects in the text; then all their spellings.
const WantedKeys place_keys = {{"constraints", "location", "leave_out"},
                                {"constraint", "constrains", "position"}};
const std::vector<std::string> constraint_keys = {"constraints",
                                                  "constraint",
                                                  "constrains",
                                                  "constrain",
                                                  "relations",
                                                  "relation",
                                                  "placement constraints",
                                                  "spatial constraints"};
const std::vector<std::string> location_keys = {"location",    "position",
                                                "coordinates", "coordinate",
                                                "pos",         "point",
                                                "center",      "centre",
                                                "xy",          "location m",
                                                "place",       "placement",
                                                "location xy", "suggested location"};
const std::vector<std::string> facing_keys = {"facing",    "yaw",   "orientation",    "rotation",
                                              "direction", "angle", "facing degrees", "face to"};
const std::vector<std::string> reasoning_keys = {"reasoning", "reason",    "reasons",    "thought",
                                                 "thoughts",  "rationale", "explanation"};

// The id that an answer means, whatever its case and separators; empty if it is none of them.
std::string read_next(const Json& json, const std::vector<std::string>& later,
                      std::vector<std::string>& repairs) {
  const Json* value = member(json, {"next", "next object", "next thing"});
  if (!value || !value->is_string() || later.empty()) return "";
  const auto wanted = words(value->get_ref<const std::string&>());
  for (const auto& id : later)
    if (words(id) == wanted) return id;
  repairs.emplace_back("the answer's \"next\" is none of those that may come next");
  return "";
}

// {"others": [{"id": "cup-0", …}]}
std::vector<std::pair<std::string, std::string>> read_others(const Json& json) {
  constexpr std::size_t most_others = 30;
  std::vector<std::pair<std::string, std::string>> others;
  const Json* list = member(json, {"others", "other things"});
  if (!list || !list->is_array()) return others;
  for (const auto& one : *list) {
    const Json* id = one.is_object() ? member(one, {"id", "object", "name"}) : nullptr;
    if (id && id->is_string() && others.size() < most_others)
      others.emplace_back(id->get<std::string>(), json_line(one));
  }
  return others;
}

// Why the thing shall not be there; how high it hangs; how large it shall be after all.
void read_amendments(const Json& json, PlaceAdvice& advice, ReplyNotes& notes) {
  const Json* out = member(json, {"leave out", "leave it out", "omit"});
  if (out && out->is_string()) advice.leave_out = shortened(out->get<std::string>(), max_repair);
  if (out && *out == Json(true)) advice.leave_out = "as it says";
  if (const Json* bottom = member(json, {"bottom m", "bottom"}))
    if (const auto height = brief::single_measure(*bottom)) advice.bottom = std::clamp(height->value, 0.0, longest);
  const Json* size = member(json, {"size cm", "size"});
  if (!size) return;
  advice.size = brief::size_in(*size, {shortest, longest});
  if (!advice.size && !size->is_null())
    notes.repair("the answer's size is not width, depth and height in centimetres");
}

// {"id": "sofa-0", "location": [x, y], "facing": 90}
void read_move(const Json& one, const PlaceReplyContext& context, const TargetNames& targets,
               PlaceAdvice& advice, ReplyNotes& notes) {
  const Json* id = one.is_object() ? member(one, {"id", "object"}) : nullptr;
  const Json* to = id && id->is_string() ? member(one, location_keys) : nullptr;
  const auto frame = context.paper_frame ? MarksFrame::paper : MarksFrame::plan;
  ReplyNotes own;
  if (!to) own.lose("it needs an id and a location");
  const auto location =
      to ? read_reply_location(*to, context.scene.room.polygon, frame, own) : std::nullopt;
  if (location) {
    advice.moves.push_back({lower(id->get<std::string>()), *location, {}});
    if (const Json* facing = member(one, facing_keys); facing && !facing->is_null())
      advice.moves.back().yaw =
          read_reply_facing(*facing, context.scene, targets, location, own).yaw;
  }
  if (!own.lost.empty())
    notes.lose("the move " + json_line(one) + " was not taken as it is: " + join(own.lost, "; "));
}

void read_moves(const Json& json, const PlaceReplyContext& context, const TargetNames& targets, PlaceAdvice& advice,
                ReplyNotes& notes) {
  constexpr std::size_t most_moves = 100;
  const Json* list = member(json, {"move", "moves"});
  if (!list || !list->is_array()) return;
  for (std::size_t i = 0; i < list->size() && i < most_moves; ++i)
    read_move((*list)[i], context, targets, advice, notes);
  if (list->size() > most_moves)
    notes.lose("only the first " + std::to_string(most_moves) + " of " +
               std::to_string(list->size()) + " moves were taken; give the others again");
}

void bound(std::vector<std::string>& repairs) {
  if (repairs.size() > max_place_repairs) repairs.resize(max_place_repairs);
  for (auto& repair : repairs) repair = shortened(std::move(repair), max_repair);
}

std::optional<Vec2> read_location(const Json& json, const PlaceReplyContext& context,
                                  ReplyNotes& notes) {
  const auto frame = context.paper_frame ? MarksFrame::paper : MarksFrame::plan;
  const Polygon& room = context.scene.room.polygon;
  const Json* value = member(json, location_keys);
  if (value && !value->is_null() && !(value->is_array() && value->empty()))
    return read_reply_location(*value, room, frame, notes);
  if (member(json, {"x"}) && member(json, {"y"})) {
    const Json pair = {{"x", *member(json, {"x"})}, {"y", *member(json, {"y"})}};
    return read_reply_location(pair, room, frame, notes);
  }
  notes.repair("the answer has no location");
  return std::nullopt;
}

// What is on a wall has its back against that; furniture stands under a window when it is before
// it.
std::vector<Relation> meant_by(const Relation& said, const PlaceReplyContext& context) {
  if (said.kind == RelationKind::on && said.target.starts_with("wall-"))
    return {{RelationKind::edge, ""}, {RelationKind::next_to, said.target}};
  if (said.kind == RelationKind::under && context.object.mount == Mount::floor &&
      find_opening(context.scene.room, said.target))
    return {{RelationKind::near, said.target}, {RelationKind::in_front_of, said.target}};
  return {};
}

std::vector<Relation> as_meant(const std::vector<Relation>& said, const PlaceReplyContext& context,
                               ReplyNotes& notes) {
  std::vector<Relation> relations;
  for (const auto& relation : said) {
    const auto meant = meant_by(relation, context);
    if (meant.empty()) {
      relations.push_back(relation);
      continue;
    }
    notes.repair("\"" + to_text(relation) + "\" was read as \"" + to_text(meant) + "\"");
    for (const auto& one : meant)
      if (std::find(said.begin(), said.end(), one) == said.end()) relations.push_back(one);
  }
  return relations;
}

Result<LooseJson> find_answer(std::string_view text) {
  auto found = find_json(text, place_keys);
  if (found || found.error().kind != Error::Kind::invalid_input) return found;
  if (auto plain = read_plain_reply(text))
    return LooseJson{*std::move(plain),
                     {"the answer was no JSON; its list of constraints was taken"}};
  return found;
}

Error unusable(const PlaceReplyContext& context, const std::vector<std::string>& repairs) {
  const Bounds2 box = bounds(context.scene.room.polygon);
  const Vec2 size = box.size();
  const Vec2 low = context.paper_frame ? Vec2(0, 0) : Vec2(box.low);
  const Vec2 high = context.paper_frame ? Vec2(size.y(), size.x()) : Vec2(box.high);
  const auto range = [](double from, double to) {
    return format_number(from) + " to " + format_number(to);
  };
  return {Error::Kind::invalid_input,
          "the answer for " + context.object.id + " has neither a constraint nor a location that " +
              "can be used: " + join(repairs, "; ") +
              ". Give \"constraints\" as in \"edge | near, bed-0\" and \"location\" as [x, y] in " +
              "metres, x from " + range(low.x(), high.x()) + ", y from " +
              range(low.y(), high.y())};
}

}  // namespace

Result<PlaceReply> read_place_reply(std::string_view text, const PlaceReplyContext& context) {
  auto found = find_answer(text);
  if (!found) return found.error();
  const Json& json = found->json;
  PlaceReply reply;
  PlaceAdvice& advice = reply.advice;
  ReplyNotes notes{std::move(found->repairs), {}};
  const TargetNames targets(context.scene, context.object, KindTable::built_in());

  if (const Json* constraints = member(json, constraint_keys))
    advice.relations = as_meant(read_reply_relations(*constraints, targets, notes), context, notes);
  advice.location = read_location(json, context, notes);
  if (const Json* facing = member(json, facing_keys); facing && !facing->is_null()) {
    const auto read =
        read_reply_facing(*facing, context.scene, targets, advice.location, notes);
    advice.yaw = read.yaw;
    if (read.relation) add_relation(advice.relations, *read.relation, notes);
  }
  advice.next = read_next(json, context.later, notes.all);
  read_amendments(json, advice, notes);
  read_moves(json, context, targets, advice, notes);
  if (const Json* reasoning = member(json, reasoning_keys); reasoning && reasoning->is_string())
    advice.reasoning = shortened(reasoning->get<std::string>(), max_reasoning);
  bound(notes.all);
  bound(notes.lost);
  reply.others = read_others(json);
  reply.repairs = std::move(notes.all);
  advice.lost = std::move(notes.lost);
  if (advice.relations.empty() && !advice.location && advice.leave_out.empty()) return unusable(context, reply.repairs);
  return reply;
}

}  // namespace roomgen::design
