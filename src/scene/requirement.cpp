#include "roomgen/scene/requirement.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "base/json_reader.h"
#include "document_parts.h"
#include "roomgen/base/json.h"

namespace roomgen {

namespace {

constexpr std::pair<Requirement::Kind, std::string_view> kinds[] = {
    {Requirement::Kind::count, "count"},
    {Requirement::Kind::attribute, "attribute"},
    {Requirement::Kind::relation, "relation"},
    {Requirement::Kind::absence, "absence"}};

constexpr std::size_t max_ids = 500;
constexpr int max_count = 10000;

std::vector<std::string> read_ids(const JsonReader& json) {
  std::vector<std::string> ids;
  for (const auto& element : json.elements_or_none(max_ids)) ids.push_back(element.text(200));
  return ids;
}

RelationKind read_relation(const JsonReader& json) {
  const std::string text = json.text(100);
  for (const auto& spelling : relation_spellings())
    if (spelling.text == text) return spelling.kind;
  json.report("\"" + text + "\" is no relation");
  return RelationKind::near;
}

Requirement read_members(const JsonReader& json) {
  Requirement requirement;
  requirement.clause = json["clause"].text_or("");
  const std::string kind = json["kind"].text(50);
  bool known = false;
  for (const auto& [value, text] : kinds)
    if (kind == text) requirement.kind = value, known = true;
  if (!known) json["kind"].report("\"" + kind + "\" is none of count, attribute, relation, absence");
  requirement.category = json["category"].text_or("", 200);
  requirement.subjects = read_ids(json["subjects"]);
  requirement.count = static_cast<int>(json["count"].integer_or(1, 0, max_count));
  requirement.at_least = json["at_least"].boolean_or(false);
  requirement.attribute = json["attribute"].text_or("", 200);
  if (requirement.kind == Requirement::Kind::relation)
    requirement.relation = read_relation(json["relation"]);
  requirement.targets = read_ids(json["targets"]);
  requirement.room = json["room"].text_or("", 200);
  return requirement;
}

}  // namespace

std::string_view name(Requirement::Kind kind) {
  for (const auto& [value, text] : kinds)
    if (value == kind) return text;
  return kinds[0].second;
}

Json to_json(const Requirement& requirement) {
  Json json;
  json["clause"] = requirement.clause;
  json["kind"] = name(requirement.kind);
  json["category"] = requirement.category;
  switch (requirement.kind) {
    case Requirement::Kind::count:
      json["count"] = requirement.count;
      if (requirement.at_least) json["at_least"] = true;
      break;
    case Requirement::Kind::attribute:
      json["attribute"] = requirement.attribute;
      break;
    case Requirement::Kind::relation:
      json["relation"] = name(requirement.relation);
      if (!requirement.targets.empty()) json["targets"] = requirement.targets;
      break;
    case Requirement::Kind::absence:
      break;
  }
  if (!requirement.subjects.empty()) json["subjects"] = requirement.subjects;
  if (!requirement.room.empty()) json["room"] = requirement.room;
  return json;
}

Json to_json(const RequirementVerdict& verdict) {
  Json json = to_json(verdict.requirement);
  json["met"] = verdict.met;
  if (!verdict.reason.empty()) json["reason"] = verdict.reason;
  return json;
}

Requirement read_requirement(const JsonReader& json) {
  json.allow_only({"clause", "kind", "category", "subjects", "count", "at_least", "attribute",
                   "relation", "targets", "room"});
  return read_members(json);
}

RequirementVerdict read_verdict(const JsonReader& json) {
  json.allow_only({"clause", "kind", "category", "subjects", "count", "at_least", "attribute",
                   "relation", "targets", "room", "met", "reason"});
  RequirementVerdict verdict;
  verdict.requirement = read_members(json);
  verdict.met = json["met"].boolean_or(false);
  verdict.reason = json["reason"].text_or("");
  return verdict;
}

}  // namespace roomgen
