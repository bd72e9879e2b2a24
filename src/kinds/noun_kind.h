#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "roomgen/kinds/kind_table.h"

namespace roomgen {

/// What makes a noun mean a kind.
enum class NounBasis : std::uint8_t {
  none,      ///< it means no kind
  name,      ///< the kind is called so
  spelling,  ///< a misspelt name of it
  synonym,   ///< another word for a name of it, in a common sense of both (WordNet)
  hyponym,   ///< a word for something more special (WordNet)
  stand_in   ///< of a kind that stands for all such things (Kind::stands_for)
};

/// The kind that a noun means.
struct NounKind {
  const Kind* kind = nullptr;  ///< as plans know it
  NounBasis basis = NounBasis::none;
  std::string name;  ///< of the kind, by which the noun means it
};

/// What a noun means that no kind is called by, in the singular: "credenza", "gong". Words for people,
/// animals, times and the like, and for what buildings are made of, mean no kind.
NounKind inferred_kind(const KindTable& table, std::string_view noun);

/// What a misspelt noun is meant for, with the name as it should be: "bokshelf", "cofee table". No kind
/// where words of English are wrong, and where names of several kinds are equally near.
NounKind misspelt_kind(const KindTable& table, std::string_view noun);

/// The stand-in for a noun that means no other kind; null if there is none.
const Kind* stand_in_for(const KindTable& table, std::string_view noun);

/// Whether one of the noun's common senses is something that one can touch; true of words that WordNet lacks.
bool is_physical(std::string_view noun);

}  // namespace roomgen
