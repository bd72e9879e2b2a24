#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomgen/library/library.h"

namespace roomgen {

/// A library that has nothing in stock and builds what is asked for from a few boxes and cylinders,
/// in the wanted size: tables, shelves, cabinets, mirrors, pictures, rugs, lamps, boxes with a lid.
/// It answers only for kinds whose vocabulary entry names one of these recipes, with one match of
/// low score; other queries get nothing.
///
/// AssetRef::procedural carries the recipe, its params (size in metres, color, mount) and the seed,
/// which decides the colour where the description names none; load() needs nothing else.
std::unique_ptr<AssetLibrary> make_standins();

/// The names of the recipes.
const std::vector<std::string>& standin_recipes();

/// Builds one: closed meshes with outward normals that fill a box of exactly `size`. `mount`
/// matters to lamps and shelves. `color` is a colour or a wood ("white", "oak"); others read as
/// oak. Null model (no parts) for an unknown recipe.
struct StandinSpec {
  std::string recipe;
  Vec3 size = Vec3::Ones();
  Mount mount = Mount::floor;
  std::string color = "oak";
  std::uint64_t seed = 0;
};
Model build_standin(const StandinSpec& spec);

}  // namespace roomgen
