#include "assemble.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>

namespace roomgen::create {

namespace {

using shape::Component;

constexpr double joint = 0.003;  // how deep parts sink into each other, metres

/// Where a part of a thing usually is.
enum class Zone { foot, body, top, back, side, front, above };

std::optional<Zone> zone_of(std::string_view label) {
  static const std::map<std::string_view, Zone> zones = {
      {"leg", Zone::foot},    {"foot", Zone::foot},   {"wheel", Zone::foot},   {"base", Zone::foot},
      {"pole", Zone::foot},   {"post", Zone::foot},   {"seat", Zone::top},     {"top", Zone::top},
      {"tray", Zone::top},    {"cushion", Zone::above}, {"pillow", Zone::above},
      {"back", Zone::back},   {"headboard", Zone::back}, {"mirror", Zone::back}, {"headrest", Zone::back},
      {"screen", Zone::back}, {"armrest", Zone::side}, {"arm", Zone::side},    {"handle", Zone::front},
      {"wing", Zone::side},   {"hook", Zone::front},  {"drawer", Zone::front}, {"door", Zone::front},
      {"footrest", Zone::front}, {"shelf", Zone::body}, {"basket", Zone::body}, {"compartment", Zone::body},
      {"shade", Zone::above}, {"bulb", Zone::above},  {"lid", Zone::above},    {"ring", Zone::above},
      {"flower", Zone::above}, {"leaf", Zone::above}, {"candle", Zone::above}, {"spout", Zone::side},
      {"ball", Zone::above},  {"canopy", Zone::above}};
  const auto found = zones.find(label);
  if (found == zones.end()) return std::nullopt;
  return found->second;
}

Component part(const std::string& label, shape::Solid solid, const Vec3& at,
               const std::string& material = "body") {
  Component component;
  component.name = label;
  component.label = label;
  component.material = material;
  component.solid = std::move(solid);
  component.at = at;
  return component;
}

std::string free_name(const shape::Program& program, const std::string& wanted) {
  std::string name = wanted;
  const auto taken = [&] {
    return std::any_of(program.components.begin(), program.components.end(),
                       [&](const auto& other) { return other.name == name; });
  };
  for (int i = 2; taken(); ++i) name = wanted + "-" + std::to_string(i);
  return name;
}

void add(shape::Program& program, Component component, const std::string& carrier) {
  component.name = free_name(program, component.name);
  if (!carrier.empty()) program.connections.emplace_back(component.name, carrier);
  program.components.push_back(std::move(component));
}

// In a row along x, evenly within `width`.
void in_a_row(Component& component, int count, double width) {
  if (count < 2) return;
  const double step = width / count;
  component.at.x() = -0.5 * step * (count - 1);
  component.operations.push_back(shape::Array{count, Vec3(step, 0, 0)});
}

int count_of(const PartWish& wish, int usual) {
  return std::clamp(wish.count.value_or(usual), 0, 24);
}

}  // namespace

bool attach(shape::Program& program, const PartWish& wish, const Bounds3& box, double top) {
  const Vec3 size = box.size();
  const double w = size.x(), d = size.y(), small = std::min({w, d, size.z()});
  const std::string& label = wish.label;
  const double back_y = box.high.y(), front_y = box.low.y(), left_x = box.low.x();
  if (label.empty() || program.components.empty()) return false;
  const std::string carrier = program.components.front().name;
  if (label == "wheel") {
    const double r = std::clamp(0.08 * small, 0.02, 0.05);
    for (auto& component : program.components) component.at.z() += 2 * r - joint;
    Component wheel = part(label, shape::Frustum{r, r, 0.6 * r, 0.1 * r},
                           {left_x + r * 1.4, front_y + r, r}, "metal");
    wheel.rotate.y() = pi / 2;
    const int count = count_of(wish, 4);
    if (count == 4) {
      wheel.operations = {shape::Mirror{0}, shape::Mirror{1}};
    } else {
      wheel.operations = {shape::Radial{std::max(1, count)}};
    }
    add(program, std::move(wheel), carrier);
    return true;
  }
  const auto zone = zone_of(label);
  if (!zone) return false;
  switch (*zone) {
    case Zone::back: {
      const double height = std::clamp(0.6 * w, 0.25, 0.6);
      Component back = part(label, shape::Box{{0.92 * w, 0.03, height}, 0.01},
                            {0, back_y - 0.02, top - joint});
      add(program, std::move(back), carrier);
      return true;
    }
    case Zone::side: {
      Component arm = part(label, shape::Box{{0.05, 0.7 * d, 0.2}, 0.012},
                           {left_x + 0.025, 0.05 * d, top - joint});
      arm.operations = {shape::Mirror{0}};
      add(program, std::move(arm), carrier);
      return true;
    }
    case Zone::front: {
      const int count = count_of(wish, label == "hook" ? 3 : 1);
      if (count == 0) return true;
      const double part_width = 0.8 * w / count;
      const double height = std::clamp(0.15 * size.z(), 0.02, 0.18);
      Component front =
          label == "handle" || label == "hook"
              ? part(label, shape::Ellipsoid{{0.03, 0.03, 0.03}}, {0, front_y - 0.01, 0.75 * top}, "metal")
              : part(label, shape::Box{{part_width, 0.02, height}, 0.004},
                     {0, front_y - 0.01 + joint, std::max(0.3 * top, top - 1.3 * height)});
      in_a_row(front, count, 0.9 * w);
      add(program, std::move(front), carrier);
      return true;
    }
    case Zone::body: {
      const int count = count_of(wish, 1);
      if (count == 0) return true;
      Component shelf = part(label, shape::Box{{0.9 * w, 0.9 * d, 0.018}, 0.003}, {0, 0, 0});
      const double step = top / (count + 1);
      shelf.at.z() = step;
      if (count > 1) shelf.operations.push_back(shape::Array{count, Vec3(0, 0, step)});
      add(program, std::move(shelf), carrier);
      return true;
    }
    case Zone::above:
    case Zone::top: {
      const int count = count_of(wish, 1);
      if (count == 0) return true;
      const double side = std::min(0.9 * w / count, 0.5 * d);
      shape::Solid solid = shape::Cushion{{side, side, 0.3 * side}, 0.4};
      if (label == "shade" || label == "bulb")
        solid = shape::Frustum{0.5 * side, 0.35 * side, 0.6 * side, 0.004};
      else if (label == "ring")
        solid = shape::Lathe{{{{0.42 * side, 0}, {0.5 * side, 0}, {0.5 * side, 0.08 * side}, {0.42 * side, 0.08 * side}},
                              {0, 1, 2, 3}, true}};
      else if (label == "candle") solid = shape::Frustum{0.012, 0.012, 0.15, 0.002};
      else if (label == "lid" || label == "top" || label == "tray")
        solid = shape::Box{{0.98 * w, 0.98 * d, 0.02}, 0.005};
      else if (label != "cushion" && label != "pillow")
        solid = shape::Ellipsoid{{side, side, side}};
      Component piece = part(label, std::move(solid), {0, 0, top - joint});
      in_a_row(piece, count, 0.9 * w);
      add(program, std::move(piece), carrier);
      return true;
    }
    case Zone::foot: {
      const double height = 0.12;
      for (auto& component : program.components) component.at.z() += height - joint;
      const int count = count_of(wish, label == "base" || label == "pole" ? 1 : 4);
      if (count == 0) return true;
      const double r = std::clamp(0.06 * small, 0.012, 0.03);
      if (label == "base" || count == 1) {
        add(program, part(label, shape::Frustum{0.45 * std::min(w, d), 0.4 * std::min(w, d), height, 0.005},
                          {0, 0, 0}),
            carrier);
        return true;
      }
      Component leg = part(label, shape::Frustum{0.8 * r, r, height, 0.002},
                           {left_x + 2 * r, front_y + 2 * r, 0});
      if (count == 4) leg.operations = {shape::Mirror{0}, shape::Mirror{1}};
      else leg.operations = {shape::Radial{count}};
      add(program, std::move(leg), carrier);
      return true;
    }
  }
  return false;
}

shape::Program assemble(const Description& description, const Vec3& size) {
  shape::Program program;
  program.name = description.noun.empty() ? "object" : description.noun;
  program.about = "approximate: " + description.prompt;
  shape::Surface body{"body", "oak", 0.6, 0.0, 1.0, "grain", "", 1.0};
  shape::Surface metal{"metal", "steel", 0.4, 0.8, 1.0, "none", "", 1.0};
  program.materials = {body, metal};
  const double height = 0.75 * size.z();
  const bool on_feet = std::any_of(description.parts.begin(), description.parts.end(), [](const auto& wish) {
    return zone_of(wish.label) == Zone::foot && wish.count.value_or(1) > 0;
  });
  const double low = on_feet ? 0.6 * height : 0.0;
  const std::string core = [&] {
    for (const auto& wish : description.parts)
      if (zone_of(wish.label) == Zone::top && wish.count.value_or(1) > 0) return wish.label;
    return std::string("body");
  }();
  const double thick = on_feet ? std::clamp(0.06 * size.z(), 0.03, 0.2) : height - low;
  program.components = {part(core, shape::Box{{size.x(), size.y(), thick}, std::min(0.02, 0.2 * thick)},
                             {0, 0, low})};
  Bounds3 box;
  box.add({-0.5 * size.x(), -0.5 * size.y(), 0});
  box.add({0.5 * size.x(), 0.5 * size.y(), low + thick});
  for (const auto& wish : description.parts) {
    if (wish.label.empty() || wish.label == core || wish.count.value_or(1) == 0) continue;
    if (zone_of(wish.label) == Zone::foot && on_feet) {
      const int count = count_of(wish, wish.label == "leg" || wish.label == "foot" ? 4 : 1);
      const double r = std::clamp(0.05 * std::min(size.x(), size.y()), 0.012, 0.04);
      Component leg = part(wish.label, shape::Frustum{0.8 * r, r, low + joint, 0.003},
                           {-0.5 * size.x() + 2 * r, -0.5 * size.y() + 2 * r, 0});
      if (count == 1) leg.at.head<2>().setZero();
      else if (count == 4) leg.operations = {shape::Mirror{0}, shape::Mirror{1}};
      else {
        leg.at.head<2>() = Vec2(0, -0.4 * std::min(size.x(), size.y()));
        leg.operations = {shape::Radial{count}};
      }
      add(program, std::move(leg), core);
      continue;
    }
    attach(program, wish, box, low + thick);
  }
  return program;
}

}  // namespace roomgen::create
