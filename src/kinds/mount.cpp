#include "roomgen/kinds/kind_table.h"

#include <array>

namespace roomgen {

namespace {
constexpr std::array<std::string_view, 4> mount_names = {"floor", "wall", "ceiling", "surface"};
}

std::string_view name(Mount mount) {
  return mount_names[static_cast<std::size_t>(mount)];
}

std::optional<Mount> parse_mount(std::string_view text) {
  for (std::size_t i = 0; i < mount_names.size(); ++i)
    if (mount_names[i] == text) return static_cast<Mount>(i);
  return std::nullopt;
}

}  // namespace roomgen
