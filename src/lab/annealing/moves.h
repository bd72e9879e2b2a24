#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/random.h"
#include "bounds.h"
#include "evaluator.h"
#include "settle.h"
#include "world.h"

namespace roomgen::lab::annealing {

/// The moves of the annealing (InfiniBench's supplement, section C.2): eight of single things, three of clusters.
enum class MoveKind {
  add, remove, resample, translate, rotate, change_plane, change_target, swap,
  resample_cluster, translate_cluster, rotate_cluster,
};
inline constexpr std::size_t move_kinds = 11;
std::string_view name(MoveKind kind);

/// Proposes changes of a world. Each leaves the world changed and says what was moved; nothing if there was no such
/// change to make (the world may be changed all the same: take it back).
class Moves {
 public:
  /// All must outlive this. `articles_of_kind`: numbers of articles by number of kind.
  Moves(World& world, Evaluator& evaluator, const std::vector<Bound>& bounds,
        const std::vector<std::vector<int>>& articles_of_kind, const Language& language, Random& random);

  /// `reach`: metres by which things are shifted, one standard deviation.
  std::optional<SlotSet> propose(MoveKind kind, double reach);

 private:
  using Proposal = std::optional<SlotSet>;
  Proposal add();
  Proposal remove();
  Proposal resample(bool cluster);
  Proposal translate(double reach, bool cluster);
  Proposal rotate(bool cluster);
  Proposal change_plane();
  Proposal change_target();
  Proposal swap();

  struct Deficit {
    const Bound* bound;
    int number;
    std::vector<Slot> variables;
    double missing;  ///< below the least; negative: so many may be more
  };
  std::vector<Deficit> deficits();
  std::optional<Slot> add_for(const Deficit& wanted);
  void add_company(Slot root, SlotSet& moved);
  void clear_place_of(Slot slot);
  std::optional<int> design_of(int bound) const;
  bool settle_anew(Slot root, SlotSet& moved);
  std::optional<Slot> any_thing(bool with_dependants);
  /// Chooses a target and faces for a relation; nothing if there is no target.
  std::optional<Attachment> attach(int relation, int target_set, const std::vector<Slot>& variables,
                                   const Kind& kind, std::optional<Slot> self);
  std::optional<std::vector<Attachment>> attach_all(const Recipe& recipe, const std::vector<Slot>& variables,
                                                    const Kind& kind, std::optional<Slot> self);
  std::optional<Attachment> usual_attachment(const Kind& kind);
  bool choose_faces(Attachment& attachment, const Kind& kind);
  /// Puts a thing there with all that is up against it.
  Proposal put(Slot slot, const Stance& stance);

  World& world_;
  Evaluator& evaluator_;
  const std::vector<Bound>& bounds_;
  const std::vector<std::vector<int>>& articles_of_kind_;
  const Language& language_;
  Random& random_;
  Settler settler_;
  bool bounds_with_variables_;
};

}  // namespace roomgen::lab::annealing
