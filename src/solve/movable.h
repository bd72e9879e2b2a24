#pragma once

#include <optional>
#include <span>
#include <vector>

#include "domain.h"
#include "roomgen/scene/problem.h"
#include "scene/resolved_relation.h"

namespace roomgen {

/// A constraint of a thing, with those of the things that it names: their footprints change.
struct BoundRelation {
  ResolvedRelation relation;
  std::optional<std::size_t> target = {};
  std::optional<std::size_t> other = {};  ///< of `between`
};

/// One thing of a layout of which others are drawn. Numbers are those of the things in placement order.
struct Movable {
  PlacementTask task;  ///< with the constraints that must hold, and no suggestion
  bool fixed = false;  ///< it stays where it is
  std::vector<BoundRelation> relations;
  /// What it stands on, or what its constraints place it by: where that goes, this goes too.
  std::optional<std::size_t> anchor;
  /// All things whose place follows from this one's, directly or not, in placement order.
  std::vector<std::size_t> dependants;
  Domain domain;
};

/// Which of the things stay: what is locked, with all that carries it, and what hangs at a window.
std::vector<bool> immovable(std::span<const PlacementTask> tasks, const KindTable& kinds);

/// Layouts of the same things in the same order, as poses.
using Poses = std::vector<Pose>;

/// The things of a layout, ready to be drawn anew. Domains are found about where things stand in the examples, which
/// are whole layouts; `layout` is empty, and is again in the end.
std::vector<Movable> make_movables(Layout& layout, std::span<const PlacementTask> tasks,
                                   std::span<const Poses> examples);

}  // namespace roomgen
