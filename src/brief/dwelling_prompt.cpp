#include "dwelling_prompt.h"

#include "dwelling_reading.h"
#include "prompt.h"
#include "style_phrase.h"
#include "token_readers.h"

namespace roomgen::brief {

namespace {

// "a 70 m2 apartment"
std::optional<double> total_area(const DwellingText& text, const NamedRoom& whole) {
  std::vector<Token> head(text.tokens.begin(),
                          text.tokens.begin() + static_cast<std::ptrdiff_t>(whole.end));
  Brief brief;
  read_measures(head, text.prompt, text.words, text.things, brief);
  if (brief.area) return brief.area;
  if (brief.size) return brief.size->prod();
  return std::nullopt;
}

// "a modern apartment": each of its rooms is.
std::string read_styles(const DwellingText& text, const NamedRoom& whole, const RoomKinds& kinds,
                        std::vector<HeardWords>& heard) {
  std::string styles;
  std::size_t i = whole.noun;
  while (i > 0 && whole.noun - i < 2 * longest_phrase && text.tokens[i - 1].kind != Token::Kind::stop) --i;
  for (; i < whole.noun; ++i) {
    const auto style = style_at({text.tokens.data(), whole.noun}, i, kinds);
    if (!style) continue;
    styles += style->name + " ";
    heard.push_back({source_of(text.tokens, i, style->length), Heard::As::style, ""});
    i += style->length - 1;
  }
  return styles;
}

// Without the words that only join it to the next room's.
Stretch without_joints(const DwellingText& text, Stretch range) {
  const auto& tokens = text.tokens;
  const auto joins = [](const Token& token) {
    return token.kind == Token::Kind::comma || token.is_word("and") || token.is_word("plus") ||
           token.is_word("each") || token.is_word("while") || token.is_word("but");
  };
  const auto leads_on = [&](const Token& token) {
    return text.dwellings.links.count(token.text) || token.is_word("to") ||
           token.is_word("leading") || token.is_word("in");
  };
  while (range.begin < range.end && joins(tokens[range.begin])) ++range.begin;
  while (range.end > range.begin &&
         (joins(tokens[range.end - 1]) || leads_on(tokens[range.end - 1])))
    --range.end;
  return range;
}

/// A room's own words: those that are said of it, joined by what is only meant.
class RoomWords {
 public:
  explicit RoomWords(const DwellingText& text) : text_(text) {}

  void mean(const std::string& words, std::size_t before) {
    const auto at = before < text_.tokens.size() ? said(before)->span.begin : 0;
    for (auto& token : language::tokenize(words)) {
      token.span = {at, at};
      words_.push_back(std::move(token));
    }
  }
  void add(Stretch range) {
    const auto& end = text_.tokens[range.end - 1].source.end;
    words_.insert(words_.end(), said(range.begin), text_.prompt.begin() + end);
  }
  std::vector<language::Token> take() { return std::move(words_); }

 private:
  std::vector<language::Token>::const_iterator said(std::size_t token) const {
    return text_.prompt.begin() + text_.tokens[token].source.begin;
  }

  const DwellingText& text_;
  std::vector<language::Token> words_;
};

bool begins_with_link(const DwellingText& text, Stretch range) {
  static const WordSet links = {"with",     "has",      "have", "contains", "features",
                                "includes", "for",      "that", "where"};
  return range.end > range.begin + 1 && links.count(text.tokens[range.begin].text) > 0;
}

std::vector<language::Token> words_of(const DwellingText& text, const FoundRoom& room,
                                      const std::vector<Stretch>& about,
                                      const std::string& styles) {
  RoomWords words(text);
  words.mean("a " + styles + room.adjectives + room.type, room.introduced);
  for (const auto& range : about) {
    const Stretch said = without_joints(text, range);
    if (said.begin == said.end) continue;
    // At once it goes on about the room that it names, later it comes back to it.
    const bool goes_on = range.begin == room.introduced, is_link = begins_with_link(text, said);
    if (is_link && !goes_on) words.mean(". the " + room.type, said.begin);
    if (!is_link)
      words.mean(text.tokens[said.begin].is_word("there") ? "." : ". there is", said.begin);
    words.add(said);
  }
  return words.take();
}

// "The flat has a kitchen", "... and a bathroom": what only says that the room is there.
std::optional<std::size_t> verb_before(const DwellingText& text, const NamedRoom& name) {
  static const WordSet verbs = {"has", "have", "contains", "includes", "comprises", "features", "offers", "needs", "is"};
  std::size_t i = name.begin;
  while (i > 0 && (text.tokens[i - 1].is_word("a") || text.tokens[i - 1].is_word("an") || text.tokens[i - 1].is_word("the"))) --i;
  return i > 0 && verbs.count(text.tokens[i - 1].text) ? std::optional(i - 1) : std::nullopt;
}

// The names of rooms, how many they are, and words of size and style before them.
void hear_names(const DwellingText& text, const std::vector<NamedRoom>& names,
                const RoomKinds& kinds, std::vector<HeardWords>& heard) {
  for (const auto& name : names) {
    heard.push_back({source_of(text.tokens, name.noun, name.end - name.noun), Heard::As::room,
                     name.type});
    if (const auto verb = verb_before(text, name)) heard.push_back({text.tokens[*verb].source, Heard::As::room, name.type});
    for (std::size_t i = name.begin; i < name.noun; ++i) {
      const Token& token = text.tokens[i];
      const bool counts =
          token.kind == Token::Kind::number || text.words.numbers.count(token.text) > 0;
      if (counts || text.words.sizes.count(token.text))
        heard.push_back({token.source, Heard::As::room, name.type});
      else if (const auto style = style_at({text.tokens.data(), name.noun}, i, kinds))
        heard.push_back({source_of(text.tokens, i, style->length), Heard::As::style, ""});
    }
  }
}

}  // namespace

std::optional<SaidDwelling> read_dwelling(std::string_view prompt, const DwellingKinds& dwellings,
                                          const RoomKinds& kinds, const KindTable& table) {
  const auto& words = built_in_vocabulary();
  if (!words) return std::nullopt;
  const DwellingText text(prompt, *words, dwellings, kinds, table);
  auto names = find_room_names(text);
  SaidDwelling said;
  const auto rooms = find_rooms(text, names, said.notes);
  if (rooms.size() < 2) return std::nullopt;
  std::string styles;
  if (const NamedRoom* whole = whole_dwelling(text, names)) {
    said.area = total_area(text, *whole);
    styles = read_styles(text, *whole, kinds, said.heard);
  }
  const auto about = share_clauses(text, names, rooms, kinds, table);
  for (std::size_t r = 0; r < rooms.size(); ++r)
    said.rooms.push_back({rooms[r].type, rooms[r].owner,
                          read_words(words_of(text, rooms[r], about[r], styles), kinds, table)});
  hear_names(text, names, kinds, said.heard);
  said.tokens = text.prompt;
  return said;
}

}  // namespace roomgen::brief
