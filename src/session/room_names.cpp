#include "room_names.h"

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

// How many tokens from `at` on are the name of the room's type: "living room".
std::size_t length_of_name(const EditText& text, std::size_t at, const Room& room) {
  const auto name = words(room.type);
  for (std::size_t i = 0; i < name.size(); ++i)
    if (!text.is_word(at + i, name[i])) return 0;
  return name.size();
}

bool is_numbered(const EditText& text, std::size_t at, const Room& room) {
  if (at >= text.raw.size() || text.raw[at].kind != language::Token::Kind::number) return false;
  return room.id.ends_with("-" + text.raw[at].text);
}

}  // namespace

MayRead<std::string> in_room_at(const EditText& text, std::size_t at) {
  if (text.scene.rooms.empty()) return std::nullopt;
  if (!text.is_word(at, "in") && !text.is_word(at, "to") && !text.is_word(at, "into") && !text.is_word(at, "from"))
    return std::nullopt;
  ++at;
  while (at < text.tokens.size() && text.words.definite.count(text.tokens[at].text)) ++at;
  std::vector<std::string> ids;
  std::size_t end = at;
  for (const auto& room : text.scene.rooms) {
    const auto length = length_of_name(text, at, room);
    if (length == 0) continue;
    if (is_numbered(text, at + length, room)) return Read<std::string>{room.id, at + length + 1};
    ids.push_back(room.id);
    end = at + length;
  }
  if (ids.empty()) return std::nullopt;
  if (ids.size() > 1)
    return not_understood("\"" + text.words_from(at, end) + "\" may be " + join(ids, ", ") + "; say which one");
  return Read<std::string>{ids.front(), end};
}

}  // namespace roomgen
