#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"
#include "roomgen/edit/operation.h"
#include "scene/room_look_json.h"

namespace roomgen::edit {

namespace {

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

void add_program(Json& json, const std::string& program) {
  if (program.empty()) return;
  const auto parsed = parse_json(program, "program");
  json["program"] = parsed ? *parsed : Json(program);
}

void add_number(Json& json, const char* key, const std::optional<double>& number) {
  if (number) json[key] = rounded(*number);
}

// Where an opening is, and how large.
template <typename Opening>
void add_measures(Json& json, const Opening& opening) {
  add_text(json, "wall", opening.wall);
  add_number(json, "at", opening.at);
  add_number(json, "width", opening.width);
  add_number(json, "height", opening.height);
  add_number(json, "sill", opening.sill);
}

struct Writer {
  Json operator()(const Add& add) const {
    Json json = {{"do", "add"}, {"category", add.category}};
    add_text(json, "description", add.description);
    if (add.size) json["size"] = numbers_of(*add.size);
    if (add.count != 1) json["count"] = add.count;
    if (!add.relations.empty()) json["relations"] = texts_of(add.relations);
    add_text(json, "room", add.room);
    add_program(json, add.program);
    if (add.mount) json["mount"] = name(*add.mount);
    return json;
  }
  Json operator()(const Remove& remove) const {
    Json json = {{"do", "remove"}, {"objects", remove.objects}};
    if (remove.group) json["group"] = true;
    return json;
  }
  Json operator()(const Move& move) const {
    Json json = {{"do", "move"}, {"object", move.object}, {"relations", texts_of(move.relations)}};
    if (move.group) json["group"] = true;
    add_text(json, "room", move.room);
    return json;
  }
  Json operator()(const Put& put) const {
    Json json = {{"do", "put"}, {"object", put.object}, {"position", numbers_of(put.position)}};
    if (put.yaw) json["yaw_deg"] = degrees_of(*put.yaw);
    add_text(json, "on", put.on);
    return json;
  }
  Json operator()(const Shift& shift) const {
    Json json = {{"do", "shift"}, {"object", shift.object}, {"by", numbers_of(shift.by)}};
    if (shift.group) json["group"] = true;
    return json;
  }
  Json operator()(const Turn& turn) const {
    Json json = {{"do", "turn"}, {"object", turn.object}, {"by_deg", degrees_of(turn.by)}};
    if (turn.group) json["group"] = true;
    return json;
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
    if (replace.size) json["size"] = numbers_of(*replace.size);
    add_program(json, replace.program);
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
  Json operator()(const Light& light) const {
    Json json = light_json(light.light);
    json["do"] = "light";
    add_text(json, "room", light.room);
    return json;
  }
  Json operator()(const Rearrange& rearrange) const {
    return {{"do", "rearrange"}, {"objects", rearrange.objects}};
  }
  Json operator()(const Arrange& arrange) const {
    Json spots = Json::array();
    for (const auto& spot : arrange.spots) {
      spots.push_back(
          {{"object", spot.object}, {"position", numbers_of(spot.position)}, {"yaw_deg", degrees_of(spot.yaw)}});
      if (spot.size) spots.back()["size"] = numbers_of(*spot.size);
    }
    return {{"do", "arrange"}, {"spots", std::move(spots)}};
  }
  Json operator()(const Reform& reform) const {
    return {{"do", "reform"}, {"object", reform.object}, {"words", reform.words}};
  }
  Json operator()(const Reshape& reshape) const {
    Json json = {{"do", "reshape"}};
    if (!reshape.wall.empty()) json.update({{"wall", reshape.wall}, {"by", rounded(reshape.by)}});
    add_number(json, "height", reshape.height);
    return json;
  }
  Json operator()(const Open& open) const {
    Json json = {{"do", "open"}, {"kind", open.kind}};
    add_measures(json, open);
    add_text(json, "room", open.room);
    return json;
  }
  Json operator()(const Refit& refit) const {
    Json json = {{"do", "refit"}, {"opening", refit.opening}};
    add_measures(json, refit);
    return json;
  }
  Json operator()(const Close& close) const { return {{"do", "close"}, {"openings", close.openings}}; }
  Json operator()(const Revert&) const { return {{"do", "revert"}}; }
};

}  // namespace

Json to_json(const Operation& operation) { return std::visit(Writer(), operation); }

}  // namespace roomgen::edit
