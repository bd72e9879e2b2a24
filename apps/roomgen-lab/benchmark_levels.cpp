#include "benchmark_levels.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "roomgen/base/file.h"
#include "roomgen/base/text.h"

extern "C" const unsigned char roomgen_benchmark_levels[];
extern "C" const std::uint64_t roomgen_benchmark_levels_size;

namespace roomgen::cli {

using namespace lab;

namespace {

std::string built_in_levels() {
  return {reinterpret_cast<const char*>(roomgen_benchmark_levels), static_cast<std::size_t>(roomgen_benchmark_levels_size)};
}

LevelRange level_range(const Json& json) {
  const auto bound = [&](std::size_t k, double open) { return json.at(k).is_null() ? open : json.at(k).get<double>(); };
  return {bound(0, 0.0), bound(1, std::numeric_limits<double>::infinity())};
}

std::map<std::string, LevelRange> level_ranges(const Json& json) {
  std::map<std::string, LevelRange> ranges;
  for (const auto& [level, range] : json.items()) ranges[level] = level_range(range);
  return ranges;
}

bool stands_on_floor(const Object& object) { return object.mount == Mount::floor && !object.traits.flat; }

double cover_of(const Object& object) { return stands_on_floor(object) ? object.size.x() * object.size.y() : 0.0; }

double floor_of(const Scene& scene) { return std::abs(signed_area(scene.room.polygon.points)); }

double seats_of(const Object& object, const BenchmarkLevels& levels) {
  const auto& kinds = KindTable::built_in();
  if (kinds.is_a(object.category, "sofa")) return levels.sofa_seats;
  return kinds.is_a(object.category, "seat") ? 1.0 : 0.0;
}

// With what stands on it.
void remove_object(Scene& scene, const std::string& id) {
  std::set<std::string> gone = {id};
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& object : scene.objects)
      if (!object.on.empty() && gone.count(object.on) && gone.insert(object.id).second) grew = true;
  }
  std::erase_if(scene.objects, [&](const Object& object) { return gone.count(object.id) > 0; });
}

double total(const Scene& scene, const auto& value) {
  double sum = 0.0;
  for (const auto& object : scene.objects) sum += value(object);
  return sum;
}

// The last ones go first, as long as the sum is above `most` and does not fall below `least`.
void thin_out(Scene& scene, const LevelRange& range, const auto& value, const auto& may_go) {
  const auto objects = scene.objects;
  for (auto object = objects.rbegin(); object != objects.rend(); ++object) {
    const double sum = total(scene, value), less = sum - value(*object);
    if (sum <= range[1]) return;
    if (value(*object) <= 0 || less < range[0] || !may_go(*object) || !find_object(scene, object->id)) continue;
    remove_object(scene, object->id);
  }
}

// Of what stands on the floor those that take most of it a seat, as long as there are seats enough.
void thin_out_seats(Scene& scene, double most_cover, double least_seats, const auto& seats) {
  while (total(scene, cover_of) > most_cover) {
    const double all = total(scene, seats);
    const Object* widest = nullptr;
    const auto floor_a_seat = [&](const Object& object) { return cover_of(object) / seats(object); };
    for (const auto& object : scene.objects)
      if (seats(object) > 0 && cover_of(object) > 0 && all - seats(object) >= least_seats &&
          (!widest || floor_a_seat(object) >= floor_a_seat(*widest)))
        widest = &object;
    if (!widest) return;
    remove_object(scene, std::string(widest->id));
  }
}

bool within(double value, const LevelRange& range) { return value >= range[0] && value <= range[1]; }

std::string range_text(const LevelRange& range, double unit, const char* name) {
  const std::string least = format_number(unit * range[0], 0);
  return std::isinf(range[1]) ? least + name + " and more" : least + " to " + format_number(unit * range[1], 0) + name;
}

std::string shortfall(const Reduced& made, const LevelRange& seats, const LevelRange& shares) {
  std::vector<std::string> what;
  if (!within(made.seats, seats))
    what.push_back(format_number(made.seats, 0) + " seats where " + range_text(seats, 1.0, "") + " are asked for");
  if (!within(made.occupancy, shares))
    what.push_back(format_number(100.0 * made.occupancy, 1) + " % of the floor under furniture where " +
                   range_text(shares, 100.0, " %") + " are asked for");
  return join(what, "; ");
}

}  // namespace

Result<BenchmarkLevels> read_levels(const std::string& file) {
  const auto text = file.empty() ? Result<std::string>(built_in_levels()) : read_file(file);
  if (!text) return text.error();
  const std::string source = file.empty() ? "data/benchmark/levels.json" : file;
  const auto json = parse_json(*text, source);
  if (!json) return json.error();
  try {
    BenchmarkLevels levels;
    levels.rooms = json->at("rooms").get<std::map<std::string, std::string>>();
    levels.compositional = level_ranges(json->at("compositional"));
    levels.relational = level_ranges(json->at("relational"));
    levels.observational = json->at("observational");
    levels.sofa_seats = json->at("seats of a sofa");
    levels.tries = json->value("tries", levels.tries);
    if (levels.tries < 1 || levels.tries > 1000)
      return Error{Error::Kind::invalid_input, source + ": there must be 1 to 1000 tries for a base room"};
    return levels;
  } catch (const Json::exception& error) {
    return Error{Error::Kind::invalid_input, source + ": " + error.what()};
  }
}

Reduced reduced(const Scene& base, const BenchmarkLevels& levels, const BenchmarkCell& cell) {
  const auto seats = [&](const Object& object) { return seats_of(object, levels); };
  const LevelRange seat_range = levels.compositional.at(cell.compositional);
  const LevelRange share_range = levels.relational.at(cell.relational);
  const double floor = floor_of(base);
  Reduced result{base, 0.0, 0.0, ""};
  thin_out(result.scene, seat_range, seats, [](const Object&) { return true; });
  const LevelRange cover_range = {share_range[0] * floor, share_range[1] * floor};
  thin_out(result.scene, cover_range, cover_of, [&](const Object& object) { return seats(object) == 0.0; });
  thin_out_seats(result.scene, cover_range[1], seat_range[0], seats);
  result.scene.unplaced.clear();
  result.scene.requirements.clear();
  result.scene.heard.clear();
  result.seats = total(result.scene, seats);
  result.occupancy = total(result.scene, cover_of) / floor;
  result.shortfall = shortfall(result, seat_range, share_range);
  return result;
}

Result<TourOptions> tour_options(const Scene& scene, const BenchmarkLevels& levels, const BenchmarkCell& cell) {
  const Json& level = levels.observational.at(cell.observational);
  TourOptions options;
  if (level.value("birds eye", false)) options = birds_eye(scene, options);
  options.eye_height = level.value("eye height", options.eye_height);
  if (level.contains("hidden")) {
    options.least_hidden = level["hidden"].at(0);
    options.greatest_hidden = level["hidden"].at(1);
  }
  return options;
}

}  // namespace roomgen::cli
