#include "learned_things.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "composition/patterns.h"
#include "roomgen/base/text.h"
#include "scene/written_asset.h"

namespace roomgen::book {

namespace {

using composition::Place;

constexpr double fits = 0.06;          ///< metres by which a pattern may miss a thing
constexpr double fits_turn = 0.1;      ///< radians
constexpr double little_off = 0.05;    ///< metres
constexpr double little_turned = 3.0;  ///< degrees
constexpr double below_top = 0.03;     ///< metres, of what lies on a board within a thing
constexpr std::size_t many_alike = 3;  ///< of small things on one: they share its top evenly
constexpr double least_gap = -0.45, most_gap = 0.9, most_aside = 0.4;

double in_file(double value) {
  return rounded(value, 3);
}

Place place_in(const Object& thing, const Object& frame) {
  return {rotated(thing.position.head<2>() - frame.position.head<2>(), -frame.yaw),
          wrap_angle(thing.yaw - frame.yaw)};
}

bool is_near(const Place& a, const Place& b) {
  return (a.position - b.position).norm() <= fits &&
         std::abs(wrap_angle(a.yaw - b.yaw)) <= fits_turn;
}

/// A word for where things are, and the sides of the other that they share.
struct Word {
  const char* text;
  std::vector<Side> sides;  ///< none: around it
};
const std::vector<Word> words_of_place = {{"around ", {}},
                                          {"in front of ", {Side::front}},
                                          {"behind ", {Side::back}},
                                          {"left of ", {Side::left}},
                                          {"right of ", {Side::right}},
                                          {"beside ", {Side::left, Side::right}},
                                          {"at the ends of ", {Side::left, Side::right}}};

struct Facing {
  const char* text;
  double turn;
};
constexpr Facing facings[] = {{"to", 0.0}, {"away", pi}};
// Beside a thing and looking as it does, backs in line.
struct Aside {
  const char* text;
  double sign;
};
constexpr Aside asides[] = {{"left of ", 1.0}, {"right of ", -1.0}};

/// So many things, so far from another, looking at it (0) or away from it.
struct Row {
  int number = 1;
  double gap = 0.0, turn = 0.0;
};

// The places of a row at each side, as the patterns of groups have them.
std::vector<Place> row_places(const Word& word, const Object& of, const Vec3& size,
                              const Row& row) {
  std::vector<Place> places;
  const Footprint table(Vec2::Zero(), of.size.head<2>(), 0.0, of.traits.round);
  const auto add = [&](const composition::SeatPlace& seat) {
    places.push_back({seat.rim + (row.gap + 0.5 * size.y()) * seat.outward,
                      wrap_angle(yaw_facing(Vec2(-seat.outward)) + row.turn)});
  };
  if (word.sides.empty())
    for (const auto& seat : composition::seat_places(table, row.number)) add(seat);
  const Footprint box(Vec2::Zero(), of.size.head<2>(), 0.0);
  for (const Side side : word.sides)
    for (const auto& seat : composition::seat_places_at_side(
             box, side, row.number / static_cast<int>(word.sides.size())))
      add(seat);
  return places;
}

bool all_fit(std::vector<Place> places, const std::vector<Place>& wanted) {
  for (const auto& one : wanted) {
    const auto found = std::find_if(places.begin(), places.end(),
                                    [&](const Place& place) { return is_near(place, one); });
    if (found == places.end()) return false;
    places.erase(found);
  }
  return places.empty();
}

/// Tells the things of one unit.
class ThingTeller {
 public:
  ThingTeller(const Unit& unit, const Telling& telling) : unit_(unit), telling_(telling) {}

  Json run() {
    tell(unit_.things.front(), told(*unit_.things.front()));
    tell_standing();
    for (const Object* thing : unit_.things)
      if (!names_.count(thing) && thing->mount != Mount::surface) tell(thing, placed_at(*thing));
    return std::move(things_);
  }

 private:
  // A thing and what is on it; `like` are told with it.
  void tell(const Object* thing, Json json, const std::vector<const Object*>& like = {}) {
    const std::string name = new_name(thing->category);
    json["part"] = name;
    names_[thing] = name;
    for (const Object* other : like) names_[other] = name;
    const std::size_t index = things_.size();
    things_.push_back(std::move(json));
    const auto inner = told_within(*thing);
    if (!inner.empty()) things_[index]["on_top"] = inner;
    tell_carried(*thing);
  }

  std::string new_name(const std::string& category) {
    const int number = ++numbers_[category];
    return number == 1 ? category : category + " " + std::to_string(number);
  }

  Json told(const Object& thing) const {
    Json json = told_thing(thing, telling_);
    json.erase("place");
    return json;
  }

  std::vector<const Object*> carried_by(const Object& carrier) const {
    std::vector<const Object*> found;
    for (const Object* thing : unit_.things)
      if (thing->mount == Mount::surface && thing->on == carrier.id &&
          thing != unit_.things.front())
        found.push_back(thing);
    return found;
  }

  static bool is_within(const Object& thing, const Object& carrier) {
    const bool is_said =
        std::any_of(thing.relations.begin(), thing.relations.end(),
                    [](const Relation& relation) { return relation.kind == RelationKind::inside; });
    return is_said || bottom(thing) < top(carrier) - below_top;
  }

  static bool looks_like(const Object& a, const Object& b) {
    return a.category == b.category && a.description == b.description &&
           (a.size - b.size).cwiseAbs().maxCoeff() < 0.03;
  }

  // What is on the boards of a shelf finds its place there; of a bed or seat what lies on it is
  // where it is.
  Json told_within(const Object& carrier) {
    Json told_ones = Json::array();
    if (unit_.grid.number() > 1 || !telling_.kinds.is_a(carrier.category, "storage"))
      return told_ones;
    std::vector<std::pair<const Object*, int>> kinds;
    for (const Object* thing : carried_by(carrier)) {
      if (!is_within(*thing, carrier)) continue;
      names_[thing] = "";
      const auto known = std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) {
        return looks_like(*one.first, *thing) && carried_by(*thing).empty();
      });
      if (known != kinds.end())
        ++known->second;
      else
        kinds.emplace_back(thing, 1);
    }
    for (const auto& [thing, number] : kinds) {
      Json json = told_thing(*thing, telling_);
      json["place"] = "in " + carrier.category;
      if (number > 1) json["quantity"] = number;
      json["spare"] = 1;
      told_ones.push_back(std::move(json));
    }
    return told_ones;
  }

  void tell_carried(const Object& carrier) {
    const auto carried = carried_by(carrier);
    for (const Object* thing : carried) {
      if (names_.count(thing)) continue;
      std::vector<const Object*> like;
      for (const Object* other : carried)
        if (other != thing && !names_.count(other) && looks_like(*other, *thing) &&
            carried_by(*other).empty())
          like.push_back(other);
      Json json = told(*thing);
      json["where"] = "on " + names_[&carrier];
      json["spare"] = 1;
      if (like.size() + 1 >= many_alike && carried_by(*thing).empty())
        json["quantity"] = like.size() + 1;
      else
        like.clear(), put_at(*thing, carrier, json);
      tell(thing, std::move(json), like);
    }
  }

  static void put_at(const Object& thing, const Object& frame, Json& json) {
    const Place place = place_in(thing, frame);
    json["at_m"] = {in_file(place.position.x()), in_file(place.position.y())};
    const double turn = rounded(degrees(place.yaw), 1);
    if (std::abs(turn) > little_turned) json["facing"] = turn;
  }

  bool has_alike_cargo(const Object& a, const Object& b) const {
    const auto own = carried_by(a), its = carried_by(b);
    return own.size() == its.size() &&
           std::all_of(own.begin(), own.end(), [&](const Object* thing) {
             return std::any_of(its.begin(), its.end(), [&](const Object* other) {
               return thing->category == other->category &&
                      (place_in(*thing, a).position - place_in(*other, b).position).norm() < fits;
             });
           });
  }

  bool stands(const Object& thing) const {
    return thing.mount == Mount::floor && !thing.traits.flat;
  }

  // Things that look alike and together fit a word for where they are.
  void tell_standing() {
    for (const Object* thing : unit_.things) {
      if (names_.count(thing) || !stands(*thing)) continue;
      std::vector<const Object*> like = {thing};
      for (const Object* other : unit_.things)
        if (other != thing && !names_.count(other) && stands(*other) &&
            looks_like(*other, *thing) && has_alike_cargo(*other, *thing))
          like.push_back(other);
      if (!tell_by_word(like)) tell(thing, placed_at(*thing));
    }
  }

  // All of them, else as many as fit; a table that is not the anchor may have seats, too.
  bool tell_by_word(const std::vector<const Object*>& like) {
    for (const auto& [target, name] : std::map<const Object*, std::string>(names_)) {
      if (!stands(*target) || name.empty() || is_several(name) || !leads(*target, *like.front()))
        continue;
      for (const auto& chosen : {like, std::vector<const Object*>{like.front()}}) {
        auto json = by_word(chosen, *target, name);
        if (!json) continue;
        tell(chosen.front(), *std::move(json), {chosen.begin() + 1, chosen.end()});
        for (const Object* thing : chosen)
          for (const Object* cargo : carried_by(*thing)) names_.try_emplace(cargo, "");
        return true;
      }
    }
    return false;
  }
  // Seats follow their table, and none another seat.
  bool leads(const Object& target, const Object& thing) const {
    const auto is_seat = [&](const Object& one) {
      return telling_.kinds.is_a(one.category, "seat");
    };
    return &target == unit_.things.front() || (is_seat(thing) && !is_seat(target));
  }
  bool is_several(const std::string& name) const {
    return std::count_if(names_.begin(), names_.end(),
                         [&](const auto& one) { return one.second == name; }) > 1;
  }

  std::optional<Json> by_word(const std::vector<const Object*>& like, const Object& target,
                              const std::string& name) const {
    std::vector<Place> wanted;
    for (const Object* thing : like) wanted.push_back(place_in(*thing, target));
    const auto number = static_cast<int>(like.size());
    const Vec3& size = like.front()->size;
    for (const Word& word : words_of_place) {
      if (!word.sides.empty() && number % static_cast<int>(word.sides.size()) != 0) continue;
      if (word.sides.empty() && number < 2) continue;
      for (const Facing& facing : facings) {
        Row row{number, 0.0, facing.turn};
        const auto gap = gap_of(row_places(word, target, size, row), wanted.front());
        row.gap = gap.value_or(0.0);
        if (!gap || !all_fit(row_places(word, target, size, row), wanted)) continue;
        Json json = told(*like.front());
        json["where"] = word.text + name;
        json["gap_m"] = in_file(*gap);
        if (!word.sides.empty() || facing.turn > 0.0) json["facing"] = facing.text;
        if (number > 1) json["quantity"] = number;
        return json;
      }
    }
    return like.size() == 1 ? told_aside(*like.front(), target, name) : std::nullopt;
  }

  std::optional<Json> told_aside(const Object& thing, const Object& target,
                                 const std::string& name) const {
    const Place place = place_in(thing, target);
    for (const Aside& aside : asides) {
      const double gap = aside.sign * place.position.x() - 0.5 * (thing.size.x() + target.size.x());
      const double back = 0.5 * (target.size.y() - thing.size.y()) - place.position.y();
      if (gap < -0.02 || gap > most_aside || std::abs(back) > fits ||
          std::abs(place.yaw) > fits_turn)
        continue;
      Json json = told(thing);
      json["where"] = aside.text + name;
      json["gap_m"] = in_file(gap);
      json["align"] = "back", json["facing"] = "same";
      return json;
    }
    return std::nullopt;
  }

  // How much farther out than one of these places it is.
  static std::optional<double> gap_of(const std::vector<Place>& places, const Place& wanted) {
    for (const auto& place : places) {
      const Vec2 out = place.position.norm() > 1e-6 ? outward_of(place) : Vec2(0, -1);
      const Vec2 off = wanted.position - place.position;
      const double gap = off.dot(out);
      if ((off - gap * out).norm() <= fits && gap >= least_gap && gap <= most_gap &&
          std::abs(wrap_angle(wanted.yaw - place.yaw)) <= fits_turn)
        return gap;
    }
    return std::nullopt;
  }
  // Its back or its front is turned away from the other.
  static Vec2 outward_of(const Place& place) {
    const Vec2 back = rotated({0, 1}, place.yaw);
    return back.dot(place.position) >= 0.0 ? back : Vec2(-back);
  }

  // In the frame of the anchor, or of what is under it or it hangs over.
  Json placed_at(const Object& thing) const {
    Json json = told(thing);
    const Object* frame = thing.mount == Mount::ceiling ? below(thing) : unit_.things.front();
    const Place place = place_in(thing, *frame);
    const std::string word = word_for(thing, *frame);
    json["where"] = word + names_.at(frame);
    put_at(thing, *frame, json);
    const bool is_middle = std::abs(place.position.x()) < little_off &&
                           (word == "above " || std::abs(place.position.y()) < little_off);
    if (is_middle && word != "at ") json.erase("at_m");
    const bool is_hung = thing.mount == Mount::wall || thing.mount == Mount::ceiling;
    if (is_hung || thing.traits.flat) json["spare"] = 1;
    const bool is_usual = word != "at " || thing.mount == telling_.kinds.get(thing.category).mount;
    if (!is_usual) json["place"] = std::string(name(thing.mount));
    return json;
  }

  static std::string word_for(const Object& thing, const Object& frame) {
    if (thing.traits.flat) return "under ";
    if (thing.mount == Mount::ceiling) return "over ";
    const Place place = place_in(thing, frame);
    const bool is_above = thing.mount == Mount::wall && std::abs(place.yaw) < fits_turn &&
                          place.position.y() > 0.0 && bottom(thing) > top(frame) - 0.1;
    return is_above ? "above " : "at ";
  }

  const Object* below(const Object& lamp) const {
    for (const auto& [thing, name] : names_)
      if (stands(*thing) && !name.empty() && !is_several(name) &&
          contains(footprint(*thing), Vec2(lamp.position.head<2>())))
        return thing;
    return unit_.things.front();
  }

  const Unit& unit_;
  const Telling& telling_;
  Json things_ = Json::array();
  std::map<const Object*, std::string> names_;  ///< of what is told; empty: within another
  std::map<std::string, int> numbers_;
};

void tell_asset(const Object& object, const Telling& telling, Json& json) {
  if (is_written(object.asset)) {
    if (auto program = parse_json(object.asset.procedural->params, object.id))
      json["program"] = *std::move(program);
  } else if (telling.keep_assets && !object.asset.is_box()) {
    json["asset"] = asset_key(object.asset);
  }
}

// What it was painted with stands at its end: "..., painted: upholstery blue".
std::string description_of(const Object& object) {
  std::string text = object.description;
  const std::size_t painted = text.find(", painted: ");
  if (painted == std::string::npos) return text;
  text.erase(painted);
  for (const auto& [stuff, finish] : object.asset.finish)
    text += ", " + finish + (finish.find(stuff) == std::string::npos ? " " + stuff : "");
  return text;
}

}  // namespace

Json told_thing(const Object& object, const Telling& telling) {
  Json json = {{"name", object.category}, {"description", telling.worded(description_of(object))}};
  if (telling.kinds.by_name(object.category)) json["kind"] = object.category;
  json["size_cm"] = Json::array();
  for (const double side : object.size) json["size_cm"].push_back(rounded(100.0 * side, 1));
  json["place"] = std::string(name(object.mount));
  const double lean = -degrees(object.asset.tilt.x());
  if (lean > 1.0 && object.mount == Mount::floor) json["lean_deg"] = rounded(lean, 1);
  if (object.mount == Mount::wall || object.mount == Mount::ceiling)
    json["bottom_m"] = in_file(bottom(object));
  tell_asset(object, telling, json);
  return json;
}

Json told_things(const Unit& unit, const Telling& telling) {
  return ThingTeller(unit, telling).run();
}

}  // namespace roomgen::book
