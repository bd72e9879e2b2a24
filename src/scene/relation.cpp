#include "roomgen/scene/relation.h"

#include <algorithm>
#include <array>
#include <optional>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

struct Word {
  std::string_view text;
  RelationKind kind;
};

// The first spelling of each kind is its name.
constexpr std::array vocabulary = {
    Word{"edge", RelationKind::edge},
    Word{"middle", RelationKind::middle},
    Word{"corner", RelationKind::corner},
    Word{"near", RelationKind::near},
    Word{"far", RelationKind::far},
    Word{"in front of", RelationKind::in_front_of},
    Word{"behind", RelationKind::behind},
    Word{"left of", RelationKind::left_of},
    Word{"right of", RelationKind::right_of},
    Word{"side of", RelationKind::side_of},
    Word{"around", RelationKind::around},
    Word{"center aligned", RelationKind::center_aligned},
    Word{"aligned", RelationKind::aligned},
    Word{"face to", RelationKind::face_to},
    Word{"face same as", RelationKind::face_same_as},
    Word{"face opposite to", RelationKind::face_opposite_to},
    Word{"on", RelationKind::on},
    Word{"above", RelationKind::above},
    Word{"under", RelationKind::under},
    Word{"hang from", RelationKind::hang_from},
    // Other spellings.
    Word{"against wall", RelationKind::edge},
    Word{"center", RelationKind::middle},
    Word{"close to", RelationKind::near},
    Word{"next to", RelationKind::near},
    Word{"far from", RelationKind::far},
    Word{"to the left of", RelationKind::left_of},
    Word{"to the right of", RelationKind::right_of},
    Word{"beside", RelationKind::side_of},
    Word{"center align with", RelationKind::center_aligned},
    Word{"center aligned with", RelationKind::center_aligned},
    Word{"centre aligned", RelationKind::center_aligned},
    Word{"centre aligned with", RelationKind::center_aligned},
    Word{"centre align with", RelationKind::center_aligned},
    Word{"aligned with", RelationKind::aligned},
    Word{"facing", RelationKind::face_to},
    Word{"face", RelationKind::face_to},
    Word{"on top of", RelationKind::on},
    Word{"below", RelationKind::under},
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

std::optional<RelationKind> find_kind(std::string_view text) {
  const auto found = std::find_if(vocabulary.begin(), vocabulary.end(),
                                  [&](const Word& word) { return word.text == text; });
  if (found == vocabulary.end()) return std::nullopt;
  return found->kind;
}

}  // namespace

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

  const auto kind = find_kind(word);
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
