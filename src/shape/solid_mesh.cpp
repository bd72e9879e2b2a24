#include "solid_mesh.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "expression.h"
#include "letters.h"
#include "placing.h"
#include "roomgen/base/json.h"
#include "roomgen/shape/primitives.h"
#include "skin.h"

namespace roomgen::shape::detail {

namespace {

Curve<Vec2> outline(const std::variant<Disc, Rectangle, Curve<Vec2>>& section, double tolerance) {
  if (const auto* disc = std::get_if<Disc>(&section))
    return ellipse(Vec2::Constant(2 * disc->radius), tolerance);
  if (const auto* rect = std::get_if<Rectangle>(&section))
    return rectangle(rect->size, rect->bevel, tolerance);
  return std::get<Curve<Vec2>>(section);
}

Curve<Vec2> outline(const std::variant<RoundedSize, Curve<Vec2>>& level, double tolerance) {
  if (const auto* size = std::get_if<RoundedSize>(&level))
    return rounded(size->size, size->round, tolerance);
  return std::get<Curve<Vec2>>(level);
}

Result<Mesh> height_mesh(const HeightPart& part, double tolerance) {
  const auto formula = Expression::compile(part.height, Expression::max_bound_length);
  if (!formula) return with_context(formula.error(), "\"height\"");
  Scope scope;
  double& u = std::get<double>(scope.values["u"]);
  double& v = std::get<double>(scope.values["v"]);
  std::optional<Error> wrong;
  HeightField field{part.size, nullptr, part.divisions, part.least, part.most};
  field.height = [&](double x, double y) {
    u = x, v = y;
    const auto height = formula->number(scope);
    if (height) return *height;
    if (!wrong) wrong = with_context(height.error(), "\"height\"");
    return part.least;
  };
  auto result = mesh(field, tolerance);
  if (wrong) return *wrong;
  return result;
}

// The whole picture on the front; sides and back continue its edge, as a canvas on a frame does.
Result<Mesh> picture_mesh(const PicturePart& part, double tolerance) {
  auto result = mesh(Box{{part.size.x(), part.thickness, part.size.y()}, 0.0}, tolerance);
  if (!result) return result;
  result->uvs.clear();
  constexpr float inset = 0.004f;  // stays inside the picture when the texture is filtered
  for (const auto& p : result->positions) {
    const float u = p.x() / static_cast<float>(part.size.x()) + 0.5f;
    const float v = 1.0f - p.z() / static_cast<float>(part.size.y());
    result->uvs.emplace_back(inset + u * (1 - 2 * inset), inset + v * (1 - 2 * inset));
  }
  return result;
}

// Written lying on the ground, as skins and sections know what is up there, then stood up.
Mesh stood_up(Mesh mesh, double back) {
  for (auto& p : mesh.positions) p = {p.x(), static_cast<float>(back) - p.z(), p.y()};
  for (auto& n : mesh.normals) n = {n.x(), -n.z(), n.y()};
  return mesh;
}

Result<Mesh> flat_letters(const std::vector<Loop>& lines, double width, double depth,
                          double tolerance) {
  const auto loops = around_lines(lines, width, tolerance);
  SurfaceBuilder surface;
  for (const auto& loop : loops) {
    Skin side;
    side.rows = {raised(loop, 0.0), raised(loop, depth)};
    add_skin(surface, side);
  }
  add_level_cap(surface, loops, 0.0, false);
  add_level_cap(surface, loops, depth, true);
  return stood_up(surface.mesh(), 0.5 * depth);
}

Result<Mesh> text_mesh(const TextPart& part, double tolerance) {
  const Align align = part.align == "left"    ? Align::left
                      : part.align == "right" ? Align::right
                                              : Align::center;
  std::vector<Loop> lines;
  Mesh tubes;
  const Lettering letters = lettering(part.words, align, part.height, part.fit);
  for (const auto& curve : letters.lines) {
    Loop line = polyline(curve, 0.5 * tolerance);
    if (curve.closed) line.push_back(line.front());
    if (part.radius == 0.0) {
      lines.push_back(std::move(line));
      continue;
    }
    Curve<Vec3> path{{}, curve.corners, curve.closed};
    for (const auto& p : curve.points) path.points.emplace_back(p.x(), p.y(), 0.0);
    auto tube = mesh(Sweep{path, ellipse(Vec2::Constant(2 * part.radius), tolerance)}, tolerance);
    if (!tube) return tube;
    append_mesh(tubes, *tube);
  }
  if (part.radius > 0.0) return stood_up(std::move(tubes), 0.0);
  return flat_letters(lines, part.width * letters.height / part.height, part.depth, tolerance);
}

constexpr double finest_retry = 0.0005;  // metres

struct Maker {
  double tolerance;

  template <typename T>
  Result<Mesh> operator()(const T& solid) const {
    return mesh(solid, tolerance);
  }
  Result<Mesh> operator()(const SweptPart& part) const {
    return mesh(Sweep{part.path, outline(part.section, tolerance), part.taper, part.twist},
                tolerance);
  }
  Result<Mesh> operator()(const LoftedPart& part) const {
    Loft loft;
    loft.straight = part.straight;
    for (const auto& level : part.levels)
      loft.levels.push_back({level.z, outline(level.outline, tolerance)});
    return mesh(loft, tolerance);
  }
  Result<Mesh> operator()(const HeightPart& part) const { return height_mesh(part, tolerance); }
  Result<Mesh> operator()(const PicturePart& part) const { return picture_mesh(part, tolerance); }
  Result<Mesh> operator()(const TextPart& part) const { return text_mesh(part, tolerance); }
  Result<Mesh> operator()(const Group&) const { return Mesh{}; }
};

}  // namespace

Result<Mesh> solid_mesh(const Solid& solid, double tolerance) {
  while (true) {
    auto made = std::visit(Maker{tolerance}, solid);
    // Coarse chords of a thin wall cross each other: then it is made as finely as it needs.
    if (made || tolerance <= finest_retry) return made;
    tolerance = std::max(finest_retry, 0.25 * tolerance);
  }
}

}  // namespace roomgen::shape::detail
