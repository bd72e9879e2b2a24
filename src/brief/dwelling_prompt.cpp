#include "dwelling_prompt.h"

#include "dwelling_clauses.h"
#include "measures.h"

namespace roomgen::design {

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
std::string styles_of(const DwellingText& text, const NamedRoom& whole, const RoomKinds& kinds) {
  std::string styles;
  for (std::size_t i = whole.noun; i-- > 0 && whole.noun - i <= 2 * longest_phrase;) {
    if (text.tokens[i].kind == Token::Kind::stop) break;
    if (kinds.style(text.tokens[i].text)) styles += text.tokens[i].text + " ";
  }
  return styles;
}

// Without the words that only join it to the next room's.
std::string text_of(const DwellingText& text, Stretch range) {
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
  std::string said;
  for (std::size_t i = range.begin; i < range.end; ++i)
    said += tokens[i].kind == Token::Kind::comma ? "," : (said.empty() ? "" : " ") + tokens[i].text;
  return said;
}

bool begins_with_link(const std::string& text) {
  for (const char* link : {"with ", "has ", "have ", "contains ", "features ", "includes ", "for ",
                           "that ", "where "})
    if (text.starts_with(link)) return true;
  return false;
}

std::string prompt_for(const DwellingText& text, const FoundRoom& room,
                       const std::vector<Stretch>& about, const std::string& styles) {
  std::string prompt = "a " + styles + room.adjectives + room.type;
  for (const auto& range : about) {
    const std::string said = text_of(text, range);
    if (said.empty()) continue;
    // At once it goes on about the room that it names, later it comes back to it.
    const bool goes_on = range.begin == room.introduced;
    if (begins_with_link(said))
      prompt += (goes_on ? " " : ". the " + room.type + " ") + said;
    else
      prompt += (said.starts_with("there ") ? ". " : ". there is ") + said;
  }
  return prompt;
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
    styles = styles_of(text, *whole, kinds);
  }
  const auto about = share_clauses(text, names, rooms, kinds, table);
  for (std::size_t r = 0; r < rooms.size(); ++r)
    said.rooms.push_back(
        {rooms[r].type, prompt_for(text, rooms[r], about[r], styles), rooms[r].owner});
  return said;
}

}  // namespace roomgen::design
