#include "arrange.h"

#include <algorithm>
#include <cmath>

namespace roomgen::composition {

namespace {

constexpr double above_target = 0.15;  ///< metres from the top of a thing to what hangs over it
constexpr double behind_rim =
    0.03;  ///< metres from the edge of a table to what stands before a seat
constexpr double apart = 0.02, farther = 0.06;  ///< between those at one seat
constexpr double screen_off = 0.5;              ///< from the edge to the middle of a screen
constexpr double far_behind = 5.0,
                 reach = 0.5;  ///< metres from a seat to the edge of its table, at most
constexpr double longest_row = 200;

Error wrong(const Part& part, const std::string& what) {
  return {Error::Kind::invalid_input, "part \"" + part.name + "\": " + what};
}

Vec2 sized(Side side, const Vec2& half) {
  return outward(side).cwiseProduct(half);
}

bool is_across(Side side) {
  return side == Side::left || side == Side::right;
}

Arranged moved_to(const Place& frame, Arranged arranged) {
  for (auto& member : arranged.members) member.place = within(frame, member.place);
  return arranged;
}

Place inverse(const Place& place) {
  return {rotated(-place.position, -place.yaw), wrap_angle(-place.yaw)};
}

// Far deeper than its kind, it is none of those that hang: a boiler on the floor.
bool stands_by_size(const Vec3& size, const Kind& kind) {
  constexpr double deepest = 0.6, least = 0.25, most_of_kind = 2.0;
  const double depth = size.head<2>().minCoeff();
  return depth > deepest ||
         (depth > least && depth > most_of_kind * kind.size.head<2>().minCoeff());
}

/// A thing or a whole group within the one that is made: what parts refer to.
struct Instance {
  Place place;  ///< of the middle of its box
  Vec3 size = Vec3::Ones();
  std::size_t member = 0;  ///< the first of its members
  int unit = -1;           ///< of the anchor's copies the one that it is at
  bool round = false;
};

bool is_screen(const Vec3& size) {
  return size.z() > 0.3 && size.x() > 2.0 * size.y();
}

class Arranging {
 public:
  Arranging(const Composition& composition, const Making& making, std::string path, int depth)
      : composition_(composition), making_(making), path_(std::move(path)), depth_(depth) {}

  Result<Arranged> run(const Values& values) {
    if (depth_ > deepest_nesting)
      return Error{Error::Kind::limit, "\"" + composition_.name + "\": groups nest at most " +
                                           std::to_string(deepest_nesting) + " deep"};
    if (auto status = set_parameters(values); !status) return status.error();
    for (const auto& part : composition_.parts)
      if (auto status = add(part); !status) return status.error();
    if (arranged_.members.empty())
      return Error{Error::Kind::not_found, "\"" + composition_.name + "\": the anchor is left out"};
    const Place to_anchor = inverse(arranged_.members.front().place);
    return moved_to(to_anchor, std::move(arranged_));
  }

 private:
  Status set_parameters(const Values& values) {
    for (const auto& [name, value] : values)
      if (std::none_of(composition_.parameters.begin(), composition_.parameters.end(),
                       [&](const Parameter& one) { return one.name == name; }))
        return Error{Error::Kind::invalid_input,
                     "\"" + composition_.name + "\" has no parameter \"" + name + "\""};
    for (const auto& parameter : composition_.parameters) {
      const auto given = values.find(parameter.name);
      Value value = given == values.end() ? parameter.value : given->second;
      for (const auto& choice : parameter.choices) scope_.words.insert(choice);
      if (double* number = std::get_if<double>(&value); number && parameter.choices.empty())
        *number = std::clamp(*number, parameter.least, parameter.most);
      else if (std::find(parameter.choices.begin(), parameter.choices.end(),
                         number ? std::string() : std::get<std::string>(value)) ==
               parameter.choices.end())
        return Error{Error::Kind::invalid_input,
                     "\"" + composition_.name + "\": \"" + parameter.name + "\" cannot be that"};
      scope_.values[parameter.name] = std::move(value);
    }
    return {};
  }

  // The first formula that cannot be worked out makes the whole group fail.
  double number(const std::optional<Formula>& formula, double fallback) {
    if (!formula) return fallback;
    const auto value = formula->number(scope_);
    if (value) return *value;
    if (!problem_) problem_ = value.error().message;
    return fallback;
  }

  double gap_of(const Part& part) {
    constexpr double clear = 0.02;
    const double gap = number(part.gap, 0.0);
    return gap < 0.0 && making_.tuck < 1.0 ? making_.tuck * gap + (making_.tuck > 0.0 ? 0.0 : clear)
                                           : gap;
  }

  Status add(const Part& part) {
    Arranged unit;
    if (part.kind.empty()) {
      auto made = nested(part);
      // What is left out with its anchor is left out as a whole.
      if (!made && made.error().kind == Error::Kind::not_found) return {};
      if (!made) return made.error();
      unit = *std::move(made);
    } else {
      unit.members.push_back(thing(part));
    }
    const Bounds2 box = box_of(unit, making_.kinds);
    const Vec3 size(box.size().x(), box.size().y(), unit.members.front().size.z());
    unit = moved_to({-0.5 * (box.low + box.high), 0.0}, std::move(unit));
    remember_size(part.name, size);
    if (making_.without.count(path_of(part)) > 0 || (part.when && number(part.when, 1.0) == 0.0))
      return {};
    for (const auto& [place, reference] :
         repeated(part, places(part, size, unit.members.front().mount))) {
      if (arranged_.members.size() + unit.members.size() > most_members)
        return Error{Error::Kind::limit,
                     "a group holds at most " + std::to_string(most_members) + " things"};
      put(part, unit, {place, size}, reference);
    }
    if (problem_) return wrong(part, *problem_);
    return {};
  }

  std::string path_of(const Part& part) const {
    return path_.empty() ? part.name : path_ + "/" + part.name;
  }

  Result<Arranged> nested(const Part& part) {
    const auto found = making_.known.find(part.composition);
    if (found == making_.known.end())
      return wrong(part, "there is no group \"" + part.composition + "\"");
    Values values;
    for (const auto& [name, formula] : part.with) {
      const auto value = formula.value(scope_);
      if (!value) return wrong(part, value.error().message);
      values[name] = *value;
    }
    return Arranging(found->second, making_, path_of(part), depth_ + 1).run(values);
  }

  Member thing(const Part& part) {
    Member member;
    member.part = path_of(part);
    member.category = making_.kind_of ? making_.kind_of(member.part) : "";
    if (member.category.empty()) member.category = part.kind;
    const Kind& kind = making_.kinds.get(member.category);
    member.description = part.description;
    for (int axis = 0; axis < 3; ++axis)
      member.size[axis] = std::clamp(
          number(part.size[static_cast<std::size_t>(axis)], kind.size[axis]), 0.001, 50.0);
    if (const auto real = making_.size_of ? making_.size_of(member.part) : std::nullopt)
      member.size = *real;
    member.mount = mount_of(part, kind, member.size);
    member.varied = part.varied;
    member.spread = part.on && part.where == Where::at && !part.x && !part.y;
    member.spare = part.spare;
    if (part.height) member.height = number(part.height, 0.0);
    return member;
  }

  // What is said of where it is comes before what its kind is used to.
  Mount mount_of(const Part& part, const Kind& kind, const Vec3& size) const {
    if (making_.leans && making_.leans(path_of(part))) return Mount::floor;
    if (part.mount) return *part.mount;
    const bool is_before_it = part.where == Where::around ||
                              (part.where == Where::beside && part.sides.front() == Side::front);
    if (kind.mount == Mount::wall)
      return is_before_it || stands_by_size(size, kind) ? Mount::floor : Mount::wall;
    const bool is_beside = part.where == Where::around || part.where == Where::beside;
    if (kind.mount != Mount::surface || !is_beside) return kind.mount;
    const auto references = instances_.find(part.of);
    const bool is_carried = references != instances_.end() && !references->second.empty() &&
                            carrier_of(references->second.front()).has_value();
    return is_carried ? Mount::surface : Mount::floor;
  }

  // The member that a thing stands on.
  std::optional<std::size_t> carrier_of(const Instance& instance) const {
    const Member& member = arranged_.members[instance.member];
    return member.mount == Mount::surface ? std::optional(member.on) : std::nullopt;
  }

  struct Placed {
    Place place;
    const Instance* reference = nullptr;
  };

  std::vector<Placed> places(const Part& part, const Vec3& size, Mount mount) {
    if (part.of.empty()) return {{Place{}, nullptr}};
    std::vector<Placed> found;
    const auto references = instances_.find(part.of);
    if (references == instances_.end()) return found;
    for (const auto& reference : references->second) {
      for (auto& place : places_at(part, size, mount, reference))
        found.push_back({within(reference.place, place), &reference});
      if (part.first_only) break;
    }
    return found;
  }

  // In the frame of the reference.
  std::vector<Place> places_at(const Part& part, const Vec3& size, Mount mount,
                               const Instance& reference) {
    switch (part.where) {
      case Where::beside:
        return beside(part, size, mount, reference);
      case Where::around:
        return around(part, size, reference);
      case Where::before:
        return before(part, size, reference);
      case Where::at:
        break;
    }
    Place place{Vec2(number(part.x, 0.0), number(part.y, 0.0)), own_yaw(part, 0.0)};
    if (mount == Mount::wall && !part.y) place.position.y() = 0.5 * (reference.size.y() - size.y());
    const bool is_apart = place.position.norm() > 1e-6;  // else an arc says where its copies look
    if (is_apart && part.facing == Facing::to) place.yaw = yaw_facing(-place.position);
    if (is_apart && part.facing == Facing::away) place.yaw = yaw_facing(place.position);
    return {place};
  }

  double own_yaw(const Part& part, double fallback) {
    if (part.yaw) return radians(number(part.yaw, 0.0));
    return part.facing == Facing::opposite ? pi : fallback;
  }

  int count_of(const Part& part) {
    return static_cast<int>(std::clamp(std::round(number(part.count, 1.0)), 0.0, longest_row));
  }

  std::vector<Place> beside(const Part& part, const Vec3& size, Mount mount,
                            const Instance& reference) {
    std::vector<Place> found;
    const Vec2 half = 0.5 * reference.size.head<2>();
    for (const Side side : part.sides) {
      const Vec2 normal = outward(side);
      double yaw = own_yaw(part, 0.0);
      if (part.facing == Facing::to) yaw = yaw_facing(-normal);
      if (part.facing == Facing::away) yaw = yaw_facing(normal);
      const bool turned = std::abs(std::sin(yaw)) > 0.7;
      const Vec2 own = turned ? Vec2(size.y(), size.x()) : Vec2(size.head<2>());
      const double off = 0.5 * normal.cwiseAbs().dot(own) + gap_of(part);
      const double slack = is_across(side) ? half.y() - 0.5 * own.y() : half.x() - 0.5 * own.x();
      double shift = number(part.shift, 0.0);
      // What hangs beside a thing is at the wall behind that.
      const bool is_at_back =
          part.align == Part::Align::back || (mount == Mount::wall && !turned && is_across(side));
      if (is_at_back || part.align == Part::Align::front) shift += is_at_back ? slack : -slack;
      const double length = is_across(side) ? reference.size.y() : reference.size.x();
      for (double along : in_a_row(count_of(part), length, number(part.pitch, 0.0)))
        found.push_back(
            {sized(side, half) + off * normal + (along + shift) * normal.cwiseAbs().reverse(),
             yaw});
    }
    return found;
  }

  std::vector<Place> around(const Part& part, const Vec3& size, const Instance& reference) {
    std::vector<Place> found;
    const Footprint table(Vec2::Zero(), reference.size.head<2>(), 0.0, reference.round);
    for (const auto& seat : seat_places(table, count_of(part)))
      found.push_back(
          {seat.rim + (gap_of(part) + 0.5 * size.y()) * seat.outward,
           yaw_facing(part.facing == Facing::away ? seat.outward : Vec2(-seat.outward))});
    return found;
  }

  // On the reference, before each of the seats that look at it.
  // A screen stands farther away, behind what lies there.
  std::vector<Place> before(const Part& part, const Vec3& size, const Instance& reference) {
    std::vector<Place> found;
    const auto seats = instances_.find(part.seat);
    if (seats == instances_.end()) return found;
    const Footprint table(Vec2::Zero(), reference.size.head<2>(), 0.0, reference.round);
    // To the right of what is at that seat already, and a little farther: a glass by its plate.
    double& taken = at_seats_[{part.of + "/" + part.seat, reference.member}];
    const bool is_behind = !part.gap && is_screen(size);
    const bool is_beside = !part.shift && !is_behind && taken > 0.0;
    const Vec2 off(is_beside ? -taken - 0.5 * size.x() : number(part.shift, 0.0),
                   is_beside ? farther : 0.0);
    if (!is_behind) taken += is_beside ? size.x() + apart : 0.5 * size.x() + apart;
    for (const auto& seat : seats->second) {
      const Place local = within(inverse(reference.place), seat.place);
      const Vec2 ahead = rotated({0, -1}, local.yaw), aside = rotated({1, 0}, local.yaw);
      // From well behind, for who sits with the middle under the table.
      const double edge = ray_hit(table, local.position - far_behind * ahead, ahead) - far_behind;
      if (edge <= -far_behind || edge > 0.5 * seat.size.y() + reach) continue;
      const double far = far_behind - ray_hit(table, local.position + far_behind * ahead, -ahead);
      const double depth = is_behind
                               ? std::min(edge + screen_off, far - behind_rim - 0.5 * size.y())
                               : edge + behind_rim + 0.5 * size.y() + number(part.gap, off.y());
      found.push_back(
          {local.position + depth * ahead + off.x() * aside, wrap_angle(local.yaw + pi)});
    }
    return found;
  }

  std::vector<Placed> repeated(const Part& part, std::vector<Placed> places) {
    if (!part.repeat) return places;
    std::vector<Placed> found;
    for (const auto& one : places)
      for (const auto& copy : copies(*part.repeat, part.facing))
        found.push_back({within(one.place, copy), one.reference});
    return found;
  }

  std::vector<Place> copies(const Repeat& repeat, std::optional<Facing> facing) {
    const auto whole = [&](const Formula& formula) {
      return static_cast<int>(std::clamp(std::round(number(formula, 1.0)), 0.0, longest_row));
    };
    const int most =
        static_cast<int>(std::clamp(number(repeat.number, 1.0), 0.0, most_members + 1.0));
    std::vector<Place> found;
    if (repeat.is_arc) {
      const double from = number(repeat.from, 0), turn = number(repeat.to, 0) - from,
                   radius = number(repeat.radius, 1);
      const bool whole_turn = std::abs(turn) > 359.0;
      for (int i = 0; i < most; ++i) {
        const double share =
            most < 2 ? 0.5 : static_cast<double>(i) / (whole_turn ? most : most - 1);
        const Vec2 away = rotated({1, 0}, radians(from + share * turn));
        found.push_back({radius * away, yaw_facing(facing == Facing::away ? away : Vec2(-away))});
      }
      return found;
    }
    const int columns = whole(repeat.columns);
    const auto xs = in_a_row(columns, 0.0, std::max(1e-6, number(repeat.across, 1)));
    const auto ys = in_a_row(whole(repeat.rows), 0.0, std::max(1e-6, number(repeat.along, 1)));
    for (std::size_t row = 0; row < ys.size(); ++row)
      for (double x : xs)
        if (static_cast<int>(found.size()) < most)
          found.push_back({{x + (row % 2 ? number(repeat.stagger, 0) : 0.0), ys[row]}, 0.0});
    return found;
  }

  // The things of a part, in the frame of the middle of their box, as one more instance of it.
  void put(const Part& part, const Arranged& unit, Instance instance, const Instance* reference) {
    const std::size_t first = instance.member = arranged_.members.size();
    // A copy of the anchor is one as well, with all that is at it.
    if (!part.kind.empty()) instance.unit = reference ? reference->unit : part.repeat ? units_++ : -1;
    const int own_unit = part.kind.empty() ? units_++ : instance.unit;
    for (Member member : unit.members) {
      member.unit = own_unit;
      member.place = within(instance.place, member.place);
      if (member.mount == Mount::surface) member.on += first;
      member.number = numbers_[member.part]++;
      if (!part.kind.empty()) hang(part, reference, member);
      if (part.spare > 0 && (member.spare == 0 || part.spare < member.spare))
        member.spare = part.spare;
      if (part.kind.empty()) know(member, arranged_.members.size());
      arranged_.members.push_back(std::move(member));
    }
    instance.round = !part.kind.empty() && is_round(unit.members.front());
    instances_[part.name].push_back(instance);
  }

  bool is_round(const Member& member) const {
    return making_.kinds.get(member.category).traits.round;
  }

  // The things of a group within this one are known by their names in it, too.
  void know(const Member& member, std::size_t index) {
    const std::string name = member.part.substr(path_.empty() ? 0 : path_.size() + 1);
    instances_[name].push_back({member.place, member.size, index, is_round(member)});
  }

  void hang(const Part& part, const Instance* reference, Member& member) {
    if (!reference) return;
    if (member.mount == Mount::surface)
      member.on = part.on || part.where == Where::at
                      ? reference->member
                      : carrier_of(*reference).value_or(reference->member);
    if (member.mount != Mount::wall || part.height) return;
    if (part.where != Where::at)
      member.height = arranged_.members[reference->member].height;
    else
      member.height = reference->size.z() + number(part.gap, above_target) + 0.5 * member.size.z();
  }

  // Later parts may use its measures: chair_w, chair_d, chair_h.
  void remember_size(std::string name, const Vec3& size) {
    for (char& c : name)
      if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    scope_.values[name + "_w"] = size.x();
    scope_.values[name + "_d"] = size.y();
    scope_.values[name + "_h"] = size.z();
  }

  const Composition& composition_;
  const Making& making_;
  std::string path_;
  int depth_;
  shape::Scope scope_;
  Arranged arranged_;
  std::map<std::string, std::vector<Instance>> instances_;
  std::map<std::string, std::size_t> numbers_;
  /// By the parts and the copy of what carries: metres, from the middle to the right.
  std::map<std::pair<std::string, std::size_t>, double> at_seats_;
  int units_ = 0;
  std::optional<std::string> problem_;
};

}  // namespace

Result<Arranged> arrange(const Composition& composition, const Values& values,
                         const Making& making) {
  return Arranging(composition, making, "", 1).run(values);
}

std::vector<Arranged> units_of(const Arranged& arranged) {
  std::vector<Arranged> units;
  std::vector<std::size_t> now(arranged.members.size());
  for (std::size_t i = 0; i < arranged.members.size(); ++i) {
    Member member = arranged.members[i];
    if (member.unit < 0) continue;
    units.resize(std::max(units.size(), static_cast<std::size_t>(member.unit) + 1));
    Arranged& unit = units[static_cast<std::size_t>(member.unit)];
    if (member.mount == Mount::surface) member.on = now[member.on];
    now[i] = unit.members.size();
    unit.members.push_back(std::move(member));
  }
  std::erase_if(units, [](const Arranged& unit) { return unit.members.empty(); });
  for (auto& unit : units) {
    const Place to_anchor = inverse(unit.members.front().place);
    unit = moved_to(to_anchor, std::move(unit));
  }
  return units;
}

Arranged mirrored(Arranged arranged) {
  for (auto& member : arranged.members) {
    member.place.position.x() = -member.place.position.x();
    member.place.yaw = wrap_angle(-member.place.yaw);
  }
  return arranged;
}

Bounds2 box_of(const Arranged& arranged, const KindTable& kinds) {
  Bounds2 box;
  const bool are_flat = kinds.get(arranged.members.front().category).traits.flat;
  for (const auto& member : arranged.members) {
    const Kind& kind = kinds.get(member.category);
    if (member.mount != Mount::floor || (kind.traits.flat && !are_flat)) continue;
    const Footprint own(member.place.position, member.size.head<2>(), member.place.yaw,
                        kind.traits.round);
    for (const Vec2& corner : own.outline()) box.add(corner);
  }
  if (box.low.x() > box.high.x())
    box = {-0.5 * arranged.members.front().size.head<2>(),
           0.5 * arranged.members.front().size.head<2>()};
  return box;
}

}  // namespace roomgen::composition
