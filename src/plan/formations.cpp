#include "formations.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "formation_site.h"
#include "round_formations.h"
#include "scene/room_part.h"

namespace roomgen::plan {

namespace {

constexpr double least_behind = 0.5, least_beside = 0.1;  ///< metres between things
constexpr double before_audience = 1.2;                   ///< metres for what is looked at
constexpr double margin = 0.45;                           ///< metres to the walls
constexpr double closenesses[] = {1.0, 0.75, 0.5, 0.25};  ///< of the floor between things

/// Rows of equal things: all lengths in metres.
struct RowBlock {
  std::size_t rows = 0, columns = 0;
  double width = 0.0, depth = 0.0;    ///< of a thing
  double beside = 0.0, behind = 0.0;  ///< floor between them
  double before = 0.0;                ///< floor before the first row
  double across() const { return static_cast<double>(columns) * (width + beside) - beside; }
  double along() const { return static_cast<double>(rows) * (depth + behind) - behind + before; }
  /// With that share of the floor between its things.
  RowBlock closer(double share) const {
    RowBlock block = *this;
    block.behind *= share;
    block.beside *= share;
    return block;
  }
};

/// Where a block stands: the wall that its front rows are nearest to, and how close its things are.
struct FormationSite {
  std::size_t wall = 0;
  Vec2 forward = Vec2::Zero(), center = Vec2::Zero();
  double closeness = 1.0;
};

class Formations {
 public:
  Formations(const std::vector<Draft>& drafts, const KindTable& table, const Arrangements& arrangements,
             Plan& plan)
      : drafts_(drafts), table_(table), arrangements_(arrangements), plan_(plan) {}

  void run() {
    std::map<std::pair<std::size_t, std::string>, std::vector<std::size_t>> members;  // items by mention and kind
    for (std::size_t i = 0; i < drafts_.size(); ++i)
      if (drafts_[i].formation && drafts_[i].item.mount == Mount::floor &&
          drafts_[i].item.quantity == 1 && drafts_[i].item.size)
        members[{drafts_[i].mention, drafts_[i].item.category}].push_back(i);
    for (const auto& [kind, items] : members) lay_out(items);
  }

 private:
  void lay_out(const std::vector<std::size_t>& items) {
    const Draft& first = drafts_[items.front()];
    if (first.formation->is_round()) return lay_out_round(items, drafts_, table_, plan_);
    const auto laid = loosest(first, items.size());
    if (!laid) return;
    const auto& [wanted, site] = *laid;
    const RowBlock block = wanted.closer(site.closeness);
    for (std::size_t n = 0; n < items.size(); ++n) stand(plan_.items[items[n]], block, site, n);
    put_focus_at_wall(first, site.wall, site.center, margin, drafts_, plan_);
  }

  // Of the blocks that the words allow the one that finds the loosest site: as wide as usual, else narrower or wider.
  std::optional<std::pair<RowBlock, FormationSite>> loosest(const Draft& draft, std::size_t count) const {
    const brief::Formation& said = *draft.formation;
    const std::size_t usual = columns_of(said, count);
    std::vector<std::size_t> widths = {usual};
    if (said.rows == 0 && said.columns == 0)
      for (std::size_t off = 1; off < count; ++off) {
        if (usual > off + 1) widths.push_back(usual - off);
        if (2 * (usual + off) <= count + 1) widths.push_back(usual + off);
      }
    std::optional<std::pair<RowBlock, FormationSite>> best;
    for (const std::size_t columns : widths) {
      const RowBlock block = block_of(draft, count, columns);
      if (block.rows < 2) continue;
      const auto site = site_for(block, draft);
      if (site && (!best || site->closeness > best->second.closeness)) best = {block, *site};
    }
    return best;
  }

  RowBlock block_of(const Draft& draft, std::size_t count, std::size_t columns) const {
    const PlanItem& item = draft.item;
    const auto& reserve = arrangements_.get(table_, item.category, item.mount).reserve;
    const auto open = [&](roomgen::Side side) { return reserve[static_cast<std::size_t>(side)]; };
    RowBlock block;
    block.columns = columns;
    block.rows = (count + block.columns - 1) / block.columns;
    block.width = item.size->x();
    block.depth = item.size->y();
    block.behind = std::max(least_behind, open(roomgen::Side::front) + open(roomgen::Side::back));
    block.before = faces_something(draft) ? before_audience : 0.0;
    block.beside = std::max(least_beside, open(roomgen::Side::left) + open(roomgen::Side::right));
    return block;
  }

  // Of the walls that the rows may face the one that was told, or one without a door or windows; the loosest
  // that there is room for.
  std::optional<FormationSite> site_for(const RowBlock& block, const Draft& draft) const {
    const Bounds2 floor = floor_of(draft, plan_.room);
    for (const double closeness : closenesses) {
      const RowBlock closer = block.closer(closeness);
      std::optional<FormationSite> best;
      double least = 0.0;
      for (std::size_t wall = 0; wall < plan_.room.polygon.size(); ++wall) {
        const Vec2 forward = -plan_.room.polygon.inward(wall);
        if (is_flat(draft) && forward.sum() > 0.0) continue;
        const bool is_along_x = std::abs(forward.x()) > std::abs(forward.y());
        const Vec2 need = is_along_x ? Vec2(closer.along(), closer.across())
                                     : Vec2(closer.across(), closer.along());
        if (((floor.size() - need).array() < 2.0 * margin).any()) continue;
        const double cost = cost_of_facing(plan_.room, wall, draft, drafts_);
        if (best && cost >= least) continue;
        best = FormationSite{wall, forward, 0.5 * (floor.low + floor.high - closer.before * forward), closeness};
        least = cost;
      }
      if (best) return best;
    }
    return std::nullopt;
  }
  // Mats and rugs lie one way or across, never turned about.
  bool is_flat(const Draft& draft) const { return table_.get(draft.item.category).traits.flat; }
  static std::string wall_name(const FormationSite& site) { return "wall-" + std::to_string(site.wall); }

  // Who sits at a desk looks over it: its back is where the rows look.
  bool looks_backwards(const std::string& category) const { return table_.is_a(category, "table"); }

  void stand(PlanItem& item, const RowBlock& block, const FormationSite& site, std::size_t number) const {
    const bool backwards = looks_backwards(item.category);
    const Vec2 front = backwards ? Vec2(-site.forward) : site.forward;
    const Vec2 right(front.y(), -front.x());
    const auto middle = [](std::size_t lines) { return 0.5 * (static_cast<double>(lines) - 1.0); };
    const double row = static_cast<double>(number / block.columns) - middle(block.rows);
    const double column = static_cast<double>(number % block.columns) - middle(block.columns);
    item.location = site.center + column * (block.width + block.beside) * right -
                    row * (block.depth + block.behind) * front;
    // As a whole the rows look there: only who sits in the middle does so straight.
    std::erase_if(item.relations, [](const Relation& one) { return is_looking_at(one.kind); });
    if (number > 0) return;
    const std::string wall = wall_name(site);
    const auto facing = backwards ? RelationKind::face_same_as : RelationKind::face_opposite_to;
    item.relations.push_back({facing, wall});
  }

  const std::vector<Draft>& drafts_;
  const KindTable& table_;
  const Arrangements& arrangements_;
  Plan& plan_;
};

}  // namespace

void fall_in_as_usual(std::vector<Draft>& drafts, const KindTable& table, const Arrangements& arrangements) {
  for (auto& draft : drafts) {
    if (draft.formation || draft.item.mount != Mount::floor || !draft.demands.empty()) continue;
    const int from = arrangements.get(table, draft.item.category, Mount::floor).rows_from;
    if (from == 0 || draft.item.quantity < from) continue;
    draft.formation = brief::Formation{.rows = 0, .columns = 0};
    draft.is_usual_formation = true;
  }
}

void lay_out_formations(const std::vector<Draft>& drafts, const KindTable& table,
                        const Arrangements& arrangements, Plan& plan) {
  Formations(drafts, table, arrangements, plan).run();
}

std::size_t columns_of(const brief::Formation& formation, std::size_t count) {
  constexpr double breadth = 1.5;  ///< a block whose rows were not counted is somewhat wider than deep
  if (formation.columns > 0) return static_cast<std::size_t>(formation.columns);
  const std::size_t rows =
      formation.rows > 0 ? static_cast<std::size_t>(formation.rows)
                         : std::max<std::size_t>(2, static_cast<std::size_t>(std::sqrt(static_cast<double>(count) / breadth)));
  return std::max<std::size_t>(1, (count + rows - 1) / rows);
}

}  // namespace roomgen::plan
