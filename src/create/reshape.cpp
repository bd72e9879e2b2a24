#include "reshape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "parts.h"
#include "roomgen/shape/evaluate.h"

namespace roomgen::create {

namespace {

using shape::Component;

constexpr int most_of_part = 200;

bool stands_on_floor(const std::string& label) {
  return label == "leg" || label == "foot" || label == "wheel" || label == "post" || label == "pole";
}

/// Width, depth and height of a solid that stands straight, and its radius if it is round.
struct Bar {
  Vec3 size;
  bool round;
};

std::optional<Bar> bar_of(const shape::Solid& solid) {
  if (const auto* box = std::get_if<shape::Box>(&solid)) return Bar{box->size, false};
  if (const auto* frustum = std::get_if<shape::Frustum>(&solid)) {
    const double across = frustum->bottom_radius + frustum->top_radius;
    return Bar{{across, across, frustum->height}, true};
  }
  if (const auto* prism = std::get_if<shape::Prism>(&solid)) {
    const double across = prism->bottom_radius + prism->top_radius;
    return Bar{{across, across, prism->height}, false};
  }
  if (const auto* plane = std::get_if<shape::Plane>(&solid))
    return Bar{{plane->size.x(), plane->size.y(), plane->thickness}, false};
  if (const auto* loft = std::get_if<shape::LoftedPart>(&solid)) {
    Vec2 size = Vec2::Zero();
    for (const auto& level : loft->levels) {
      const auto* rounded = std::get_if<shape::RoundedSize>(&level.outline);
      if (!rounded) return std::nullopt;
      size = size.cwiseMax(rounded->size);
    }
    if (loft->levels.empty() || std::abs(loft->levels.front().z) > 0.01) return std::nullopt;
    return Bar{{size.x(), size.y(), loft->levels.back().z}, false};
  }
  return std::nullopt;
}

double amount(Strength strength) {
  return strength == Strength::gentle ? 0.06 : strength == Strength::moderate ? 0.12 : 0.2;
}

Eigen::Matrix3d rotation(const Vec3& angles) {
  return (Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
          Eigen::AngleAxisd(angles.x(), Vec3::UnitX()))
      .toRotationMatrix();
}

// About X, then Y, then Z.
Vec3 angles_of(const Eigen::Matrix3d& m) {
  const double y = std::asin(std::clamp(-m(2, 0), -1.0, 1.0));
  return {std::atan2(m(2, 1), m(2, 2)), y, std::atan2(m(1, 0), m(0, 0))};
}

Vec2 outward(const Component& component) {
  const Vec2 at = component.at.head<2>();
  return at.norm() < 1e-4 ? Vec2(0, -1) : Vec2(at.normalized());
}

// Sideways from a straight line, at a share t of the length; ends stay where they are.
double offset(Course course, double t) {
  switch (course) {
    case Course::arc:
      return std::sin(pi * t);
    case Course::s_curve:
      return std::sin(2 * pi * t);
    case Course::wave:
      return 0.5 * std::sin(6 * pi * t);
    default:
      return 0.0;
  }
}

shape::Curve<Vec3> upright_path(double height, double sideways, const Vec2& direction, Course course,
                                Strength strength) {
  shape::Curve<Vec3> path;
  const int steps = course == Course::spiral ? 32 : course == Course::wave ? 18 : 8;
  const double turns = strength == Strength::gentle ? 1 : strength == Strength::moderate ? 2 : 3;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    Vec2 aside = offset(course, t) * sideways * direction;
    // A helix that begins and ends on the axis.
    if (course == Course::spiral)
      aside = 0.5 * sideways * std::sin(pi * t) *
              Vec2(std::cos(2 * pi * turns * t), std::sin(2 * pi * turns * t));
    path.points.emplace_back(aside.x(), aside.y(), height * t);
  }
  return path;
}

void bend_upright(Component& component, const Bar& bar, Course course, Strength strength) {
  const Eigen::Matrix3d turn = rotation(component.rotate);
  const Vec2 out = outward(component);
  const Vec3 local = turn.transpose() * Vec3(out.x(), out.y(), 0);
  shape::SweptPart swept;
  swept.path = upright_path(bar.size.z(), amount(strength) * bar.size.z(),
                            local.head<2>().norm() < 1e-6 ? Vec2(0, -1)
                                                          : Vec2(local.head<2>().normalized()),
                            course, strength);
  const Vec2 across = bar.size.head<2>();
  if (bar.round) swept.section = shape::Disc{0.25 * across.sum()};
  else swept.section = shape::Rectangle{across, 0.15 * across.minCoeff()};
  component.solid = std::move(swept);
}

// A board that is wider than high or deep: bent backwards in its middle, as seen from above.
void bend_board(Component& component, const Bar& bar, Course course, Strength strength) {
  shape::SweptPart swept;
  const int steps = course == Course::wave ? 18 : 8;
  const double sideways = amount(strength) * bar.size.x();
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    swept.path.points.emplace_back(bar.size.x() * (t - 0.5), sideways * offset(course, t),
                                   0.5 * bar.size.z());
  }
  const double thick = std::min(bar.size.y(), bar.size.z());
  swept.section = shape::Rectangle{{bar.size.y(), bar.size.z()}, 0.2 * thick};
  component.solid = std::move(swept);
}

// A board that lies: its middle goes up and down along its length.
void bend_flat(Component& component, const Bar& bar, Course course, Strength strength) {
  shape::SweptPart swept;
  const int steps = course == Course::wave ? 36 : 12;
  const double upward = 0.6 * amount(strength) * std::min(bar.size.x(), 3 * bar.size.y());
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    swept.path.points.emplace_back(bar.size.x() * (t - 0.5), 0,
                                   0.5 * bar.size.z() + upward * offset(course, t));
  }
  swept.section = shape::Rectangle{{bar.size.y(), bar.size.z()}, 0.2 * bar.size.z()};
  component.solid = std::move(swept);
}

std::string add_surface(shape::Program& program, const std::string& base, shape::Surface surface) {
  surface.name = base;
  const auto taken = [&](const std::string& name) {
    return std::any_of(program.materials.begin(), program.materials.end(),
                       [&](const auto& other) { return other.name == name; });
  };
  for (int i = 2; taken(surface.name); ++i) surface.name = base + "-" + std::to_string(i);
  program.materials.push_back(surface);
  return surface.name;
}

shape::Surface painted(shape::Surface surface, const std::string& material, const std::string& color,
                       const Words& words) {
  if (const auto found = words.materials.find(material); found != words.materials.end()) {
    const std::string own = surface.name;
    surface = found->second;
    surface.name = own;
  }
  if (!color.empty()) surface.color = color;
  surface.second.clear();
  return surface;
}

}  // namespace

bool set_count(shape::Program& program, const std::string& label, int count) {
  if (count < 0 || count > most_of_part) return false;
  if (count == 0) {
    filter_wholes(program, label, [](Component&) { return false; });
    prune_connections(program);
    return true;
  }
  std::vector<Component> wholes;
  filter_wholes(program, label, [&](Component& component) {
    wholes.push_back(component);
    return true;
  });
  if (wholes.empty()) return false;
  const bool has_array =
      wholes.size() == 1 && std::any_of(wholes[0].operations.begin(), wholes[0].operations.end(),
                                        [](const auto& operation) {
                                          return std::holds_alternative<shape::Array>(operation);
                                        });
  if (!has_array && !stands_on_floor(label)) {
    // Of single ones as many as there are to spare go.
    if (count > static_cast<int>(wholes.size())) return false;
    int kept = 0;
    filter_wholes(program, label, [&](Component&) { return kept++ < count; });
    prune_connections(program);
    return count_parts(program, label) == count;
  }
  bool first = true;
  filter_wholes(program, label, [&](Component& component) {
    if (!first) return false;
    first = false;
    if (has_array) {
      for (auto& operation : component.operations)
        if (auto* array = std::get_if<shape::Array>(&operation)) {
          if (count > 1 && array->count > 1) array->step *= (array->count - 1.0) / (count - 1.0);
          array->count = count;
        }
      return true;
    }
    std::erase_if(component.operations, [](const auto& operation) {
      return !std::holds_alternative<shape::Cut>(operation);
    });
    if (count == 1) {
      component.at.head<2>().setZero();
      component.rotate.setZero();
    } else {
      // One leg at the back of a thing with three, as on most of them.
      const double start = std::atan2(component.at.y(), component.at.x());
      component.operations.push_back(
          shape::Radial{count, Vec2::Zero(), 2 * pi, (count % 2 ? pi / 2 : pi / count) - start});
    }
    return true;
  });
  prune_connections(program);
  return true;
}

void lean(shape::Program& program, const std::string& label, double angle) {
  filter_wholes(program, label, [&](Component& component) {
    shape::Program alone;
    alone.materials = program.materials;
    alone.components = {component};
    alone.components[0].operations.clear();
    const auto shape = shape::evaluate(alone, shape::for_measuring);
    if (!shape || component.at.head<2>().norm() < 1e-4) return true;
    const Bounds3 box = bounds(*shape);
    const Vec3 top(component.at.x(), component.at.y(), box.high.z());
    const Vec2 out = outward(component);
    // Feet go outward when the top of a vertical leg would go inward: a turn about the tangent.
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(-radians(angle), Vec3(-out.y(), out.x(), 0)).toRotationMatrix();
    component.rotate = angles_of(turn * rotation(component.rotate));
    component.scale.z() /= std::cos(radians(angle));
    component.at = top + turn * (component.at - top) / std::cos(radians(angle));
    return true;
  });
}

void bend(shape::Program& program, const std::string& label, Course course, Strength strength) {
  if (course == Course::straight || course == Course::taper) return;
  for_each_part(program, label, [&](Component& component) {
    const auto bar = bar_of(component.solid);
    if (!bar) return;
    if (bar->size.z() > 1.2 * bar->size.head<2>().maxCoeff())
      bend_upright(component, *bar, course, strength);
    else if (bar->size.x() > 2.0 * bar->size.y() && bar->size.z() > bar->size.y())
      bend_board(component, *bar, course, strength);
    else if (label == "shelf" && bar->size.x() > 2.0 * bar->size.y())
      bend_board(component, *bar, course, strength);
    else if (bar->size.x() > 1.5 * bar->size.y() && bar->size.z() < 0.4 * bar->size.y())
      bend_flat(component, *bar, course, strength);
  });
}

void set_outline(shape::Program& program, const std::string& label, const std::string& shape) {
  for_each_part(program, label, [&](Component& component) {
    const auto bar = bar_of(component.solid);
    if (!bar || bar->size.z() > bar->size.head<2>().minCoeff()) return;
    const double w = bar->size.x(), d = bar->size.y(), h = bar->size.z();
    const double bevel = std::min(0.25 * h, 0.006);
    const auto prism = [&](int sides) {
      const double radius = 0.5 * w / std::cos(pi / sides);
      component.solid = shape::Prism{sides, radius, radius, h};
      component.scale.y() *= d / w;
    };
    if (shape == "round" || shape == "oval") {
      component.solid = shape::Frustum{0.5 * w, 0.5 * w, h, bevel};
      component.scale.y() *= d / w;
    } else if (shape == "hexagonal") {
      prism(6);
    } else if (shape == "octagonal") {
      prism(8);
    } else if (shape == "triangular") {
      prism(3);
    } else if ((shape == "square" || shape == "rectangular") && bar->round) {
      component.solid = shape::Box{{w, d, h}, bevel};
    }
  });
}

void scale(shape::Program& program, const std::string& label, const Vec3& factors) {
  for_each_part(program, label,
                [&](Component& component) { component.scale = component.scale.cwiseProduct(factors); });
}

void resize(shape::Program& program, const std::string& label, const Vec3& size) {
  const Vec3 now = part_size(program, label);
  Vec3 factors = Vec3::Ones();
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isnan(size[axis]) && now[axis] > 1e-4) factors[axis] = size[axis] / now[axis];
  scale(program, label, factors);
}

void paint(shape::Program& program, const std::string& label, const std::string& material,
           const std::string& color, const Words& words) {
  std::map<std::string, std::string> repainted;  // each surface once
  std::vector<Component*> parts;
  for_each_part(program, label, [&](Component& component) { parts.push_back(&component); });
  for (Component* part : parts) {
    const auto known = repainted.find(part->material);
    if (known != repainted.end()) {
      part->material = known->second;
      continue;
    }
    shape::Surface surface;
    for (const auto& own : program.materials)
      if (own.name == part->material) surface = own;
    const std::string name =
        add_surface(program, label + "-" + (material.empty() ? "paint" : "material"),
                    painted(surface, material, color, words));
    repainted[part->material] = name;
    part->material = name;
  }
}

void paint_surfaces(shape::Program& program, const std::vector<std::string>& surfaces,
                    const std::string& material, const std::string& color, const Words& words) {
  for (auto& surface : program.materials)
    if (std::find(surfaces.begin(), surfaces.end(), surface.name) != surfaces.end())
      surface = painted(surface, material, color, words);
}

}  // namespace roomgen::create
