#include <algorithm>
#include <cmath>
#include <vector>

#include "settle.h"

namespace roomgen::brief {

namespace {

constexpr double between_loads = 0.05;  ///< metres between things on a table
constexpr double fullest_top = 0.55;    ///< share of a top that things take
constexpr double widest = 1.35, widest_if_sized = 1.1;

// A stool beside the lamp on a table is beside the table.
void stand_beside_carriers(Brief& brief) {
  for (std::size_t i = 0; i < brief.mentions.size(); ++i) {
    Mention& mention = brief.mentions[i];
    if (mention.mount != Mount::floor) continue;
    for (auto& demand : mention.demands) {
      if (demand.mention == Demand::none || !is_beside(demand.kind)) continue;
      const Mention& target = brief.mentions[demand.mention];
      const auto carrier = target.mount == Mount::surface ? support_of(target) : std::nullopt;
      if (carrier && *carrier != i) demand.mention = *carrier;
    }
  }
}

// Only what is on a thing can be inside it.
void keep_inside_what_carries(Mention& mention) {
  const auto support = support_of(mention);
  std::erase_if(mention.demands, [&](const Demand& demand) {
    return demand.kind == RelationKind::inside &&
           (mention.mount != Mount::surface || support != demand.mention);
  });
}

// Whose one top is what carries things.
bool has_one_top(const Mention& mention, const KindTable& table) {
  return table.is_any_of(mention.category,
                         {"table", "nightstand", "bar cart", "tray", "kitchen island"}) &&
         !table.get(mention.category).traits.flat;
}

// A table for many things is a larger one.
void widen_for_loads(Brief& brief, const KindTable& table) {
  std::vector<double> loads(brief.mentions.size(), 0.0);
  for (const auto& mention : brief.mentions)
    if (const auto support = support_of(mention); support && mention.mount == Mount::surface)
      loads[*support] +=
          mention.quantity * (mention.size.head<2>() + Vec2::Constant(between_loads)).prod();
  for (std::size_t i = 0; i < brief.mentions.size(); ++i) {
    Mention& carrier = brief.mentions[i];
    if (loads[i] == 0.0 || !has_one_top(carrier, table)) continue;
    const double need = loads[i] / carrier.quantity / fullest_top;
    const double factor = std::sqrt(need / carrier.size.head<2>().prod());
    carrier.size.head<2>() *= std::clamp(factor, 1.0, carrier.sized ? widest_if_sized : widest);
  }
}

// "A television on a stand across from the sofa": where the stand stands.
bool places_on_floor(const Demand& demand, const Brief& brief, std::size_t carrier) {
  if (demand.kind == RelationKind::on || demand.kind == RelationKind::inside ||
      demand.kind == RelationKind::above || demand.kind == RelationKind::under)
    return false;
  if (demand.mention == Demand::none)
    return !demand.part.empty() || demand.kind == RelationKind::edge ||
           demand.kind == RelationKind::corner;
  return demand.mention != carrier && brief.mentions[demand.mention].mount == Mount::floor;
}

void lift_to_carriers(Brief& brief) {
  for (auto& mention : brief.mentions) {
    const auto support = support_of(mention);
    if (mention.mount != Mount::surface || !support) continue;
    Mention& carrier = brief.mentions[*support];
    if (carrier.mount != Mount::floor) continue;
    const auto lifted = std::stable_partition(
        mention.demands.begin(), mention.demands.end(),
        [&](const Demand& demand) { return !places_on_floor(demand, brief, *support); });
    // Its own place, where it has one, is what counts.
    if (carrier.demands.empty()) carrier.demands.assign(lifted, mention.demands.end());
    mention.demands.erase(lifted, mention.demands.end());
  }
}

}  // namespace

void settle_carriers(Brief& brief, const KindTable& table) {
  widen_for_loads(brief, table);
  stand_beside_carriers(brief);
  lift_to_carriers(brief);
  for (auto& mention : brief.mentions) keep_inside_what_carries(mention);
}

}  // namespace roomgen::brief
