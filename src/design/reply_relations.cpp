#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "chat/loose_json.h"
#include "place_answers.h"
#include "reply_words.h"
#include "roomgen/base/text.h"
#include "scene/room_part.h"

namespace roomgen::design {

namespace {

constexpr std::size_t max_relations = 12;
constexpr std::size_t max_pieces = 64;
constexpr std::size_t max_piece = 400;  ///< bytes
constexpr std::size_t least_misspelt = 4;

// How models say it beside the spellings that files may use, without articles. Longer phrases win.
constexpr std::array synonyms = {
    RelationSpelling{"against one wall", RelationKind::edge},
    RelationSpelling{"against", RelationKind::edge},
    RelationSpelling{"along wall", RelationKind::edge},
    RelationSpelling{"at wall", RelationKind::edge},
    RelationSpelling{"on wall", RelationKind::edge},
    RelationSpelling{"at edge", RelationKind::edge},
    RelationSpelling{"on edge", RelationKind::edge},
    RelationSpelling{"edge of room", RelationKind::edge},
    RelationSpelling{"at edge of room", RelationKind::edge},
    RelationSpelling{"room edge", RelationKind::edge},
    RelationSpelling{"back to wall", RelationKind::edge},
    RelationSpelling{"wall aligned", RelationKind::edge},
    RelationSpelling{"centre", RelationKind::middle},
    RelationSpelling{"in middle", RelationKind::middle},
    RelationSpelling{"in center", RelationKind::middle},
    RelationSpelling{"in centre", RelationKind::middle},
    RelationSpelling{"middle of room", RelationKind::middle},
    RelationSpelling{"center of room", RelationKind::middle},
    RelationSpelling{"centre of room", RelationKind::middle},
    RelationSpelling{"in middle of room", RelationKind::middle},
    RelationSpelling{"in center of room", RelationKind::middle},
    RelationSpelling{"in centre of room", RelationKind::middle},
    RelationSpelling{"in corner", RelationKind::corner},
    RelationSpelling{"at corner", RelationKind::corner},
    RelationSpelling{"corner of room", RelationKind::corner},
    RelationSpelling{"in corner of room", RelationKind::corner},
    RelationSpelling{"near to", RelationKind::near},
    RelationSpelling{"close", RelationKind::near},
    RelationSpelling{"adjacent to", RelationKind::near},
    RelationSpelling{"adjacent", RelationKind::near},
    RelationSpelling{"nearby", RelationKind::near},
    RelationSpelling{"by", RelationKind::near},
    RelationSpelling{"far away from", RelationKind::far},
    RelationSpelling{"away from", RelationKind::far},
    RelationSpelling{"in front", RelationKind::in_front_of},
    RelationSpelling{"front of", RelationKind::in_front_of},
    RelationSpelling{"before", RelationKind::in_front_of},
    RelationSpelling{"in back of", RelationKind::behind},
    RelationSpelling{"left", RelationKind::left_of},
    RelationSpelling{"to left of", RelationKind::left_of},
    RelationSpelling{"on left of", RelationKind::left_of},
    RelationSpelling{"left side of", RelationKind::left_of},
    RelationSpelling{"on left side of", RelationKind::left_of},
    RelationSpelling{"right", RelationKind::right_of},
    RelationSpelling{"to right of", RelationKind::right_of},
    RelationSpelling{"on right of", RelationKind::right_of},
    RelationSpelling{"right side of", RelationKind::right_of},
    RelationSpelling{"on right side of", RelationKind::right_of},
    RelationSpelling{"at side of", RelationKind::side_of},
    RelationSpelling{"by side of", RelationKind::side_of},
    RelationSpelling{"side", RelationKind::side_of},
    RelationSpelling{"surrounding", RelationKind::around},
    RelationSpelling{"center align", RelationKind::center_aligned},
    RelationSpelling{"centre align", RelationKind::center_aligned},
    RelationSpelling{"centered on", RelationKind::center_aligned},
    RelationSpelling{"centered with", RelationKind::center_aligned},
    RelationSpelling{"align", RelationKind::aligned},
    RelationSpelling{"align with", RelationKind::aligned},
    RelationSpelling{"aligned to", RelationKind::aligned},
    RelationSpelling{"faces", RelationKind::face_to},
    RelationSpelling{"facing to", RelationKind::face_to},
    RelationSpelling{"facing towards", RelationKind::face_to},
    RelationSpelling{"face towards", RelationKind::face_to},
    RelationSpelling{"face toward", RelationKind::face_to},
    RelationSpelling{"towards", RelationKind::face_to},
    RelationSpelling{"facing same as", RelationKind::face_same_as},
    RelationSpelling{"face same direction as", RelationKind::face_same_as},
    RelationSpelling{"same direction as", RelationKind::face_same_as},
    RelationSpelling{"face opposite", RelationKind::face_opposite_to},
    RelationSpelling{"facing opposite to", RelationKind::face_opposite_to},
    RelationSpelling{"on top", RelationKind::on},
    RelationSpelling{"over", RelationKind::above},
    RelationSpelling{"beneath", RelationKind::under},
    RelationSpelling{"underneath", RelationKind::under},
    RelationSpelling{"hanging from", RelationKind::hang_from},
    RelationSpelling{"hung from", RelationKind::hang_from},
};

constexpr std::array relation_fillers = {"the", "a",          "an",       "place",     "placed",
                                         "put", "must",       "should",   "be",        "is",
                                         "it",  "constraint", "position", "positioned"};
constexpr std::array connectors = {"to", "of", "with", "from", "at", "target"};

const std::vector<RelationSpelling>& phrases() {
  static const std::vector<RelationSpelling> all = [] {
    const auto spellings = relation_spellings();
    std::vector<RelationSpelling> result(spellings.begin(), spellings.end());
    result.insert(result.end(), synonyms.begin(), synonyms.end());
    return result;
  }();
  return all;
}

using Pieces = std::vector<std::string>;

std::string spoken(const Pieces& words, std::size_t begin, std::size_t end) {
  return join(Pieces(words.begin() + static_cast<std::ptrdiff_t>(begin),
                     words.begin() + static_cast<std::ptrdiff_t>(end)),
              " ");
}

struct KindWords {
  RelationKind kind;
  std::size_t length;  ///< words
  bool misspelt = false;
};

constexpr std::size_t longest_phrase = 5;

std::optional<KindWords> leading_kind(const Pieces& words) {
  for (std::size_t n = std::min(longest_phrase, words.size()); n > 0; --n) {
    const std::string text = spoken(words, 0, n);
    for (const auto& phrase : phrases())
      if (phrase.text == text) return KindWords{phrase.kind, n};
  }
  return std::nullopt;
}

std::optional<KindWords> misspelt_kind(const Pieces& words) {
  std::vector<std::string> known;
  for (const auto& phrase : phrases()) known.emplace_back(phrase.text);
  for (std::size_t n = std::min(longest_phrase, words.size()); n > 0; --n) {
    const std::string text = spoken(words, 0, n);
    if (text.size() < least_misspelt) continue;
    const std::string close = closest_name(text, known);
    for (const auto& phrase : phrases())
      if (!close.empty() && phrase.text == close) return KindWords{phrase.kind, n, true};
  }
  return std::nullopt;
}

/// Reads segments ("near", "bed-0", "left of the bed-0") one after the other: names of constraints
/// and their targets.
class RelationReader {
 public:
  RelationReader(const TargetNames& targets, ReplyNotes& notes)
      : targets_(targets), notes_(notes) {}

  /// "near, bed-0": what stands between two bars.
  void read(std::string_view piece) {
    if (!waiting_) state_ = State::none;
    if (read_gap(piece.substr(0, max_piece))) return;
    std::string text(piece.substr(0, max_piece));
    for (char& c : text)
      if (std::string_view(":()=[]").find(c) != std::string_view::npos) c = ',';
    for (const auto& part : split(text, ','))
      for (const auto& segment : split_at_and(part)) read_segment(segment);
  }

  std::vector<Relation> take() {
    end_waiting();
    return std::move(relations_);
  }

 private:
  enum class State { none, kind, unknown };

  // "gap 0.8 m, bed-0"
  bool read_gap(std::string_view piece) {
    auto relation = parse_relation(piece);
    if (!relation || relation->kind != RelationKind::gap) return false;
    end_waiting();
    const NamedTarget target = relation->target == nearest_wall ? NamedTarget{relation->target, ""} : targets_.find(relation->target);
    if (target.id.empty()) {
      notes_.lose("\"" + to_text(*relation) + "\" was dropped: " + target.repair);
      return true;
    }
    if (!target.repair.empty()) notes_.repair(target.repair);
    relation->target = target.id;
    add_relation(relations_, *relation, notes_);
    return true;
  }

  static Pieces split_at_and(std::string_view part) {
    Pieces result;
    for (auto at = part.find(" and "); at != std::string_view::npos; at = part.find(" and ")) {
      result.emplace_back(part.substr(0, at));
      part.remove_prefix(at + 5);
    }
    result.emplace_back(part);
    return result;
  }

  // Without articles, numbers of lists and the name of the object in front.
  Pieces meaningful(const std::string& segment) const {
    Pieces all = words(segment);
    for (std::size_t n = 1; n <= all.size(); ++n)
      if (targets_.is_self({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n)})) {
        // Alone it may be a target that must be refused.
        if (n == all.size() && waiting_) return all;
        all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
        break;
      }
    const auto is_digit_word = [](const std::string& word) {
      return word.find_first_not_of("0123456789") == std::string::npos;
    };
    if (all.size() > 1 && is_digit_word(all.front())) all.erase(all.begin());
    while (!all.empty() && is_one_of(all.front(), relation_fillers)) all.erase(all.begin());
    std::erase_if(
        all, [](const std::string& word) { return word == "the" || word == "a" || word == "an"; });
    return all;
  }

  void read_segment(const std::string& segment) {
    const Pieces pieces = meaningful(segment);
    if (pieces.empty()) return;
    if (waiting_ && !targets_.spelt(pieces).empty()) return read_target(segment, pieces);
    if (const auto kind = leading_kind(pieces)) return read_kind(*kind, segment, pieces);
    if (state_ == State::unknown) return;
    if (state_ == State::kind) return read_target(segment, pieces);
    if (const auto kind = misspelt_kind(pieces)) return read_kind(*kind, segment, pieces);
    notes_.lose("the unknown constraint \"" + segment + "\" was dropped");
    state_ = State::unknown;
  }

  void read_kind(const KindWords& found, const std::string& segment, const Pieces& pieces) {
    end_waiting();
    kind_ = found.kind;
    state_ = State::kind;
    const std::string given = spoken(pieces, 0, found.length);
    if (found.misspelt || given != name(kind_))
      notes_.repair("\"" + given + "\" was read as \"" + std::string(name(kind_)) + "\"");
    waiting_ = takes_target(kind_);
    if (!waiting_) add_relation(relations_, {kind_, ""}, notes_);
    std::size_t rest = found.length;
    while (rest < pieces.size() && is_one_of(pieces[rest], connectors)) ++rest;
    if (rest == pieces.size()) return;
    read_target(segment, {pieces.begin() + static_cast<std::ptrdiff_t>(rest), pieces.end()});
  }

  void read_target(const std::string& segment, const Pieces& pieces) {
    if (!takes_target(kind_)) return read_needless_target(pieces);
    waiting_ = false;
    // As it was written if nothing else was: then the id needs no note.
    const bool alone = words(segment) == pieces;
    const NamedTarget target =
        targets_.find(alone ? std::string_view(segment) : std::string_view(join(pieces, " ")));
    if (target.id.empty()) {
      notes_.lose("\"" + std::string(name(kind_)) + "\" was dropped: " + target.repair);
      return;
    }
    if (!target.repair.empty() && (alone || words(target.id) != pieces))
      notes_.repair(target.repair);
    add_relation(relations_, {kind_, target.id}, notes_);
  }

  // "against, wall-3" names the wall.
  void read_needless_target(const Pieces& pieces) {
    const std::string id = targets_.spelt(pieces);
    const std::string said = "\"" + std::string(name(kind_)) + "\" takes no target; \"";
    if (kind_ == RelationKind::edge && id.starts_with("wall-")) {
      notes_.repair(said + id + "\" was read as \"next to, " + id + "\"");
      add_relation(relations_, {RelationKind::next_to, id}, notes_);
    } else {
      notes_.lose(said + join(pieces, " ") + "\" was dropped");
    }
  }

  void end_waiting() {
    if (waiting_)
      notes_.lose("\"" + std::string(name(kind_)) + "\" was dropped: it has no target");
    waiting_ = false;
  }

  const TargetNames& targets_;
  ReplyNotes& notes_;
  std::vector<Relation> relations_;
  State state_ = State::none;
  RelationKind kind_ = RelationKind::edge;
  bool waiting_ = false;  ///< for a target of kind_
};

std::string plain_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return value.dump();
  return "";
}

// The texts of a value and its elements, with commas between them.
std::string comma_text(const Json& value) {
  if (!value.is_array()) return plain_text(value);
  Pieces texts;
  for (const auto& element : value)
    if (texts.size() < max_pieces) texts.push_back(plain_text(element));
  return join(texts, ", ");
}

const std::vector<std::string> relation_type_keys = {"type", "constraint", "relation", "kind", "name"};
const std::vector<std::string> target_keys = {"target", "targets", "object",          "reference",
                                              "to",     "anchor",  "reference object"};

Pieces pieces_of_object(const Json& value) {
  if (const Json* type = member(value, relation_type_keys)) {
    const Json* target = member(value, target_keys);
    return {plain_text(*type) + (target ? ", " + comma_text(*target) : "")};
  }
  Pieces pieces;
  for (const auto& [key, element] : value.items()) {
    const bool denied = element.is_null() || (element.is_boolean() && !element.get<bool>());
    if (!denied) pieces.push_back(key + ", " + comma_text(element));
  }
  return pieces;
}

Pieces pieces_of_text(const std::string& text) {
  std::string bars = text;
  for (char& c : bars)
    if (c == '\n' || c == ';' || c == '&') c = '|';
  return split(bars, '|');
}

Pieces pieces_of(const Json& value) {
  if (value.is_object()) return pieces_of_object(value);
  if (!value.is_array()) return pieces_of_text(plain_text(value));
  Pieces pieces;
  for (const auto& element : value) {
    if (pieces.size() >= max_pieces) break;
    const Pieces more = element.is_object()  ? pieces_of_object(element)
                        : element.is_array() ? Pieces{comma_text(element)}
                                             : pieces_of_text(plain_text(element));
    pieces.insert(pieces.end(), more.begin(), more.end());
  }
  return pieces;
}

bool is_at_wall(RelationKind kind) {
  return kind == RelationKind::edge || kind == RelationKind::corner;
}

bool contradict(RelationKind a, RelationKind b) {
  return (a == RelationKind::middle && is_at_wall(b)) ||
         (b == RelationKind::middle && is_at_wall(a));
}

}  // namespace

void add_relation(std::vector<Relation>& relations, const Relation& relation,
                  ReplyNotes& notes) {
  if (std::find(relations.begin(), relations.end(), relation) != relations.end()) {
    notes.repair("\"" + to_text(relation) + "\" was said twice");
    return;
  }
  for (const auto& other : relations)
    if (contradict(other.kind, relation.kind)) {
      notes.lose("\"" + to_text(relation) + "\" was dropped: it contradicts \"" +
                        to_text(other) + "\"");
      return;
    }
  if (relations.size() >= max_relations) {
    notes.lose("\"" + to_text(relation) + "\" was dropped: only the first " +
                      std::to_string(max_relations) + " constraints are kept");
    return;
  }
  relations.push_back(relation);
}

std::vector<Relation> read_reply_relations(const Json& value, const TargetNames& targets,
                                           ReplyNotes& notes) {
  RelationReader reader(targets, notes);
  Pieces pieces = pieces_of(value);
  if (pieces.size() > max_pieces) {
    pieces.resize(max_pieces);
    notes.repair("only the first " + std::to_string(max_pieces) +
                         " constraints were looked at");
  }
  for (const auto& piece : pieces) reader.read(piece);
  return reader.take();
}

}  // namespace roomgen::design
