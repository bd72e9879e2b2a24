#include "roomgen/scene/requirement.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "base/json_reader.h"
#include "document_parts.h"
#include "relation_named.h"

namespace roomgen {

namespace {

template <typename T>
using Names = std::span<const std::pair<T, std::string_view>>;

constexpr std::pair<Requirement::Kind, std::string_view> kinds[] = {
    {Requirement::Kind::count, "count"},
    {Requirement::Kind::attribute, "attribute"},
    {Requirement::Kind::relation, "relation"},
    {Requirement::Kind::absence, "absence"},
    {Requirement::Kind::room, "room"},
    {Requirement::Kind::each, "each"},
    {Requirement::Kind::only, "only"}};
constexpr std::pair<Requirement::Source, std::string_view> sources[] = {
    {Requirement::Source::prompt, "prompt"},
    {Requirement::Source::model, "model"},
    {Requirement::Source::edit, "edit"},
    {Requirement::Source::person, "person"},
    {Requirement::Source::activity, "activity"}};
constexpr std::pair<Compliance, std::string_view> compliances[] = {
    {Compliance::met, "met"},
    {Compliance::not_met, "not met"},
    {Compliance::not_judged, "cannot be judged"},
    {Compliance::withdrawn, "withdrawn"}};

template <typename T>
std::string_view name_in(Names<T> names, T wanted) {
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const auto& entry) { return entry.first == wanted; });
  return found == names.end() ? names.front().second : found->second;
}

template <typename T>
T read_name(const JsonReader& json, Names<T> names) {
  const std::string text = json.text(50);
  for (const auto& [value, name] : names)
    if (text == name) return value;
  std::string known;
  for (const auto& [value, name] : names) known += (known.empty() ? "" : ", ") + std::string(name);
  json.report("\"" + text + "\" is none of " + known);
  return names.front().first;
}

constexpr std::size_t max_ids = 500;
constexpr int max_count = 10000;
constexpr std::string_view image = "image ";
constexpr int most_images = 9;

std::string source_text(const Requirement& requirement) {
  if (requirement.picture == 0) return std::string(name(requirement.source));
  return std::string(image) + std::to_string(requirement.picture);
}

void read_source(const JsonReader& json, Requirement& requirement) {
  const std::string text = json.text(50);
  for (int k = 1; k <= most_images; ++k)
    if (text == std::string(image) + std::to_string(k)) requirement.picture = k;
  if (requirement.picture == 0) requirement.source = read_name<Requirement::Source>(json, sources);
}

std::vector<std::string> read_ids(const JsonReader& json) {
  std::vector<std::string> ids;
  for (const auto& element : json.elements_or_none(max_ids)) ids.push_back(element.text(200));
  return ids;
}

Requirement read_members(const JsonReader& json) {
  Requirement requirement;
  requirement.id = json["id"].text_or("", 200);
  requirement.clause = json["clause"].text_or("");
  requirement.kind = read_name<Requirement::Kind>(json["kind"], kinds);
  if (json["source"].exists()) read_source(json["source"], requirement);
  requirement.category = json["category"].text_or("", 200);
  requirement.subjects = read_ids(json["subjects"]);
  requirement.count = static_cast<int>(json["count"].integer_or(1, 0, max_count));
  requirement.most = static_cast<int>(json["most"].integer_or(0, 0, max_count));
  requirement.at_least = json["at_least"].boolean_or(false);
  requirement.at_most = json["at_most"].boolean_or(false);
  requirement.denied = json["denied"].boolean_or(false);
  requirement.attribute = json["attribute"].text_or("", 200);
  requirement.amount = json["amount"].number_or(0.0, 0.0, 1e6);
  if (requirement.kind == Requirement::Kind::relation || requirement.kind == Requirement::Kind::each)
    requirement.relation = read_relation(json["relation"]).value_or(RelationKind::near);
  requirement.targets = read_ids(json["targets"]);
  requirement.room = json["room"].text_or("", 200);
  return requirement;
}

}  // namespace

std::optional<RelationKind> read_relation(const JsonReader& json) {
  const std::string text = json.text(100);
  const auto kind = relation_named(text);
  if (!kind) json.report("\"" + text + "\" is no relation");
  return kind;
}

std::string_view name(Requirement::Kind kind) {
  return name_in<Requirement::Kind>(kinds, kind);
}

std::string_view name(Requirement::Source source) {
  return name_in<Requirement::Source>(sources, source);
}

std::string told(const Requirement& requirement) {
  return requirement.clause + (requirement.picture > 0 ? " (" + source_text(requirement) + ")" : "");
}

std::string told(const RequirementVerdict& verdict) {
  const Requirement& requirement = verdict.requirement;
  return requirement.id + ": " + told(requirement) + ": " + std::string(name(verdict.compliance)) +
         (verdict.reason.empty() || verdict.met() ? "" : ", " + verdict.reason);
}

std::string_view name(Compliance compliance) {
  return name_in<Compliance>(compliances, compliance);
}

namespace {

void write_limits(const Requirement& requirement, Json& json) {
  if (requirement.most > 0) json["most"] = requirement.most;
  if (requirement.at_least) json["at_least"] = true;
  if (requirement.at_most) json["at_most"] = true;
}

}  // namespace

Json to_json(const Requirement& requirement) {
  Json json;
  if (!requirement.id.empty()) json["id"] = requirement.id;
  json["clause"] = requirement.clause;
  json["kind"] = name(requirement.kind);
  json["source"] = source_text(requirement);
  json["category"] = requirement.category;
  switch (requirement.kind) {
    case Requirement::Kind::count:
      json["count"] = requirement.count;
      if (!requirement.attribute.empty()) json["attribute"] = requirement.attribute;
      write_limits(requirement, json);
      break;
    case Requirement::Kind::attribute:
      json["attribute"] = requirement.attribute;
      if (requirement.count != 1) json["count"] = requirement.count;
      if (requirement.amount > 0.0) json["amount"] = rounded(requirement.amount);
      write_limits(requirement, json);
      break;
    case Requirement::Kind::relation:
      json["relation"] = name(requirement.relation);
      if (requirement.relation == RelationKind::gap) json["amount"] = rounded(requirement.amount), write_limits(requirement, json);
      if (requirement.denied) json["denied"] = true;
      if (!requirement.targets.empty()) json["targets"] = requirement.targets;
      break;
    case Requirement::Kind::each:
      json["count"] = requirement.count;
      json["relation"] = name(requirement.relation);
      json["targets"] = requirement.targets;
      break;
    case Requirement::Kind::only:
      if (!requirement.attribute.empty()) json["attribute"] = requirement.attribute;
      if (!requirement.targets.empty()) json["targets"] = requirement.targets;
      break;
    case Requirement::Kind::room:
      json["attribute"] = requirement.attribute;
      json["amount"] = rounded(requirement.amount);
      write_limits(requirement, json);
      break;
    case Requirement::Kind::absence:
      if (!requirement.attribute.empty()) json["attribute"] = requirement.attribute;
      break;
  }
  if (!requirement.subjects.empty()) json["subjects"] = requirement.subjects;
  if (!requirement.room.empty()) json["room"] = requirement.room;
  return json;
}

Json to_json(const RequirementVerdict& verdict) {
  Json json = to_json(verdict.requirement);
  json["verdict"] = name(verdict.compliance);
  json["met"] = verdict.met();
  if (!verdict.reason.empty()) json["reason"] = verdict.reason;
  return json;
}

Requirement read_requirement(const JsonReader& json) {
  json.allow_only({"id", "clause", "kind", "source", "category", "subjects", "count", "most",
                   "at_least", "at_most", "denied", "attribute", "amount", "relation", "targets", "room"});
  return read_members(json);
}

RequirementVerdict read_verdict(const JsonReader& json) {
  json.allow_only({"id", "clause", "kind", "source", "category", "subjects", "count", "most",
                   "at_least", "at_most", "denied", "attribute", "amount", "relation", "targets", "room", "verdict", "met",
                   "reason"});
  RequirementVerdict verdict;
  verdict.requirement = read_members(json);
  if (json["verdict"].exists())
    verdict.compliance = read_name<Compliance>(json["verdict"], compliances);
  else
    verdict.compliance = json["met"].boolean_or(false) ? Compliance::met : Compliance::not_met;
  verdict.reason = json["reason"].text_or("");
  return verdict;
}

}  // namespace roomgen
