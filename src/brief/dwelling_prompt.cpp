#include "dwelling_prompt.h"

#include "dwelling_reading.h"
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

/// Puts a room's own prompt together and remembers where its words come from.
class RoomPrompt {
 public:
  explicit RoomPrompt(const DwellingText& text) : text_(text) {}

  void add(std::string_view words) { prompt_ += words; }
  void add(Stretch range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const Token& token = text_.tokens[i];
      if (token.kind == Token::Kind::comma) {
        prompt_ += ",";
        continue;
      }
      if (i > range.begin) prompt_ += " ";
      const std::size_t begin = prompt_.size();
      prompt_ += token.text;
      origins_.push_back({{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(prompt_.size())},
                          text_.prompt[token.source.begin].span});
    }
  }
  void put_into(SaidRoom& room) {
    room.prompt = std::move(prompt_);
    room.origins = std::move(origins_);
  }

 private:
  const DwellingText& text_;
  std::string prompt_;
  std::vector<Origin> origins_;
};

bool begins_with_link(const DwellingText& text, Stretch range) {
  static const WordSet links = {"with",     "has",      "have", "contains", "features",
                                "includes", "for",      "that", "where"};
  return range.end > range.begin + 1 && links.count(text.tokens[range.begin].text) > 0;
}

void write_prompt(const DwellingText& text, const FoundRoom& room,
                  const std::vector<Stretch>& about, const std::string& styles, SaidRoom& said) {
  RoomPrompt prompt(text);
  prompt.add("a " + styles + room.adjectives + room.type);
  for (const auto& range : about) {
    const Stretch words = without_joints(text, range);
    if (words.begin == words.end) continue;
    // At once it goes on about the room that it names, later it comes back to it.
    const bool goes_on = range.begin == room.introduced;
    if (begins_with_link(text, words))
      prompt.add(goes_on ? " " : ". the " + room.type + " ");
    else
      prompt.add(text.tokens[words.begin].is_word("there") ? ". " : ". there is ");
    prompt.add(words);
  }
  prompt.put_into(said);
}

SaidRoom said_room(const DwellingText& text, const FoundRoom& room,
                   const std::vector<Stretch>& about, const std::string& styles) {
  SaidRoom said;
  said.type = room.type;
  said.owner = room.owner;
  write_prompt(text, room, about, styles, said);
  return said;
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
    said.rooms.push_back(said_room(text, rooms[r], about[r], styles));
  hear_names(text, names, kinds, said.heard);
  said.tokens = text.prompt;
  return said;
}

}  // namespace roomgen::brief
