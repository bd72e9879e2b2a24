#include "room_type.h"

#include <algorithm>
#include <set>

#include "language/lexicon.h"
#include "room_purpose.h"
#include "roomgen/base/text.h"
#include "stated_room.h"
#include "style_phrase.h"

namespace roomgen::brief {

namespace {

constexpr double first_weight = 1.5;
constexpr double exactly = 0.1;  ///< less than anything else tells
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
    if (style) hear_style(brief, *style, source_of(tokens, i, style->length));
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

// "police" of a police station.
bool is_noun_before(const Token& token, const language::Parse& parse) {
  return std::any_of(parse.modifiers.begin(), parse.modifiers.end(), [&](const auto& modifier) {
    return modifier.kind == language::Modifier::Kind::noun && modifier.tokens.begin == token.source.begin &&
           modifier.tokens.end == token.source.end;
  });
}

// "A bakery with …": the last word of the prompt's first phrase, when it is neither a thing nor a
// room in general.
void read_leading_noun(std::vector<Token>& tokens, const language::Parse& parse, const Vocabulary& words,
                       const KindTable& table, const RoomKinds& kinds, Brief& brief) {
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
  using language::WordClass;
  if (language::lexicon().is(noun, WordClass::person) || language::lexicon().is(noun, WordClass::animal)) return;
  std::size_t first = end - 1;
  while (first > 0 && tokens[first - 1].kind == Token::Kind::word && is_noun_before(tokens[first - 1], parse)) --first;
  make_room_token(tokens, first, end - first);
  brief.type = tokens[first].text;
  hear(brief, tokens[first].source, Heard::As::room, "kind");
  collect_styles(tokens, first, kinds, words, brief);
}

/// A name of a kind of room.
struct NamedRoom {
  std::size_t at = 0, length = 0;  ///< tokens
  std::string type;
  bool is_head = false;  ///< of its noun phrase: a theatre poster names no theatre
};

bool is_head(const Token& token, const language::Parse& parse) {
  return std::any_of(parse.phrases.begin(), parse.phrases.end(), [&](const auto& phrase) {
    return phrase.head + 1 == token.source.end;
  });
}

// "post office", "data hall": another noun makes it another kind of room, unless it says whose it is.
bool is_compound(const Token& token, const language::Parse& parse) {
  return std::any_of(parse.phrases.begin(), parse.phrases.end(), [&](const auto& phrase) {
    if (phrase.head + 1 != token.source.end || phrase.modifiers.empty()) return false;
    const auto& before = parse.modifiers[phrase.modifiers.end - 1];
    return before.kind == language::Modifier::Kind::noun && before.tokens.end == token.source.begin &&
           !language::lexicon().is(parse.tokens[before.tokens.begin].text, language::WordClass::person);
  });
}

std::vector<NamedRoom> named_rooms(const std::vector<Token>& tokens, const language::Parse& parse,
                                   const KindTable& table, const RoomNames& names) {
  std::vector<NamedRoom> rooms;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != Token::Kind::word) continue;
    const auto room = longest(names, tokens, i, 3);
    // "bathroom cabinet", "kitchen sink", "hall table" and "play kitchen" name things.
    if (!room || mention_at(table, tokens, i).length > room.length || is_within_name(table, tokens, i)) continue;
    rooms.push_back({i, room.length, *room.value, is_head(tokens[i + room.length - 1], parse)});
    i += room.length - 1;
  }
  return rooms;
}

// "A cosy bar with …": what the prompt speaks of first, unless it is one of a list.
void keep_leading(std::vector<NamedRoom>& rooms, const std::vector<Token>& tokens,
                  const language::Parse& parse) {
  const auto first = std::find_if(parse.phrases.begin(), parse.phrases.end(),
                                  [](const auto& phrase) { return !phrase.is_pronoun; });
  std::erase_if(rooms, [&](const NamedRoom& room) {
    return first == parse.phrases.end() || first->list != language::none || first->is_plural ||
           tokens[room.at + room.length - 1].source.end != first->head + 1;
  });
}

std::set<std::string> names_alone(const RoomKinds& kinds) {
  std::set<std::string> names;
  for (const auto& [type, kind] : kinds.types) names.insert(kind.alone.begin(), kind.alone.end());
  return names;
}

void drop_compounds(std::vector<NamedRoom>& rooms, const std::vector<Token>& tokens, const language::Parse& parse,
                    const RoomKinds& kinds) {
  const auto alone = names_alone(kinds);
  std::erase_if(rooms, [&](const NamedRoom& room) {
    return room.length == 1 && alone.count(tokens[room.at].text) && is_compound(tokens[room.at], parse);
  });
}

// One room is made; of the others that the prompt names it is said that they are not.
void note_other_rooms(const std::vector<NamedRoom>& rooms, const std::string& type, Brief& brief) {
  std::set<std::string> others;
  for (const auto& room : rooms)
    if (room.is_head && room.type != type) others.insert(room.type);
  if (others.empty()) return;
  brief.notes.push_back("one room is made, a " + type + "; the prompt also names: " +
                        join({others.begin(), others.end()}, ", "));
}

// What no kind of room is called by, or what WordNet takes it for.
void take_stated(const StatedRoom& stated, std::vector<Token>& tokens, const RoomNames& names, const RoomKinds& kinds,
                 const Vocabulary& words, Brief& brief) {
  const auto first = std::find_if(tokens.begin(), tokens.end(), [&](const Token& token) {
    return token.source.begin == stated.tokens.begin;
  });
  const std::size_t length = stated.tokens.size();
  if (tokens.end() - first < static_cast<std::ptrdiff_t>(length)) return;
  const auto at = static_cast<std::size_t>(first - tokens.begin());
  const std::string near = near_room(stated.name, names);
  make_room_token(tokens, at, length);
  brief.type = near.empty() ? stated.name : near;
  brief.type_known = brief.type_inferred = !near.empty();
  if (!near.empty()) brief.notes.push_back("\"" + stated.name + "\" is taken for a " + near);
  hear(brief, tokens[at].source, Heard::As::room, "kind");
  collect_styles(tokens, at, kinds, words, brief);
}

// One that is a head is what the prompt is about; other kinds are only named where they are heads.
std::string choose_type(std::vector<NamedRoom>& rooms) {
  if (rooms.empty()) return "";
  const auto head =
      std::find_if(rooms.begin(), rooms.end(), [](const auto& room) { return room.is_head; });
  const std::string type = (head == rooms.end() ? rooms.begin() : head)->type;
  std::erase_if(rooms, [&](const auto& room) { return !room.is_head && room.type != type; });
  return type;
}

void make_room_tokens(std::vector<Token>& tokens, std::vector<NamedRoom>& rooms) {
  std::size_t removed = 0;
  for (auto& room : rooms) {
    room.at -= removed;
    make_room_token(tokens, room.at, room.length);
    removed += room.length - 1;
  }
}

RoomNames names_by(const RoomKinds& kinds, std::vector<std::string> RoomKind::*list) {
  RoomNames names;
  for (const auto& [type, kind] : kinds.types)
    for (const auto& other : kind.*list) names.try_emplace(join(words(other), " "), type);
  return names;
}

}  // namespace

RoomNames room_names(const RoomKinds& kinds) {
  RoomNames names = names_by(kinds, &RoomKind::names);
  for (const auto& [type, kind] : kinds.types)
    if (std::find(kind.leading.begin(), kind.leading.end(), type) == kind.leading.end())
      names[type] = type;
  return names;
}

void read_room_type(std::vector<Token>& tokens, const language::Parse& parse,
                    const Vocabulary& words, const KindTable& table, const RoomKinds& kinds,
                    Brief& brief) {
  const RoomNames names = room_names(kinds);
  auto rooms = named_rooms(tokens, parse, table, names);
  drop_compounds(rooms, tokens, parse, kinds);
  if (rooms.empty()) {
    rooms = named_rooms(tokens, parse, table, names_by(kinds, &RoomKind::leading));
    keep_leading(rooms, tokens, parse);
  }
  const auto is_named = [&](std::uint32_t head) {
    return std::any_of(rooms.begin(), rooms.end(), [&](const NamedRoom& room) {
      return tokens[room.at + room.length - 1].source.end == head + 1;
    });
  };
  const auto stated = stated_room({parse, plain_tokens(parse.tokens), words, table}, is_named);
  if (stated && (stated->is_told || rooms.empty())) {
    rooms.clear();
    take_stated(*stated, tokens, names, kinds, words, brief);
  }
  const std::string type = choose_type(rooms);
  if (!type.empty()) note_other_rooms(rooms, type, brief);
  make_room_tokens(tokens, rooms);
  auto room = rooms.begin();
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind == Token::Kind::word && style_heads().count(tokens[i].text))
      read_styles_at_head(tokens, i, kinds, words, brief);
    if (room == rooms.end() || room->at != i) continue;
    if ((room++)->type != type) continue;
    hear(brief, tokens[i].source, Heard::As::room, "kind");
    if (brief.type_known) continue;
    brief.type = type;
    brief.type_known = true;
    collect_styles(tokens, i, kinds, words, brief);
  }
  if (brief.type.empty()) read_compound_rooms(tokens, words, table, kinds, brief);
  if (brief.type.empty()) read_leading_noun(tokens, parse, words, table, kinds, brief);
  if (!brief.type.empty() && !brief.type_known)
    brief.notes.push_back("no kind of room is called \"" + brief.type + "\"; little was added to what the prompt names");
  for (std::size_t i = 0; brief.type.empty() && i < tokens.size(); ++i)
    if (tokens[i].kind == Token::Kind::word && words.generic_rooms.count(tokens[i].text))
      collect_styles(tokens, i, kinds, words, brief);
}

namespace {

// How much a thing tells of a kind of room: what the room is for most, and most of all when it is
// just that kind of thing.
double vote_of(const RoomKind& kind, const std::string& category, const KindTable& table) {
  double vote = 0.0;
  if (kind.known_by && kind.known_by->empty()) return vote;
  const auto hear_kind = [&](const std::string& known, double weight) {
    if (category == known) weight += exactly;
    if (table.is_a(category, known)) vote = std::max(vote, weight);
  };
  const auto hear_pieces = [&](const std::vector<Piece>& pieces, double weight) {
    for (const auto& piece : pieces)
      for (const auto& [known, chance] : piece.any) hear_kind(known, weight);
  };
  if (kind.known_by)
    for (const auto& known : *kind.known_by) hear_kind(known, first_weight);
  else if (!kind.core.empty())
    hear_pieces({kind.core.front()}, first_weight);
  hear_pieces(kind.core, 1.0);
  hear_pieces(kind.extras, 0.3);
  return vote;
}

}  // namespace

std::string guess_room_type(const Brief& brief, const RoomKinds& kinds, const KindTable& table) {
  std::string best;
  double most = 0.0;
  for (const auto& [type, kind] : kinds.types) {
    double votes = 0.0;
    bool is_meant = false;  // what the room is for is there
    for (const auto& mention : brief.mentions) {
      const double vote = vote_of(kind, mention.category, table);
      votes += vote;
      is_meant = is_meant || vote >= first_weight;
    }
    if (is_meant && votes > most) {
      most = votes;
      best = type;
    }
  }
  return best.empty() ? room_by_purpose(kinds, brief) : best;
}

}  // namespace roomgen::brief
