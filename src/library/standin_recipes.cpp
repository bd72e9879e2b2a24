// How each stand-in is built. Local frame: x to the right, y to the back, z up, the box centred on
// the z axis with its bottom at 0; lengths in metres.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "roomgen/base/random.h"
#include "roomgen/library/standins.h"

namespace roomgen {

namespace {

using Rgb = std::array<float, 3>;

const std::map<std::string, Rgb, std::less<>>& colors() {
  static const std::map<std::string, Rgb, std::less<>> table = {
      {"oak", {191, 152, 104}},   {"walnut", {104, 71, 48}},  {"pine", {216, 182, 132}},
      {"white", {240, 238, 232}}, {"black", {34, 34, 36}},    {"grey", {140, 142, 146}},
      {"brown", {120, 84, 58}},   {"beige", {218, 204, 178}}, {"red", {166, 52, 46}},
      {"orange", {214, 124, 54}}, {"yellow", {226, 190, 82}}, {"green", {86, 122, 88}},
      {"blue", {62, 92, 138}},    {"purple", {110, 80, 130}}, {"pink", {222, 164, 172}},
      {"brass", {186, 152, 84}},  {"steel", {172, 176, 180}}, {"linen", {232, 222, 202}}};
  return table;
}

Rgb color_of(const std::string& name) {
  const auto found = colors().find(name);
  return found == colors().end() ? colors().at("oak") : found->second;
}

Rgb shaded(Rgb color, float factor) {
  for (auto& c : color) c = std::clamp(c * factor, 0.0f, 255.0f);
  return color;
}

Mesh make_frustum(const Vec2& center, double bottom_radius, double top_radius, double low,
                  double high) {
  constexpr int sides = 20;
  Mesh mesh;
  const auto vertex = [&](double angle, double radius, double z, const Vec3& normal) {
    mesh.positions.push_back(
        Vec3(center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle), z)
            .cast<float>());
    mesh.normals.push_back(normal.cast<float>());
    mesh.uvs.push_back({static_cast<float>(angle * bottom_radius), static_cast<float>(z)});
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  const double slope = (bottom_radius - top_radius) / (high - low);
  for (int i = 0; i < sides; ++i) {
    // The last corner is the first one to the bit, so that the mesh closes.
    const double a = 2 * pi * i / sides, b = 2 * pi * ((i + 1) % sides) / sides;
    const auto outward = [&](double angle) {
      return Vec3(std::cos(angle), std::sin(angle), slope).normalized();
    };
    const auto p = vertex(a, bottom_radius, low, outward(a)),
               q = vertex(b, bottom_radius, low, outward(b));
    const auto r = vertex(b, top_radius, high, outward(b)),
               s = vertex(a, top_radius, high, outward(a));
    mesh.triangles.push_back({p, q, r});
    mesh.triangles.push_back({p, r, s});
    for (const double z : {low, high}) {
      const double radius = z == low ? bottom_radius : top_radius;
      const Vec3 normal(0, 0, z == low ? -1 : 1);
      const auto c = vertex(0, 0, z, normal), d = vertex(a, radius, z, normal),
                 e = vertex(b, radius, z, normal);
      if (z == low)
        mesh.triangles.push_back({c, e, d});
      else
        mesh.triangles.push_back({c, d, e});
    }
  }
  return mesh;
}

// Collects solids by material.
class Builder {
 public:
  explicit Builder(const StandinSpec& spec) : half(0.5 * spec.size), size(spec.size) {}

  int material(const std::string& name, const Rgb& color, float roughness = 0.7f,
               float metallic = 0.0f) {
    Material material;
    material.name = name;
    for (std::size_t i = 0; i < 3; ++i) material.base_color[i] = linear_from_srgb(color[i]);
    material.roughness = roughness;
    material.metallic = metallic;
    model.materials.push_back(material);
    model.parts.push_back({{}, static_cast<int>(model.materials.size()) - 1});
    return model.parts.back().material;
  }
  void box(int material, const Vec3& low, const Vec3& high) {
    if (((high - low).array() > 0.0).all()) append(mesh(material), make_box(low, high));
  }
  void frustum(int material, const Vec2& center, double bottom, double top, double low,
               double high) {
    append(mesh(material), make_frustum(center, bottom, top, low, high));
  }
  Mesh& mesh(int material) { return model.parts[static_cast<std::size_t>(material)].mesh; }

  Model model;
  const Vec3 half;
  const Vec3 size;
};

void build_table(Builder& b, const Rgb& color) {
  const int wood = b.material("wood", color, 0.6f), legs = b.material("legs", shaded(color, 0.85f));
  const double top = std::min(0.04, 0.3 * b.size.z());
  const double leg = std::clamp(0.06 * b.size.head<2>().minCoeff(), 0.03, 0.08);
  const double inset = 0.02, under = b.size.z() - top;
  b.box(wood, {-b.half.x(), -b.half.y(), under}, {b.half.x(), b.half.y(), b.size.z()});
  const Vec2 corner = b.half.head<2>() - Vec2::Constant(inset + leg);
  for (const double sx : {-1.0, 1.0})
    for (const double sy : {-1.0, 1.0}) {
      const double x = sx > 0 ? corner.x() : -corner.x() - leg;
      const double y = sy > 0 ? corner.y() : -corner.y() - leg;
      b.box(legs, {x, y, 0}, {x + leg, y + leg, under});
    }
  const double apron = std::min(0.08, 0.2 * under);
  b.box(legs, {-corner.x(), -corner.y() - 0.5 * leg, under - apron},
        {corner.x(), corner.y() + 0.5 * leg, under});
}

void build_shelf(Builder& b, const Rgb& color) {
  const int wood = b.material("wood", color, 0.6f);
  const int back = b.material("back panel", shaded(color, 0.8f), 0.8f);
  const double board = std::clamp(0.03 * b.size.z(), 0.018, 0.03);
  if (b.size.z() < 0.3) {  // a board on two brackets
    const double thick = std::min(board, 0.5 * b.size.z());
    b.box(wood, {-b.half.x(), -b.half.y(), b.size.z() - thick},
          {b.half.x(), b.half.y(), b.size.z()});
    for (const double x : {-0.6 * b.half.x(), 0.6 * b.half.x()})
      b.box(back, {x - 0.01, -0.5 * b.half.y(), 0}, {x + 0.01, b.half.y(), b.size.z() - thick});
    return;
  }
  for (const double x : {-b.half.x(), b.half.x() - board})
    b.box(wood, {x, -b.half.y(), 0}, {x + board, b.half.y(), b.size.z()});
  b.box(back, {-b.half.x() + board, b.half.y() - 0.01, 0.02},
        {b.half.x() - board, b.half.y(), b.size.z() - 0.005});
  const int gaps = std::max(1, static_cast<int>(std::lround(b.size.z() / 0.36)));
  const double low = b.size.z() > 0.6 ? 0.06 : 0.0;
  for (int i = 0; i <= gaps; ++i) {
    const double z = low + (b.size.z() - low - board) * i / gaps;
    b.box(wood, {-b.half.x() + board, -b.half.y() + 0.005, z},
          {b.half.x() - board, b.half.y() - 0.01, z + board});
  }
}

void build_cabinet(Builder& b, const Rgb& color) {
  const int body = b.material("body", shaded(color, 0.92f)),
            front = b.material("fronts", color, 0.55f);
  const int knob = b.material("handles", color_of("steel"), 0.35f, 0.6f);
  const double handle = std::min(0.025, 0.15 * b.size.y()),
               panel = std::min(0.02, 0.15 * b.size.y());
  const double plinth = b.size.z() > 0.4 ? 0.06 : 0.0;
  const double face = -b.half.y() + handle;
  b.box(body, {-b.half.x(), face + panel, plinth}, {b.half.x(), b.half.y(), b.size.z()});
  b.box(body, {-b.half.x() + 0.03, face + panel + 0.04, 0},
        {b.half.x() - 0.03, b.half.y(), plinth});
  const bool doors = b.size.z() > 1.1;
  const int columns =
      std::clamp(static_cast<int>(std::lround(b.size.x() / (doors ? 0.5 : 0.7))), 1, 8);
  const int rows = doors ? 1 : std::clamp(static_cast<int>(std::lround(b.size.z() / 0.24)), 1, 5);
  const Vec2 cell(b.size.x() / columns, (b.size.z() - plinth) / rows);
  constexpr double seam = 0.004;
  for (int c = 0; c < columns; ++c)
    for (int r = 0; r < rows; ++r) {
      const double x = -b.half.x() + cell.x() * c, z = plinth + cell.y() * r;
      b.box(front, {x + seam, face, z + seam},
            {x + cell.x() - seam, face + panel, z + cell.y() - seam});
      const bool hinge_left = c % 2 == 0;
      const double kx = !doors ? x + 0.5 * cell.x() : hinge_left ? x + cell.x() - 0.06 : x + 0.06;
      const double kz = z + (doors ? 0.5 : 0.6) * cell.y();
      const Vec2 reach = doors ? Vec2(0.008, 0.06) : Vec2(0.06, 0.008);
      b.box(knob, {kx - reach.x(), -b.half.y(), kz - reach.y()},
            {kx + reach.x(), face, kz + reach.y()});
    }
}

// A frame around a panel, for things that hang flat on a wall. Returns the inner rectangle.
Vec2 build_frame(Builder& b, int frame, double width) {
  const Vec2 inner(b.half.x() - width, b.half.z() - width);
  b.box(frame, {-b.half.x(), -b.half.y(), 0}, {b.half.x(), b.half.y(), width});
  b.box(frame, {-b.half.x(), -b.half.y(), b.size.z() - width},
        {b.half.x(), b.half.y(), b.size.z()});
  b.box(frame, {-b.half.x(), -b.half.y(), width}, {-inner.x(), b.half.y(), b.size.z() - width});
  b.box(frame, {inner.x(), -b.half.y(), width}, {b.half.x(), b.half.y(), b.size.z() - width});
  return inner;
}

void build_mirror(Builder& b, const Rgb& color) {
  const int frame = b.material("frame", color, 0.5f);
  const int glass = b.material("mirror glass", {214, 222, 226}, 0.05f, 0.9f);
  const double width = std::clamp(0.06 * std::min(b.size.x(), b.size.z()), 0.012, 0.05);
  const Vec2 inner = build_frame(b, frame, width);
  b.box(glass, {-inner.x(), -0.4 * b.half.y(), width}, {inner.x(), b.half.y(), b.size.z() - width});
}

// Sky, hills and a foreground in colours of the seed.
std::shared_ptr<const Image> paint_landscape(std::uint64_t seed) {
  constexpr int width = 96, height = 72;
  Random random(seed);
  Image image(width, height);
  const std::array<Rgb, 3> sky = {{{198, 214, 226}, {238, 206, 170}, {170, 190, 206}}};
  const std::array<Rgb, 3> land = {{{112, 132, 96}, {146, 112, 84}, {84, 104, 124}}};
  const Rgb above = sky[static_cast<std::size_t>(random.integer(0, 2))];
  const Rgb below = land[static_cast<std::size_t>(random.integer(0, 2))];
  std::array<double, 3> phase{};
  for (auto& p : phase) p = random.uniform(0.0, 2 * pi);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Rgb color = shaded(above, 1.0f - 0.15f * static_cast<float>(y) / height);
      for (std::size_t layer = 0; layer < 3; ++layer) {
        const double ridge = height * (0.45 + 0.18 * static_cast<double>(layer)) +
                             6.0 * std::sin(0.06 * x + phase[layer]);
        if (y > ridge) color = shaded(below, 1.15f - 0.25f * static_cast<float>(layer));
      }
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<std::uint8_t>(color[static_cast<std::size_t>(c)]);
      image.at(x, y)[3] = 255;
    }
  return std::make_shared<const Image>(std::move(image));
}

void build_picture(Builder& b, const Rgb& color, std::uint64_t seed) {
  const int frame = b.material("frame", color, 0.5f),
            mat = b.material("mat", {244, 242, 236}, 0.9f);
  const int canvas = b.material("picture", {255, 255, 255}, 0.9f);
  b.model.materials[static_cast<std::size_t>(canvas)].texture = paint_landscape(seed);
  const double width = std::clamp(0.05 * std::min(b.size.x(), b.size.z()), 0.01, 0.04);
  const Vec2 inner = build_frame(b, frame, width);
  const double border = 1.5 * width, deep = -0.2 * b.half.y();
  b.box(mat, {-inner.x(), deep, width}, {inner.x(), b.half.y(), b.size.z() - width});
  const Vec3 low(-inner.x() + border, 1.8 * deep, width + border);
  const Vec3 high(inner.x() - border, deep, b.size.z() - width - border);
  b.box(canvas, low, high);
  Mesh& mesh = b.mesh(canvas);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.uvs[i] = {static_cast<float>((mesh.positions[i].x() - low.x()) / (high.x() - low.x())),
                   static_cast<float>((high.z() - mesh.positions[i].z()) / (high.z() - low.z()))};
}

void build_rug(Builder& b, const Rgb& color) {
  const int edge = b.material("border", shaded(color, 0.7f), 1.0f),
            field = b.material("field", color, 1.0f);
  const double border = 0.08 * b.size.head<2>().minCoeff(), pile = 0.75 * b.size.z();
  b.box(edge, {-b.half.x(), -b.half.y(), 0}, {b.half.x(), b.half.y(), pile});
  b.box(field, {-b.half.x() + border, -b.half.y() + border, pile},
        {b.half.x() - border, b.half.y() - border, b.size.z()});
}

void build_lamp(Builder& b, const Rgb& color, Mount mount) {
  const int metal = b.material("metal", color, 0.35f, 0.5f),
            shade = b.material("shade", color_of("linen"), 0.9f);
  const double radius = b.half.head<2>().minCoeff(), top = b.size.z();
  const Vec2 center(0, 0);
  if (mount == Mount::ceiling) {
    b.frustum(metal, center, 0.3 * radius, 0.3 * radius, 0.96 * top, top);
    b.frustum(metal, center, 0.01, 0.01, 0.3 * top, 0.96 * top);
    b.frustum(shade, center, radius, 0.45 * radius, 0, 0.45 * top);
  } else if (mount == Mount::wall) {
    const double deep = b.half.y(), shade_radius = std::min(b.half.x(), 0.7 * deep);
    b.box(metal, {-0.35 * b.half.x(), 0.85 * deep, 0}, {0.35 * b.half.x(), deep, 0.7 * top});
    b.box(metal, {-0.012, -deep + shade_radius, 0.25 * top}, {0.012, 0.85 * deep, 0.3 * top});
    b.frustum(shade, {0, -deep + shade_radius}, shade_radius, 0.65 * shade_radius, 0.3 * top, top);
  } else {
    const double shade_height = std::min(std::clamp(0.3 * top, 0.12, 0.35), 0.6 * top);
    b.frustum(metal, center, 0.7 * radius, 0.7 * radius, 0, 0.025 * top);
    b.frustum(metal, center, 0.014, 0.014, 0.025 * top, top - 0.5 * shade_height);
    b.frustum(shade, center, radius, 0.65 * radius, top - shade_height, top);
  }
}

void build_box(Builder& b, const Rgb& color) {
  const int body = b.material("body", color, 0.8f),
            lid = b.material("lid", shaded(color, 0.88f), 0.7f);
  const int latch = b.material("latch", color_of("brass"), 0.4f, 0.6f);
  const double lip = std::min(0.012, 0.04 * b.size.head<2>().minCoeff());
  const double seam = 0.8 * b.size.z(), knob = lip;
  b.box(body, {-b.half.x() + lip, -b.half.y() + lip + knob, 0},
        {b.half.x() - lip, b.half.y() - lip, seam});
  b.box(lid, {-b.half.x(), -b.half.y() + knob, seam}, {b.half.x(), b.half.y(), b.size.z()});
  b.box(latch, {-0.06 * b.size.x(), -b.half.y(), seam - 0.08 * b.size.z()},
        {0.06 * b.size.x(), -b.half.y() + knob, seam + 0.08 * b.size.z()});
}

void drop_empty_parts(Model& model) {
  std::erase_if(model.parts, [](const ModelPart& part) { return part.mesh.triangles.empty(); });
}

// The recipes leave rounding and, for round things in oblong boxes, whole gaps.
void fill_box(Model& model, const Vec3& size) {
  const Bounds3 box = bounds(model);
  if (box.empty()) return;
  const Vec3 scale = size.cwiseQuotient(box.size().cwiseMax(1e-9));
  const Vec3 offset = -scale.cwiseProduct(Vec3(box.center().x(), box.center().y(), box.low.z()));
  for (auto& part : model.parts) {
    Mesh fitted;
    append(fitted, part.mesh, scale, offset);
    part.mesh = std::move(fitted);
  }
}

}  // namespace

const std::vector<std::string>& standin_recipes() {
  static const std::vector<std::string> names = {"table",   "shelf", "cabinet", "mirror",
                                                 "picture", "rug",   "lamp",    "box"};
  return names;
}

Model build_standin(const StandinSpec& spec) {
  Builder builder(spec);
  const Rgb color = color_of(spec.color);
  if (spec.recipe == "table")
    build_table(builder, color);
  else if (spec.recipe == "shelf")
    build_shelf(builder, color);
  else if (spec.recipe == "cabinet")
    build_cabinet(builder, color);
  else if (spec.recipe == "mirror")
    build_mirror(builder, color);
  else if (spec.recipe == "picture")
    build_picture(builder, color, spec.seed);
  else if (spec.recipe == "rug")
    build_rug(builder, color);
  else if (spec.recipe == "lamp")
    build_lamp(builder, color, spec.mount);
  else if (spec.recipe == "box")
    build_box(builder, color);
  drop_empty_parts(builder.model);
  fill_box(builder.model, spec.size);
  return std::move(builder.model);
}

}  // namespace roomgen
