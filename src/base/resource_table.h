#pragma once

#include <string_view>

namespace roomgen::detail {

/// The table that cmake/embed.cmake generates; an entry without a name ends it.
struct ResourceEntry {
  std::string_view name;
  std::string_view bytes;
};
extern const ResourceEntry resource_table[];

}  // namespace roomgen::detail
