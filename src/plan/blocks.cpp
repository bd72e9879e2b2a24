#include "blocks.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "block_site.h"
#include "fitting.h"
#include "roomgen/base/text.h"

namespace roomgen::plan {

namespace {

constexpr double least_behind = 0.55, behind_seats = 0.75, least_beside = 0.1, in_one_row = 0.02;  ///< metres between things
constexpr double behind_one = 0.9, behind_sitter = 0.45;  ///< metres to what is behind a thing, or behind who sits at it
constexpr double drawn_up = 0.1;                          ///< metres that who sits at a table is under it
constexpr double least_at_wall = 0.3, usual_at_wall = 0.6;  ///< metres between those who sit before a wall
constexpr double around_focus = 0.35;   ///< metres between what stands in the middle and those around it
constexpr double free_middle = 0.5;     ///< metres from the middle to the fronts around it, where nothing stands there
constexpr double view = 1.4;            ///< metres between those in an arc and what they look at
constexpr double beside_in_ring = 0.6;  ///< metres between neighbours
constexpr double between_islands = 1.0; ///< metres between the seats of neighbouring islands
constexpr double half_circle = 180.0, arc_at_focus = 140.0;  ///< degrees

std::string metres(double value) { return format_number(value, 3); }

nlohmann::json unit_of(const FormedBlock& block) {
  nlohmann::json unit{{"part", block_unit}};
  if (block.composition.empty()) {
    unit["kind"] = block.thing.item.category;
    return unit;
  }
  unit["group"] = block.composition;
  for (const auto& [name, value] : block.with)
    if (const double* number = std::get_if<double>(&value)) unit["with"][name] = *number;
  return unit;
}

// At its left or right: what is told so; and of what is only near, all that no seat is in the way of.
bool stands_beside(const FormedBlock& block, const Draft& companion, const KindTable& kinds) {
  const auto is_told = [](const brief::Demand& demand) {
    return demand.flank || demand.kind == RelationKind::left_of || demand.kind == RelationKind::right_of;
  };
  const auto is_near = [](const brief::Demand& demand) {
    return demand.kind == RelationKind::near || demand.kind == RelationKind::next_to || demand.kind == RelationKind::side_of;
  };
  const auto& category = companion.item.category;
  const bool is_free_there = block.count == 1 || !kinds.is_a(block.thing.item.category, "table");
  return std::any_of(companion.demands.begin(), companion.demands.end(), is_told) ||
         (is_free_there && !kinds.is_a(category, "seat") && kinds.get(category).foot == 0.0 &&
          std::all_of(companion.demands.begin(), companion.demands.end(), is_near));
}

// What is told of its place at the thing; what is only near stands off a corner, where no seat is.
nlohmann::json part_of_companion(const FormedBlock& block, std::size_t number, const KindTable& kinds) {
  const Draft& companion = block.companions[number];
  const PlanItem& item = companion.item;
  nlohmann::json part{{"part", item.part}, {"kind", item.category}, {"count", item.quantity}};
  const bool sits = kinds.is_a(item.category, "seat");
  const auto beside = [&](const char* side, const char* facing, double gap) {
    part["beside"] = block_unit, part["side"] = side, part["facing"] = facing, part["gap"] = gap;
    return part;
  };
  const auto at_side = [&](const char* side) {
    beside(side, "same", sits ? 0.15 : 0.05);
    part["beside"] = block.anchor, part["align"] = "back";
    return part;
  };
  const auto around = [&] {
    part["around"] = block.anchor, part["gap"] = -drawn_up;
    return part;
  };
  for (const auto& demand : companion.demands) {
    if (demand.flank && demand.kind != RelationKind::around) {
      part["count"] = std::max(1, item.quantity / 2);
      return beside("sides", sits ? "to" : "same", 0.05);
    }
    switch (demand.kind) {
      case RelationKind::around:
        return around();
      case RelationKind::in_front_of:
        return beside("front", "to", sits ? -0.1 : 0.3);
      case RelationKind::behind:
        return beside("back", sits ? "to" : "same", sits ? 0.05 : 0.1);
      case RelationKind::left_of:
        return at_side("left");
      case RelationKind::right_of:
        return at_side("right");
      default:
        break;
    }
  }
  if (sits) return around();
  if (stands_beside(block, companion, kinds)) return at_side(number % 2 ? "right" : "left");
  part["of"] = block_unit;
  const char* turn[] = {"", "-1 * ", "", "-1 * "};
  const double foot = kinds.get(item.category).foot;
  const auto off = [&](const char* sign, const std::string& side) {
    const std::string own = foot > 0.0 ? metres(foot) : item.part + "_" + side;
    return sign + ("(unit_" + side + " / 2 + " + own + " / 2)");
  };
  part["at"] = {off(turn[number % 4], "w"), off(turn[number / 2 % 4], "d")};
  part.erase("count");
  return part;
}

void add_companions(const FormedBlock& block, const KindTable& kinds, nlohmann::json& parts) {
  for (std::size_t i = 0; i < block.companions.size(); ++i)
    parts.push_back(part_of_companion(block, i, kinds));
}

nlohmann::json one_of(const FormedBlock& block, const KindTable& kinds) {
  auto unit = unit_of(block);
  auto parts = nlohmann::json::array();
  if (!block.behind.empty()) {
    parts.push_back({{"part", block_behind}, {"kind", block.behind}});
    unit["beside"] = block_behind, unit["side"] = "front", unit["facing"] = block.looks_over ? "to" : "same";
    double gap = block.composition.empty() || !block.looks_over ? behind_one : behind_sitter;
    for (const auto& zone : kinds.get(block.behind).zones)
      if (zone.side == Side::front) gap = std::max(gap, zone.depth + in_one_row);
    unit["gap"] = gap;
  }
  parts.push_back(std::move(unit));
  add_companions(block, kinds, parts);
  return {{"parts", parts}, {"mirrors", true}};
}

nlohmann::json open_parameter() {
  return {{"default", 1.0}, {"least", 0.1}, {"most", 1.0}, {"try", {0.5, 0.2}}};
}

// Between neighbours stays open what the thing wants, less what the unit has there anyway.
std::string pitch(const std::string& unit, double least, double usual, double with_reserve) {
  return unit + " + max(" + metres(least) + ", open * max(" + metres(usual) + ", " + metres(with_reserve) + " - " + unit + "))";
}

// Metres that what is at each thing needs between two of them, across and along.
Vec2 taken_by_companions(const FormedBlock& block, const KindTable& kinds) {
  Vec2 taken = Vec2::Zero();
  const bool is_round = kinds.get(block.thing.item.category).traits.round;
  for (const auto& companion : block.companions) {
    const int count = companion.item.quantity;
    const Vec3 size = companion.item.size.value_or(kinds.get(companion.item.category).size);
    if (stands_beside(block, companion, kinds)) taken.x() += count * size.x();
    if (!kinds.is_a(companion.item.category, "seat")) continue;
    const double out = size.y() - drawn_up;
    if (count > (is_round ? 2 : 4)) taken.x() = 2.0 * out;
    taken.y() = (count > 1 ? 2.0 : 1.0) * out;
  }
  return taken;
}

nlohmann::json rows_of(const FormedBlock& block, const KindTable& kinds, const Arrangements& arrangements) {
  const PlanItem& item = block.thing.item;
  const auto& reserve = arrangements.get(kinds, item.category, item.mount).reserve;
  const auto open = [&](Side one, Side other) {
    return reserve[static_cast<std::size_t>(one)] + reserve[static_cast<std::size_t>(other)];
  };
  const bool hangs = item.mount == Mount::wall;
  const double beside = hangs ? least_at_wall : block.formation.rows == 1 ? in_one_row : least_beside;
  const double usual = hangs ? usual_at_wall : beside;
  // Behind who sits at something one passes.
  const bool has_seats = !block.composition.empty() || !block.companions.empty();
  const double behind = has_seats ? behind_seats : least_behind;
  auto unit = unit_of(block);
  const auto count = static_cast<double>(block.count);
  const Vec2 taken = taken_by_companions(block, kinds);
  unit["repeat"] = {{"rows", "ceil(" + metres(count) + " / columns)"},
                    {"columns", "columns"},
                    {"number", count},
                    {"across", pitch("unit_w", beside + taken.x(), usual + taken.x(), item.size->x() + open(Side::left, Side::right))},
                    {"along", pitch("unit_d", least_behind + taken.y(), behind + taken.y(), item.size->y() + open(Side::front, Side::back))}};
  const double columns = static_cast<double>(columns_of(block.formation, static_cast<std::size_t>(block.count)));
  const nlohmann::json across = {{"default", columns}, {"least", 1}, {"most", count}};
  auto parts = nlohmann::json::array({unit});
  add_companions(block, kinds, parts);
  return {{"parameters", {{"columns", across}, {"open", open_parameter()}}}, {"parts", parts}};
}

// Neighbours' nearest corners, which are those towards the middle, are a gap apart.
nlohmann::json ring_of(const FormedBlock& block, const KindTable& kinds) {
  const bool is_circle = block.formation.shape == brief::Formation::Shape::circle;
  const double turn = is_circle ? 360.0 : block.has_focus ? arc_at_focus : half_circle;
  const double step = radians(turn) / (is_circle ? block.count : block.count - 1);
  const double factor = 0.5 / std::tan(0.5 * std::min(step, 0.5 * pi));
  const bool is_around = is_circle || std::any_of(block.thing.demands.begin(), block.thing.demands.end(),
                                                  [](const auto& one) { return one.kind == RelationKind::around; });
  const std::string inside = !block.has_focus ? metres(free_middle)
                                          : "0.5 * max(focus_w, focus_d) + " + metres(is_around ? around_focus : view);
  auto unit = unit_of(block);
  unit["repeat"] = {{"number", block.count},
                    {"radius", "unit_d / 2 + max(" + inside + ", " + metres(factor) + " * (unit_w + max(0.05, open * " +
                                   metres(beside_in_ring) + ")))"}};
  const double from = is_circle ? 90.0 + 180.0 / block.count : block.has_focus ? 270.0 - 0.5 * turn : 0.0;
  unit["repeat"]["from"] = from, unit["repeat"]["to"] = from + turn;
  if (block.looks_over) unit["facing"] = "away";
  auto parts = nlohmann::json::array();
  if (block.has_focus) {
    parts.push_back({{"part", block_focus}, {"kind", block.focus_kind}});
    unit["of"] = block_focus, unit["at"] = {0, 0};
  }
  parts.push_back(std::move(unit));
  add_companions(block, kinds, parts);
  return {{"parameters", {{"open", open_parameter()}}}, {"parts", parts}};
}

// Two lines of places that meet where nobody sits, so many such islands as there are things for.
nlohmann::json islands_of(const FormedBlock& block) {
  const int places = places_of(block), islands = block.count / places, in_line = (places + 1) / 2;
  const char* meeting = block.looks_over ? "back" : "front";
  auto parts = nlohmann::json::array();
  for (int place = 0; place < places; ++place) {
    auto unit = unit_of(block);
    unit["part"] = unit_name(place);
    if (place == 0) {
      unit["repeat"] = {{"rows", "ceil(" + metres(islands) + " / columns)"},
                        {"columns", "columns"},
                        {"number", islands},
                        {"across", metres(in_line) + " * unit_w + max(0.6, open * " + metres(between_islands) + ")"},
                        {"along", metres(places > 1 ? 2 : 1) + " * unit_d + max(0.55, open * " + metres(between_islands) + ")"}};
    } else if (place < in_line) {
      unit["beside"] = unit_name(place - 1), unit["side"] = "left", unit["gap"] = 0.005;
    } else {
      unit["beside"] = unit_name(place - in_line), unit["side"] = meeting;
      unit["gap"] = 0.005, unit["facing"] = "opposite";
    }
    parts.push_back(std::move(unit));
  }
  const double columns = std::ceil(std::sqrt(islands));
  const nlohmann::json across = {{"default", columns}, {"least", 1}, {"most", islands}, {"try", {1, islands}}};
  return {{"parameters", {{"columns", across}, {"open", open_parameter()}}}, {"parts", parts}};
}

struct Site {
  composition::Values values;
  double facing = 0.0;
  Vec2 location = Vec2::Zero(), center = Vec2::Zero();
  std::size_t wall = 0;
};

/// Looks for the wall that a block can look at.
class Siting {
 public:
  Siting(const FormedBlock& block, const composition::Composition& composition, const composition::Making& making,
         const Room& room, const std::vector<Draft>& drafts)
      : block_(block),
        composition_(composition),
        making_(making),
        room_(room),
        drafts_(drafts),
        foci_(foci_of(block.thing, drafts, making.kinds)),
        is_crowded_(is_crowded()) {}

  const std::vector<std::size_t>& foci() const { return foci_; }

  // The loosest of the blocks that the words allow: as wide as usual, else narrower or wider.
  std::optional<Site> loosest() const {
    constexpr double closenesses[] = {1.0, 0.75, 0.5, 0.25, 0.1};
    for (const double open : closenesses)
      for (const double columns : widths())
        if (const auto site = site_for(columns, open)) return site;
    return std::nullopt;
  }

 private:
  std::vector<double> widths() const {
    const auto count = static_cast<std::size_t>(block_.count);
    if (block_.formation.shape == brief::Formation::Shape::islands) {
      const int islands = block_.count / places_of(block_);
      std::vector<double> all;
      for (int n = islands; n > 0; --n) all.push_back(n);
      const auto off_square = [&](double columns) { return std::abs(columns * columns - islands); };
      std::stable_sort(all.begin(), all.end(), [&](double a, double b) { return off_square(a) < off_square(b); });
      return all;
    }
    const std::size_t usual = columns_of(block_.formation, count);
    std::vector<double> widths = {static_cast<double>(usual)};
    if (block_.formation.shape != brief::Formation::Shape::rows) return widths;
    if (block_.formation.rows > 0 || block_.formation.columns > 0) return widths;
    for (std::size_t off = 1; off < count; ++off) {
      if (usual > off + 1) widths.push_back(static_cast<double>(usual - off));
      if (2 * (usual + off) <= count + 1) widths.push_back(static_cast<double>(usual + off));
    }
    return widths;
  }

  std::optional<Site> site_for(double columns, double open) const {
    Site site{{{"open", open}}};
    if (!block_.formation.is_round()) site.values["columns"] = columns;
    const auto arranged = composition::arrange(composition_, site.values, making_);
    if (!arranged) return std::nullopt;
    const Bounds2 box = composition::box_of(*arranged, making_.kinds), floor = floor_of(block_.thing, room_);
    const double before = depth_of_foci();
    std::optional<double> least;
    for (std::size_t wall = 0; wall < room_.polygon.size(); ++wall) {
      const Vec2 forward = -room_.polygon.inward(wall);
      const double yaw = anchor_yaw(yaw_facing(forward));
      const double cost = cost_of_facing(room_, wall, block_.thing, foci_, drafts_);
      const Vec2 own = rotated(box.size(), yaw).cwiseAbs();
      const Vec2 spare = floor.size() - own - before * forward.cwiseAbs();
      if ((least && cost >= *least) || (spare.array() < 2.0 * margin - 1e-6).any()) continue;
      least = cost;
      site.wall = wall, site.facing = yaw;
      const double ahead = is_crowded_ ? 0.5 * spare.cwiseProduct(forward.cwiseAbs()).sum() - margin : 0.0;
      site.center = 0.5 * (floor.low + floor.high) + (ahead - 0.5 * before) * forward;
      site.location = site.center - rotated(0.5 * (box.low + box.high), yaw);
    }
    return least ? std::optional(site) : std::nullopt;
  }

  // Of the floor between the block and the wall that it looks at, what they take.
  double depth_of_foci() const {
    double depth = foci_.empty() ? 0.0 : before_audience;
    for (const std::size_t i : foci_) {
      const PlanItem& item = drafts_[i].item;
      if (item.mount == Mount::floor && item.size) depth = std::max(depth, item.size->y() + before_stage);
    }
    return depth;
  }

  // Whether there is much else that wants floor.
  bool is_crowded() const {
    constexpr double much = 0.06;  ///< of the floor, without what is open around things
    double others = 0.0;
    for (const auto& draft : drafts_)
      if (draft.item.group != block_.group) others += floor_area(draft.item, making_.kinds);
    return others > much * area(room_.polygon);
  }

  // Of the first of the things, where the block as a whole looks that way.
  double anchor_yaw(double yaw) const {
    const double turned = block_.looks_over ? pi : 0.0;
    return wrap_angle(yaw + turned + (block_.formation.is_round() ? yaw_facing({-1, 0}) : 0.0));
  }

  const FormedBlock& block_;
  const composition::Composition& composition_;
  const composition::Making& making_;
  const Room& room_;
  const std::vector<Draft>& drafts_;
  std::vector<std::size_t> foci_;
  bool is_crowded_;
};

}  // namespace

std::string definition_of(const FormedBlock& block, const KindTable& kinds, const Arrangements& arrangements) {
  if (block.count == 1) return one_of(block, kinds).dump();
  if (block.formation.shape == brief::Formation::Shape::islands) return islands_of(block).dump();
  if (block.formation.is_round()) return ring_of(block, kinds).dump();
  return rows_of(block, kinds, arrangements).dump();
}

void stand_in_room(const FormedBlock& block, const KindTable& kinds, const Room& room, std::vector<Draft>& drafts,
                   PlanGroup& group) {
  const bool is_circle = block.formation.shape == brief::Formation::Shape::circle;
  if (is_circle || block.has_focus || block.count == 1 || block.formation.rows == 1) return;
  const auto json = parse_json(group.definition, group.id);
  const auto composition = composition::read_composition(*json, group.id, group.id);
  composition::Making making{*composition::built_in_compositions(), kinds};
  making.without = group.without;
  making.size_of = [&](const std::string& part) -> std::optional<Vec3> {
    for (const auto& draft : drafts)
      if (draft.item.group == group.id && draft.item.part == part) return draft.item.size;
    return std::nullopt;
  };
  const Siting siting(block, *composition, making, room, drafts);
  const auto site = siting.loosest();
  if (!site) return;
  group.parameters = site->values;
  group.location = site->location;
  group.facing = site->facing;
  put_at_wall(siting.foci(), block.thing, site->wall, site->center, room, drafts);
}

bool is_place_at(RelationKind kind) {
  using enum RelationKind;
  static const std::set<RelationKind> kinds = {near,   next_to, around,   side_of, in_front_of,
                                               behind, left_of, right_of, face_to, on, above};
  return kinds.count(kind) > 0;
}

bool is_place_at_side(RelationKind kind) {
  return is_place_at(kind) && kind != RelationKind::near && kind != RelationKind::face_to && kind != RelationKind::on;
}

int places_of(const FormedBlock& block) {
  const bool are_islands = block.formation.shape == brief::Formation::Shape::islands;
  return are_islands ? std::clamp(block.formation.columns, 1, block.count) : 1;
}

std::string unit_name(int place) { return block_unit + (place == 0 ? "" : std::to_string(place)); }

std::vector<std::size_t> told_companions(const Draft& thing, int count, const std::vector<Draft>& drafts,
                                         const KindTable& kinds) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    const Draft& one = drafts[i];
    const bool may_be = is_free(one) && one.item.mount == Mount::floor && one.mention != thing.mention;
    if (!may_be || one.demands.empty() || one.item.quantity < count || one.item.quantity % count != 0) continue;
    const bool is_told = std::all_of(one.demands.begin(), one.demands.end(), [&](const brief::Demand& demand) {
      return demand.mention != brief::Demand::none && demand.mention == thing.mention && is_place_at(demand.kind);
    });
    // What is larger finds its own place near by.
    constexpr double largest = 1.2;
    const bool is_small = kinds.get(one.item.category).foot > 0.0 ||
                          (one.item.size && one.item.size->head<2>().maxCoeff() < largest);
    if (is_told && is_small && thing.mention != brief::Demand::none) found.push_back(i);
  }
  return found;
}

std::size_t columns_of(const brief::Formation& formation, std::size_t count) {
  constexpr double breadth = 1.5;  ///< a block whose rows were not counted is somewhat wider than deep
  if (formation.columns > 0) return static_cast<std::size_t>(formation.columns);
  const auto usual = static_cast<std::size_t>(std::sqrt(static_cast<double>(count) / breadth));
  const std::size_t rows =
      formation.rows > 0 ? static_cast<std::size_t>(formation.rows) : std::max<std::size_t>(2, usual);
  return std::max<std::size_t>(1, (count + rows - 1) / rows);
}

}  // namespace roomgen::plan
