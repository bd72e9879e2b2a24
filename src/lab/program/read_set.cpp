#include "read_set.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "names.h"

namespace roomgen::lab {

namespace {

using Source = ProgramSet::Source;

void read_set_name(const JsonReader& json, ProgramSet& set) {
  const std::string text = json.text(program_limits::name_bytes + 1);
  const auto given = std::find(given_sets.begin(), given_sets.end(), text);
  if (given != given_sets.end()) {
    set.source = static_cast<Source>(given - given_sets.begin());
    return;
  }
  const bool variable = text.starts_with('$');
  set.source = variable ? Source::variable : Source::named;
  set.name = variable ? text.substr(1) : text;
  if (!is_program_name(set.name)) json.report("\"" + text + "\" names no set");
}

void read_tags(const JsonReader& json, ProgramSet& set) {
  for (const auto& element : json.elements_or_none(program_limits::tags)) {
    const std::string tag = element.text(program_limits::name_bytes);
    if (tag.starts_with('-')) set.without.push_back(tag.substr(1));
    else set.tags.push_back(tag);
    if (tag.empty() || tag == "-") element.report("an empty tag");
  }
}

SetRelation read_set_relation(const JsonReader& json, ReadingBudget& budget, int depth) {
  SetRelation relation;
  const auto parts = json.elements(2);
  if (parts.size() != 2) {
    json.report("expected [\"relation\", SET], as in [\"on_floor\", \"room\"]");
    return relation;
  }
  const std::string text = parts[0].text(program_limits::name_bytes);
  relation.absent = text.starts_with('-');
  relation.relation = relation.absent ? text.substr(1) : text;
  relation.target.push_back(read_set(parts[1], budget, depth + 1));
  return relation;
}

void read_description(const JsonReader& json, ReadingBudget& budget, int depth, ProgramSet& set) {
  json.allow_only({"from", "tags", "factory", "rel"});
  set.source = Source::described;
  if (const auto from = json["from"]; from.exists()) set.from.push_back(read_set(from, budget, depth + 1));
  // All things are what a description describes anyway.
  if (!set.from.empty() && set.from[0].source == Source::objects) set.from.clear();
  read_tags(json["tags"], set);
  set.factory = json["factory"].text_or("", program_limits::name_bytes);
  for (const auto& element : json["rel"].elements_or_none(program_limits::set_relations))
    set.relations.push_back(read_set_relation(element, budget, depth));
}

void read_union(const JsonReader& json, ReadingBudget& budget, int depth, ProgramSet& set) {
  json.allow_only({"union"});
  set.source = Source::united;
  for (const auto& element : json["union"].elements(program_limits::operands))
    set.from.push_back(read_set(element, budget, depth + 1));
  if (set.from.empty()) json["union"].report("a union of no sets");
}

}  // namespace

bool ReadingBudget::admits(const JsonReader& json, int depth, int most_depth) {
  if (depth > most_depth) {
    json.report("nested more than " + std::to_string(most_depth) + " deep");
    return false;
  }
  if (left_ == 0) {
    json.report("more than " + std::to_string(program_limits::nodes) + " sets and terms");
    return false;
  }
  --left_;
  return true;
}

ProgramSet read_set(const JsonReader& json, ReadingBudget& budget, int depth) {
  ProgramSet set;
  set.at = json.pointer();
  if (!budget.admits(json, depth, program_limits::set_depth)) return set;
  if (json.is_string()) read_set_name(json, set);
  else if (!json.is_object())
    json.report("expected a set: its name, \"$variable\", \"objects\", \"room\", \"doors\", \"windows\" or "
                "{\"from\", \"tags\", \"factory\", \"rel\"}");
  else if (json["union"].exists()) read_union(json, budget, depth, set);
  else read_description(json, budget, depth, set);
  return set;
}

}  // namespace roomgen::lab
