#pragma once

#include <array>
#include <vector>

#include "compiled.h"
#include "pair_memo.h"
#include "structure_memo.h"
#include "world.h"

namespace roomgen::lab::annealing {

/// What a state is worth: violations first, then scores; less is better.
struct Worth {
  double violation = 0.0;  ///< the sum of what constraints miss
  double loss = 0.0;       ///< what minimize and maximize say

  bool operator==(const Worth&) const = default;
};

/// Says what a compiled program thinks of a world. What it found of pairs of things it remembers as long as both
/// stay where they are, so that a move costs what it touches; a new evaluator says the same from scratch.
class Evaluator {
 public:
  /// Both must outlive the evaluator.
  Evaluator(const Compiled& program, const World& world);

  Worth worth();
  /// By how much a constraint is missed; 0: it holds.
  double violation(const TermNode& truth);
  /// The value of a number; NaN for nothing (an operand was empty).
  double value(const TermNode& number);
  SlotSet members(int set);
  /// The same with variables in force.
  SlotSet members(int set, const std::vector<Slot>& variables);
  double violation(const TermNode& truth, const std::vector<Slot>& variables);
  double occupancy();
  /// Relations of a tie's thing: the weight of those that do not hold, and the mean degree of all.
  struct Held {
    double lost = 0.0;
    double degree = 0.0;
  };
  std::optional<Held> held(const Tie& tie);

 private:
  using Distances = PairMemo<double>;
  SlotSet find_members(const SetNode& node);
  bool is_related(Slot slot, const SetNode::Relation& relation, const SlotSet& targets) const;
  double pair_distance(Slot a, Slot b);
  double distance(const TermNode& node);
  double distance_to_face_of_room(Slot slot, Face face);
  double nearest(Slot slot, const TermNode& node, const SlotSet& others, bool is_room);
  double access(const TermNode& node);
  double angle(const TermNode& node);
  double focus(const TermNode& node);
  double center(const TermNode& node);
  double gap(const TermNode& node);
  double seats(const TermNode& node);
  double floor_area(const SlotSet& set, bool on_floor_only);
  double arithmetic(const TermNode& node);
  double over_members(const TermNode& node);
  double comparison(const TermNode& node);
  std::vector<Footprint> footprints(int set);

  const Compiled& program_;
  const World& world_;
  double area_ = 0.0;
  std::array<Slot, most_variables> variables_{};
  Distances distances_;
  Distances shared_;
  Distances to_room_;  ///< of one thing and a number for what is asked of the room
  std::vector<Distances> accesses_;
  std::optional<Slot> slot_of(int kind_number) const;
  Held judge_tie(const Tie& tie, Slot slot, const std::vector<Slot>& targets) const;
  PairMemo<Held> ties_;
  template <typename Memo, typename Find>
  const auto& of_structure(std::vector<Memo>& memos, int number, Find&& find) {
    return memos[static_cast<std::size_t>(number)].get(world_.structure(), world_.marked_structure(), find);
  }
  double find_value(const TermNode& node);
  double find_violation(const TermNode& node);
  std::vector<StructureMemo<SlotSet>> sets_;
  std::vector<StructureMemo<double>> counts_;  ///< what depends on the structure alone
};

}  // namespace roomgen::lab::annealing
