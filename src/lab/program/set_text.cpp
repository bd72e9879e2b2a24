#include "roomgen/base/text.h"
#include "program_text.h"

namespace roomgen::lab {

namespace {

using Source = ProgramSet::Source;

std::string noun_of(const ProgramSet& set) {
  std::vector<std::string> words;
  for (const auto& tag : set.without) words.push_back("non-" + tag);
  words.insert(words.end(), set.tags.begin(), set.tags.end());
  if (!set.factory.empty()) words.push_back(set.factory);
  // What is said to be without something is said of things.
  if (!words.empty() && set.tags.empty() && set.factory.empty() && set.from.empty()) words.push_back("things");
  return join(words, " ");
}

std::string relation_text(const SetRelation& relation) {
  const std::string words = relation.relation == "any" ? "put up against" : relation.relation;
  return (relation.absent ? "not " : "") + words +
         (relation.target.empty() ? "" : " " + operand_text(relation.target[0]));
}

std::string described_text(const ProgramSet& set) {
  std::string text = noun_of(set);
  if (!set.from.empty()) text += (text.empty() ? "" : " of ") + operand_text(set.from[0]);
  if (text.empty()) text = "things";
  std::vector<std::string> relations;
  for (const auto& relation : set.relations) relations.push_back(relation_text(relation));
  return text + (relations.empty() ? "" : " " + join(relations, " and "));
}

std::string united_text(const ProgramSet& set) {
  std::vector<std::string> members;
  for (const auto& member : set.from) members.push_back(operand_text(member));
  return join(members, " or ");
}

}  // namespace

std::string to_text(const ProgramSet& set) {
  switch (set.source) {
    case Source::objects: return "things";
    case Source::room: return "the room";
    case Source::doors: return "doors";
    case Source::windows: return "windows";
    case Source::described: return described_text(set);
    case Source::united: return united_text(set);
    default: return set.name;
  }
}

std::string operand_text(const ProgramSet& set) {
  const bool several = set.source == Source::united ? set.from.size() > 1 : !set.relations.empty();
  return several ? "(" + to_text(set) + ")" : to_text(set);
}

}  // namespace roomgen::lab
