#include <cmath>

#include "phrase_text.h"

namespace roomgen::create {

using language::Measure;
using Side = Measure::Side;

namespace {

int axis_of(Side side) {
  return side == Side::height ? 2 : side == Side::depth ? 1 : 0;
}

void set_thickness(PartWish& part, double thickness) {
  const Place place = built_in_parts()->of(part.label, 1).place;
  if (place == Place::foot || place == Place::column || place == Place::upright)
    part.size->head<2>().setConstant(thickness);
  else
    (*part.size)[place == Place::back || place == Place::front ? 1 : 2] = thickness;
}

}  // namespace

std::optional<Measure> read_measure(const PhraseText& text, std::size_t at) {
  auto measure = language::measure_at(text.parse().tokens, at);
  if (!measure || !measure->has_unit || measure->kind == Measure::Kind::area) return std::nullopt;
  if (at > 0 && measure->side == Side::unsaid) {
    const std::string& before = text[text.is(at - 1, "of") && at > 1 ? at - 2 : at - 1];
    if (before == "height") measure->side = Side::height;
    if (before == "depth") measure->side = Side::depth;
    if (before == "thickness") measure->side = Side::thickness;
  }
  return measure;
}

Vec3 sides(const Measure& measure) {
  Vec3 result = Vec3::Constant(std::nan(""));
  if (measure.kind != Measure::Kind::sides) {
    const bool is_range = measure.kind == Measure::Kind::range;
    result[axis_of(measure.side)] =
        is_range ? (measure.values[0] + measure.values[1]) / 2 : measure.values[0];
    return result;
  }
  for (int i = 0; i < std::min(measure.count, 3); ++i) result[i] = measure.values[i];
  return result;
}

void apply(const Measure& measure, PartWish& part) {
  if (!part.size) part.size = Vec3::Constant(std::nan(""));
  if (measure.side == Side::thickness) return set_thickness(part, measure.values[0]);
  const Vec3 said = sides(measure);
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isnan(said[axis])) (*part.size)[axis] = said[axis];
}

}  // namespace roomgen::create
