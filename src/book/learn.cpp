#include "learn.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "brief/room_kinds.h"
#include "design.h"
#include "learned_shell.h"
#include "learned_things.h"
#include "roomgen/base/text.h"

namespace roomgen::book {

namespace {

constexpr double least_share = 0.82, most_share = 1.3,
                 most_grid_share = 2.0;  ///< of the usual sides
constexpr int most_copies = 12;          ///< of a row
constexpr std::size_t longest_name = 80;
constexpr std::size_t most_told_words = 40;
constexpr std::size_t never_spare = 2;  ///< of the largest things of a room that nobody knows

/// A grid whose rows and columns follow the room, and the number of its things.
struct Growing {
  std::array<std::string, 2> numbers;  ///< formulas of rows and columns
  Json parameter;                      ///< null: it has none
  std::string name;                    ///< of the parameter
  std::array<Json, 2> usual;           ///< of the room
};

std::string number(double value) {
  return format_number(value, 3);
}

/// Makes a design of a room whose box begins at 0, 0.
class Learning {
 public:
  Learning(const Scene& scene, const KindTable& kinds, const LearnOptions& options)
      : scene_(scene),
        kinds_(kinds),
        options_(options),
        size_(bounds(scene.room.polygon).size()),
        telling_{kinds, with_roles(scene.room), options.keep_assets},
        units_(units_of(scene, kinds)),
        places_(places_of(units_, size_)) {}

  Json run() {
    Json design = {{"format", "roomgen-design"}, {"version", 1}, {"name", name_of()}};
    design["for"] = options_.rooms.empty()
                        ? std::vector{scene_.room.type.empty() ? "room" : scene_.room.type}
                        : options_.rooms;
    if (const auto words = told_words(); !words.empty()) design["words"] = words;
    if (!scene_.prompt.empty()) design["concept"] = shortened(scene_.prompt, 1000);
    tell_size(design);
    design["room"] = told_room(scene_.room, telling_.worded);
    design["openings"] = told_openings(scene_.room);
    tell_units(design);
    if (scene_.room.polygon.size() != 4)
      design["remarks"] = "the room was no rectangle: it is told by the box round it";
    return design;
  }

 private:
  std::string name_of() const {
    if (!options_.name.empty()) return options_.name;
    const std::string& text = scene_.prompt.empty() ? scene_.room.type : scene_.prompt;
    return shortened(text.empty() ? "room" : text, longest_name);
  }

  // What a wish said of people, doings and styles.
  std::vector<std::string> told_words() const {
    std::vector<std::string> told = scene_.room.style;
    for (const auto& heard : scene_.heard) {
      const bool is_mood = heard.as == Heard::As::style || heard.as == Heard::As::person ||
                           heard.as == Heard::As::activity;
      const std::string word = lower(heard.text);
      if (is_mood && std::find(told.begin(), told.end(), word) == told.end() &&
          told.size() < most_told_words)
        told.push_back(word);
    }
    return told;
  }

  // --- grids and the size of the room

  const Unit* main_grid() const {
    const Unit* most = nullptr;
    for (const auto& unit : units_)
      if (unit.grid.number() > 1 && (!most || unit.grid.number() > most->grid.number()))
        most = &unit;
    return most;
  }
  bool is_only_grid() const {
    return std::count_if(units_.begin(), units_.end(),
                         [](const Unit& unit) { return unit.grid.number() > 1; }) == 1;
  }

  // As many as the room has space for; beside other grids no more than there were.
  std::string fitting(int now, double step, const Vec2& axis) const {
    const Eigen::Index k = std::abs(axis.x()) > 0.5 ? 0 : 1;
    const int most = is_only_grid() ? std::max(now, most_copies) : now;
    return "clamp(floor((" + std::string(k == 0 ? "W" : "D") + " - " +
           number(size_[k] - (now - 1) * step) + ")/" + number(step) + " + 1.02), 1, " +
           std::to_string(most) + ")";
  }

  Growing growing(const Unit& unit) const {
    const Grid& grid = unit.grid;
    Growing told{{std::to_string(grid.rows), std::to_string(grid.columns)},
                 nullptr,
                 "",
                 {size_.x(), size_.y()}};
    if (!side_faced(unit.anchor().yaw)) return told;
    const Vec2 columns = rotated({1, 0}, unit.anchor().yaw),
               rows = rotated({0, 1}, unit.anchor().yaw);
    if (grid.rows > 1) told.numbers[0] = fitting(grid.rows, grid.along, rows);
    if (grid.columns > 1) told.numbers[1] = fitting(grid.columns, grid.across, columns);
    if (&unit == main_grid() && is_only_grid()) by_parameter(unit, told);
    return told;
  }

  // So many of its anchors: as many rows as they need, and as many columns as those rows leave.
  void by_parameter(const Unit& unit, Growing& told) const {
    const Grid& grid = unit.grid;
    const std::string category = unit.anchor().category;
    const auto each =
        std::count_if(unit.things.begin(), unit.things.end(),
                      [&](const Object* thing) { return thing->category == category; });
    told.name = formula_name(category);
    const auto now = static_cast<int>(each) * grid.number();
    told.parameter = {{"default", now}, {"least", each}, {"most", 4 * now}, {"counts", {category}}};
    const std::string copies =
        each == 1 ? told.name : "ceil(" + told.name + "/" + std::to_string(each) + ")";
    const auto limited = [&](const std::string& most, const std::string& by) {
      return "min(" + most + ", ceil(" + copies + "/" + by + "))";
    };
    const std::string rows = told.numbers[0], columns = told.numbers[1];
    if (grid.rows > 1) told.numbers[0] = limited(rows, columns);
    if (grid.columns > 1)
      told.numbers[1] =
          limited(columns, grid.rows > 1 ? told.numbers[0] : std::to_string(grid.rows));
    // The usual room has as many more columns, and rows, as its number asks for.
    const std::string wide =
        grid.rows == 1 ? copies
        : grid.columns == 1
            ? std::string("1")
            : "ceil(sqrt(" + copies + "*" + number(double(grid.columns) / grid.rows) + ") - 0.01)";
    const std::string deep = grid.rows == 1 ? "1" : "ceil(" + copies + "/" + wide + ")";
    grow(told, rotated({1, 0}, unit.anchor().yaw), grid.across, grid.columns, wide);
    grow(told, rotated({0, 1}, unit.anchor().yaw), grid.along, grid.rows, deep);
  }
  void grow(Growing& told, const Vec2& axis, double step, int now,
            const std::string& wanted) const {
    if (now < 2) return;
    const Eigen::Index k = std::abs(axis.x()) > 0.5 ? 0 : 1;
    told.usual[static_cast<std::size_t>(k)] =
        number(size_[k]) + " + " + number(step) + "*(" + wanted + " - " + std::to_string(now) + ")";
  }

  static std::string formula_name(const std::string& category) {
    std::string name = category + "s";
    for (char& c : name)
      if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
  }

  void tell_size(Json& design) const {
    Json usual = {size_.x(), size_.y()};
    double most = most_share;
    if (const Unit* grid = main_grid()) {
      const Growing told = growing(*grid);
      if (!told.parameter.is_null())
        design["parameters"][told.name] = told.parameter, most = most_grid_share;
      usual = {told.usual[0], told.usual[1]};
    }
    const auto sides = [&](double share) {
      return Json{rounded(share * size_.x(), 2), rounded(share * size_.y(), 2)};
    };
    design["size_m"] = {{"usual", usual}, {"least", sides(least_share)}, {"most", sides(most)}};
  }

  // --- what stands in it

  void tell_units(Json& design) {
    design["groups"] = Json::array(), design["objects"] = Json::array();
    const auto spare = spare_of();
    std::set<std::string> curtains;
    for (std::size_t i = 0; i < units_.size(); ++i) {
      const Unit& unit = units_[i];
      if (unit.things.size() == 1 && hangs_everywhere(unit.anchor())) {
        if (curtains.insert(unit.anchor().category).second)
          design["objects"].push_back(told_curtain(unit.anchor()));
        continue;
      }
      Json told = unit.things.size() == 1 ? told_single(unit) : told_group(unit);
      const std::array<std::string, 2> numbers =
          unit.grid.number() > 1 ? growing(unit).numbers : std::array<std::string, 2>();
      told["stands"] =
          told_stands(unit, places_[i], {scene_.room, openings_seen(scene_.room)}, numbers);
      if (const auto found = spare.find(i); found != spare.end()) told["spare"] = found->second;
      design[unit.things.size() == 1 ? "objects" : "groups"].push_back(std::move(told));
    }
  }

  Json told_single(const Unit& unit) const {
    const Object& thing = unit.anchor();
    Json told = told_thing(thing, telling_);
    // What is just under the ceiling stays there.
    constexpr double under_ceiling = 0.3;
    const double below = scene_.room.height - bottom(thing);
    if (thing.mount == Mount::wall && scene_.room.height - top(thing) < under_ceiling)
      told["bottom_m"] = "H - " + number(below);
    return told;
  }

  Json told_group(const Unit& unit) const {
    Json told = {{"id", unit.id}, {"things", told_things(unit, telling_)}};
    if (unit.grid.number() < 2) return told;
    const Growing numbers = growing(unit);
    told["repeat"] = {{"rows", numbers.numbers[0]}, {"columns", numbers.numbers[1]}};
    if (unit.grid.columns > 1) told["repeat"]["across_m"] = rounded(unit.grid.across, 3);
    if (unit.grid.rows > 1) told["repeat"]["along_m"] = rounded(unit.grid.along, 3);
    return told;
  }

  // A curtain of the kind that every window has.
  bool hangs_everywhere(const Object& thing) const {
    if (!kinds_.get(thing.category).covers_window) return false;
    const auto windows =
        std::count_if(scene_.room.openings.begin(), scene_.room.openings.end(),
                      [](const Opening& opening) { return !opening.is_entrance(); });
    return windows > 0 &&
           std::count_if(scene_.objects.begin(), scene_.objects.end(), [&](const Object& other) {
             return other.category == thing.category && other.description == thing.description;
           }) >= windows;
  }
  Json told_curtain(const Object& thing) const {
    Json told = told_thing(thing, telling_);
    for (const char* measure : {"size_cm", "bottom_m"}) told.erase(measure);
    return told;
  }

  // Single things may be left out, the smallest first, but what makes the room and its largest
  // things.
  std::map<std::size_t, int> spare_of() const {
    const auto& rooms = brief::built_in_room_kinds();
    std::vector<std::string> makers;
    if (rooms) makers = rooms->get(scene_.room.type).made_by;
    std::vector<std::pair<double, std::size_t>> singles;
    for (std::size_t i = 0; i < units_.size(); ++i) {
      const Object& thing = units_[i].anchor();
      const bool is_kept = units_[i].things.size() > 1 ||
                           kinds_.is_any_of(thing.category, makers) || hangs_everywhere(thing);
      if (!is_kept) singles.emplace_back(thing.size.prod(), i);
    }
    std::sort(singles.begin(), singles.end());
    const bool has_core = std::any_of(units_.begin(), units_.end(),
                                      [](const Unit& unit) { return unit.things.size() > 1; });
    if (!has_core) singles.resize(singles.size() > never_spare ? singles.size() - never_spare : 0);
    std::map<std::size_t, int> spare;
    int next = 1;
    for (const auto& [volume, i] : singles) spare[i] = std::min(next++, 99);
    return spare;
  }

  const Scene& scene_;
  const KindTable& kinds_;
  const LearnOptions& options_;
  Vec2 size_;
  Telling telling_;
  std::vector<Unit> units_;
  std::vector<Place2> places_;
};

}  // namespace

Json design_of(const Scene& scene, const KindTable& kinds, const LearnOptions& options) {
  Scene moved = scene;
  const Vec2 low = bounds(scene.room.polygon).low;
  for (Vec2& corner : moved.room.polygon.points) corner -= low;
  for (auto& object : moved.objects) object.position.head<2>() -= low;
  return Learning(moved, kinds, options).run();
}

}  // namespace roomgen::book

namespace roomgen {

Result<Json> learn_design(const Scene& scene, const LearnOptions& options) {
  if (!scene.rooms.empty())
    return Error{Error::Kind::invalid_input, "a dwelling of " + std::to_string(scene.rooms.size()) +
                                                 " rooms is no design: give the scene of one room"};
  if (auto status = check(scene); !status) return status.error();
  if (scene.objects.empty())
    return Error{Error::Kind::invalid_input, "the room is empty: there is nothing to learn"};
  Json design = book::design_of(scene, KindTable::built_in(), options);
  if (auto read = book::read_design(design, "the design"); !read) return read.error();
  return design;
}

Result<std::string> check_design(const Json& json, const std::string& source) {
  const auto design = book::read_design(json, source);
  if (!design) return design.error();
  const auto count = [&](const char* list) {
    return design->body.value(list, Json::array()).size();
  };
  return "design of " + std::to_string(count("groups")) + " groups and " +
         std::to_string(count("objects")) + " single things";
}

}  // namespace roomgen
