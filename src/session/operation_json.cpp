#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "roomgen/session/operation.h"

namespace roomgen::edit {

namespace {

constexpr std::size_t most_named = 1000, most_operations = 200;
constexpr int most_added = 50;
constexpr double furthest = 1e4, largest = 100.0;  // metres

Json numbers_of(const Vec2& v) { return {rounded(v.x()), rounded(v.y())}; }
Json numbers_of(const Vec3& v) { return {rounded(v.x()), rounded(v.y()), rounded(v.z())}; }
Json degrees_of(double yaw) { return rounded(degrees(yaw), 3); }

Json texts_of(const std::vector<Relation>& relations) {
  Json texts = Json::array();
  for (const auto& relation : relations) texts.push_back(to_text(relation));
  return texts;
}

void add_text(Json& json, const char* key, const std::string& text) {
  if (!text.empty()) json[key] = text;
}

struct Writer {
  Json operator()(const Add& add) const {
    Json json = {{"do", "add"}, {"category", add.category}};
    add_text(json, "description", add.description);
    if (add.size) json["size"] = numbers_of(*add.size);
    if (add.count != 1) json["count"] = add.count;
    if (!add.relations.empty()) json["relations"] = texts_of(add.relations);
    add_text(json, "room", add.room);
    return json;
  }
  Json operator()(const Remove& remove) const {
    Json json = {{"do", "remove"}, {"objects", remove.objects}};
    if (remove.group) json["group"] = true;
    return json;
  }
  Json operator()(const Move& move) const {
    return {{"do", "move"}, {"object", move.object}, {"relations", texts_of(move.relations)}};
  }
  Json operator()(const Put& put) const {
    Json json = {{"do", "put"}, {"object", put.object}, {"position", numbers_of(put.position)}};
    if (put.yaw) json["yaw_deg"] = degrees_of(*put.yaw);
    add_text(json, "on", put.on);
    return json;
  }
  Json operator()(const Shift& shift) const {
    return {{"do", "shift"}, {"object", shift.object}, {"by", numbers_of(shift.by)}};
  }
  Json operator()(const Turn& turn) const {
    return {{"do", "turn"}, {"object", turn.object}, {"by_deg", degrees_of(turn.by)}};
  }
  Json operator()(const Face& face) const {
    return {{"do", "face"}, {"object", face.object}, {"target", face.target}};
  }
  Json operator()(const Swap& swap) const {
    return {{"do", "swap"}, {"first", swap.first}, {"second", swap.second}};
  }
  Json operator()(const Replace& replace) const {
    Json json = {{"do", "replace"}, {"object", replace.object}};
    add_text(json, "category", replace.category);
    add_text(json, "description", replace.description);
    return json;
  }
  Json operator()(const Resize& resize) const {
    return {{"do", "resize"}, {"object", resize.object}, {"size", numbers_of(resize.size)}};
  }
  Json operator()(const Recolor& recolor) const {
    return {{"do", "recolor"}, {"object", recolor.object}, {"looks", recolor.looks}};
  }
  Json operator()(const Lock& lock) const {
    return {{"do", "lock"}, {"objects", lock.objects}, {"locked", lock.locked}};
  }
  Json operator()(const Cover& cover) const {
    Json json = {{"do", "cover"}, {"part", cover.part}, {"looks", cover.looks}};
    add_text(json, "room", cover.room);
    return json;
  }
  Json operator()(const Revert&) const { return {{"do", "revert"}}; }
};

Vec2 vec2_of(const JsonReader& json) {
  const auto v = json.numbers(2, -furthest, furthest);
  return {v[0], v[1]};
}

Vec3 vec3_of(const JsonReader& json) {
  const auto v = json.numbers(3, -furthest, furthest);
  return {v[0], v[1], v[2]};
}

Vec3 size_of(const JsonReader& json) {
  const auto v = json.numbers(3, 1e-3, largest);
  return {v[0], v[1], v[2]};
}

double angle_of(const JsonReader& json) { return radians(json.number(-36000.0, 36000.0)); }

std::vector<std::string> ids_of(const JsonReader& json) {
  std::vector<std::string> ids;
  for (const auto& element : json.elements(most_named)) ids.push_back(element.text(200));
  if (ids.empty()) json.report("names nothing");
  return ids;
}

std::vector<Relation> relations_of(const JsonReader& json) {
  std::vector<Relation> relations;
  for (const auto& element : json.elements_or_none(20)) {
    const auto relation = parse_relation(element.text(500));
    if (relation) relations.push_back(*relation);
    else element.report(relation.error().message);
  }
  return relations;
}

Operation read_add(const JsonReader& json) {
  json.allow_only({"do", "category", "description", "size", "count", "relations", "room"});
  Add add{json["category"].text(200), json["description"].text_or("", 1000)};
  if (json["size"].exists()) add.size = size_of(json["size"]);
  add.count = static_cast<int>(json["count"].integer_or(1, 1, most_added));
  add.relations = relations_of(json["relations"]);
  add.room = json["room"].text_or("", 200);
  return add;
}

Operation read_remove(const JsonReader& json) {
  json.allow_only({"do", "objects", "group"});
  return Remove{ids_of(json["objects"]), json["group"].boolean_or(false)};
}

Operation read_move(const JsonReader& json) {
  json.allow_only({"do", "object", "relations"});
  Move move{json["object"].text(200), relations_of(json["relations"])};
  if (move.relations.empty()) json.report("\"relations\" says where to, such as [\"next to, bed-0\"]");
  return move;
}

Operation read_put(const JsonReader& json) {
  json.allow_only({"do", "object", "position", "yaw_deg", "on"});
  Put put{json["object"].text(200), vec2_of(json["position"])};
  if (json["yaw_deg"].exists()) put.yaw = angle_of(json["yaw_deg"]);
  put.on = json["on"].text_or("", 200);
  return put;
}

Operation read_shift(const JsonReader& json) {
  json.allow_only({"do", "object", "by"});
  return Shift{json["object"].text(200), vec3_of(json["by"])};
}

Operation read_turn(const JsonReader& json) {
  json.allow_only({"do", "object", "by_deg"});
  return Turn{json["object"].text(200), angle_of(json["by_deg"])};
}

Operation read_face(const JsonReader& json) {
  json.allow_only({"do", "object", "target"});
  return Face{json["object"].text(200), json["target"].text(200)};
}

Operation read_swap(const JsonReader& json) {
  json.allow_only({"do", "first", "second"});
  return Swap{json["first"].text(200), json["second"].text(200)};
}

Operation read_replace(const JsonReader& json) {
  json.allow_only({"do", "object", "category", "description"});
  return Replace{json["object"].text(200), json["category"].text_or("", 200), json["description"].text_or("", 1000)};
}

Operation read_resize(const JsonReader& json) {
  json.allow_only({"do", "object", "size"});
  return Resize{json["object"].text(200), size_of(json["size"])};
}

Operation read_recolor(const JsonReader& json) {
  json.allow_only({"do", "object", "looks"});
  return Recolor{json["object"].text(200), json["looks"].text(500)};
}

Operation read_lock(const JsonReader& json) {
  json.allow_only({"do", "objects", "locked"});
  return Lock{ids_of(json["objects"]), json["locked"].boolean_or(true)};
}

Operation read_cover(const JsonReader& json) {
  json.allow_only({"do", "part", "looks", "room"});
  return Cover{json["part"].text(50), json["looks"].text(500), json["room"].text_or("", 200)};
}

Operation read_revert(const JsonReader& json) {
  json.allow_only({"do"});
  return Revert{};
}

struct OperationKind {
  std::string_view name;
  Operation (*read)(const JsonReader& json);
};
constexpr std::array<OperationKind, 14> operation_kinds = {{{"add", read_add},
                                                            {"remove", read_remove},
                                                            {"move", read_move},
                                                            {"put", read_put},
                                                            {"shift", read_shift},
                                                            {"turn", read_turn},
                                                            {"face", read_face},
                                                            {"swap", read_swap},
                                                            {"replace", read_replace},
                                                            {"resize", read_resize},
                                                            {"recolor", read_recolor},
                                                            {"lock", read_lock},
                                                            {"cover", read_cover},
                                                            {"revert", read_revert}}};

Operation read_operation(const JsonReader& json) {
  const std::string what = json["do"].text(50);
  std::string known;
  for (const auto& kind : operation_kinds) {
    if (kind.name == what) return kind.read(json);
    known += (known.empty() ? "" : ", ") + std::string(kind.name);
  }
  json["do"].report("\"" + what + "\" is none of " + known);
  return Operation();
}

}  // namespace

Json to_json(const Operation& operation) { return std::visit(Writer(), operation); }

Result<Operation> operation_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  Operation operation = read_operation(JsonReader(json, problems));
  if (problems.first()) return *problems.first();
  return operation;
}

Result<std::vector<Operation>> operations_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  std::vector<Operation> operations;
  if (!root.is_array()) operations.push_back(read_operation(root));
  else
    for (const auto& element : root.elements(most_operations)) operations.push_back(read_operation(element));
  if (problems.first()) return *problems.first();
  if (operations.empty()) return Error{Error::Kind::invalid_input, source + ": there is nothing to do"};
  return operations;
}

}  // namespace roomgen::edit
