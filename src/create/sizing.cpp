#include "sizing.h"

#include <algorithm>
#include <cmath>

#include "relative_size.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

constexpr double size_variation = 0.05;  // of the usual size, either way
constexpr double longish = 2.2;  // times as wide as deep: nobody means a square by "round"

const shape::Parameter* find(const std::vector<shape::Parameter>& parameters, const std::string& name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const auto& parameter) { return parameter.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

std::optional<double> number_in(const shape::Value& value) {
  if (const double* number = std::get_if<double>(&value)) return *number;
  return std::nullopt;
}

class Sizer {
 public:
  Sizer(const Description& description, const ShapeKind& kind,
        const std::vector<shape::Parameter>& parameters, const shape::Values& values)
      : description_(description), kind_(kind), parameters_(parameters), values_(values),
        said_(said_size(description, &kind)) {}

  Sizing run(Random random) {
    const Vec3 growth = growth_of_counts();
    const double blown_up = exaggeration();
    for (int axis = 0; axis < 3; ++axis) {
      double side = kind_.size[axis] * random.uniform(1 - size_variation, 1 + size_variation);
      side = (side + growth[axis]) * description_.scale[axis];
      side = blown_up * std::clamp(side, kind_.least[axis], kind_.most[axis]);
      if (is_said(axis)) side = std::clamp((*said_)[axis], least_side, greatest_side);
      result_.size[axis] = within_parameter(std::round(side * 1000) / 1000, axis);
    }
    square_up();
    square_up_on_wall();
    return std::move(result_);
  }

 private:
  bool is_said(int axis) const { return said_ && !std::isnan((*said_)[axis]); }

  // How many of something the kind has, and how many it usually has.
  std::optional<double> count_now(const std::string& name) const {
    if (name == "people") {
      const auto people = read_relative_size(description_.prompt).people;
      return people ? std::optional<double>(*people) : std::nullopt;
    }
    if (const auto set = values_.find(name); set != values_.end()) return number_in(set->second);
    const auto* parameter = find(parameters_, name);
    return parameter ? number_in(parameter->value) : std::nullopt;
  }

  // More doors need a wider thing, more drawers above each other a taller one.
  Vec3 growth_of_counts() const {
    Vec3 growth = Vec3::Zero();
    for (const auto& [name, each] : kind_.growth)
      if (const auto count = count_now(name)) growth += (*count - each.usual) * each.each;
    return growth;
  }

  // Small things that are asked for in the size of a child grow all over, while a table that is twice
  // as long is no higher for it.
  double exaggeration() const {
    if (kind_.mount != Mount::surface) return 1.0;
    double times = 1.0;
    for (int axis = 0; axis < 3; ++axis)
      if (is_said(axis) && (*said_)[axis] > kind_.most[axis])
        times = std::max(times, std::sqrt((*said_)[axis] / kind_.most[axis] * (*said_)[axis] / kind_.size[axis]));
    return times;
  }

  double within_parameter(double side, int axis) {
    const auto* parameter = find(parameters_, axes[axis]);
    if (!parameter) return side;
    const double kept = std::clamp(side, parameter->min, parameter->max);
    if (std::abs(kept - side) > 1e-9)
      result_.notes.push_back(std::string(axes[axis]) + " " + format_number(side) + " m was brought to " +
                              format_number(kept) + " m, as far as a " + kind_.name + " goes");
    return kept;
  }

  // What is round or square is as deep as it is wide.
  void square_up() {
    if (is_said(0) && is_said(1)) return;
    for (const auto& part : description_.parts) {
      const bool outer = part.label.empty() || part.label == "top" || part.label == "seat" ||
                         part.label == "shade" || (part.label == "shelf" && find(parameters_, "shelf_shape"));
      if (!outer || (part.shape != "round" && part.shape != "square" && part.shape != "globe")) continue;
      if (kind_.size.x() > longish * kind_.size.y()) continue;
      const double side = is_said(0)   ? result_.size.x()
                          : is_said(1) ? result_.size.y()
                                       : std::sqrt(result_.size.x() * result_.size.y());
      result_.size.x() = result_.size.y() = std::round(side * 1000) / 1000;
    }
  }

  // The outline of a mirror is seen from the front.
  void square_up_on_wall() {
    if (is_said(2) || !find(parameters_, "frame_shape")) return;
    for (const auto& part : description_.parts) {
      const bool even = part.shape == "round" || part.shape == "square" || part.shape == "octagonal";
      if (even) result_.size.z() = result_.size.x();
      if (part.shape == "hexagonal") result_.size.z() = std::round(result_.size.x() * 866.0) / 1000;
    }
  }

  const Description& description_;
  const ShapeKind& kind_;
  const std::vector<shape::Parameter>& parameters_;
  const shape::Values& values_;
  const std::optional<Vec3> said_;
  Sizing result_;
};

}  // namespace

Sizing choose_size(const Description& description, const ShapeKind& kind,
                   const std::vector<shape::Parameter>& parameters, const shape::Values& values,
                   Random random) {
  return Sizer(description, kind, parameters, values).run(std::move(random));
}

}  // namespace roomgen::create
