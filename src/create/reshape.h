#pragma once

#include "roomgen/create/maker.h"
#include "roomgen/shape/program.h"
#include "words.h"

namespace roomgen::create {

// Changes of a concrete program that say what no parameter of its recipe says. The validator closes
// what they open.

/// As many parts of this label: none, or those there are told how often to be repeated. False if it
/// is not known how.
bool set_count(shape::Program& program, const std::string& label, int count);
/// Turns the parts about their tops, feet outward.
void lean(shape::Program& program, const std::string& label, double degrees);
/// Straight parts become curved ones of the same length and thickness.
void bend(shape::Program& program, const std::string& label, Course course, Strength strength);
/// Flat parts (tops, seats) get another outline.
void set_outline(shape::Program& program, const std::string& label, const std::string& shape);
/// To these metres along the axes that are no NaN, as a whole where there are several alike.
void resize(shape::Program& program, const std::string& label, const Vec3& size);
void scale(shape::Program& program, const std::string& label, const Vec3& factors);
/// A material or colour for the parts of a label; an empty label means the surfaces of these names.
void paint(shape::Program& program, const std::string& label, const std::string& material,
           const std::string& color, const Words& words);
void paint_surfaces(shape::Program& program, const std::vector<std::string>& surfaces,
                    const std::string& material, const std::string& color, const Words& words);

}  // namespace roomgen::create
