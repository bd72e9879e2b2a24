#include "relation_named.h"

#include <algorithm>

#include "relation_table.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

// The names first, then other spellings.
const std::vector<RelationSpelling>& vocabulary() {
  static const std::vector<RelationSpelling> all = [] {
    std::vector<RelationSpelling> names, others;
    for (const auto& relation : relation_definitions())
      for (const auto spelling : relation.spellings)
        if (!spelling.empty())
          (spelling == relation.name() ? names : others).push_back({spelling, relation.kind});
    names.insert(names.end(), others.begin(), others.end());
    return names;
  }();
  return all;
}

Error relation_error(const std::string& what) {
  return {Error::Kind::invalid_input, what};
}

std::string with_single_spaces(std::string_view text) {
  std::string result;
  for (const char c : trim(text)) {
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!space) result += c;
    else if (result.back() != ' ') result += ' ';
  }
  return result;
}

}  // namespace

std::span<const RelationSpelling> relation_spellings() {
  return vocabulary();
}

std::optional<RelationKind> relation_named(std::string_view text) {
  for (const auto& word : vocabulary())
    if (word.text == text) return word.kind;
  return std::nullopt;
}

std::string_view name(RelationKind kind) {
  return definition(kind).name();
}

bool takes_target(RelationKind kind) {
  return definition(kind).has(RelationDefinition::targeted);
}

std::string to_text(const Relation& relation) {
  std::string text(name(relation.kind));
  return relation.target.empty() ? text : text + ", " + relation.target;
}

std::string to_text(const std::vector<Relation>& relations) {
  std::vector<std::string> pieces;
  for (const auto& relation : relations) pieces.push_back(to_text(relation));
  return join(pieces, " | ");
}

Result<Relation> parse_relation(std::string_view text) {
  const std::string low = lower(text);
  const auto comma = low.find(',');
  const std::string word = with_single_spaces(low.substr(0, comma));
  const std::string target(comma == std::string::npos ? "" : trim(low.substr(comma + 1)));

  const auto kind = relation_named(word);
  if (!kind) {
    std::vector<std::string> known;
    for (const auto& entry : vocabulary()) known.emplace_back(entry.text);
    const std::string close = closest_name(word, known);
    return relation_error("unknown constraint \"" + word + "\"" +
                          (close.empty() ? "" : "; did you mean \"" + close + "\"?"));
  }
  if (takes_target(*kind) && target.empty())
    return relation_error("\"" + word + "\" needs a target, as in \"" + word + ", bed-0\"");
  if (!takes_target(*kind) && !target.empty())
    return relation_error("\"" + word + "\" takes no target, but has \"" + target + "\"");
  return Relation{*kind, target};
}

Result<std::vector<Relation>> parse_relations(std::string_view text) {
  std::vector<Relation> relations;
  for (const auto& piece : split(text, '|')) {
    if (piece.empty()) continue;
    auto relation = parse_relation(piece);
    if (!relation) return relation.error();
    if (std::find(relations.begin(), relations.end(), *relation) == relations.end())
      relations.push_back(*std::move(relation));
  }
  return relations;
}

}  // namespace roomgen
