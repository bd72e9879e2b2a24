#include "part_count.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "composition/composition.h"
#include "composition/plan_groups.h"

namespace roomgen::book {

namespace {

constexpr int most_tried = 60;

using Counts = std::map<std::string, int>;

// Empty: it cannot be made so.
Counts counts_of(const PlanGroup& group, const std::vector<PlanItem>& items,
                 const KindTable& kinds) {
  Plan plan;
  plan.groups = {group};
  for (auto item : items) {
    item.quantity = 0;
    const bool is_known =
        std::any_of(plan.items.begin(), plan.items.end(),
                    [&](const PlanItem& other) { return other.part == item.part; });
    if (!is_known) plan.items.push_back(std::move(item));
  }
  composition::complete_groups(plan, kinds);
  Counts counts;
  for (const auto& item : plan.items)
    if (item.group == group.id) counts[item.part] += item.quantity;
  return counts;
}

int of_part(const Counts& counts, const std::string& part) {
  const auto found = counts.find(part);
  return found == counts.end() ? 0 : found->second;
}

void try_parameters(const PlanGroup& group, std::vector<PlanGroup>& tried) {
  const auto& known = composition::built_in_compositions();
  if (!known || !group.definition.empty()) return;
  const auto composition = known->find(group.composition);
  if (composition == known->end()) return;
  for (const auto& parameter : composition->second.parameters) {
    if (!parameter.choices.empty() || parameter.most - parameter.least > most_tried) continue;
    for (double value = std::ceil(parameter.least); value <= parameter.most; value += 1.0) {
      tried.push_back(group);
      tried.back().parameters[parameter.name] = value;
      tried.back().fixed.insert(parameter.name);
    }
  }
}

template <typename Offer>
void try_grid(const Json& json, std::size_t i, int number, Offer offer) {
  const Json& one = json["parts"][i];
  if (!one.contains("repeat") || !one["repeat"].contains("rows")) return;
  const double rows = one["repeat"]["rows"].is_number() ? one["repeat"]["rows"].get<double>() : 1.0;
  for (double columns = 1.0; columns <= number; columns += 1.0) {
    Json changed = json;
    Json& repeat = changed["parts"][i]["repeat"];
    repeat["columns"] = columns;
    repeat["rows"] = std::min(rows + 1.0, std::ceil(number / columns));
    repeat["number"] = std::min<double>(number, columns * (rows + 1.0));
    offer(changed);
  }
}

// Of a group of its own: the parameters of the composition that is its unit, the number of a part,
// the grid of the first.
void try_definition(const PlanGroup& group, const std::string& part, int number,
                    std::vector<PlanGroup>& tried) {
  const auto json =
      group.definition.empty() ? Result<Json>(Error{}) : parse_json(group.definition, group.id);
  if (!json || !json->contains("parts")) return;
  const auto offer = [&](const Json& changed) {
    tried.push_back(group);
    tried.back().definition = json_line(changed);
  };
  for (std::size_t i = 0; i < (*json)["parts"].size(); ++i) {
    const Json& one = (*json)["parts"][i];
    const Json with = one.contains("group") ? one.value("with", Json::object()) : Json::object();
    for (const auto& [name, value] : with.items())
      for (int count = 1; count <= std::min(number, most_tried); ++count) {
        Json changed = *json;
        changed["parts"][i]["with"][name] = count;
        offer(changed);
      }
    const bool is_it = one.value("part", std::string()) == part;
    if (is_it && (one.contains("beside") || one.contains("around")))
      for (const int share : {number, (number + 1) / 2, (number + 3) / 4}) {
        Json changed = *json;
        changed["parts"][i]["count"] = share;
        offer(changed);
      }
    try_grid(*json, i, number, offer);
  }
}

}  // namespace

std::map<std::string, int> set_part_count(PlanGroup& group, const std::vector<PlanItem>& items,
                                          const std::string& part, int number,
                                          const KindTable& kinds) {
  Counts best = counts_of(group, items, kinds);
  std::vector<PlanGroup> tried;
  try_parameters(group, tried);
  try_definition(group, part, number, tried);
  PlanGroup chosen = group;
  for (const auto& one : tried) {
    const Counts counts = counts_of(one, items, kinds);
    if (std::abs(of_part(counts, part) - number) >= std::abs(of_part(best, part) - number))
      continue;
    best = counts;
    chosen = one;
    if (of_part(best, part) == number) break;
  }
  group = std::move(chosen);
  return best;
}

}  // namespace roomgen::book
