#include <algorithm>

#include "floor_shapes.h"
#include "room_type.h"
#include "token_readers.h"

namespace roomgen::brief {

namespace {

constexpr std::size_t longest_shape_name = 3;
constexpr std::size_t ahead = 6;   ///< words between a shape and the room that has it
constexpr std::size_t behind = 4;  ///< and where the room comes first
constexpr std::size_t most_features = 6;

class ShapeReader {
 public:
  ShapeReader(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
              const RoomKinds& kinds, const FloorShapes& shapes, Brief& brief)
      : tokens_(tokens),
        words_(words),
        table_(table),
        rooms_(room_names(kinds)),
        shapes_(shapes),
        brief_(brief) {}

  void run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_[i].kind != Token::Kind::word) continue;
      read_feature(i);
      if (read_shape(i) && i > 0) --i;
    }
  }

 private:
  bool is_room(std::size_t i) const {
    const auto room = longest(rooms_, tokens_, i, 3);
    if (mention_at(table_, tokens_, i).length > std::max<std::size_t>(room.length, 1)) return false;
    return room || words_.generic_rooms.count(tokens_[i].text) ||
           words_.room_words.count(tokens_[i].text) || tokens_[i].is_word("plan") ||
           tokens_[i].is_word("layout") || tokens_[i].is_word("footprint");
  }

  // "long, narrow kitchen": the room before any thing.
  bool room_follows(std::size_t at) const {
    for (std::size_t i = at; i < tokens_.size() && i < at + ahead; ++i) {
      const Token& token = tokens_[i];
      if (token.kind == Token::Kind::comma || token.is_word("and")) continue;
      if (token.kind != Token::Kind::word) return false;
      if (is_room(i)) return true;
      if (mention_at(table_, tokens_, i).length > 0 || words_.stops.count(token.text)) return false;
    }
    return false;
  }

  // "the room is L-shaped", "a studio in the shape of an L", with no thing named since.
  bool room_precedes(std::size_t at, std::size_t after) const {
    if (after < tokens_.size() && mention_at(table_, tokens_, after).length > 0) return false;
    bool linked = false;
    for (std::size_t n = 1; n <= behind && n <= at; ++n) {
      const std::size_t i = at - n;
      const Token& token = tokens_[i];
      if (token.kind == Token::Kind::stop) return false;
      linked = linked || token.is_word("is") || token.is_word("be") || token.is_word("in") ||
               token.is_word("has");
      if (token.kind == Token::Kind::word && is_room(i)) return linked;
      if (mention_at(table_, tokens_, i).length > 0) return false;
    }
    return false;
  }

  void erase(std::size_t at, std::size_t count) {
    const auto begin = tokens_.begin() + static_cast<std::ptrdiff_t>(at);
    tokens_.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  }

  bool read_shape(std::size_t i) {
    const auto outline = longest(shapes_.outline_names, tokens_, i, longest_shape_name);
    const auto proportion = longest(shapes_.proportions, tokens_, i, longest_shape_name);
    const std::size_t length = std::max(outline.length, proportion.length);
    if (length == 0 || (!room_follows(i + length) && !room_precedes(i, i + length))) return false;
    if (outline && brief_.shape.outline.empty()) brief_.shape.outline = *outline.value;
    if (proportion && !brief_.shape.proportion) brief_.shape.proportion = *proportion.value;
    hear(brief_, source_of(tokens_, i, length), Heard::As::room, outline ? "shape" : "proportion");
    erase(i, length);
    return true;
  }

  bool is_denied(std::size_t at) const {
    for (std::size_t n = 1; n <= 2 && n <= at; ++n)
      if (words_.negations.count(tokens_[at - n].text)) return true;
    return false;
  }

  // Spoken of again it is the same one; "alcoves" are two.
  void read_feature(std::size_t i) {
    for (std::size_t length = std::min(longest_shape_name, tokens_.size() - i); length > 0; --length) {
      std::string name;
      for (std::size_t k = 0; k < length; ++k) name += (k ? " " : "") + tokens_[i + k].text;
      for (const auto& singular : singulars(name)) {
        const auto found = shapes_.feature_names.find(singular);
        if (found == shapes_.feature_names.end()) continue;
        if (is_denied(i)) return;
        add_feature(found->second, singular == name ? 1 : 2);
        hear(brief_, source_of(tokens_, i, length), Heard::As::room, found->second);
        return;
      }
    }
  }

  void add_feature(const std::string& feature, int count) {
    auto& features = brief_.shape.features;
    if (std::find(features.begin(), features.end(), feature) != features.end()) return;
    for (int n = 0; n < count && features.size() < most_features; ++n) features.push_back(feature);
  }

  std::vector<Token>& tokens_;
  const Vocabulary& words_;
  const KindTable& table_;
  const std::map<std::string, std::string, std::less<>> rooms_;
  const FloorShapes& shapes_;
  Brief& brief_;
};

}  // namespace

void read_floor_shape(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                      const RoomKinds& kinds, Brief& brief) {
  const auto& shapes = built_in_floor_shapes();
  if (shapes) ShapeReader(tokens, words, table, kinds, *shapes, brief).run();
}

}  // namespace roomgen::brief
