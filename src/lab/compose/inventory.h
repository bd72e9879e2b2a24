#pragma once

#include <string>
#include <vector>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/lab/program.h"
#include "roomgen/scene/plan.h"

namespace roomgen::lab::compose {

/// Things of one kind that are put up in one way: a set of the program, and how many there may be.
struct Stand {
  std::string name;       ///< of the set: "chair", "table lamp 2"
  std::string kind;
  Mount mount = Mount::floor;
  std::string on;         ///< the set of what carries it, for Mount::surface; empty: whatever carries things
  Range count;
  bool asked = false;     ///< somebody asked for them, in this number
  bool may_grow = false;  ///< more of them are as good
  bool essential = false; ///< nobody asked, and such a room is none without it: a bedroom's bed
  bool at_wall = true;    ///< may go against a wall where such things usually do
  bool in_rows = false;   ///< several, in line with each other
  std::vector<Relation> wishes;  ///< of the prompt; targets are sets or parts of the room
  Vec3 size = Vec3::Ones();      ///< of one
  std::string description;       ///< what retrieval looks for
};

/// The inventory of a plan, items of one kind and one way together, in the plan's order. What was asked for has the
/// number that its requirement says; what was added comes in any number up to the planned one.
std::vector<Stand> inventory_of(const Plan& plan, const KindTable& kinds);

/// A name of a set that none of these has: "chair", "chair 2".
std::string free_name(const std::vector<Stand>& stands, const std::string& kind);

/// Floor that one thing covers: nothing for rugs and for what does not stand on the floor.
double footprint_of(const Stand& stand, const KindTable& kinds);
/// Floor that the least, or the most, of all cover.
double least_footprint(const std::vector<Stand>& stands, const KindTable& kinds);
double most_footprint(const std::vector<Stand>& stands, const KindTable& kinds);

}  // namespace roomgen::lab::compose
