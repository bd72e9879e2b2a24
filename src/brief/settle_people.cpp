#include "settle_people.h"

#include <algorithm>

#include "mention_shape.h"

namespace roomgen::brief {

namespace {

bool is_named(const Piece& piece, const Lexicon& lexicon, const Brief& brief) {
  return std::any_of(brief.mentions.begin(), brief.mentions.end(), [&](const Mention& mention) {
    return mention.owner.empty() && std::any_of(piece.any.begin(), piece.any.end(), [&](const auto& option) {
             return lexicon.table.is_a(mention.category, option.first) || lexicon.table.is_a(option.first, mention.category);
           });
  });
}

// Seats for all of them are named: nobody needs other places.
bool are_seated(const Brief& brief, const Lexicon& lexicon) {
  int seats = 0;
  for (const Mention& mention : brief.mentions)
    if (lexicon.table.is_any_of(mention.category, {"seat"})) seats += mention.quantity;
  return seats >= brief.people;
}

bool is_seat(const Piece& piece, const Lexicon& lexicon) {
  return lexicon.table.is_any_of(piece.any.front().first, {"chair", "stool"});
}

// Such a room has seats, and nobody lies there.
bool is_for_sitting(const Lexicon& lexicon) {
  const auto has = [&](const char* kind) {
    const auto is_so = [&](const Piece& piece) {
      return std::any_of(piece.any.begin(), piece.any.end(), [&](const auto& option) { return lexicon.table.is_a(option.first, kind); });
    };
    const auto& core = lexicon.kind.core;
    return std::any_of(core.begin(), core.end(), [&](const Piece& piece) {
      return is_so(piece) || std::any_of(piece.then.begin(), piece.then.end(), is_so);
    });
  };
  return has("seat") && !has("bed");
}

// Such a room always has it.
bool is_certain(const Piece& piece) {
  return piece.chance >= 1.0 && piece.area <= 0.0 && piece.unless.empty() && piece.needs.empty();
}

std::vector<std::size_t> words_of_people(const Brief& brief) {
  std::vector<std::size_t> words;
  for (std::size_t i = 0; i < brief.heard.size(); ++i)
    if (brief.heard[i].as == Heard::As::person) words.push_back(i);
  return words;
}

void bring(const Piece& piece, int number, const Lexicon& lexicon, Brief& brief) {
  const auto& [category, weight] = *std::max_element(
      piece.any.begin(), piece.any.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  Mention mention = mention_for_people(category, number, lexicon.words, lexicon.table);
  mention.heard = words_of_people(brief);
  if (piece.size) mention.size = *piece.size;
  brief.mentions.push_back(std::move(mention));
}

// "six tables for two" are for twelve.
void count_at_tables(Brief& brief) {
  int seats = 0;
  for (const Mention& mention : brief.mentions) seats += mention.quantity * mention.seats;
  brief.people = std::clamp(std::max(brief.people, seats), 0, most_people);
}

}  // namespace

void bring_for_people(const Lexicon& lexicon, Brief& brief) {
  count_at_tables(brief);
  if (brief.people > 1 && is_for_sitting(lexicon)) brief.seated = brief.people;
  if (brief.people < 2 || brief.bare || are_seated(brief, lexicon)) return;
  for (const Piece& piece : lexicon.kind.core) {
    const bool is_there = is_named(piece, lexicon, brief);
    int number = 0;
    if (piece.for_people > 0 && !is_there) {
      number = (brief.people + piece.for_people - 1) / piece.for_people;
      bring(piece, number, lexicon, brief);
    }
    for (const Piece& seat : piece.then) {
      if (!is_seat(seat, lexicon) || is_named(seat, lexicon, brief)) continue;
      if (number > 0)
        bring(seat, std::min(brief.people, number * seat.high), lexicon, brief);
      else if (seat.people && (is_there || is_certain(piece))) {
        if (!is_there) bring(piece, 1, lexicon, brief);
        bring(seat, brief.people, lexicon, brief);
      }
    }
  }
}

}  // namespace roomgen::brief
