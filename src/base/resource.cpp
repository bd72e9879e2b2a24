#include "roomgen/base/resource.h"

#include <algorithm>

#include "resource_table.h"

namespace roomgen {

std::optional<std::string_view> resource(std::string_view path) {
  for (const auto* entry = detail::resource_table; !entry->name.empty(); ++entry)
    if (entry->name == path) return entry->bytes;
  return std::nullopt;
}

std::vector<std::string_view> resources(std::string_view prefix) {
  std::vector<std::string_view> names;
  for (const auto* entry = detail::resource_table; !entry->name.empty(); ++entry)
    if (entry->name.starts_with(prefix)) names.push_back(entry->name);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace roomgen
