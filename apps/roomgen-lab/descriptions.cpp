#include "descriptions.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::cli {

using namespace lab;

namespace {

constexpr std::size_t most_descriptions = 10'000;
constexpr double rounding = 0.003;  // of shares

std::optional<Range> range_of(const Json& json) {
  if (!json.is_array() || json.size() != 2 || !json[0].is_number()) return std::nullopt;
  return Range{json[0].get<double>(),
               json[1].is_number() ? json[1].get<double>() : std::numeric_limits<double>::infinity()};
}

Result<Description> description_from(const Json& json, const std::string& where) {
  const auto wrong = [&](const std::string& what) { return Error{Error::Kind::invalid_input, where + ": " + what}; };
  if (!json.is_object() || !json.value("id", Json()).is_string() || !json.value("text", Json()).is_string())
    return wrong("expected {\"id\", \"text\", \"expect\"}");
  Description description{json["id"].get<std::string>(), json["text"].get<std::string>(), {}, {}};
  const Json expect = json.value("expect", Json::object());
  for (const auto& [name, range] : complexity_measures())
    if (expect.contains(name)) {
      description.measures.*range = range_of(expect[name]);
      if (!(description.measures.*range)) return wrong(std::string("/expect/") + name + ": expected [least, most]");
    }
  const Json counts = expect.value("counts", Json::object());
  for (const auto& [noun, range] : counts.items()) {
    const auto read = range_of(range);
    if (!read) return wrong("/expect/counts/" + noun + ": expected [least, most]");
    description.counts[noun] = *read;
  }
  return description;
}

bool is_within(const Range& range, double value, double slack = 0.0) {
  return value >= range.low - slack && value <= range.high + slack;
}

/// Nouns that name one kind are one demand.
struct KindDemand {
  Range range;
  int there = 0;
};

std::map<std::string, KindDemand> demands_of(const Description& description, const KindTable& kinds) {
  std::map<std::string, KindDemand> demands;
  for (const auto& [noun, range] : description.counts) {
    const Kind* kind = kinds.find(noun);
    KindDemand& demand = demands[kind ? kind->name : noun];
    demand.range.low += range.low, demand.range.high += range.high;
  }
  return demands;
}

void count(const Scene& scene, const KindTable& kinds, std::map<std::string, KindDemand>& demands) {
  for (const auto& object : scene.objects) {
    std::vector<std::string> names = kinds.get(object.category).lineage;
    names.insert(names.begin(), object.category);
    for (const auto& name : names)
      if (const auto found = demands.find(name); found != demands.end()) {
        ++found->second.there;
        break;
      }
  }
}

}  // namespace

Result<std::vector<Description>> read_descriptions(const std::string& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  std::vector<Description> descriptions;
  const auto lines = split(*text, '\n');
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (trim(lines[i]).empty()) continue;
    const std::string where = file + ": line " + std::to_string(i + 1);
    if (descriptions.size() == most_descriptions)
      return Error{Error::Kind::limit, where + ": at most " + std::to_string(most_descriptions) + " descriptions"};
    const auto json = parse_json(lines[i], where);
    if (!json) return json.error();
    auto description = description_from(*json, where);
    if (!description) return description.error();
    descriptions.push_back(*std::move(description));
  }
  return descriptions;
}

std::optional<double> fidelity(const Description& description, const Scene& scene, double occupancy,
                               const KindTable& kinds) {
  auto demands = demands_of(description, kinds);
  count(scene, kinds, demands);
  int all = 0, met = 0;
  for (const auto& [name, demand] : demands) ++all, met += is_within(demand.range, demand.there);
  for (const auto& [name, range] : complexity_measures())
    if (const auto& wanted = description.measures.*range) {
      const double slack = std::string_view(name) == "occupancy" ? rounding : 0.0;
      ++all, met += is_within(*wanted, measured(name, scene, occupancy, kinds), slack);
    }
  if (all == 0) return std::nullopt;
  return static_cast<double>(met) / all;
}

}  // namespace roomgen::cli
