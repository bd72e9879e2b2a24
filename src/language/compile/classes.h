#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "wordnet.h"

namespace roomgen::language {

/// For each synset the classes that it is in: bit k for the k-th WordClass. `file` names the tops
/// of each class ("furniture: furniture.n.1"); what lies below one is in the class, unless it lies
/// below an exception ("-pill.n.1"). Throws std::runtime_error for unknown names.
std::vector<std::uint32_t> word_classes(const WordNet& net, const std::filesystem::path& file);

}  // namespace roomgen::language
