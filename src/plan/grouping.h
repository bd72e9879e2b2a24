#pragma once

#include <map>
#include <string>
#include <vector>

#include "blocks.h"
#include "composition/arrange.h"
#include "inventory.h"
#include "solve/arrangement.h"

namespace roomgen::plan {

/// Finds which of a room's things belong together (data/compositions), so that they are placed as
/// one. Remembers what compositions hold: one serves all attempts at a plan.
class Grouping {
 public:
  Grouping(const KindTable& kinds, const Arrangements& arrangements);

  /// The floor that they take when they are grouped: of each group that of its box.
  struct Floor {
    double area = 0.0;            ///< square metres
    Vec2 largest = Vec2::Zero();  ///< the box of the largest group, with a way
  };
  Floor floor_of(std::vector<Draft> drafts, const brief::Brief& brief, const std::string& prompt);

  /// Groups the drafts anew: those that gain most first. Drafts whose things go to several groups
  /// are split. What is told of a thing's place beyond being at its anchor keeps it out. What is told
  /// to stand in rows, in a circle or an arc, and many of what usually stands in rows, becomes a
  /// block, with what belongs to each; in a room it is told where it stands.
  void run(std::vector<Draft>& drafts, const brief::Brief& brief, Plan& plan);

 private:
  /// The things of one part of a composition.
  struct PartCount {
    std::string part, kind;
    Mount mount = Mount::floor;
    int count = 0;
    int spare = 0;
    Vec3 size = Vec3::Ones();
  };
  using Counts = std::vector<PartCount>;  ///< the anchor's part first
  /// A composition that an anchor could have, set for what is there.
  struct Fit {
    const composition::Composition* composition = nullptr;
    composition::Values values;
    Counts counts;
    double gain = 0.0;
  };

  const Counts& counts_of(const composition::Composition& composition,
                          const composition::Values& values);
  Fit fit(const composition::Composition& composition, const std::vector<Draft>& drafts,
          std::size_t anchor);
  double gain_of(const Counts& counts, const std::vector<Draft>& drafts, std::size_t anchor) const;
  /// Things of a draft that are those of a part.
  struct Use {
    std::size_t part = 0, draft = 0;
    int quantity = 0;
  };
  std::vector<int> shares(const Counts& counts, const std::vector<Draft>& drafts,
                          std::size_t anchor) const;
  /// `left`: of each draft, of its share.
  std::vector<Use> uses_of(const Counts& counts, const std::vector<Draft>& drafts,
                           std::size_t anchor, std::vector<int>& left) const;
  bool may_dress(const std::string& kind, const brief::Brief& brief) const;
  bool is_kin(const std::string& category, const std::string& kind) const;
  bool belongs(const Draft& draft, const PartCount& part) const;
  bool is_plain_word_for(const Draft& draft, const std::string& kind) const;
  void mean(Draft& draft, const PartCount& part) const;
  bool may_come_along(const std::string& kind, const brief::Brief& brief) const;
  bool is_told_within(const Draft& draft, const Counts& counts, const std::vector<Draft>& drafts,
                      std::size_t anchor) const;
  double told_gain(const Draft& thing, const std::vector<Draft>& drafts) const;
  bool is_drawn_up(const Draft& draft) const;
  Fit best_fit(const std::vector<Draft>& drafts, std::size_t anchor, const std::string& room,
               const std::string& wish, const std::string& unit_of);
  bool is_unit(const Fit& fit, const std::string& category) const;
  bool stands_in_rows(const Draft& draft) const;
  static std::string id_for(const std::string& name, const Plan& plan);
  void take(const Fit& fit, int copies, const std::string& path, std::vector<Draft>& drafts,
            std::size_t anchor, const brief::Brief& brief, PlanGroup& group);
  void make_told_block(std::vector<Draft>& drafts, std::size_t told, const std::string& wish,
                       const brief::Brief& brief, Plan& plan, std::vector<FormedBlock>& blocks);
  void make_block(const Draft& thing, Fit fit, std::vector<Draft>& drafts, std::size_t anchor,
                  const brief::Brief& brief, Plan& plan, std::vector<FormedBlock>& blocks);
  void make_group(const Fit& fit, std::vector<Draft>& drafts, std::size_t anchor,
                  const brief::Brief& brief, Plan& plan);

  const KindTable& kinds_;
  const Arrangements& arrangements_;
  std::map<std::string, Counts> known_;  ///< by composition and values
};

}  // namespace roomgen::plan
