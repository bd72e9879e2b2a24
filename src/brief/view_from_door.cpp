#include "view_from_door.h"

namespace roomgen::brief {

namespace {

using language::Run;

// The token behind "enter", "come in", "walks through"; the same one if nobody enters there.
std::uint32_t behind_entering(const PromptReading& reading, std::uint32_t at) {
  static const WordSet enters = {"enter", "enters", "entering"},
                       moves = {"come", "comes", "coming", "walk", "walks", "walking", "step", "steps", "stepping"},
                       ways = {"in", "inside", "into", "through"};
  if (enters.count(reading.word(at))) return at + 1;
  const bool goes_in = moves.count(reading.word(at)) && at + 1 < reading.text.plain.size() && ways.count(reading.word(at + 1));
  return goes_in ? at + 2 : at;
}

// "as you", "when one" before it.
std::uint32_t with_subject(const PromptReading& reading, std::uint32_t at) {
  static const WordSet whens = {"as", "when", "if", "once", "while"};
  if (at >= 2 && whens.count(reading.word(at - 2))) return at - 2;
  return at >= 1 && whens.count(reading.word(at - 1)) ? at - 1 : at;
}

}  // namespace

std::vector<Run> views_from_door(PromptReading& reading) {
  std::vector<Run> views;
  for (std::uint32_t i = 0; i < reading.text.plain.size(); ++i) {
    const auto end = behind_entering(reading, i);
    if (end == i) continue;
    views.push_back({with_subject(reading, i), end});
    hear(reading.brief, views.back(), Heard::As::room);
  }
  return views;
}

bool tells_sides_from_door(const PromptReading& reading) {
  static const WordSet sides = {"left", "right", "back", "rear", "far", "front"},
                       parts = {"wall", "walls", "side", "corner", "corners", "half", "third", "part"};
  constexpr std::uint32_t farthest = 2;  // "left hand side"
  for (std::uint32_t i = 0; i < reading.text.plain.size(); ++i) {
    if (!sides.count(reading.word(i))) continue;
    for (auto next = i + 1; next <= i + farthest && next < reading.text.plain.size(); ++next)
      if (parts.count(reading.word(next))) return true;
  }
  return false;
}

std::string half_at(int wall) {
  return wall == left_wall ? "west-half" : "east-half";
}

}  // namespace roomgen::brief
