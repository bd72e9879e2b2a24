#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace roomgen::language {

struct Synset {
  std::vector<std::string> members;    ///< lemmas
  std::vector<std::uint32_t> general;  ///< hypernyms; of adjectives what they are like, or of
};

struct Sense {
  std::uint32_t synset = 0;
  std::uint32_t tagged = 0;  ///< times in the tagged texts
};

/// What the dictionary files say. Synsets of all parts of speech are numbered on, nouns first;
/// lemmas are in lower case, with spaces.
struct WordNet {
  static constexpr std::size_t parts = 4;

  std::string licence;
  std::vector<Synset> synsets;
  std::array<std::uint32_t, parts + 1> first{};  ///< synset of each part of speech
  std::map<std::string, std::array<std::vector<Sense>, parts>> lemmas;
  std::vector<std::pair<std::string, std::pair<std::string, int>>>
      irregular;  ///< form, lemma, part
};

/// Reads WordNet 3.0 as WNdb(5) describes it. Throws std::runtime_error when a file is missing or
/// not of that form: a build must stop then.
WordNet read_wordnet(const std::filesystem::path& folder);

}  // namespace roomgen::language
