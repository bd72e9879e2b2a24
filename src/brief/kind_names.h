#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "prompt_words.h"
#include "roomgen/kinds/kind_table.h"
#include "tokens.h"

namespace roomgen::design {

/// A name of a category in a text.
struct KindMatch {
  const Kind* category = nullptr;
  std::size_t length = 0;  ///< tokens; 0 if there is none
  bool plural = false;
  std::string name;  ///< in the singular: "bedside table"
};

/// Finds names of categories in tokens: whole names and synonyms, in the singular or the plural.
class KindNames {
 public:
  explicit KindNames(const KindTable& table);

  /// The longest name that starts at `at`.
  KindMatch match(std::span<const Token> tokens, std::size_t at) const;
  /// The category of exactly this name, or null.
  const Kind* find(const std::string& name) const;

 private:
  // "spools of thread": one thing's name, whose first word is in the plural.
  KindMatch match_of(std::span<const Token> tokens, std::size_t at) const;

  std::map<std::string, const Kind*, std::less<>> names_;
};

/// What a word may be in the singular; the word itself first.
std::vector<std::string> singulars(const std::string& word);

}  // namespace roomgen::design
