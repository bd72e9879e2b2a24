#pragma once

#include <string>
#include <vector>

#include "roomgen/lab/optimise.h"

/// Articles without meshes: boxes of the kinds' usual sizes, and a smaller and a larger one.
inline roomgen::lab::Stock box_stock(const roomgen::lab::ConstraintProgram& program, const roomgen::KindTable& kinds) {
  roomgen::lab::Stock stock;
  for (const auto& name : kinds_to_stock(program, kinds)) {
    const roomgen::Kind& kind = kinds.get(name);
    for (const double factor : {1.0, 0.9, 1.08}) {
      roomgen::Object object;
      object.category = name;
      object.traits = kind.traits;
      object.size = {kind.size.x() * factor, kind.size.y() * factor, kind.size.z()};
      object.mount = kind.mount;
      stock.articles[name].push_back(object);
    }
  }
  return stock;
}

inline std::vector<std::string> example_programs() {
  const std::string folder = std::string(ROOMGEN_TEST_DATA) + "/programs/";
  return {folder + "dining.json", folder + "bathroom.json", folder + "bedroom.json"};
}
