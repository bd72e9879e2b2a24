#include "opening_phrase.h"

#include <algorithm>
#include <initializer_list>

#include "roomgen/base/text.h"

namespace roomgen::brief {

namespace {

constexpr std::size_t longest_opening_name = 5;
constexpr std::size_t most_adjectives = 5;
constexpr int most_openings = 12;
constexpr int most_plain_windows = 3;
constexpr double least_length = 0.3, greatest_length = 15.0;  // metres

struct NameMatch {
  const OpeningKind* kind = nullptr;
  std::size_t length = 0;
  bool plural = false;
};

bool is_text(const Token& token) {
  return token.kind == Token::Kind::word || token.kind == Token::Kind::room;
}

// The longest name at `at`; "floor to ceiling" may be told of any window.
NameMatch name_at(std::span<const Token> tokens, std::size_t at, const OpeningKinds& kinds) {
  NameMatch best;
  std::string text;
  for (std::size_t n = 0; n < longest_opening_name && at + n < tokens.size() && is_text(tokens[at + n]);
       ++n) {
    text += (n ? " " : "") + tokens[at + n].text;
    if (const OpeningKind* kind = kinds.find(text))
      // "a wall of windows" is one.
      best = {kind, n + 1,
              singular(tokens[at + n].text) != tokens[at + n].text &&
                  text.find(" of ") == std::string::npos};
  }
  return best;
}

// Reads one phrase from left to right.
class OpeningReader {
 public:
  OpeningReader(std::span<const Token> tokens, std::size_t at, const Vocabulary& words,
         const KindTable& table, const OpeningKinds& kinds)
      : tokens_(tokens), at_(at), words_(words), table_(table), kinds_(kinds) {}

  std::optional<OpeningPhrase> run(std::size_t sentence) {
    const std::size_t begin = at_;
    if (!read_name()) return std::nullopt;
    read_measure_behind();
    const std::size_t named = at_;
    read_places();
    if (!phrase_.wish.has_place()) {
      at_ = named;
      read_place_before(sentence, begin);
    }
    phrase_.end = at_;
    return std::move(phrase_);
  }

 private:
  bool is_word(std::size_t i, std::initializer_list<std::string_view> options) const {
    return i < tokens_.size() &&
           std::any_of(options.begin(), options.end(),
                       [&](std::string_view word) { return tokens_[i].is_word(word); });
  }

  // Article, number, adjectives, and the name of the kind.
  bool read_name() {
    for (std::size_t n = 0; n <= most_adjectives && at_ < tokens_.size(); ++n) {
      const NameMatch match = name_at(tokens_, at_, kinds_);
      const std::size_t thing = mention_at(table_, tokens_, at_).length;
      if (thing > match.length) return false;  // "door mat"
      if (match.kind) return take_name(match);
      if (thing > 0 || !read_adjective(n == 0)) return false;
      ++at_;
    }
    return false;
  }

  bool take_name(const NameMatch& match) {
    at_ += match.length;
    // "french door refrigerator"
    if (mention_at(table_, tokens_, at_).length > 0) return false;
    OpeningWish& wish = phrase_.wish;
    wish.kind = match.kind->name;
    wish.type = match.kind->type;
    phrase_.plural = match.plural;
    phrase_.special = wish.kind != name(wish.type);
    // A pair of leaves is one door.
    const bool pair = match.kind->leaves > 1 && match.plural && wish.type == OpeningType::door;
    if (!wish.counted && match.plural && !pair) wish.count = 2;
    if (pair && (!wish.counted || counted_as_pair_)) wish.count = 1;
    return true;
  }

  bool read_adjective(bool first) {
    const Token& token = tokens_[at_];
    OpeningWish& wish = phrase_.wish;
    if (token.kind == Token::Kind::length) {
      set_length(token);
      return true;
    }
    if (token.kind == Token::Kind::number)
      return set_count(static_cast<int>(std::min(token.value, 1e6)));
    if (token.kind != Token::Kind::word) return false;
    if (words_.definite.count(token.text)) {
      phrase_.definite = true;
      return first;
    }
    if (is_word(at_, {"of"})) return counted_as_pair_;
    if (const auto number = words_.numbers.find(token.text); number != words_.numbers.end()) {
      counted_as_pair_ = is_word(at_, {"pair", "set", "double"});
      return number->second == 1 || set_count(number->second);
    }
    if (words_.stops.count(token.text)) return false;
    const auto side = words_.walls.find(token.text);
    const auto size = words_.sizes.find(token.text);
    if (side != words_.walls.end()) wish.sides.push_back(side->second);
    if (side == words_.walls.end() && size == words_.sizes.end()) phrase_.unread.push_back(at_);
    if (size != words_.sizes.end()) {
      wish.wide *= size->second.x();
      wish.high *= size->second.z();
      phrase_.enlarged = phrase_.enlarged || size->second.x() > 1.0;
    }
    return true;
  }

  bool set_count(int count) {
    if (count < 1) return false;
    phrase_.wish.count = std::min(count, most_openings);
    phrase_.wish.counted = true;
    return true;
  }

  // "a 1.2 by 1.5 m window": width and height.
  void set_length(const Token& length) {
    if (length.value < least_length || length.value > greatest_length) return;
    (length.text == "depth" ? phrase_.wish.height : phrase_.wish.width) = length.value;
  }

  // "a window 2 m wide"
  void read_measure_behind() {
    if (at_ < tokens_.size() && tokens_[at_].kind == Token::Kind::length &&
        is_word(at_ + 1, {"wide", "long", "across"})) {
      set_length(tokens_[at_]);
      at_ += 2;
    }
  }

  // All places that follow, with what may stand between them and the name.
  void read_places() {
    while (is_word(at_, {"is", "are", "should", "be", "that", "which", "located", "placed", "set",
                         "positioned", "centered", "situated", "installed", "cut", "both", "one"}))
      ++at_;
    while (read_relative_place() || read_sides()) {
    }
  }

  std::optional<OpeningType> opening_after(std::size_t& at) const {
    while (at < tokens_.size() &&
           (words_.definite.count(tokens_[at].text) || is_word(at, {"a", "an"})))
      ++at;
    const NameMatch match = name_at(tokens_, at, kinds_);
    const bool entrance = is_word(at, {"entrance", "entry"});
    if (!match.kind && !entrance) return std::nullopt;
    at += match.kind ? match.length : 1;
    return match.kind ? match.kind->type : OpeningType::door;
  }

  bool read_relative_place() {
    if (is_word(at_, {"opposite", "facing"}) && is_word(at_ + 1, {"each"}) &&
        is_word(at_ + 2, {"other"})) {
      phrase_.wish.walls = std::max(2, phrase_.wish.walls);
      at_ += 3;
      return true;
    }
    std::size_t behind = at_;
    const bool across = is_word(at_, {"across"}) && is_word(at_ + 1, {"from"});
    const bool next = is_word(at_, {"next", "adjacent"}) && is_word(at_ + 1, {"to"});
    if (across || next)
      behind = at_ + 2;
    else if (is_word(at_, {"opposite", "facing", "beside"}))
      behind = at_ + 1 + is_word(at_ + 1, {"to"});
    else
      return false;
    const auto type = opening_after(behind);
    if (!type) return false;
    (next || is_word(at_, {"beside"}) ? phrase_.wish.beside : phrase_.wish.opposite) = type;
    at_ = behind;
    return true;
  }

  // "on the left and right walls", "in the back wall", "on two walls", "on each side", "on the
  // left"
  bool read_sides() {
    std::size_t i = at_;
    if (!is_word(i, {"on", "in", "at", "along", "across", "to", "spanning", "into", "through"}))
      return false;
    ++i;
    const auto place = side_phrase(i);
    if (!place) return false;
    at_ = i;
    return true;
  }

  static bool is_wall(const Token& token) {
    return token.is_word("wall") || token.is_word("walls") || token.is_word("side") ||
           token.is_word("sides") || token.is_word("end") || token.is_word("ends");
  }

  // Reads on from `i`; the sides go into the wish when the phrase is one.
  std::optional<bool> side_phrase(std::size_t& i) {
    std::vector<int> sides;
    int walls = 0;
    bool wall = false, opposite = false, all = false;
    for (std::size_t n = 0; n < 8 && i < tokens_.size(); ++n, ++i) {
      const Token& token = tokens_[i];
      const auto side = words_.walls.find(token.text);
      const auto number = words_.numbers.find(token.text);
      if (is_wall(token)) {
        wall = true;
        ++i;
        break;
      }
      if (side != words_.walls.end())
        sides.push_back(side->second);
      else if (token.is_word("opposite") || token.is_word("opposing"))
        opposite = true;
      else if (token.is_word("each") || token.is_word("every") || token.is_word("all"))
        all = true;
      else if (number != words_.numbers.end())
        walls = number->second;
      else if (token.kind == Token::Kind::number)
        walls = static_cast<int>(std::min(token.value, 12.0));
      else if (!is_article_or_and(i, sides))
        break;
    }
    if (!wall && sides.empty()) return std::nullopt;
    // "on the left of the bed" is no side of the room.
    if (is_word(i, {"of"})) {
      if (!is_room(i + 1)) return std::nullopt;
      i += 3;
    } else if (!wall && i > 0 && is_word(i - 1, {"and"})) {
      --i;
    }
    if (!take_sides(sides, walls, opposite, all, i)) return std::nullopt;
    return true;
  }

  // "and" only between sides: "on the left wall and a door …"
  bool is_article_or_and(std::size_t i, const std::vector<int>& sides) const {
    if (words_.definite.count(tokens_[i].text) ||
        is_word(i, {"adjacent", "adjoining", "same", "different"}))
      return true;
    if (tokens_[i].kind != Token::Kind::comma && !is_word(i, {"and", "or"})) return false;
    std::size_t next = i + 1;
    while (is_word(next, {"the", "and"})) ++next;
    return !sides.empty() && next < tokens_.size() && words_.walls.count(tokens_[next].text) > 0;
  }

  bool is_room(std::size_t i) const {
    return is_word(i, {"the", "this"}) && i + 1 < tokens_.size() &&
           (tokens_[i + 1].kind == Token::Kind::room || is_word(i + 1, {"room", "space"}));
  }

  bool take_sides(const std::vector<int>& sides, int walls, bool opposite, bool all,
                  std::size_t i) {
    OpeningWish& wish = phrase_.wish;
    const bool names_sides = i > 0 && is_word(i - 1, {"side", "sides", "end", "ends"});
    if (!sides.empty()) {
      wish.sides.insert(wish.sides.end(), sides.begin(), sides.end());
    } else if (all) {
      // A room has two sides to a door, and four walls.
      if (names_sides)
        wish.sides = {3, 1};
      else
        wish.sides = {0, 1, 2, 3};
      wish.count = std::max(wish.count, static_cast<int>(wish.sides.size()));
    } else if (opposite || (names_sides && walls == 2)) {
      wish.sides = {3, 1};
      wish.count = std::max(wish.count, 2);
    } else if (walls > 1) {
      wish.walls = std::min(walls, most_openings);
    } else {
      return false;
    }
    if (!wish.counted)
      wish.count =
          std::max(wish.count, std::max<int>(wish.walls, static_cast<int>(wish.sides.size())));
    return true;
  }

  // "The left wall has two windows", "on the back wall there is a sliding door"
  void read_place_before(std::size_t sentence, std::size_t begin) {
    std::size_t i = begin;
    while (i > sentence && is_word(i - 1, {"has", "have", "there", "is", "are", "features", "holds",
                                           "contains", "with", "sits", "includes"}))
      --i;
    if (i > sentence && tokens_[i - 1].kind == Token::Kind::comma) --i;
    if (i < sentence + 2 || !is_wall(tokens_[i - 1])) return;
    for (std::size_t k = i - 1; k > sentence; --k) {
      const auto side = words_.walls.find(tokens_[k - 1].text);
      if (side != words_.walls.end())
        phrase_.wish.sides.push_back(side->second);
      else if (!is_word(k - 1, {"and", "the", "long", "short"}))
        break;
    }
    std::reverse(phrase_.wish.sides.begin(), phrase_.wish.sides.end());
    if (!phrase_.wish.counted)
      phrase_.wish.count =
          std::max(phrase_.wish.count, static_cast<int>(phrase_.wish.sides.size()));
  }

  std::span<const Token> tokens_;
  std::size_t at_;
  const Vocabulary& words_;
  const KindTable& table_;
  const OpeningKinds& kinds_;
  OpeningPhrase phrase_;
  bool counted_as_pair_ = false;
};

// Nothing is said but that it is there.
bool is_plain(const OpeningPhrase& phrase) {
  const OpeningWish& wish = phrase.wish;
  const bool window = wish.type == OpeningType::window;
  // A large window is a usual one, only wider; a tall one is not.
  const bool large = window && wish.wide > 1.0 && wish.high <= wish.wide;
  const bool usual_size =
      !wish.width && !wish.height && (large || (wish.wide == 1.0 && wish.high == 1.0));
  const int usual_most = window ? most_plain_windows : 1;
  return !phrase.special && !wish.has_place() && usual_size && wish.count <= usual_most;
}

OpeningWish* spoken_of(Brief& brief, OpeningType type) {
  const auto is_window = [](OpeningType one) { return one == OpeningType::window; };
  for (auto wish = brief.openings.rbegin(); wish != brief.openings.rend(); ++wish)
    if (is_window(wish->type) == is_window(type)) return &*wish;
  return nullptr;
}

void add_place(OpeningWish& known, const OpeningWish& more) {
  if (!more.has_place()) return;
  known.sides = more.sides;
  known.walls = more.walls;
  known.opposite = more.opposite;
  known.beside = more.beside;
  if (!known.counted) known.count = std::max(known.count, more.count);
}

void ask_for_windows(const OpeningPhrase& phrase, Brief& brief) {
  OpeningWish wish = phrase.wish;
  if (is_plain(phrase)) {
    brief.wide_windows = brief.wide_windows || phrase.enlarged;
    const int usual = phrase.plural ? 2 : 1;
    // Beside windows of another kind: "a round window and two windows".
    const bool more = !phrase.definite && spoken_of(brief, OpeningType::window) != nullptr;
    if (wish.counted)
      brief.windows = wish.count;
    else if (!brief.windows || (more && *brief.windows == 0))
      brief.windows = usual;
    return;
  }
  // "Two windows. They are …": those that were only counted before.
  if (phrase.definite && brief.windows && *brief.windows > 0) {
    wish.count = std::max(wish.count, *brief.windows);
    brief.windows = 0;
  }
  if (!brief.windows) brief.windows = 0;
  brief.openings.push_back(wish);
}

}  // namespace

std::optional<OpeningPhrase> read_opening(std::span<const Token> tokens, std::size_t at,
                                          std::size_t sentence, const Vocabulary& words,
                                          const KindTable& table, const OpeningKinds& kinds) {
  return OpeningReader(tokens, at, words, table, kinds).run(sentence);
}

void ask_for(const OpeningPhrase& phrase, Brief& brief) {
  if (OpeningWish* known = phrase.definite ? spoken_of(brief, phrase.wish.type) : nullptr) {
    add_place(*known, phrase.wish);
    return;
  }
  if (phrase.wish.type == OpeningType::window) {
    ask_for_windows(phrase, brief);
  } else if (!is_plain(phrase)) {
    brief.openings.push_back(phrase.wish);
  }
}

std::size_t opening_name_at(std::span<const Token> tokens, std::size_t at,
                            const OpeningKinds& kinds) {
  return name_at(tokens, at, kinds).length;
}

}  // namespace roomgen::brief
