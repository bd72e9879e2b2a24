#include "face_names.h"
#include "roomgen/lab/program.h"

namespace roomgen::lab {

namespace {

PutUp against(std::string_view child, std::string_view parent, double margin, bool within_height = true) {
  return {PutUp::Type::stable_against, faces_named(child), faces_named(parent), margin, within_height};
}

PutUp in_plane(std::string_view face, double margin) {
  return {PutUp::Type::coplanar, faces_named(face), faces_named(face), margin, true};
}

// Chairs come to a table from all of its sides: the source leaves the back out, which our tables do not have.
PutUp front_to_any_side() {
  PutUp put_up = against("front", "side", 0.05, false);
  put_up.parent.push_back(Face::back);
  return put_up;
}

}  // namespace

// The margins are the source's but for those to the room: things stand on the floor and hang from walls and ceilings, and
// what is against a wall is at its edge as docs/constraints.md has it.
const std::map<std::string, PutUp, std::less<>>& built_in_relations() {
  static const std::map<std::string, PutUp, std::less<>> relations = {
      {"on_floor", against("bottom", "floor", 0.0)},
      {"flush_wall", against("back", "wall", 0.0)},
      {"against_wall", against("back", "wall", 0.03)},
      {"spaced_wall", against("back", "wall", 0.8)},
      {"side_against_wall", against("side", "wall", 0.05)},
      {"hanging", against("top", "ceiling", 0.0)},
      {"ontop", against("bottom", "top", 0.0)},
      {"on", against("bottom", "support", 0.0)},
      {"front_against", front_to_any_side()},
      {"front_to_front", against("front", "front", 0.05, false)},
      {"leftright_leftright", against("leftright", "leftright", 0.05)},
      {"side_by_side", against("side", "side", 0.0)},
      {"back_to_back", against("back", "back", 0.0)},
      {"front_coplanar_front", in_plane("front", 0.05)},
      {"back_coplanar_back", in_plane("back", 0.05)},
  };
  return relations;
}

}  // namespace roomgen::lab
