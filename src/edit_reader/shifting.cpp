#include <algorithm>

#include "brief/placement_phrase.h"
#include "destinations.h"
#include "language/measure.h"

namespace roomgen {

namespace {

bool hang(const EditText& text, const std::vector<std::string>& ids) {
  return !ids.empty() && std::all_of(ids.begin(), ids.end(), [&](const std::string& id) {
    const Object* object = text.object(id);
    return object && (object->mount == Mount::wall || object->mount == Mount::ceiling);
  });
}

// "the desk", "the filing cabinets", "the wall"
std::optional<Result<Read<std::vector<std::string>>>> ends_of_way(const EditText& text, std::size_t at,
                                                                  const std::vector<std::string>& subjects) {
  const auto place = place_named_at(text, at);
  if (place && place->place == brief::Place::wall && place->wall < 0 && !place->opposite)
    return Read<std::vector<std::string>>{{nearest_of_walls}, at + place->length};
  const auto thing = named_thing_at(text, at);
  const auto one = target_at(text, at, subjects);
  if (!one) return std::nullopt;
  if (*one) return Read<std::vector<std::string>>{{(*one)->id}, (*one)->end};
  if (!thing || (place && at + place->length >= thing->end)) return one->error();
  return targets_of(text, *thing, subjects);
}

std::size_t skip_further(const EditText& text, std::size_t at) {
  return at + longest_in(text.edits.further_on, text.tokens, at);
}

bool amount_behind(const EditText& text, std::size_t at) { return amount_at(text, at).has_value(); }

}  // namespace

std::optional<double> amount_at(const EditText& text, std::size_t& at) {
  std::size_t from = at;
  if (text.is_word(from, "by") || text.is_word(from, "about") || text.is_word(from, "maybe")) ++from;
  if (const auto measure = language::measure_at(text.raw, from);
      measure && measure->kind == language::Measure::Kind::length && measure->has_unit) {
    at = from + measure->length;
    return measure->values[0];
  }
  if (const auto vague = longest(text.edits.amounts, text.tokens, from)) {
    at = from + vague.length;
    return *vague.value;
  }
  return std::nullopt;
}

std::optional<Result<Shifting>> shifting_at(const EditText& text, std::size_t at,
                                            const std::vector<std::string>& subjects) {
  Shifting shifting;
  if (text.is_word(at, "out") || text.is_word(at, "over")) ++at;
  shifting.metres = amount_at(text, at);
  const std::size_t away = longest_in(text.edits.away, text.tokens, at);
  const std::size_t closer = longest_in(text.edits.closer, text.tokens, at);
  if (std::max(away, closer) == 0) at = skip_further(text, at);
  const auto height = longest(text.edits.heights, text.tokens, at);
  const auto direction = longest(text.edits.directions, text.tokens, at);
  const auto own = longest(text.edits.own_ways, text.tokens, at);
  const bool is_own = own && (shifting.metres || amount_behind(text, at + own.length) || *own.value > 0.0) &&
                      std::max(away, closer) < own.length;
  const bool is_height =
      height && (shifting.metres || hang(text, subjects)) && (subjects.empty() || hang(text, subjects));
  if (is_height) {
    shifting.direction = Vec3(0, 0, *height.value);
    at += height.length;
  } else if (is_own) {
    shifting.forward = *own.value;
    at += own.length;
  } else if (direction && direction.length >= std::max(away, closer)) {
    // "to the left of the bed" is a place.
    if (text.is_word(at + direction.length, "of")) return std::nullopt;
    shifting.direction = Vec3(direction.value->x(), direction.value->y(), 0.0);
    at += direction.length;
  } else if (away > 0 || closer > 0) {
    const auto target = ends_of_way(text, at + std::max(away, closer), subjects);
    if (!target) return std::nullopt;
    if (!*target) return target->error();
    (away >= closer && away > 0 ? shifting.from : shifting.towards) = (*target)->value;
    at = (*target)->end;
  } else {
    return std::nullopt;
  }
  if (!shifting.metres) shifting.metres = amount_at(text, at);
  shifting.end = skip_further(text, at);
  return shifting;
}

}  // namespace roomgen
