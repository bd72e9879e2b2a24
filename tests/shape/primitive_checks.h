#pragma once

#include <string>

#include "roomgen/shape/primitives.h"

/// How far meshes may be from the surface where a test does not ask for more, in metres.
constexpr double tolerance = 0.001;

/// What is wrong with a mesh that should be a primitive: open, inside out, a triangle without area,
/// normals that are missing, not of unit length or against their face, uvs missing or not in
/// metres. Empty when nothing is.
std::string flaws(const roomgen::Mesh& mesh);
/// The mesh without flaws, or the test fails.
roomgen::Mesh sound(const roomgen::Result<roomgen::Mesh>& mesh);
