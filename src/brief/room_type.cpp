#include "room_type.h"

#include <algorithm>

#include "roomgen/base/text.h"
#include "style_phrase.h"

namespace roomgen::design {

namespace {

constexpr double first_weight = 1.5;
constexpr std::size_t back = 6;  ///< words of style before a name are looked for so far

const WordSet& style_heads() {
  static const WordSet heads = {"style", "styled",     "vibe",      "vibes",  "feel",
                                "look",  "atmosphere", "aesthetic", "design", "decor",
                                "mood",  "ambiance",   "theme"};
  return heads;
}

// Of a run of words that stands before a token, each further one farther back: where it begins.
std::size_t begin_of_words(const std::vector<Token>& tokens, std::size_t before, const RoomKinds& kinds,
                           const Vocabulary& words) {
  std::size_t begin = before;
  for (; begin > 0 && before - begin < back; --begin) {
    const Token& token = tokens[begin - 1];
    if (token.kind == Token::Kind::comma || token.is_word("and") || token.is_word("but")) continue;
    if (token.kind != Token::Kind::word) break;
    if (words.stops.count(token.text) && !style_at(tokens, begin - 1, kinds)) break;
  }
  return begin;
}

void collect_styles(const std::vector<Token>& tokens, std::size_t before, const RoomKinds& kinds,
                    const Vocabulary& words, Brief& brief) {
  for (std::size_t i = begin_of_words(tokens, before, kinds, words); i < before;) {
    const auto style = style_at({tokens.data(), before}, i, kinds);
    if (style) {
      hear(brief, source_of(tokens, i, style->length), Heard::As::style);
      if (std::find(brief.styles.begin(), brief.styles.end(), style->name) == brief.styles.end())
        brief.styles.push_back(style->name);
    }
    i += style ? style->length : 1;
  }
}

// "industrial style": the head says that what stands before it is one.
void read_styles_at_head(const std::vector<Token>& tokens, std::size_t at, const RoomKinds& kinds,
                         const Vocabulary& words, Brief& brief) {
  const std::size_t before = brief.heard.size();
  collect_styles(tokens, at, kinds, words, brief);
  if (brief.heard.size() > before) hear(brief, tokens[at].source, Heard::As::style);
}

void make_room_token(std::vector<Token>& tokens, std::size_t at, std::size_t length) {
  std::vector<std::string> text;
  for (std::size_t i = at; i < at + length; ++i) text.push_back(tokens[i].text);
  replace(tokens, at, length, {{Token::Kind::room, join(text, " "), 0.0, {}}});
}

bool is_plain_word(const Token& token, const Vocabulary& words) {
  return token.kind == Token::Kind::word && !words.stops.count(token.text) &&
         !words.numbers.count(token.text) && !words.definite.count(token.text);
}

// "music room": the word before a room word, when it is no style.
void read_compound_rooms(std::vector<Token>& tokens, const Vocabulary& words,
                         const KindTable& table, const RoomKinds& kinds, Brief& brief) {
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    if (tokens[i].kind != Token::Kind::word || !words.room_words.count(tokens[i].text)) continue;
    const Token& first = tokens[i - 1];
    if (!is_plain_word(first, words) || style_at({tokens.data(), i}, i - 1, kinds) || words.sizes.count(first.text))
      continue;
    if (words.generic_rooms.count(tokens[i].text) && tokens[i].text != "room" &&
        tokens[i].text != "house")
      continue;
    // "the bed room divider" and "tv stand area" name things.
    const KindMention thing = mention_at(table, tokens, i - 1);
    if (thing.length > 1 || mention_at(table, tokens, i).length > 1) continue;
    make_room_token(tokens, i - 1, 2);
    if (brief.type.empty()) {
      brief.type = tokens[i - 1].text;
      hear(brief, tokens[i - 1].source, Heard::As::room, "kind");
      collect_styles(tokens, i - 1, kinds, words, brief);
    }
    --i;
  }
}

// "A bakery with …": the last word of the prompt's first phrase, when it is neither a thing nor a
// room in general.
void read_leading_noun(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                       const RoomKinds& kinds, Brief& brief) {
  std::size_t end = 0;
  while (end < tokens.size() && end < 6 && tokens[end].kind == Token::Kind::word &&
         (end == 0 || !words.stops.count(tokens[end].text)))
    ++end;
  if (end < 2 || end == tokens.size() ||
      !(tokens[end].is_word("with") || tokens[end].is_word("that") ||
        tokens[end].is_word("containing") || tokens[end].is_word("featuring")))
    return;
  const bool article =
      tokens[0].is_word("a") || tokens[0].is_word("an") || tokens[0].is_word("the");
  const std::string& noun = tokens[end - 1].text;
  if (!article || words.generic_rooms.count(noun) || words.numbers.count(noun) || style_at({tokens.data(), end}, end - 1, kinds))
    return;
  for (std::size_t i = 0; i < end; ++i)
    if (mention_at(table, tokens, i).length > 0) return;
  brief.type = noun;
  hear(brief, tokens[end - 1].source, Heard::As::room, "kind");
  collect_styles(tokens, end - 1, kinds, words, brief);
  make_room_token(tokens, end - 1, 1);
}

}  // namespace

std::map<std::string, std::string, std::less<>> room_names(const RoomKinds& kinds) {
  std::map<std::string, std::string, std::less<>> names;
  for (const auto& [type, kind] : kinds.types) {
    names[type] = type;
    for (const auto& other : kind.names) names.try_emplace(join(words(other), " "), type);
  }
  return names;
}

void read_room_type(std::vector<Token>& tokens, const Vocabulary& words, const KindTable& table,
                    const RoomKinds& kinds, Brief& brief) {
  const auto rooms = room_names(kinds);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != Token::Kind::word) continue;
    if (style_heads().count(tokens[i].text)) read_styles_at_head(tokens, i, kinds, words, brief);
    const auto room = longest(rooms, tokens, i, 3);
    // "bathroom cabinet", "kitchen sink" and "hall table" name things.
    if (!room || mention_at(table, tokens, i).length > room.length) continue;
    make_room_token(tokens, i, room.length);
    if (!brief.type_known || brief.type == *room.value)
      hear(brief, tokens[i].source, Heard::As::room, "kind");
    if (!brief.type_known) {
      brief.type = *room.value;
      brief.type_known = true;
      collect_styles(tokens, i, kinds, words, brief);
    }
  }
  if (!brief.type_known) read_compound_rooms(tokens, words, table, kinds, brief);
  if (brief.type.empty()) read_leading_noun(tokens, words, table, kinds, brief);
  for (std::size_t i = 0; brief.type.empty() && i < tokens.size(); ++i)
    if (tokens[i].kind == Token::Kind::word && words.generic_rooms.count(tokens[i].text))
      collect_styles(tokens, i, kinds, words, brief);
}

std::string guess_room_type(const Brief& brief, const RoomKinds& kinds,
                            const KindTable& table) {
  std::string best;
  double most = 0.0;
  for (const auto& [type, kind] : kinds.types) {
    double votes = 0.0;
    bool is_meant = false;  // what the room is for is there
    for (const auto& mention : brief.mentions) {
      double vote = 0.0;
      const auto hears = [&, &heard = kind](const std::vector<Piece>& pieces, double weight) {
        for (const auto& piece : pieces)
          // What comes first in a room's core is what it is for.
          for (const auto& [category, chance] : piece.any)
            if (table.is_a(mention.category, category))
              vote = std::max(vote, &piece == &heard.core.front() ? first_weight : weight);
      };
      hears(kind.core, 1.0);
      hears(kind.extras, 0.3);
      votes += vote;
      is_meant = is_meant || vote == first_weight;
    }
    if (is_meant && votes > most) {
      most = votes;
      best = type;
    }
  }
  return most >= 1.0 ? best : "";
}

}  // namespace roomgen::design
