#include "room_names.h"

#include "brief/room_kinds.h"
#include "language/inflection.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

// How many tokens from `at` on are the name: "living room", "bedrooms".
std::size_t length_of_name(const EditText& text, std::size_t at, const std::string& said, bool& plural) {
  const auto name = words(said);
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (text.is_word(at + i, name[i])) continue;
    const bool is_last = i + 1 == name.size() && at + i < text.tokens.size();
    if (!is_last || language::singular(text.tokens[at + i].text) != name[i]) return 0;
    plural = true;
  }
  return name.size();
}

// By its type, or another name of that.
std::size_t length_of_any_name(const EditText& text, std::size_t at, const Room& room, bool& plural) {
  std::size_t longest_name = length_of_name(text, at, room.type, plural);
  const auto& kinds = brief::built_in_room_kinds();
  if (!kinds || longest_name > 0) return longest_name;
  for (const auto& name : kinds->get(room.type).names)
    longest_name = std::max(longest_name, length_of_name(text, at, name, plural));
  return longest_name;
}

bool is_numbered(const EditText& text, std::size_t at, const Room& room) {
  if (at >= text.raw.size() || text.raw[at].kind != language::Token::Kind::number) return false;
  return room.id.ends_with("-" + text.raw[at].text);
}

}  // namespace

std::optional<SpokenRooms> rooms_named_at(const EditText& text, std::size_t at) {
  if (text.scene.rooms.size() < 2) return std::nullopt;
  SpokenRooms named;
  for (; at < text.tokens.size(); ++at) {
    const bool is_all = text.edits.all.count(text.tokens[at].text) > 0;
    if (!is_all && !text.words.definite.count(text.tokens[at].text)) break;
    named.plural = named.plural || is_all;
  }
  named.begin = at;
  if (const auto length = longest_in(text.edits.whole_dwelling, text.tokens, at);
      length > 0 && (named.plural || !text.is_word(at, "room"))) {
    for (const auto& room : text.scene.rooms) named.ids.push_back(room.id);
    return SpokenRooms{named.ids, true, at, at + length};
  }
  for (const auto& room : text.scene.rooms) {
    const auto length = length_of_any_name(text, at, room, named.plural);
    if (length == 0 || at + length < named.end) continue;
    if (is_numbered(text, at + length, room)) return SpokenRooms{{room.id}, false, at, at + length + 1};
    if (at + length > named.end) named.ids.clear();
    named.ids.push_back(room.id);
    named.end = at + length;
  }
  if (named.ids.empty()) return std::nullopt;
  return named;
}

MayRead<std::string> in_room_at(const EditText& text, std::size_t at) {
  if (!text.is_word(at, "in") && !text.is_word(at, "to") && !text.is_word(at, "into") && !text.is_word(at, "from"))
    return std::nullopt;
  const auto named = rooms_named_at(text, at + 1);
  if (!named) return std::nullopt;
  if (named->ids.size() > 1) return several_rooms(text.words_from(named->begin, named->end), named->ids);
  return Read<std::string>{named->ids.front(), named->end};
}

Error several_rooms(const std::string& words, const Ids& rooms) {
  return not_understood("\"" + words + "\" may be of " + join(rooms, ", ") + "; say which room");
}

}  // namespace roomgen
