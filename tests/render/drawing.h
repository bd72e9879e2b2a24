#pragma once

#include <memory>
#include <utility>

#include "catch.h"
#include "roomgen/render/pictures.h"

inline std::unique_ptr<roomgen::Renderer> make_renderer() {
  auto renderer = roomgen::make_osmesa_renderer();
  REQUIRE(renderer);
  return std::move(*renderer);
}
