#include "stated_size.h"

#include <algorithm>
#include <string>
#include <vector>

namespace roomgen {

namespace {

using SaidLength = language::Measure;

constexpr double size_tolerance = 0.1;  // of a length that was said

bool agrees(double have, double stated, StatedSize::Bound bound) {
  const bool small_enough = have <= (1.0 + size_tolerance) * stated;
  const bool large_enough = have >= (1.0 - size_tolerance) * stated;
  if (bound == StatedSize::Bound::at_most) return small_enough;
  return large_enough && (small_enough || bound == StatedSize::Bound::at_least);
}

// The sides that a length may be said of.
std::vector<double> sides_of(SaidLength::Side side, const Vec3& size) {
  const double longer = std::max(size.x(), size.y()), shorter = std::min(size.x(), size.y());
  switch (side) {
    case SaidLength::Side::length:
    case SaidLength::Side::diameter:
      return {longer, std::max(longer, size.z())};
    case SaidLength::Side::width:
      return {size.x(), size.y()};
    case SaidLength::Side::depth:
      return {size.y(), size.x()};
    case SaidLength::Side::height:
      return {size.z()};
    case SaidLength::Side::thickness:
      return {size.minCoeff()};
    default:
      return {longer, shorter, size.z(), std::hypot(size.x(), size.z())};
  }
}

bool has_sides(const StatedSize& stated, std::vector<double> have) {
  std::vector<double> want(stated.measure.values, stated.measure.values + have.size());
  std::sort(have.begin(), have.end());
  std::sort(want.begin(), want.end());
  return std::equal(have.begin(), have.end(), want.begin(),
                    [&](double a, double b) { return agrees(a, b, stated.bound); });
}

StatedSize::Bound bound_before(const std::vector<language::Token>& tokens, std::size_t at) {
  std::string before;
  for (std::size_t i = 0; i < at; ++i) before += tokens[i].text + " ";
  for (const char* words : {"at most", "no taller than", "no more than", "no wider than", "maximum", "max", "under", "below", "up to"})
    if (before.find(words) != std::string::npos) return StatedSize::Bound::at_most;
  for (const char* words : {"at least", "no less than", "minimum", "min", "over", "more than"})
    if (before.find(words) != std::string::npos) return StatedSize::Bound::at_least;
  return StatedSize::Bound::about;
}

}  // namespace

std::optional<StatedSize> read_stated_size(std::string_view text) {
  std::string spaced(text);
  std::replace(spaced.begin(), spaced.end(), '_', ' ');
  const auto tokens = language::tokenize(spaced);
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    auto measure = language::measure_at(tokens, at);
    if (!measure || measure->kind == SaidLength::Kind::area || !measure->has_unit) continue;
    // "a 90 cm diameter": the side may stand behind it without "in".
    const std::size_t next = at + measure->length;
    if (measure->side == SaidLength::Side::unsaid && next < tokens.size() &&
        (tokens[next].is("diameter") || tokens[next].is("across")))
      measure->side = SaidLength::Side::diameter;
    return StatedSize{*measure, bound_before(tokens, at)};
  }
  return std::nullopt;
}

bool has_size(const StatedSize& stated, const Vec3& size) {
  const SaidLength& measure = stated.measure;
  const auto single = [&](double value, StatedSize::Bound bound) {
    const auto sides = sides_of(measure.side, size);
    return std::any_of(sides.begin(), sides.end(), [&](double side) { return agrees(side, value, bound); });
  };
  if (measure.kind == SaidLength::Kind::range)
    return single(measure.values[0], StatedSize::Bound::at_least) &&
           single(measure.values[1], StatedSize::Bound::at_most);
  if (measure.kind == SaidLength::Kind::length || measure.count == 1) return single(measure.values[0], stated.bound);
  if (measure.count == 3) return has_sides(stated, {size.x(), size.y(), size.z()});
  return has_sides(stated, {size.x(), size.y()}) ||
         (size.z() > size.y() && has_sides(stated, {size.x(), size.z()}));
}

}  // namespace roomgen
