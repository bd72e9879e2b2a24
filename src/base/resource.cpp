#include "resource.h"

#include <algorithm>

#include "resource_table.h"

namespace roomgen {

namespace {

std::string_view bytes_of(const detail::ResourceEntry& entry) {
  return {reinterpret_cast<const char*>(entry.bytes), static_cast<std::size_t>(*entry.size)};
}

}  // namespace

std::optional<std::string_view> resource(std::string_view path) {
  for (const auto* entry = detail::resource_table; entry->name; ++entry)
    if (entry->name == path) return bytes_of(*entry);
  return std::nullopt;
}

std::vector<std::string_view> resources(std::string_view prefix) {
  std::vector<std::string_view> names;
  for (const auto* entry = detail::resource_table; entry->name; ++entry)
    if (std::string_view(entry->name).starts_with(prefix)) names.push_back(entry->name);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace roomgen
