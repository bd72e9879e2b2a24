#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"

namespace roomgen {

/// The constraint vocabulary. docs/constraints.md says when each holds.
enum class RelationKind {
  edge,
  middle,
  corner,
  in_part,
  near,
  next_to,
  far,
  gap,
  in_front_of,
  behind,
  left_of,
  right_of,
  side_of,
  around,
  between,
  center_aligned,
  aligned,
  face_to,
  face_same_as,
  face_opposite_to,
  used_facing,
  on,
  inside,
  above,
  under,
  hang_from,
};

/// How far apart the footprints of an object and its target are, in metres.
struct Gap {
  double least = 0.0;
  double most = 0.0;  ///< infinity: there is no most

  bool operator==(const Gap&) const = default;
};

/// "near, bed-0": what an object shall be to a target, which is the id of an object, an opening
/// ("door-0"), a wall ("wall-2"; "wall": the nearest), "corner" or a region of the room ("north-half"). edge, middle and
/// corner have no target; what is between two things has the relation twice, once with each.
struct Relation {
  RelationKind kind = RelationKind::edge;
  std::string target;
  Gap gap = {};  ///< of RelationKind::gap

  bool operator==(const Relation&) const = default;
};

/// The verdict on one relation of a placed object.
struct Judgement {
  bool held = false;
  double degree = 0.0;  ///< in [0, 1]: how well, continuous, so that near misses and best fits rank
};
struct RelationVerdict {
  std::string object;  ///< its id
  Relation relation;
  Judgement judgement;
};

/// A way to write a relation.
struct RelationSpelling {
  std::string_view text;
  RelationKind kind;
};
/// All that files may use; the first of each kind is its name.
std::span<const RelationSpelling> relation_spellings();

/// "in front of"
std::string_view name(RelationKind kind);
bool takes_target(RelationKind kind);
/// Does it say what a thing looks at: face_to by its front, used_facing by its use?
bool is_looking_at(RelationKind kind);
/// "in front of, desk-0"; "gap 0.5 m, desk-0", "gap at least 1.5 m, wall-2", "gap at most 1 m, door-0"
std::string to_text(const Relation& relation);
/// "0.5 m", "at least 1.5 m"
std::string to_text(const Gap& gap);
/// "edge | near, bed-0"
std::string to_text(const std::vector<Relation>& relations);

/// Parses one relation; case and extra spaces do not matter, common other spellings are understood
/// ("centre align with"). Targets are returned in lower case. The error names the unknown word and the
/// nearest known one.
Result<Relation> parse_relation(std::string_view text);

/// Parses "edge | near, bed-0 | …". Empty text gives no relations; repeated ones are dropped.
Result<std::vector<Relation>> parse_relations(std::string_view text);

}  // namespace roomgen
