#include "piece.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "shape/color.h"
#include "words.h"

namespace roomgen::create {

namespace {

using shape::Component;

constexpr int most_of_piece = 50;

std::string free_name(const shape::Program& program, std::string wanted) {
  std::replace(wanted.begin(), wanted.end(), ' ', '-');
  std::erase_if(wanted, [](unsigned char c) { return c != '-' && c != '_' && !std::isalnum(c); });
  if (wanted.empty()) wanted = "part";
  std::string name = wanted;
  const auto taken = [&] {
    return std::any_of(program.components.begin(), program.components.end(),
                       [&](const auto& other) { return other.name == name; });
  };
  for (int i = 2; taken(); ++i) name = wanted + "-" + std::to_string(i);
  return name;
}

// The surface of parts that are usually of something else than the whole.
std::string surface_for(shape::Program& program, const std::string& material) {
  if (material.empty())
    return program.materials.empty() ? std::string() : program.materials.front().name;
  for (const auto& surface : program.materials)
    if (surface.name == material) return material;
  shape::Surface surface;
  const Words& words = *built_in_words();
  if (const auto known = words.materials.find(material); known != words.materials.end())
    surface = known->second;
  else if (shape::parse_color(material)) surface.color = material;
  else return program.materials.empty() ? std::string() : program.materials.front().name;
  surface.name = "of-" + free_name({}, material);
  for (const auto& other : program.materials)
    if (other.name == surface.name) return surface.name;
  program.materials.push_back(surface);
  return surface.name;
}

bool is_plain(const Component& component) {
  return component.rotate.isZero() && component.at.isZero() && component.operations.empty() &&
         component.scale == Vec3::Ones();
}

// The form in the spot's size, standing on z = 0 before it is turned and moved.
std::optional<Component> component_at(const Piece& piece, const Spot& spot) {
  const auto& forms = built_in_parts()->forms;
  const auto form = forms.find(piece.form.form);
  if (form == forms.end()) return std::nullopt;
  const auto made = shape::instantiate(
      form->second, {{"width", spot.size.x()}, {"depth", spot.size.y()}, {"height", spot.size.z()}}, 0,
      nullptr, piece.form.form);
  if (!made || made->components.empty()) return std::nullopt;
  Component component;
  const bool single = made->components.size() == 1 && is_plain(made->components.front());
  if (single && !spot.about_middle) {
    component.solid = made->components.front().solid;
  } else {
    shape::Group group{made->components};
    if (spot.about_middle)
      for (auto& inner : group.components) inner.at.z() -= 0.5 * spot.size.z();
    component.solid = std::move(group);
  }
  component.rotate = spot.turn;
  component.at = spot.at;
  return component;
}

Bounds3 box_of(const Spot& spot) {
  Bounds3 box;
  const double low = spot.about_middle ? -0.5 : 0.0;
  box.add(spot.at + Vec3(-0.5 * spot.size.x(), -0.5 * spot.size.y(), low * spot.size.z()));
  box.add(spot.at + Vec3(0.5 * spot.size.x(), 0.5 * spot.size.y(), (low + 1) * spot.size.z()));
  return box;
}

}  // namespace

Piece piece_of(const PartWish& wish) {
  const PartForms& parts = *built_in_parts();
  Piece piece;
  piece.wish = wish;
  piece.form = parts.of(wish.label, wish.count.value_or(1));
  if (const auto shaped = parts.shapes.find(wish.shape); shaped != parts.shapes.end())
    piece.form.form = shaped->second;
  piece.place = wish.place.value_or(piece.form.place);
  piece.count = std::clamp(wish.count.value_or(wish.one ? 1 : piece.form.count), 0, most_of_piece);
  return piece;
}

Piece implied(const std::string& label, int count, Place place) {
  PartWish wish;
  wish.label = label;
  wish.count = count;
  wish.place = place;
  return piece_of(wish);
}

Vec3 size_on(const Piece& piece, const Vec3& whole) {
  Vec3 size = piece.form.size.cwiseProduct(whole).cwiseProduct(piece.wish.scale);
  double least = size.maxCoeff();
  for (const char axis : piece.form.same) least = std::min(least, size[axis - 'x']);
  for (const char axis : piece.form.same) size[axis - 'x'] = least;
  if (piece.wish.size)
    for (int axis = 0; axis < 3; ++axis)
      if (const double said = (*piece.wish.size)[axis]; !std::isnan(said)) size[axis] = said;
  return size.cwiseMax(0.004);
}

std::vector<Bounds3> put(shape::Program& program, const Piece& piece, const std::vector<Spot>& where,
                         std::size_t begin, std::size_t end) {
  std::vector<Bounds3> boxes;
  for (std::size_t i = begin; i < std::min(end, where.size()); ++i) {
    auto component = component_at(piece, where[i]);
    if (!component) continue;
    component->name = free_name(program, piece.wish.label);
    component->label = piece.wish.label;
    component->material = surface_for(program, piece.form.material);
    program.components.push_back(*std::move(component));
    boxes.push_back(box_of(where[i]));
  }
  return boxes;
}

void add_cords(shape::Program& program, const std::vector<Bounds3>& hung, double up_to) {
  for (const auto& box : hung) {
    Component cord;
    cord.name = free_name(program, "cord");
    cord.label = "cord";
    cord.material = surface_for(program, "rope");
    const double from = box.low.z() + 0.5 * box.size().z();
    if (up_to - from < 0.01) continue;
    cord.solid = shape::Frustum{0.006, 0.006, up_to - from, 0.0};
    cord.at = {box.center().x(), box.center().y(), from};
    program.components.push_back(std::move(cord));
  }
}

}  // namespace roomgen::create
