#include <algorithm>
#include <cmath>
#include <map>

#include "learned_unit.h"

namespace roomgen::book {

namespace {

constexpr double same_line = 0.10;   ///< metres within which middles are in line
constexpr double same_step = 0.08;   ///< by which steps may differ
constexpr double same_place = 0.20;  ///< within which members of two copies are the same
constexpr double most_other = 0.25;  ///< of the members that need not be the same
constexpr int least_number = 3;

bool is_of_floor(const Object& object) {
  return object.mount == Mount::floor && !object.traits.flat;
}

Vec2 middle_in(const Object& thing, const Object& frame) {
  return rotated(thing.position.head<2>() - frame.position.head<2>(), -frame.yaw);
}

/// The middles of equal steps: of so many numbers, so far apart.
struct Steps {
  int number = 1;
  double step = 0.0;
};

std::optional<Steps> steps_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::vector<double> lines;
  for (const double value : values)
    if (lines.empty() || value > lines.back() + same_line) lines.push_back(value);
  Steps steps{static_cast<int>(lines.size()), 0.0};
  if (steps.number < 2) return steps;
  steps.step = (lines.back() - lines.front()) / (steps.number - 1);
  for (int i = 0; i < steps.number; ++i)
    if (std::abs(lines[static_cast<std::size_t>(i)] - lines.front() - i * steps.step) > same_step)
      return std::nullopt;
  return steps;
}

bool are_alike(const Unit& a, const Unit& b) {
  const Object &first = a.anchor(), &other = b.anchor();
  if (first.category != other.category || (first.size - other.size).cwiseAbs().maxCoeff() > 0.05 ||
      std::abs(std::sin(0.5 * (first.yaw - other.yaw))) > 0.02 || !is_of_floor(first))
    return false;
  int missing = 0, number = 0, others = 0;
  for (const Object* thing : a.things) {
    if (!is_of_floor(*thing)) continue;
    ++number;
    const Vec2 place = middle_in(*thing, first);
    missing += std::none_of(b.things.begin(), b.things.end(), [&](const Object* one) {
      return one->category == thing->category &&
             (middle_in(*one, other) - place).norm() < same_place;
    });
  }
  for (const Object* thing : b.things) others += is_of_floor(*thing);
  return number > 1 && missing <= most_other * number &&
         std::abs(number - others) <= most_other * number;
}

// In the frame of the first of them; nothing: they fill no rows and columns.
std::optional<Unit> grid_of(const std::vector<const Unit*>& alike) {
  if (static_cast<int>(alike.size()) < 2) return std::nullopt;
  const Object& frame = alike.front()->anchor();
  std::vector<double> xs, ys;
  for (const Unit* unit : alike) {
    const Vec2 place = middle_in(unit->anchor(), frame);
    xs.push_back(place.x()), ys.push_back(place.y());
  }
  const auto columns = steps_of(xs), rows = steps_of(ys);
  if (!columns || !rows || columns->number * rows->number != static_cast<int>(alike.size()))
    return std::nullopt;
  const Unit& fullest = **std::max_element(
      alike.begin(), alike.end(),
      [](const Unit* a, const Unit* b) { return a->things.size() < b->things.size(); });
  Unit grid = fullest;
  grid.grid = {rows->number, columns->number, columns->step, rows->step};
  grid.id = frame.group.empty() ? frame.id : frame.group.substr(0, frame.group.find('#'));
  const Vec2 first(*std::min_element(xs.begin(), xs.end()),
                   *std::min_element(ys.begin(), ys.end()));
  grid.at = frame.position.head<2>() + rotated(first, frame.yaw);
  for (const Unit* unit : alike) grid.box.add(unit->box.low), grid.box.add(unit->box.high);
  return grid;
}

bool is_copied(const Unit& unit) {
  return unit.anchor().group.find('#') != std::string::npos;
}

}  // namespace

std::vector<Unit> in_grids(std::vector<Unit> units) {
  std::vector<Unit> found;
  std::vector<bool> is_taken(units.size(), false);
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (is_taken[i]) continue;
    std::vector<const Unit*> alike;
    std::vector<std::size_t> which;
    for (std::size_t j = i; j < units.size(); ++j)
      if (!is_taken[j] && (j == i || are_alike(units[i], units[j])))
        alike.push_back(&units[j]), which.push_back(j);
    const bool is_enough = static_cast<int>(alike.size()) >= least_number || is_copied(units[i]);
    auto grid = is_enough ? grid_of(alike) : std::nullopt;
    if (!grid) which = {i};
    for (const std::size_t j : which) is_taken[j] = true;
    found.push_back(grid ? *std::move(grid) : std::move(units[i]));
  }
  return found;
}

}  // namespace roomgen::book
