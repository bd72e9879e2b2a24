#include <algorithm>
#include <map>
#include <utility>

#include "piece.h"
#include "roomgen/shape/evaluate.h"
#include "rule_steps.h"

namespace roomgen::create {

namespace {

// Shares of the height.
constexpr double short_feet = 0.18, top_room = 0.2, back_room = 0.4, plate = 0.05;
constexpr double pile_room = 0.5;
constexpr double least_feet = 0.06, most_feet = 0.15;  ///< below things that had none, metres
constexpr const char* body_surface = "body";

constexpr Place core_places[] = {Place::upright, Place::column, Place::across,
                                 Place::deck,    Place::helix,  Place::stack};
constexpr Place outer_places[] = {Place::radial, Place::wheel, Place::around, Place::hang,
                                  Place::back,   Place::side,  Place::front,  Place::top};

/// Parts by their places, put on a frame.
class Setting {
 public:
  explicit Setting(shape::Program& program) : program_(program) {}

  void add(Piece piece) {
    if (piece.count > 0) pieces_[piece.place].push_back(std::move(piece));
  }
  bool has(Place place) const { return pieces_.count(place) > 0; }
  const std::vector<Piece>& at(Place place) const { return pieces_.at(place); }

  int total(Place place) const {
    int count = 0;
    if (has(place))
      for (const auto& piece : at(place)) count += piece.count;
    return count;
  }

  // What nobody knows stands all around a column, if there is one, as horses around a carousel.
  void spread_unknown() {
    if (!has(Place::column) || !has(Place::front)) return;
    std::vector<Piece> fronts = std::exchange(pieces_[Place::front], {});
    pieces_.erase(Place::front);
    for (auto& piece : fronts) {
      if (!piece.form.known && !piece.wish.place) piece.place = Place::radial;
      add(std::move(piece));
    }
  }

  // Several parts of one place share it. Returns the boxes of all copies.
  std::vector<Bounds3> put(Place place, const Frame& frame, double upward = 0.0) {
    std::vector<Bounds3> boxes;
    if (!has(place)) return boxes;
    const int count = total(place);
    std::size_t begin = 0;
    for (const auto& piece : at(place)) {
      auto where = spots(place, count, size_on(piece, frame.size), frame, piece.wish.series,
                         piece.form.spread);
      for (auto& spot : where) spot.at.z() += upward;
      const std::size_t end = begin + static_cast<std::size_t>(piece.count);
      const auto placed = create::put(program_, piece, where, begin, end);
      boxes.insert(boxes.end(), placed.begin(), placed.end());
      begin = end;
    }
    return boxes;
  }

  // On top parts are piled up, kind by kind.
  void pile(Frame frame) {
    if (!has(Place::top)) return;
    for (const auto& piece : at(Place::top)) {
      const auto where = spots(Place::top, piece.count, size_on(piece, frame.size), frame,
                               piece.wish.series, piece.form.spread);
      for (const auto& box : create::put(program_, piece, where, 0, where.size()))
        if (box.high.z() > frame.deck.high.z()) frame.deck = box;
    }
  }

 private:
  shape::Program& program_;
  std::map<Place, std::vector<Piece>> pieces_;
};

class Composition {
 public:
  Composition(const Description& description, const Vec3& size)
      : description_(description), setting_(program_) {
    frame_.size = size;
    program_.name = description.noun.empty() ? "object" : description.noun;
    program_.about = "approximate: " + description.prompt;
    program_.materials = {{body_surface, "oak", 0.6, 0.0, 1.0, "grain", "", 1.0}};
  }

  shape::Program run() {
    for (const auto& wish : description_.parts)
      if (!wish.label.empty()) setting_.add(piece_of(wish));
    setting_.spread_unknown();
    imply();
    divide();
    Frame below = frame_;
    below.low -= base_;
    setting_.put(Place::foot, below);
    setting_.put(Place::base, frame_, below.low);
    for (const Place place : core_places) put_core(place);
    if (core_.empty()) put_body();
    settle_faces();
    for (const Place place : outer_places) put_outer(place);
    return std::move(program_);
  }

 private:
  bool has(Place place) const { return setting_.has(place); }

  // What holds the parts together.
  void imply() {
    const bool stem = has(Place::column) || has(Place::upright) || has(Place::stack);
    const bool outward = has(Place::radial) || has(Place::helix) || has(Place::wheel);
    const int boards = setting_.total(Place::deck);
    const auto add = [&](const char* label, int count, Place place) {
      setting_.add(implied(label, count, place));
    };
    if (has(Place::hang) && !has(Place::across)) add("beam", 1, Place::across);
    if (has(Place::across) && !has(Place::upright) && !has(Place::column)) {
      if (has(Place::hang) && !has(Place::stack)) add("post", 1, Place::column);
      else add("support", 2, Place::upright);
    }
    if (setting_.total(Place::column) > 2 && boards == 0 && !has(Place::across))
      add("rail", 2, Place::across);  // a fence, an abacus
    if (outward && !stem && boards == 0) add("post", 1, Place::column);
    if (boards > 1 && !has(Place::column) && !has(Place::upright)) add("support", 2, Place::upright);
    // Slender things need something to stand on.
    const bool slender =
        has(Place::column) && (outward || has(Place::across) || boards > 0);
    const bool bare = has(Place::upright) && boards == 0;
    const bool on_feet = setting_.total(Place::foot) > 1 && has(Place::column) && boards == 0;
    const bool needs_base = bare || on_feet || has(Place::around) || (slender && !has(Place::foot));
    if (needs_base && !has(Place::base)) add("base", 1, Place::base);
  }

  // The height, from the floor up.
  void divide() {
    // What lies around on the floor is no tower.
    if (has(Place::around)) frame_.size.z() = std::min(frame_.size.z(), frame_.size.head<2>().minCoeff());
    const double height = frame_.size.z();
    frame_.framed = has(Place::upright);
    frame_.high = height - (has(Place::top) ? top_room * height : 0.0) -
                  (has(Place::back) ? back_room * height : 0.0);
    if (has(Place::base))
      for (const auto& piece : setting_.at(Place::base))
        base_ += piece.count * size_on(piece, frame_.size).z();
    frame_.low = base_ + feet_height();
    frame_.high = std::max(frame_.high, frame_.low + 0.1 * height);
    // A pile stands on the column if there are both, and within a ring is room for half the size.
    split_ = has(Place::column) && has(Place::stack)
                 ? frame_.low + 0.55 * (frame_.high - frame_.low)
                 : frame_.high;
    inner_ = frame_;
    if (has(Place::around)) {
      inner_.size.head<2>() *= 0.5;
      inner_.high = frame_.low + 0.6 * (frame_.high - frame_.low);
    }
  }

  double feet_height() const {
    if (!has(Place::foot)) return 0.0;
    const double height = frame_.size.z();
    const int boards = setting_.total(Place::deck);
    const bool tall = has(Place::column) || has(Place::upright) || has(Place::stack) ||
                      has(Place::around) || boards > 1;
    double feet = 0.0;
    for (const auto& piece : setting_.at(Place::foot)) {
      const double own = piece.form.size.z();
      feet = std::max(feet, own < 1      ? own * height
                            : tall       ? short_feet * height
                            : boards > 0 ? frame_.high - base_ - plate * height
                                         : 0.5 * frame_.high);
    }
    return feet;
  }

  void put_core(Place place) {
    Frame frame = inner_;
    if (place == Place::stack && has(Place::column)) frame.low = split_;
    if (place == Place::column) frame.high = split_;
    const auto boxes = setting_.put(place, frame);
    core_.insert(core_.end(), boxes.begin(), boxes.end());
  }

  void put_outer(Place place) {
    if (place == Place::top) return setting_.pile(faces_);
    const auto boxes = setting_.put(place, place == Place::around ? frame_ : faces_);
    if (place != Place::hang) return;
    double beam = frame_.low;
    for (const auto& box : core_) beam = std::max(beam, box.low.z());
    add_cords(program_, boxes, beam);
  }

  void put_body() {
    Piece body = implied("body", 1, Place::stack);
    body.form.size = Vec3::Ones();
    body.form.form = "block";
    for (const auto& wish : description_.parts) {
      if (!wish.label.empty()) continue;
      const auto& shapes = built_in_parts()->shapes;
      if (const auto shaped = shapes.find(wish.shape); shaped != shapes.end())
        body.form.form = shaped->second;
    }
    setting_.add(std::move(body));
    put_core(Place::stack);
  }

  // The core's largest piece has the faces (all of them between uprights), its highest one carries.
  void settle_faces() {
    faces_ = inner_;
    const auto face = [](const Bounds3& box) { return box.size().x() * box.size().z(); };
    faces_.core = *std::max_element(core_.begin(), core_.end(), [&](const auto& a, const auto& b) {
      return face(a) < face(b);
    });
    faces_.deck = *std::max_element(core_.begin(), core_.end(), [](const auto& a, const auto& b) {
      return a.high.z() < b.high.z() - 1e-6;
    });
    if (!frame_.framed) return;
    for (const auto& box : core_) {
      faces_.core.add(box.low);
      faces_.core.add(box.high);
    }
  }

  const Description& description_;
  shape::Program program_;
  Setting setting_;
  Frame frame_;  ///< of the whole
  Frame inner_;  ///< of what stands in the middle
  Frame faces_;  ///< of that with its faces
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
  const auto shape = shape::evaluate(program, shape::for_measuring);
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

// Room for feet and bases below. Feet fill what removed ones have left; round ones cannot be taller
// than wide.
void stand_on(const Setting& setting, shape::Program& program, Frame& frame) {
  if (!setting.has(Place::foot) && !setting.has(Place::base)) return;
  double wanted = frame.low > least_feet ? frame.low : 0.0;
  for (const Place place : {Place::foot, Place::base}) {
    if (!setting.has(place)) continue;
    for (const auto& piece : setting.at(place)) {
      const double height = size_on(piece, frame.size).z();
      if (place == Place::base) wanted = std::max(wanted, piece.count * height);
      else if (frame.low <= least_feet)
        wanted = std::max(wanted, std::clamp(height, least_feet, most_feet));
      if (place == Place::foot && piece.form.same.find('z') != std::string::npos)
        wanted = std::min(wanted, 0.4 * frame.size.head<2>().minCoeff());
    }
  }
  const double by = wanted - frame.low;
  raise(program, by);
  frame.low = wanted;
  frame.high += by;
  for (Bounds3* box : {&frame.core, &frame.deck}) box->low.z() += by, box->high.z() += by;
}

}  // namespace

shape::Program compose(const Description& description, const Vec3& size) {
  return Composition(description, size).run();
}

bool attach(shape::Program& program, const std::vector<PartWish>& parts) {
  auto frame = measured(program);
  if (!frame) return false;
  Setting setting(program);
  for (const auto& part : parts) setting.add(piece_of(part));
  stand_on(setting, program, *frame);
  setting.put(Place::base, *frame);
  setting.put(Place::foot, *frame);
  for (const Place place : core_places) {
    // Piles stand on the thing.
    Frame above = *frame;
    if (place == Place::stack) {
      above.low = frame->deck.high.z();
      above.high = above.low + pile_room * frame->size.z();
    }
    // A column takes the place of legs that were removed.
    if (place == Place::column && frame->low > least_feet && !setting.has(Place::foot)) {
      above.high = frame->low + 0.005;
      above.low = 0.0;
    }
    setting.put(place, above);
  }
  for (const Place place : outer_places) {
    if (place == Place::top) {
      setting.pile(*frame);
      continue;
    }
    const auto boxes = setting.put(place, *frame);
    if (place == Place::hang) add_cords(program, boxes, frame->high);
  }
  return true;
}

}  // namespace roomgen::create
