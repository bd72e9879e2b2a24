#include "compose.h"

#include <algorithm>
#include <map>

#include "part_forms.h"
#include "roomgen/base/text.h"
#include "roomgen/shape/color.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/recipe.h"
#include "spots.h"

namespace roomgen::create {

namespace {

using shape::Component;

constexpr double coarse = 0.01;
constexpr int most_copies = 50;
// Shares of the height.
constexpr double short_feet = 0.18, top_room = 0.2, back_room = 0.4, plate = 0.05;
constexpr double least_feet = 0.06, most_feet = 0.15;  ///< below things that had none, metres
constexpr const char* body_surface = "body";

/// A part with what is known about it.
struct Piece {
  PartWish wish;
  PartForm form;
  Place place = Place::top;
  int count = 1;
};

Piece piece_of(const PartWish& wish) {
  const PartForms& parts = *built_in_parts();
  Piece piece;
  piece.wish = wish;
  piece.form = parts.of(wish.label, wish.count.value_or(1));
  if (const auto shaped = parts.shapes.find(wish.shape); shaped != parts.shapes.end())
    piece.form.form = shaped->second;
  piece.place = wish.place.value_or(piece.form.place);
  piece.count = std::clamp(wish.count.value_or(piece.form.count), 0, most_copies);
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
  return piece.wish.size.value_or(size).cwiseMax(0.004);
}

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

// Some of the spots, as components; their boxes.
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

// What hangs does so on cords.
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

class Composition {
 public:
  Composition(const Description& description, const Vec3& size) : description_(description) {
    frame_.size = size;
    program_.name = description.noun.empty() ? "object" : description.noun;
    program_.about = "approximate: " + description.prompt;
    program_.materials = {{body_surface, "oak", 0.6, 0.0, 1.0, "grain", "", 1.0}};
  }

  shape::Program run() {
    for (const auto& wish : description_.parts)
      if (!wish.label.empty() && wish.count.value_or(1) > 0) add(piece_of(wish));
    imply();
    divide();
    for (const Place place : {Place::base, Place::foot}) place_all(place);
    divide_between_column_and_pile();
    for (const Place place : {Place::upright, Place::column, Place::across, Place::deck, Place::helix,
                              Place::stack})
      place_all(place);
    if (core_.empty()) place_body();
    settle_faces();
    for (const Place place : {Place::radial, Place::wheel, Place::around, Place::hang, Place::back,
                              Place::side, Place::front, Place::top})
      place_all(place);
    return std::move(program_);
  }

 private:
  void add(Piece piece) { pieces_[piece.place].push_back(std::move(piece)); }
  bool has(Place place) const { return pieces_.count(place) > 0; }

  int total(Place place) const {
    int count = 0;
    if (has(place))
      for (const auto& piece : pieces_.at(place)) count += piece.count;
    return count;
  }

  // What holds the parts together.
  void imply() {
    const bool stem = has(Place::column) || has(Place::upright) || has(Place::stack);
    if (has(Place::hang) && !has(Place::across)) add(implied("beam", 1, Place::across));
    if (has(Place::across) && !stem)
      add(has(Place::hang) ? implied("post", 1, Place::column) : implied("support", 2, Place::upright));
    else if (has(Place::across) && has(Place::stack) && !has(Place::upright))
      add(implied("support", 2, Place::upright));
    if ((has(Place::radial) || has(Place::helix) || has(Place::wheel)) && !stem)
      add(implied("post", 1, Place::column));
    if (total(Place::deck) > 1 && !has(Place::column) && !has(Place::upright))
      add(implied("support", 2, Place::upright));
    // Slender things need something to stand on.
    const bool slender = has(Place::column) && !has(Place::foot) && !has(Place::upright) &&
                         (has(Place::radial) || has(Place::across) || has(Place::helix) || has(Place::wheel) || has(Place::deck));
    if ((slender || has(Place::around)) && !has(Place::base)) add(implied("base", 1, Place::base));
    if (has(Place::upright) && total(Place::deck) == 0 && !has(Place::base) && !has(Place::foot))
      add(implied("base", 1, Place::base));
  }

  // The height, from the floor up.
  void divide() {
    const double height = frame_.size.z();
    const bool tall = has(Place::column) || has(Place::upright) || has(Place::stack) ||
                      has(Place::around) || total(Place::deck) > 1;
    double room = 0.0;
    if (has(Place::top)) room += top_room * height;
    if (has(Place::back)) room += back_room * height;
    frame_.high = height - room;
    if (has(Place::foot)) {
      double feet = 0.0;
      for (const auto& piece : pieces_.at(Place::foot))
        feet = std::max(feet, piece.form.size.z() < 1 ? piece.form.size.z() * height
                              : tall                  ? short_feet * height
                              : has(Place::deck)      ? frame_.high - plate * height
                                                      : 0.5 * frame_.high);
      frame_.low = feet;
    }
    if (has(Place::base))
      for (const auto& piece : pieces_.at(Place::base))
        base_ += piece.count * size_on(piece, frame_.size).z();
    frame_.low += base_;
    frame_.high = std::max(frame_.high, frame_.low + 0.1 * height);
    frame_.framed = has(Place::upright);
  }

  // A pile stands on the column if there are both.
  void divide_between_column_and_pile() {
    split_ = has(Place::column) && has(Place::stack) ? frame_.low + 0.55 * (frame_.high - frame_.low)
                                                     : frame_.high;
  }

  void place_all(Place place) {
    if (!has(place)) return;
    const int count = total(place);
    std::size_t begin = 0;
    for (const auto& piece : pieces_.at(place)) {
      const std::size_t end = begin + static_cast<std::size_t>(piece.count);
      place_some(piece, count, begin, end);
      begin = end;
    }
  }

  void place_some(const Piece& piece, int count, std::size_t begin, std::size_t end) {
    Frame frame = frame_;
    const Place place = piece.place;
    if (place == Place::foot && base_ > 0) frame.low -= base_;
    if (place == Place::stack && has(Place::column)) frame.low = split_;
    if (place == Place::column && has(Place::stack)) frame.high = split_;
    // What is on top is piled up, kind by kind.
    const bool alone = place == Place::top;
    auto where = spots(place, alone ? piece.count : count, size_on(piece, frame.size), frame,
                       piece.wish.series, piece.form.spread);
    if (place == Place::foot)
      for (auto& spot : where) spot.at.z() += base_;
    const auto boxes = put(program_, piece, where, alone ? 0 : begin, alone ? where.size() : end);
    remember(place, boxes);
    if (place == Place::hang) add_cords(program_, boxes, beam_height());
  }

  void remember(Place place, const std::vector<Bounds3>& boxes) {
    const bool core = place == Place::upright || place == Place::column || place == Place::across ||
                      place == Place::deck || place == Place::stack || place == Place::helix;
    if (core) core_.insert(core_.end(), boxes.begin(), boxes.end());
    if (place == Place::top)
      for (const auto& box : boxes)
        if (box.high.z() > frame_.deck.high.z()) frame_.deck = box;
  }

  double beam_height() const {
    double height = frame_.low;
    for (const auto& box : core_) height = std::max(height, box.low.z());
    return height;
  }

  void place_body() {
    Piece body = implied("body", 1, Place::stack);
    body.form.size = Vec3::Ones();
    body.form.form = "block";
    for (const auto& wish : description_.parts) {
      if (!wish.label.empty()) continue;
      const auto& shapes = built_in_parts()->shapes;
      if (const auto shaped = shapes.find(wish.shape); shaped != shapes.end())
        body.form.form = shaped->second;
    }
    place_some(body, 1, 0, 1);
  }

  // The core's largest piece has the faces, its highest one carries.
  void settle_faces() {
    const auto face = [](const Bounds3& box) { return box.size().x() * box.size().z(); };
    frame_.core = *std::max_element(core_.begin(), core_.end(), [&](const auto& a, const auto& b) {
      return face(a) < face(b);
    });
    frame_.deck = *std::max_element(core_.begin(), core_.end(), [](const auto& a, const auto& b) {
      return a.high.z() < b.high.z() - 1e-6;
    });
  }

  const Description& description_;
  shape::Program program_;
  Frame frame_;
  std::map<Place, std::vector<Piece>> pieces_;
  std::vector<Bounds3> core_;
  double base_ = 0.0, split_ = 0.0;
};

Bounds3 box_of_body(const shape::Body& body) {
  Bounds3 box;
  for (const auto& p : body.mesh.positions) box.add(p.cast<double>());
  return box;
}

void raise(shape::Program& program, double by) {
  for (auto& component : program.components) component.at.z() += by;
}

// The frame of a thing that is there.
std::optional<Frame> measured(const shape::Program& program) {
  const auto shape = shape::evaluate(program, {.tolerance = coarse, .paint = false});
  if (!shape || shape->bodies.empty()) return std::nullopt;
  const Bounds3 whole = bounds(*shape);
  Frame frame;
  frame.size = whole.size();
  frame.low = whole.low.z();
  frame.high = whole.high.z();
  frame.deck = whole;
  double greatest = 0.0;
  Bounds3 carrier;
  for (const auto& body : shape->bodies) {
    const Bounds3 box = box_of_body(body);
    const Vec3 size = box.size();
    if (const double face = size.x() * size.z(); face > greatest) greatest = face, frame.core = box;
    // Things stand on the seat or top if there is one, else on the whole.
    if (body.label == "seat" || body.label == "top") {
      carrier.add(box.low);
      carrier.add(box.high);
    }
  }
  if (!carrier.empty()) frame.deck = carrier;
  return frame;
}

}  // namespace

shape::Program compose(const Description& description, const Vec3& size) {
  return Composition(description, size).run();
}

bool attach(shape::Program& program, const PartWish& part) {
  auto frame = measured(program);
  if (!frame) return false;
  const Piece piece = piece_of(part);
  const Vec3 size = size_on(piece, frame->size);
  const double lift = piece.place == Place::base
                          ? piece.count * size.z()
                          : std::clamp(size.z(), least_feet, most_feet);
  // Feet fill what removed ones have left.
  const bool lifts = piece.place == Place::base ||
                     (piece.place == Place::foot && frame->low < least_feet);
  if (lifts) {
    raise(program, lift - frame->low);
    frame->low = lift;
  }
  const auto where = spots(piece.place, piece.count, size, *frame, part.series, piece.form.spread);
  const auto boxes = put(program, piece, where, 0, where.size());
  if (piece.place == Place::hang) add_cords(program, boxes, frame->high);
  return true;
}

}  // namespace roomgen::create
