#include <algorithm>

#include "language/number.h"
#include "phrase_text.h"

namespace roomgen::create {

const Placement* placement_at(const PhraseText& text, std::size_t at, const Words& words) {
  const auto found =
      std::find_if(words.placements.begin(), words.placements.end(),
                   [&](const Placement& placement) { return text.starts(at, placement.words); });
  return found == words.placements.end() ? nullptr : &*found;
}

void place_before(const Placement& placement, PartWish& part) {
  if (placement.before) part.place = placement.before;
  // "drawers, three on each side"
  if (placement.each > 1) part.count = placement.each * part.count.value_or(1);
  if (placement.series.scale != 1.0) part.series.scale = placement.series.scale;
  if (placement.series.turn > 0) part.series.turn = placement.series.turn;
}

void place_after(const Placement& placement, PartWish& part) {
  const PartForm form = built_in_parts()->of(part.label, 1);
  if (placement.gone) part.count = 0;
  if (placement.after) part.place = placement.after;
  // Rings around a ball: it is no column.
  if (placement.after == Place::column && form.same == "xyz") part.place.reset();
  if (!placement.below) return;
  // What carries by nature does so in its own way.
  const bool carries = form.place == Place::foot || form.place == Place::base ||
                       form.place == Place::column || form.place == Place::upright;
  if (!carries) part.place = Place::foot;
}

Place place_of(const std::string& relation) {
  if (relation == "on") return Place::top;
  if (relation == "under") return Place::base;
  if (relation == "behind") return Place::back;
  return relation == "in front of" ? Place::front : Place::side;
}

double read_turn(const PhraseText& text, std::size_t& at) {
  const auto number = language::number_at(text.parse().tokens, at);
  if (!number || !text[at + number->length].starts_with("degree")) return 0.0;
  at += number->length + 1;
  return radians(std::min(number->value, 180.0));
}

}  // namespace roomgen::create
