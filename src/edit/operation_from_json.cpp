#include <array>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "roomgen/edit/operation.h"
#include "scene/room_look_json.h"

namespace roomgen::edit {

namespace {

constexpr std::size_t most_named = 1000, most_operations = 200;
constexpr std::size_t longest_program = 400'000;  // bytes
constexpr int most_added = 50;
constexpr double furthest = 1e4, largest = 100.0;  // metres

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
    const auto one_or_more = parse_relations(element.text(500));
    if (!one_or_more) element.report(one_or_more.error().message);
    else relations.insert(relations.end(), one_or_more->begin(), one_or_more->end());
  }
  return relations;
}

// As it was written: who builds it says what is wrong with it.
std::string program_of(const JsonReader& json) {
  if (!json.exists() || json.raw()->is_null()) return {};
  std::string text = json_line(*json.raw());
  if (json.raw()->is_object() && text.size() <= longest_program) return text;
  json.report("is no shape program of at most " + std::to_string(longest_program) + " bytes");
  return {};
}

Operation read_add(const JsonReader& json) {
  json.allow_only(
      {"do", "category", "description", "size", "count", "relations", "room", "program", "mount"});
  Add add{json["category"].text(200), json["description"].text_or("", 1000)};
  if (json["size"].exists()) add.size = size_of(json["size"]);
  add.count = static_cast<int>(json["count"].integer_or(1, 1, most_added));
  add.relations = relations_of(json["relations"]);
  add.room = json["room"].text_or("", 200);
  add.program = program_of(json["program"]);
  const JsonReader mount = json["mount"];
  if (mount.exists() && !(add.mount = parse_mount(mount.text(20))))
    mount.report("is floor, wall, ceiling or surface");
  return add;
}

Operation read_remove(const JsonReader& json) {
  json.allow_only({"do", "objects", "group"});
  return Remove{ids_of(json["objects"]), json["group"].boolean_or(false)};
}

Operation read_move(const JsonReader& json) {
  json.allow_only({"do", "object", "relations", "group", "room"});
  Move move{json["object"].text(200), relations_of(json["relations"]), json["group"].boolean_or(false),
            json["room"].text_or("", 200)};
  if (move.relations.empty() && move.room.empty())
    json.report("\"relations\" says where to, such as [\"next to, bed-0\"]");
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
  json.allow_only({"do", "object", "by", "group"});
  return Shift{json["object"].text(200), vec3_of(json["by"]), json["group"].boolean_or(false)};
}

Operation read_turn(const JsonReader& json) {
  json.allow_only({"do", "object", "by_deg", "group"});
  return Turn{json["object"].text(200), angle_of(json["by_deg"]), json["group"].boolean_or(false)};
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
  json.allow_only({"do", "object", "category", "description", "size", "program"});
  Replace replace{json["object"].text(200), json["category"].text_or("", 200), json["description"].text_or("", 1000)};
  if (json["size"].exists()) replace.size = size_of(json["size"]);
  replace.program = program_of(json["program"]);
  return replace;
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

Operation read_light_of_room(const JsonReader& json) {
  json.allow_only({"do", "hour", "sky", "level", "warmth", "lamps", "room"});
  Light light{read_light(json), json["room"].text_or("", 200)};
  if (light.light == Lighting())
    json.report("\"hour\", \"sky\", \"level\", \"warmth\" or \"lamps\" say how the light shall be");
  return light;
}

Operation read_rearrange(const JsonReader& json) {
  json.allow_only({"do", "objects"});
  return Rearrange{ids_of(json["objects"])};
}

Operation read_arrange(const JsonReader& json) {
  json.allow_only({"do", "spots"});
  Arrange arrange;
  for (const auto& element : json["spots"].elements(most_named)) {
    element.allow_only({"object", "position", "yaw_deg", "size"});
    Arrange::Spot spot{element["object"].text(200), vec3_of(element["position"]), angle_of(element["yaw_deg"])};
    if (element["size"].exists()) spot.size = size_of(element["size"]);
    arrange.spots.push_back(std::move(spot));
  }
  if (arrange.spots.empty()) json.report("\"spots\" says what goes where");
  return arrange;
}

Operation read_reform(const JsonReader& json) {
  json.allow_only({"do", "object", "words"});
  return Reform{json["object"].text(200), json["words"].text(500)};
}

std::optional<double> number_at(const JsonReader& json, double least, double most) {
  if (!json.exists()) return std::nullopt;
  return json.number(least, most);
}

Operation read_reshape(const JsonReader& json) {
  json.allow_only({"do", "wall", "by", "height"});
  Reshape reshape{json["wall"].text_or("", 200), json["by"].number_or(0.0, -furthest, furthest),
                  number_at(json["height"], 0.0, largest)};
  if (reshape.wall.empty() && !reshape.height) json.report("\"wall\" and \"by\", or \"height\", say what changes");
  return reshape;
}

template <typename Opening>
void read_measures(const JsonReader& json, Opening& opening) {
  opening.wall = json["wall"].text_or("", 200);
  opening.at = number_at(json["at"], 0.0, furthest);
  opening.width = number_at(json["width"], 0.0, largest);
  opening.height = number_at(json["height"], 0.0, largest);
  opening.sill = number_at(json["sill"], 0.0, largest);
}

Operation read_open(const JsonReader& json) {
  json.allow_only({"do", "kind", "wall", "at", "width", "height", "sill", "room"});
  Open open;
  open.kind = json["kind"].text(200);
  open.room = json["room"].text_or("", 200);
  read_measures(json, open);
  return open;
}

Operation read_refit(const JsonReader& json) {
  json.allow_only({"do", "opening", "wall", "at", "width", "height", "sill"});
  Refit refit;
  refit.opening = json["opening"].text(200);
  read_measures(json, refit);
  return refit;
}

Operation read_close(const JsonReader& json) {
  json.allow_only({"do", "openings"});
  return Close{ids_of(json["openings"])};
}

Operation read_revert(const JsonReader& json) {
  json.allow_only({"do"});
  return Revert{};
}

struct OperationKind {
  std::string_view name;
  Operation (*read)(const JsonReader& json);
};
constexpr std::array<OperationKind, 22> operation_kinds = {{{"add", read_add},
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
                                                            {"light", read_light_of_room},
                                                            {"rearrange", read_rearrange},
                                                            {"arrange", read_arrange},
                                                            {"reform", read_reform},
                                                            {"reshape", read_reshape},
                                                            {"open", read_open},
                                                            {"refit", read_refit},
                                                            {"close", read_close},
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

// What a file would be read without is no operation.
std::optional<Error> first_of(const JsonReader::Problems& problems) {
  if (problems.first() || problems.remarks().empty()) return problems.first();
  return Error{Error::Kind::invalid_input, problems.remarks().front()};
}

}  // namespace

Result<Operation> operation_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  Operation operation = read_operation(JsonReader(json, problems));
  if (auto wrong = first_of(problems)) return *wrong;
  return operation;
}

Result<std::vector<Operation>> operations_from_json(const Json& json, const std::string& source) {
  JsonReader::Problems problems(source);
  const JsonReader root(json, problems);
  std::vector<Operation> operations;
  if (!root.is_array()) operations.push_back(read_operation(root));
  else
    for (const auto& element : root.elements(most_operations)) operations.push_back(read_operation(element));
  if (auto wrong = first_of(problems)) return *wrong;
  if (operations.empty()) return Error{Error::Kind::invalid_input, source + ": there is nothing to do"};
  return operations;
}

}  // namespace roomgen::edit
