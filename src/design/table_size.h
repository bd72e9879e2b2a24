#pragma once

#include <vector>

#include "brief.h"
#include "roomgen/scene/category.h"

namespace roomgen::design {

struct Draft;

/// A table of this usual size made large enough for so many seats (NKBA: 0.61 m for each), never
/// smaller than usual.
Vec3 table_for(const Vec3& usual, bool round, int seats);

/// Makes the tables that the prompt asks for, without saying how large, fit the seats it asks for.
void fit_tables(std::vector<Draft>& drafts, const Brief& brief, const CategoryTable& table);

}  // namespace roomgen::design
