#include "relation_named.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

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

bool is_looking_at(RelationKind kind) {
  return kind == RelationKind::face_to || kind == RelationKind::used_facing;
}

std::string to_text(const Gap& gap) {
  const bool is_open = std::isinf(gap.most);
  const std::string bound = gap.least == gap.most ? "" : is_open ? "at least " : "at most ";
  return bound + format_number(is_open ? gap.least : gap.most) + " m";
}

std::string to_text(const Relation& relation) {
  std::string text(name(relation.kind));
  if (relation.kind == RelationKind::gap) text += " " + to_text(relation.gap);
  return relation.target.empty() ? text : text + ", " + relation.target;
}

std::string to_text(const std::vector<Relation>& relations) {
  std::vector<std::string> pieces;
  for (const auto& relation : relations) pieces.push_back(to_text(relation));
  return join(pieces, " | ");
}

namespace {

constexpr double most_metres = 1000.0;

// "0.5 m", "at least 1.5 m"
std::optional<Gap> parse_gap(std::string text) {
  const bool at_least = text.starts_with("at least "), at_most = text.starts_with("at most ");
  if (at_least) text.erase(0, 9);
  if (at_most) text.erase(0, 8);
  if (text.ends_with("m")) text.pop_back();
  double metres = 0.0;
  const std::string_view number = trim(text);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), metres);
  if (error != std::errc() || end != number.data() + number.size() || !(metres >= 0.0 && metres <= most_metres)) return std::nullopt;
  return Gap{at_most ? 0.0 : metres, at_least ? std::numeric_limits<double>::infinity() : metres};
}

}  // namespace

Result<Relation> parse_relation(std::string_view text) {
  const std::string low = lower(text);
  const auto comma = low.find(',');
  std::string word = with_single_spaces(low.substr(0, comma));
  const std::string gap_name(name(RelationKind::gap));
  Gap gap;
  if (word == gap_name || word.starts_with(gap_name + " ")) {
    const auto said = parse_gap(word.substr(std::min(word.size(), gap_name.size() + 1)));
    if (!said) return relation_error("\"" + word + "\" needs a length, as in \"gap 0.5 m, bed-0\" or \"gap at least 1 m, bed-0\"");
    gap = *said;
    word = gap_name;
  }
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
  return Relation{*kind, target, gap};
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
