#include "sheet_layout.h"

#include <algorithm>
#include <cmath>

#include "model_camera.h"

namespace roomgen {

namespace {

const ModelView front_quarter = {"front quarter", radians(32.0), radians(24.0)};
constexpr double pixels_per_metre = 100.0;  // once the things of a row are scaled
constexpr double title_height = 20.0, caption_height = 15.0, margin = 5.0;  // pixels
constexpr double title_letters = 10.0, label_letters = 12.0, caption_letters = 8.0;
// Rows get the whole of a page that a model sees unshrunk, as far as that is of use.
constexpr double page_height = 1560.0, least_row = 130.0;

/// How large a thing looks, metres across and up.
Vec2 looks_large(const Camera& camera, const Vec3& size) {
  const Vec3 half = 0.5 * size;
  return 2.0 * Vec2(half.dot(camera.right.cwiseAbs()), half.dot(camera.up.cwiseAbs()));
}

/// One row of the sheet, and what it adds to the layout.
class Row {
 public:
  Row(const ContactSheet::Row& row, const Bounds2& area, SheetLayout& layout)
      : row_(row), area_(area), layout_(layout) {}

  void add(std::size_t columns) {
    const double width = area_.size().x() / static_cast<double>(columns);
    write(Drawing::Text::legend, row_.title, title_letters, area_.low,
          {area_.size().x(), title_height});
    line(area_.low, {area_.high.x(), area_.low.y()});
    const Vec2 room(width - 2.0 * margin,
                    area_.size().y() - title_height - caption_height - 2.0 * margin);
    const double scale = scale_to(room);
    for (std::size_t i = 0; i < row_.things.size(); ++i) {
      const Vec2 corner(area_.low.x() + width * static_cast<double>(i),
                        area_.low.y() + title_height);
      add_thing(row_.things[i], {corner, Vec2(corner.x() + width, area_.high.y())}, scale);
    }
  }

 private:
  // The largest things of the row just fit.
  double scale_to(const Vec2& room) const {
    double scale = 1e3;
    for (const auto& thing : row_.things) {
      const Vec2 large = looks_large(layout_.camera, thing.object.size).cwiseMax(1e-6);
      scale = std::min(scale, room.cwiseQuotient(pixels_per_metre * large).minCoeff());
    }
    return scale;
  }

  void add_thing(const ContactSheet::Thing& thing, const Bounds2& cell, double scale) {
    const double low = cell.high.y() - caption_height;
    if (thing.object.size.minCoeff() > 0.0)
      stand({0.5 * (cell.low + cell.high).x(), low - margin}, thing.object, scale);
    const double label = label_size(thing.label, label_letters).x() + 4.0;
    write(Drawing::Text::object, thing.label, label_letters, cell.low + Vec2::Constant(2.0),
          {label, title_height});
    write(Drawing::Text::legend, thing.caption, caption_letters, {cell.low.x() + margin, low},
          {cell.size().x() - 2.0 * margin, caption_height});
  }

  // With its lowest point there.
  void stand(const Vec2& pixel, Object object, double scale) {
    object.size *= scale;
    const double up = 0.5 * looks_large(layout_.camera, object.size).y();
    const Vec2 middle = Vec2(pixel.x(), -pixel.y()) / pixels_per_metre + Vec2(0.0, up);
    object.position = middle.x() * layout_.camera.right + middle.y() * layout_.camera.up -
                      Vec3(0.0, 0.0, 0.5 * object.size.z());
    layout_.objects.push_back(std::move(object));
  }

  void write(Drawing::Text kind, const std::string& text, double letters, const Vec2& corner,
             const Vec2& box) {
    layout_.drawing.labels.push_back({kind, text, corner + 0.5 * box, box, letters});
  }

  void line(const Vec2& from, const Vec2& to) {
    layout_.drawing.strokes.push_back({Drawing::Line::outline, {from, to}});
  }

  const ContactSheet::Row& row_;
  Bounds2 area_;
  SheetLayout& layout_;
};

}  // namespace

Result<SheetLayout> lay_out(const ContactSheet& sheet) {
  if (sheet.rows.empty()) return Error{Error::Kind::invalid_input, "a contact sheet needs rows"};
  const double height = std::clamp(page_height / static_cast<double>(sheet.rows.size()), least_row,
                                   std::max(least_row, sheet.most_row));
  SheetLayout layout;
  layout.camera =
      model_camera({Vec3::Constant(-1.0), Vec3::Constant(1.0)}, front_quarter, sheet.pixels);
  layout.camera.height = static_cast<int>(height * static_cast<double>(sheet.rows.size()));
  for (const int side : {layout.camera.width, layout.camera.height})
    if (auto status = check_picture_side(side); !status) return status.error();
  layout.camera.pixels_per_metre = pixels_per_metre;
  layout.camera.center =
      Vec2(layout.camera.width, -layout.camera.height) / (2.0 * pixels_per_metre);
  std::size_t columns = 1;
  for (const auto& row : sheet.rows) columns = std::max(columns, row.things.size());
  double top = 0.0;
  for (const auto& row : sheet.rows) {
    Row(row, {{0.0, top}, Vec2(sheet.pixels, top + height)}, layout).add(columns);
    top += height;
  }
  // Whatever stands there reaches no further along the line of sight than it could across.
  const double reach = layout.camera.width / pixels_per_metre;
  layout.camera.near = reach, layout.camera.far = -reach;
  return layout;
}

}  // namespace roomgen
