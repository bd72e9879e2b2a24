#include "phrase_measure.h"

#include <cmath>

#include "language/small_words.h"
#include "part_forms.h"

namespace roomgen::create {

namespace {

constexpr std::size_t most_lengths = 3;

// Which side is the first of these lengths: the word after them says it, which is passed over, or the
// one before ("height 50 cm").
int axis_of(const PhraseText& text, std::size_t begin, Measure& measure) {
  const std::size_t after = measure.end++;
  if (text.is(after, {"wide", "width", "long", "length", "diameter", "across"})) return 0;
  if (text.is(after, {"deep", "depth"})) return 1;
  if (text.is(after, {"tall", "high", "height"})) return 2;
  measure.end = after;
  if (measure.lengths.size() > 1 || begin == 0) return 0;
  if (text.is(begin - 1, {"height"})) return 2;
  return text.is(begin - 1, {"depth"}) ? 1 : 0;
}

void set_thickness(PartWish& part, double thickness) {
  const Place place = built_in_parts()->of(part.label, 1).place;
  if (place == Place::foot || place == Place::column || place == Place::upright)
    part.size->head<2>().setConstant(thickness);
  else
    (*part.size)[place == Place::back || place == Place::front ? 1 : 2] = thickness;
}

}  // namespace

std::optional<Measure> read_measure(const PhraseText& text, std::size_t begin) {
  const auto& units = language::small_words().lengths;
  Measure measure;
  double unit = 0.0;
  for (std::size_t at = begin; measure.lengths.size() < most_lengths; ++at) {
    const auto number = text.number(at);
    if (!number) break;
    measure.lengths.push_back(*number);
    measure.end = ++at;
    if (at < text.size())
      if (const auto found = units.find(text[at]); found != units.end())
        unit = found->second, measure.end = ++at;
    if (at + 1 >= text.size() || !text.is(at, {"x", "by"})) break;
  }
  if (measure.lengths.empty() || unit == 0.0) return std::nullopt;
  for (double& length : measure.lengths) length *= unit;
  measure.axis = axis_of(text, begin, measure);
  measure.thick = text.is(measure.end, {"thick", "thickness"});
  if (measure.thick) ++measure.end;
  return measure;
}

Vec3 sides(const Measure& measure) {
  Vec3 result = Vec3::Constant(std::nan(""));
  for (std::size_t i = 0; i < measure.lengths.size(); ++i)
    if (const auto axis = measure.axis + static_cast<Eigen::Index>(i); axis < 3)
      result[axis] = measure.lengths[i];
  return result;
}

void apply(const Measure& measure, PartWish& part) {
  if (!part.size) part.size = Vec3::Constant(std::nan(""));
  if (measure.thick) return set_thickness(part, measure.lengths.front());
  const Vec3 said = sides(measure);
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isnan(said[axis])) (*part.size)[axis] = said[axis];
}

}  // namespace roomgen::create
