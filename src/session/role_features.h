#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "edit_roles.h"

namespace roomgen {

/// Hashes of what a choice is made by.
using Features = std::vector<std::uint32_t>;

/// What is known of each word of a text whatever its role.
struct WordSigns {
  std::string word, base, tag;
  std::string kinds;                 ///< letters for what the words there mean to edits, in order
  std::vector<std::string> classes;  ///< more general terms, of WordNet
};
std::vector<WordSigns> signs_of(const EditText& text);

/// What the roles before a word say.
struct RoleContext {
  EditRole last = EditRole::next, before = EditRole::next;  ///< of the last two stretches
  bool has_order = false, has_thing = false, has_target = false;  ///< since the last "and"

  void add(EditRole role, bool ends_sentence);
  friend auto operator<=>(const RoleContext&, const RoleContext&) = default;
};

/// Of a word, whatever stands before it.
Features word_features(const std::vector<WordSigns>& signs, std::size_t at);
/// Of a word behind others that have roles.
Features context_features(const std::vector<WordSigns>& signs, std::size_t at, const RoleContext& context);
/// Of what an order is for; `previous`: the deed before, that may go on.
Features deed_features(const EditText& text, const std::vector<WordSigns>& signs, const SpokenOrder& order,
                       std::string_view previous);
/// Of where an order says that something shall go.
Features place_features(const EditText& text, const std::vector<WordSigns>& signs, const SpokenOrder& order, EditDeed deed);

}  // namespace roomgen
