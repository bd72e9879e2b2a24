#include "set_ids.h"

#include <nlohmann/json.hpp>

#include "program_text.h"
#include "roomgen/base/json.h"

namespace roomgen::lab {

std::size_t SetIds::of(const ProgramSet& set) {
  const auto [entry, is_new] = known_.try_emplace(&set);
  if (is_new) {
    const std::string text = json_line(to_json(set));
    entry->second = texts_.try_emplace(text, texts_.size()).first->second;
  }
  return entry->second;
}

SetIds::Key SetIds::key(const ProgramSet& set,
                        const std::vector<std::pair<std::string, const ProgramSet*>>& variables) {
  Key key = {{"", of(set)}};
  for (const auto& [name, members] : variables) key.emplace_back(name, of(*members));
  return key;
}

}  // namespace roomgen::lab
