#pragma once

#include <cstdint>

namespace roomgen::detail {

/// The table that cmake/RoomgenEmbed.cmake generates; an entry without a name ends it.
struct ResourceEntry {
  const char* name;
  const unsigned char* bytes;
  const std::uint64_t* size;
};
extern const ResourceEntry resource_table[];

}  // namespace roomgen::detail
