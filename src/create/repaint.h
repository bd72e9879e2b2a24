#pragma once

#include <map>
#include <string>

#include "finish_table.h"
#include "paint_box.h"
#include "roomgen/geometry/model.h"

namespace roomgen::create {

/// What a surface is made of, by what its material lets through, by being metallic, and by the words of
/// its name; empty if none of them tells.
std::string stuff_of(const Material& material, const FinishTable& table = finish_table());

/// Paints parts of a model anew: words for looks (finish_look.h) by the stuff of the parts that get them.
/// Where the parts of that stuff are less than a third of the surface, those whose stuff is not known get
/// them too, then all that no other word is about; glass, plants, screens and bedding only when they are
/// named. The drawing of a texture stays where only its tone changes.
void repaint(Model& model, const std::map<std::string, std::string>& finish, PaintBox& paints,
             const FinishTable& table = finish_table());

/// Which share of what is seen of a model each of the looks would cover, by the stuff that it is said of.
std::map<std::string, double> painted_shares(const Model& model, const std::map<std::string, std::string>& finish,
                                             const FinishTable& table = finish_table());

}  // namespace roomgen::create
