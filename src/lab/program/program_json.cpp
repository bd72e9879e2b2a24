#include <nlohmann/json.hpp>

#include "face_names.h"
#include "form_operands.h"
#include "names.h"
#include "program_text.h"
#include "roomgen/scene/scene.h"

namespace roomgen::lab {

namespace {

using Source = ProgramSet::Source;

Json tags_json(const ProgramSet& set) {
  Json tags = Json::array();
  for (const auto& tag : set.tags) tags.push_back(tag);
  for (const auto& tag : set.without) tags.push_back("-" + tag);
  return tags;
}

Json sets_json(const std::vector<ProgramSet>& sets) {
  Json json = Json::array();
  for (const auto& set : sets) json.push_back(to_json(set));
  return json;
}

Json description_json(const ProgramSet& set) {
  Json json = Json::object();
  if (!set.from.empty()) json["from"] = to_json(set.from[0]);
  if (!set.tags.empty() || !set.without.empty()) json["tags"] = tags_json(set);
  if (!set.factory.empty()) json["factory"] = set.factory;
  for (const auto& relation : set.relations) {
    Json pair = Json::array({(relation.absent ? "-" : "") + relation.relation});
    for (const auto& target : relation.target) pair.push_back(to_json(target));
    json["rel"].push_back(std::move(pair));
  }
  return json;
}

Json access_json(const ProgramTerm& term) {
  const ProgramTerm usual;
  Json json = Json::object();
  if (term.direction != usual.direction) json["dir"] = term.direction;
  if (term.depth != usual.depth) json["depth"] = term.depth;
  return json;
}

// Takes the parts of a term in the order of its form.
class OperandWriter {
 public:
  explicit OperandWriter(const ProgramTerm& term) : term_(term) {}

  bool done() const { return set_ >= term_.sets.size() && operand_ >= term_.operands.size(); }
  void write(char sort, Json& json) {
    switch (sort) {
      case 'S':
        if (set_ < term_.sets.size()) json.push_back(to_json(term_.sets[set_++]));
        break;
      case 'L': write_literal(json); break;
      case 'v': json.push_back(term_.name); break;
      case 's':
        if (term_.face) json.push_back(name(*term_.face));
        break;
      case 'a':
        if (Json access = access_json(term_); !access.empty()) json.push_back(std::move(access));
        break;
      default:
        if (operand_ < term_.operands.size()) json.push_back(to_json(term_.operands[operand_++]));
    }
  }

 private:
  void write_literal(Json& json) {
    if (is_weighted(term_.op)) json.push_back(term_.number);
    else if (literal_ < term_.literals.size()) json.push_back(term_.literals[literal_++]);
  }

  const ProgramTerm& term_;
  std::size_t set_ = 0, operand_ = 0, literal_ = 0;
};

Json range_json(const Range& range) {
  return range.low == range.high ? Json(range.low) : Json::array({range.low, range.high});
}

Json faces_json(const std::vector<Face>& faces) {
  Json json = Json::array();
  for (const Face face : faces) json.push_back(name(face));
  return json;
}

Json put_up_json(const PutUp& put_up) {
  return {{"type", put_up.type == PutUp::Type::coplanar ? "coplanar" : "stable_against"},
          {"child", faces_json(put_up.child)},
          {"parent", faces_json(put_up.parent)},
          {"margin", put_up.margin},
          {"check_z", put_up.within_height}};
}

Json parameter_json(const ProgramParameter& parameter) {
  if (parameter.uniform) return {{"uniform", {parameter.uniform->low, parameter.uniform->high}}};
  if (parameter.choice.size() == 1) return parameter.choice[0];
  return {{"choice", parameter.choice}};
}

Json polygon_json(const Polygon& polygon) {
  Json json = Json::array();
  for (const auto& point : polygon.points) json.push_back({point.x(), point.y()});
  return json;
}

// As scenes write them.
Json openings_json(const std::vector<Opening>& openings) {
  Room room;
  room.openings = openings;
  return to_json(room)["openings"];
}

Json room_json(const ProgramRoom& room) {
  Json json;
  json["type"] = room.type;
  if (room.polygon) json["polygon"] = polygon_json(*room.polygon);
  if (room.width) json["width"] = range_json(*room.width);
  if (room.depth) json["depth"] = range_json(*room.depth);
  if (room.area) json["area"] = range_json(*room.area);
  if (room.height) json["height"] = *room.height;
  if (room.openings) json["openings"] = openings_json(*room.openings);
  return json;
}

template <typename Named>
Json named_json(const Named& named) {
  Json json = Json::object();
  for (const auto& [name, value] : named) json[name] = to_json(value);
  return json;
}

}  // namespace

Json to_json(const ProgramSet& set) {
  switch (set.source) {
    case Source::named: return set.name;
    case Source::variable: return "$" + set.name;
    case Source::described: return description_json(set);
    case Source::united: return {{"union", sets_json(set.from)}};
    default: return given_sets[static_cast<std::size_t>(set.source)];
  }
}

Json to_json(const ProgramTerm& term) {
  if (term.op == ProgramOp::constant) return term.number;
  if (term.op == ProgramOp::parameter) return "@" + term.name;
  const auto& form = form_of(term.op);
  Json json = Json::array({form.name});
  OperandWriter writer(term);
  std::size_t place = 0;
  for (const char c : form.operands)
    if (c != '+') writer.write(operand_at(form, place++), json);
  while (form.operands.back() == '+' && !writer.done()) writer.write(operand_at(form, place++), json);
  return json;
}

Json to_json(const ConstraintProgram& program) {
  Json json;
  json["format"] = "roomgen-program";
  json["version"] = 1;
  if (!program.prompt.empty()) json["prompt"] = program.prompt;
  if (program.seed != 0) json["seed"] = program.seed;
  json["room"] = room_json(program.room);
  for (const auto& [name, parameter] : program.parameters) json["params"][name] = parameter_json(parameter);
  for (const auto& [name, put_up] : program.relations) json["relations"][name] = put_up_json(put_up);
  json["sets"] = named_json(program.sets);
  json["constraints"] = named_json(program.constraints);
  json["scores"] = named_json(program.scores);
  return json;
}

}  // namespace roomgen::lab
