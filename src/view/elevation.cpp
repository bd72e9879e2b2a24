#include <algorithm>
#include <cmath>

#include "layer_things.h"
#include "marks.h"
#include "object_labels.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

// Metres of paper: beside each wall for heights, above and below it for its name and coordinates,
// and for the legend.
constexpr double beside = 0.5, above = 0.35, below = 0.35, under_all = 0.3;
constexpr double before_wall = 0.6;    // as near as that a thing stands before a wall
constexpr double close_to_wall = 0.3;  // and belongs to it
constexpr double at_wall = 0.1;        // as near as that it hangs on it
constexpr double sheet_letters_at_1024 = 11.0, least_sheet_letters = 4.0, sheet_shrink = 0.88;

struct Face {
  const Room* room;
  std::size_t wall;
  Segment line;
  int axis = -1;       ///< coordinate of the marks that changes along the wall, if one alone does
  double first = 0.0;  ///< what is written at the wall's first corner
  double slope = 1.0;  ///< and how it changes a metre on
  Vec2 corner = Vec2::Zero();  ///< lower left on the sheet, metres to the right and down

  double length() const { return line.length(); }
};

Face face_of(const Room& room, std::size_t wall, bool paper_frame) {
  Face face{&room, wall, room.polygon.edge(wall)};
  const Vec2 a = mark_from_room(room, face.line.a, paper_frame);
  const Vec2 along = (mark_from_room(room, face.line.b, paper_frame) - a) / face.length();
  for (const int axis : {0, 1})
    if (std::abs(along[1 - axis]) < 1e-6)
      face.axis = axis, face.first = a[axis], face.slope = along[axis];
  return face;
}

// Row by row, none longer than a width unless it is one wall; the size of the paper.
Vec2 lay_out(std::vector<Face>& faces, double width) {
  Vec2 at(0.0, 0.0), size(0.0, 0.0);
  for (auto& face : faces) {
    if (at.x() > 0.0 && at.x() + 2.0 * beside + face.length() > width) at = {0.0, size.y()};
    face.corner = at + Vec2(beside, above + face.room->height);
    at.x() += beside + face.length();
    size = size.cwiseMax(Vec2(at.x() + beside, face.corner.y() + below));
  }
  return size + Vec2(0.0, under_all);
}

// In as many rows as show it large on little paper.
Vec2 lay_out_best(std::vector<Face>& faces) {
  double total = 0.0, best = 0.0, least = 1e300;
  for (const auto& face : faces) total += 2.0 * beside + face.length();
  constexpr int steps = 40;
  for (int i = 1; i <= steps; ++i) {
    const double width = total * i / steps + 1e-6;
    const Vec2 size = lay_out(faces, width);
    const double cost = size.maxCoeff() + 0.2 * size.minCoeff();
    if (cost < least - 1e-9) least = cost, best = width;
  }
  return lay_out(faces, best);
}

// Where something is seen before or on a wall: metres from the wall's first corner, and up.
Bounds2 seen_on(const Face& face, const Object& object) {
  Bounds2 box;
  const Vec2 along = face.line.direction();
  const Footprint area = footprint(object);
  for (const auto& corner : area.outline())
    box.add({std::clamp((corner - face.line.a).dot(along), 0.0, face.length()), bottom(object)});
  box.high.y() = top(object);
  return box;
}

bool is_on(const Face& face, const Object& object, double reach) {
  const Footprint area = footprint(object);
  return object.mount == Mount::wall &&
         area.front().dot(face.room->polygon.inward(face.wall)) > 0.7 &&
         distance(face.line, area.to_world({0.0, area.half().y()})) < reach;
}

bool is_before(const Face& face, const Object& object) {
  const bool stands = object.mount == Mount::floor || object.mount == Mount::surface;
  return stands && !object.traits.flat && gap(footprint(object), face.line) < before_wall;
}

class Sheets {
 public:
  Sheets(const Scene& scene, const View& view, const Vec2& size)
      : scene_(scene), view_(view), scale_(view.pixels / size.maxCoeff()) {
    sheet_.width = static_cast<int>(std::ceil(size.x() * scale_ - 1e-6));
    sheet_.height = static_cast<int>(std::ceil(size.y() * scale_ - 1e-6));
  }

  /// Nothing if the names do not fit with letters of this height.
  std::optional<Sheet> draw(const std::vector<Face>& faces, double letters) {
    sheet_.drawing = {};
    sheet_.drawing.text_height = letters;
    detail::LabelPlacer placer(sheet_.width, sheet_.height);
    std::vector<detail::ObjectMark> marks;
    for (const auto& face : faces) add_marks(face, marks);
    detail::name_marks(marks, letters, area_of(faces), placer, sheet_.drawing.strokes);
    for (const auto& face : faces) draw_wall(face, placer);
    for (const auto& mark : marks) stroke(mark.look, mark.outline);
    if (!detail::place_object_labels(marks, letters, placer, sheet_.drawing.strokes))
      return std::nullopt;
    sheet_.drawing.labels = placer.labels();
    return sheet_;
  }

 private:
  double area_of(const std::vector<Face>& faces) const {
    double area = 0.0;
    for (const auto& face : faces) area += face.length() * face.room->height * scale_ * scale_;
    return area;
  }

  // From inside the first corner of a wall is at its right.
  Vec2 pixel(const Face& face, double along, double up) const {
    return scale_ * Vec2(face.corner.x() + face.length() - along, face.corner.y() - up);
  }

  std::vector<Vec2> rectangle(const Face& face, const Bounds2& box) const {
    return {pixel(face, box.low.x(), box.low.y()), pixel(face, box.high.x(), box.low.y()),
            pixel(face, box.high.x(), box.high.y()), pixel(face, box.low.x(), box.high.y())};
  }

  void stroke(Drawing::Line kind, std::vector<Vec2> outline) {
    outline.push_back(outline.front());
    sheet_.drawing.strokes.push_back({kind, std::move(outline)});
  }

  void write(Drawing::Text kind, const std::string& text, const Vec2& at,
             detail::LabelPlacer& placer) {
    const Vec2 size = label_size(text, sheet_.drawing.text_height), half = 0.5 * size;
    const Vec2 center = at.cwiseMin(placer.picture() - half).cwiseMax(half);
    placer.place({kind, text, center, size});
  }

  void draw_wall(const Face& face, detail::LabelPlacer& placer) {
    const double length = face.length(), height = face.room->height;
    stroke(Drawing::Line::paper, rectangle(face, {{0.0, 0.0}, {length, height}}));
    std::string title = part_id(*face.room, detail::wall_title(*face.room, face.wall, " "));
    title += face.axis < 0 ? " (m)" : face.axis == 0 ? " (x)" : " (y)";
    write(Drawing::Text::part, title, pixel(face, 0.5 * length, height + 0.5 * above), placer);
    draw_grid(face, placer);
    for (const auto& opening : face.room->openings) {
      if (opening.wall != face.wall) continue;
      std::vector<Vec2> hole;
      for (const auto& p : outline(opening)) hole.push_back(pixel(face, p.x(), p.y()));
      stroke(Drawing::Line::hole, hole);
      write(Drawing::Text::part, detail::opening_title(opening, "\n"),
            pixel(face, 0.5 * (opening.from + opening.to), 0.5 * (opening.sill + opening.head)),
            placer);
    }
  }

  void draw_grid(const Face& face, detail::LabelPlacer& placer) {
    const double step = scale_ < 8.0 * sheet_.drawing.text_height ? 1.0 : 0.5;
    const double length = face.length(), height = face.room->height,
                 last = face.first + face.slope * length;
    for (const double value :
         detail::multiples(std::min(face.first, last), std::max(face.first, last), step)) {
      const double along = (value - face.first) / face.slope;
      sheet_.drawing.strokes.push_back(
          {Drawing::Line::grid, {pixel(face, along, 0.0), pixel(face, along, height)}});
      write(Drawing::Text::tick, format_number(value, 2), pixel(face, along, -0.5 * below), placer);
    }
    for (const double up : detail::multiples(0.0, height, 0.5)) {
      sheet_.drawing.strokes.push_back(
          {Drawing::Line::grid, {pixel(face, 0.0, up), pixel(face, length, up)}});
      write(Drawing::Text::tick, format_number(up, 2), pixel(face, length + 0.5 * beside, up),
            placer);
    }
  }

  void add_mark(const Face& face, const Object& object, Drawing::Line look,
                std::vector<detail::ObjectMark>& marks) const {
    const Bounds2 box = seen_on(face, object);
    if (box.size().x() < 1e-3) return;
    detail::ObjectMark mark;
    mark.id = mark.text = object.id;
    if (object.mount == Mount::surface)
      mark.text.clear();
    else if (object.mount == Mount::floor)
      mark.text += " h " + format_number(object.size.z(), 2);
    else
      mark.text += " z " + format_number(bottom(object), 2);
    mark.outline = rectangle(face, box);
    mark.center = mark.arrow_start = mark.arrow_end = 0.5 * (mark.outline[0] + mark.outline[2]);
    mark.look = look;
    mark.may_be_nameless = gap(footprint(object), face.line) > close_to_wall;
    marks.push_back(std::move(mark));
  }

  void add_marks(const Face& face, std::vector<detail::ObjectMark>& marks) const {
    for (const auto& object : scene_.objects) {
      if (&room_of(scene_, object) != face.room) continue;
      if (is_before(face, object)) add_mark(face, object, Drawing::Line::before, marks);
      if (is_on(face, object, at_wall)) add_mark(face, object, Drawing::Line::hung, marks);
    }
    for (const auto& object : view_.refused)
      if (is_on(face, object, before_wall))
        add_mark(face, object, Drawing::Line::refused, marks);
  }

  const Scene& scene_;
  const View& view_;
  double scale_;  ///< pixels a metre
  Sheet sheet_;
};

}  // namespace

Result<Sheet> layout_elevation(const Scene& scene, const View& view) {
  if (auto status = check_picture_side(view.pixels); !status) return status.error();
  std::vector<Face> faces;
  for (const auto& room : rooms_of(scene))
    for (std::size_t k = 0; k < room.polygon.size(); ++k)
      faces.push_back(face_of(room, k, view.paper_frame));
  if (faces.size() < 3)
    return Error{Error::Kind::invalid_input, "the room has no walls to look at"};
  const Vec2 size = lay_out_best(faces);
  Sheets sheets(scene, view, size);
  for (double letters = std::max(sheet_letters_at_1024 * view.pixels / 1024.0, least_sheet_letters);
       ; letters *= sheet_shrink) {
    if (auto sheet = sheets.draw(faces, letters)) return *std::move(sheet);
    if (letters < 1.0)
      return Error{Error::Kind::invalid_input, "the walls do not fit a picture of so few pixels"};
  }
}

}  // namespace roomgen
