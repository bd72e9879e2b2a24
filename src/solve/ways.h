#pragma once

#include <vector>

#include "layout.h"
#include "roomgen/scene/relation.h"

namespace roomgen {

/// Nearer than this, metres, a thing is taken for the partner of another.
inline constexpr double partner_gap = 0.7;

/// A way with things instead of kinds ("near, sofa" became "near, sofa-1").
struct NamedWay {
  std::vector<Relation> relations;
  double burden = 0.0;  ///< how well provided its targets are already: 0 for none, 1 for enough
};

/// The ways to name things, those with the least burden first. Empty if a kind has no member in the
/// room that wants such a partner. Each kind means one thing throughout a way.
std::vector<NamedWay> name_targets(const Layout& layout, const Object& self,
                                   const std::vector<Relation>& way);

/// The first of the ways that is to a thing like this host, and to nothing else, with its name; empty if there is none.
std::vector<Relation> ways_to(const Arrangement& arrangement, const KindTable& kinds, const Object& host);

/// How many of the object's kind will share one table when `of_its_kind` are to come in all.
int company_at_table(const Layout& layout, int of_its_kind);

}  // namespace roomgen
