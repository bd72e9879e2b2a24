#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "roomgen/shape/program.h"

namespace roomgen::create {

/// Calls `visit` for every solid component (no groups) of this label, as bodies get it: the
/// component's own, else the enclosing group's, else its name. Labels match in the singular.
void for_each_part(shape::Program& program, std::string_view label,
                   const std::function<void(shape::Component&)>& visit);

/// The outermost components in which every solid has this label: a leg that is a group of pieces is
/// one. Visited in order; `visit` says whether to keep it.
void filter_wholes(shape::Program& program, std::string_view label,
                   const std::function<bool(shape::Component&)>& keep);

/// Bodies of this label that the program makes, whole groups counted once where their solids share
/// the label.
int count_parts(const shape::Program& program, std::string_view label);

/// That of every label in the program.
std::map<std::string, int> all_parts(const shape::Program& program);

/// What is written on it: words of its letters and of its drawings.
std::string letters_of(const std::vector<shape::Component>& components);

/// Of the largest body of this label; 0 when there is none.
Vec3 part_size(const shape::Program& program, std::string_view label);

/// Drops connections of which an end is no longer there.
void prune_connections(shape::Program& program);

}  // namespace roomgen::create
