#include "prompt.h"

#include <algorithm>

#include "bound_mentions.h"
#include "prompt_passes.h"
#include "prompt_reading.h"
#include "room_purpose.h"
#include "room_type.h"
#include "settle.h"
#include "settle_people.h"
#include "style_phrase.h"
#include "token_readers.h"
#include "view_from_door.h"

namespace roomgen::brief {

namespace {

// "Rustic but bright.", "a cosy one": words of style that are said of no thing are the room's.
// "Little" and "open" are words of style only where they stand before a room.
void read_styles(PromptReading& reading) {
  const std::vector<bool> used = reading.heard_tokens();
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    if (used[i] || reading.taken[i] == Taken::yes || reading.is_denied(i)) continue;
    const auto style = style_at(reading.text.plain, i, reading.kinds);
    if (!style || !style->is_look) continue;
    const auto end = i + static_cast<std::uint32_t>(style->length);
    if (std::find(used.begin() + i, used.begin() + end, true) != used.begin() + end) continue;
    hear_style(reading.brief, *style, {i, end});
    i = end - 1;
  }
}

}  // namespace

Brief read_words(std::string_view prompt, const RoomKinds& kinds, const KindTable& table) {
  return read_words(language::tokenize(prompt, max_tokens), kinds, table);
}

Brief read_words(std::vector<language::Token> prompt, const RoomKinds& kinds,
                 const KindTable& table) {
  Brief brief;
  const auto& words = built_in_vocabulary();
  if (!words) return brief;
  const auto parse =
      language::parse(std::move(prompt),
                      [&](std::string_view name) { return table.spelled(name) != nullptr; });
  if (parse.tokens.size() >= max_tokens)
    brief.notes.push_back("only the first " + std::to_string(max_tokens) +
                          " words of the prompt were read");
  brief.tokens = parse.tokens;
  auto tokens = meaningful_tokens(parse.tokens);
  read_measures(tokens, parse.tokens, *words, table, brief);
  read_people(tokens, *words, table, brief);
  read_floor_shape(tokens, *words, table, kinds, brief);
  read_room_type(tokens, parse, *words, table, kinds, brief);
  refine_room_type(parse, kinds, brief);
  read_finishes(tokens, *words, table, finish_words(), brief);
  auto taken = taken_from(parse.tokens.size(), tokens);
  auto plain = plain_tokens(parse.tokens);
  for (std::size_t i = 0; i < plain.size(); ++i)
    if (taken[i] == Taken::room) plain[i].kind = Token::Kind::room;
  const PromptText text{parse, plain, *words, table};
  PromptReading reading(text, std::move(tokens), std::move(taken),
                        {*words, table, kinds.get(brief.type)}, kinds, brief);
  read_openings(reading);
  read_things(reading);
  read_limits(reading);
  read_additions(reading);
  share_colours(reading);
  read_partitions(reading);
  read_formations(reading);
  read_heights(reading);
  read_distances(reading);
  read_places(reading);
  read_headings(reading);
  read_groups(reading);
  brief.told_from_door = tells_sides_from_door(reading);
  read_styles(reading);
  hear_purposes(kinds, brief);
  brief.understood = !brief.heard.empty();
  reading.hearing.plain_verbs(reading.mentions);
  read_palette(reading);
  read_remarks(reading);
  note_lost_limits(reading);
  bring_for_people({*words, table, kinds.get(brief.type)}, brief);
  return brief;
}

void conclude(Brief& brief, const RoomKinds& kinds, const KindTable& table) {
  bound_mentions(brief);
  settle(brief, table);
  if (!brief.type.empty()) return;
  brief.type = guess_room_type(brief, kinds, table);
  if (brief.type.empty()) return;
  brief.type_known = brief.type_guessed = true;
  brief.notes.push_back("the prompt names no kind of room; taken for a " + brief.type);
}

Brief read_prompt(std::string_view prompt, const RoomKinds& kinds, const KindTable& table) {
  Brief brief = read_words(prompt, kinds, table);
  conclude(brief, kinds, table);
  return brief;
}

}  // namespace roomgen::brief
