#pragma once

#include <string>
#include <vector>

#include "part_forms.h"
#include "roomgen/create/maker.h"
#include "roomgen/shape/program.h"
#include "spots.h"

namespace roomgen::create {

/// A part with what is known about it.
struct Piece {
  PartWish wish;
  PartForm form;
  Place place = Place::top;
  int count = 1;
};

Piece piece_of(const PartWish& wish);
/// One that nobody asked for and that others need.
Piece implied(const std::string& label, int count, Place place);

/// Of one copy on a thing of this size.
Vec3 size_on(const Piece& piece, const Vec3& whole);

/// Adds the copies of the piece for spots [begin, end) to the program, under free names. Returns
/// their boxes.
std::vector<Bounds3> put(shape::Program& program, const Piece& piece, const std::vector<Spot>& where,
                         std::size_t begin, std::size_t end);

/// What hangs does so on cords that end at a height.
void add_cords(shape::Program& program, const std::vector<Bounds3>& hung, double up_to);

}  // namespace roomgen::create
