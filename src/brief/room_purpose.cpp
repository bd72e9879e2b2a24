#include "room_purpose.h"

#include <algorithm>
#include <map>

#include "language/inflection.h"
#include "roomgen/base/text.h"

namespace roomgen::brief {

namespace {

using language::none;
using language::NounPhrase;
using language::Run;

constexpr std::uint32_t longest_purpose = 3;  ///< words

// "knitting" as "knit", "children" as "child".
std::string plain_form(const std::string& word) {
  const auto verb = language::verb(word);
  return verb && verb->form == language::VerbForm::gerund ? verb->base : language::singular(word);
}

std::map<std::string, std::string> purposes_of(const RoomKinds& kinds) {
  std::map<std::string, std::string> rooms;
  for (const auto& [type, kind] : kinds.types)
    for (const auto& purpose : kind.purposes) {
      auto said = words(purpose);
      for (auto& word : said) word = plain_form(word);
      rooms.try_emplace(join(said, " "), type);
    }
  return rooms;
}

// "my daughter's bedroom", "a bedroom for two girls and their brother": the words for whom a room
// is.
std::vector<Run> whom_room_is_for(const language::Parse& parse,
                                  const std::vector<bool>& names_room) {
  std::vector<Run> runs;
  for (const NounPhrase& phrase : parse.phrases)
    for (auto i = phrase.modifiers.begin; names_room[phrase.head] && i < phrase.modifiers.end; ++i)
      if (parse.modifiers[i].kind == language::Modifier::Kind::owner)
        runs.push_back(parse.modifiers[i].tokens);
  for (const auto& one : parse.attachments)
    if (one.relation == "for" && one.from != none && one.to != none &&
        names_room[parse.phrases[static_cast<std::size_t>(one.from)].head])
      runs.push_back(parse.phrases[static_cast<std::size_t>(one.to)].tokens);
  return runs;
}

/// Words that say what a room is for.
struct Purpose {
  Run tokens;
  std::string room;
};

// One behind the other, each the longest that begins there.
std::vector<Purpose> purposes_in(const std::vector<language::Token>& tokens, const Run& words,
                                 const RoomKinds& kinds) {
  const auto rooms = purposes_of(kinds);
  std::vector<Purpose> found;
  for (std::uint32_t first = words.begin; first < words.end;) {
    std::string said;
    Purpose best{{first, first + 1}, ""};
    for (std::uint32_t i = first; i < words.end && i < first + longest_purpose; ++i) {
      said += (said.empty() ? "" : " ") + plain_form(tokens[i].text);
      if (const auto room = rooms.find(said); room != rooms.end())
        best = {{first, i + 1}, room->second};
    }
    first = best.tokens.end;
    if (!best.room.empty()) found.push_back(std::move(best));
  }
  return found;
}

Run all_of(const Brief& brief) {
  return {0, static_cast<std::uint32_t>(brief.tokens.size())};
}

}  // namespace

void hear_purposes(const RoomKinds& kinds, Brief& brief) {
  std::vector<bool> used(brief.tokens.size(), false);
  for (const HeardWords& heard : brief.heard)
    std::fill(used.begin() + heard.tokens.begin, used.begin() + heard.tokens.end, true);
  for (const auto& [tokens, room] : purposes_in(brief.tokens, all_of(brief), kinds))
    if (std::find(used.begin() + tokens.begin, used.begin() + tokens.end, true) ==
        used.begin() + tokens.end)
      hear(brief, tokens, Heard::As::activity);
}

std::string room_by_purpose(const RoomKinds& kinds, const Brief& brief) {
  const auto purposes = purposes_in(brief.tokens, all_of(brief), kinds);
  return purposes.empty() ? "" : purposes.front().room;
}

void refine_room_type(const language::Parse& parse, const RoomKinds& kinds, Brief& brief) {
  std::vector<bool> names_room(parse.tokens.size(), false);
  for (const HeardWords& heard : brief.heard)
    if (heard.as == Heard::As::room && heard.word == "kind")
      std::fill(names_room.begin() + heard.tokens.begin, names_room.begin() + heard.tokens.end,
                true);
  std::string meant;
  for (const Run& run : whom_room_is_for(parse, names_room)) {
    const auto purposes = purposes_in(parse.tokens, run, kinds);
    // "for a couple and their baby" is none's alone.
    if (purposes.empty() || (!meant.empty() && purposes.front().room != meant)) return;
    meant = purposes.front().room;
  }
  const auto& wider = kinds.get(meant).instead_of;
  if (std::find(wider.begin(), wider.end(), brief.type) != wider.end()) brief.type = meant;
}

}  // namespace roomgen::brief
