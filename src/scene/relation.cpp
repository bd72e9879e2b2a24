#include "relation_named.h"

#include <algorithm>
#include <array>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

// The first spelling of each kind is its name.
constexpr std::array vocabulary = {
    RelationSpelling{"edge", RelationKind::edge},
    RelationSpelling{"middle", RelationKind::middle},
    RelationSpelling{"corner", RelationKind::corner},
    RelationSpelling{"in part", RelationKind::in_part},
    RelationSpelling{"near", RelationKind::near},
    RelationSpelling{"next to", RelationKind::next_to},
    RelationSpelling{"far", RelationKind::far},
    RelationSpelling{"in front of", RelationKind::in_front_of},
    RelationSpelling{"behind", RelationKind::behind},
    RelationSpelling{"left of", RelationKind::left_of},
    RelationSpelling{"right of", RelationKind::right_of},
    RelationSpelling{"side of", RelationKind::side_of},
    RelationSpelling{"around", RelationKind::around},
    RelationSpelling{"between", RelationKind::between},
    RelationSpelling{"center aligned", RelationKind::center_aligned},
    RelationSpelling{"aligned", RelationKind::aligned},
    RelationSpelling{"face to", RelationKind::face_to},
    RelationSpelling{"face same as", RelationKind::face_same_as},
    RelationSpelling{"face opposite to", RelationKind::face_opposite_to},
    RelationSpelling{"on", RelationKind::on},
    RelationSpelling{"inside", RelationKind::inside},
    RelationSpelling{"above", RelationKind::above},
    RelationSpelling{"under", RelationKind::under},
    RelationSpelling{"hang from", RelationKind::hang_from},
    // Other spellings.
    RelationSpelling{"against wall", RelationKind::edge},
    RelationSpelling{"center", RelationKind::middle},
    RelationSpelling{"close to", RelationKind::near},
    RelationSpelling{"far from", RelationKind::far},
    RelationSpelling{"to the left of", RelationKind::left_of},
    RelationSpelling{"to the right of", RelationKind::right_of},
    RelationSpelling{"beside", RelationKind::side_of},
    RelationSpelling{"center align with", RelationKind::center_aligned},
    RelationSpelling{"center aligned with", RelationKind::center_aligned},
    RelationSpelling{"centre aligned", RelationKind::center_aligned},
    RelationSpelling{"centre aligned with", RelationKind::center_aligned},
    RelationSpelling{"centre align with", RelationKind::center_aligned},
    RelationSpelling{"aligned with", RelationKind::aligned},
    RelationSpelling{"facing", RelationKind::face_to},
    RelationSpelling{"face", RelationKind::face_to},
    RelationSpelling{"on top of", RelationKind::on},
    RelationSpelling{"within", RelationKind::inside},
    RelationSpelling{"below", RelationKind::under},
};

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
  return vocabulary;
}

std::optional<RelationKind> relation_named(std::string_view text) {
  const auto found = std::find_if(vocabulary.begin(), vocabulary.end(),
                                  [&](const RelationSpelling& word) { return word.text == text; });
  if (found == vocabulary.end()) return std::nullopt;
  return found->kind;
}

std::string_view name(RelationKind kind) {
  for (const auto& word : vocabulary)
    if (word.kind == kind) return word.text;
  return "";
}

bool takes_target(RelationKind kind) {
  return kind != RelationKind::edge && kind != RelationKind::middle &&
         kind != RelationKind::corner;
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
    for (const auto& entry : vocabulary) known.emplace_back(entry.text);
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
