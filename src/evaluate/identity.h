#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "library/vocabulary.h"
#include "roomgen/scene/object.h"

namespace roomgen {

/// What an object of a scene is known to be, from what made it: what somebody saw in a library's
/// mesh, or the kind of a recipe. What the scene's description asked for is no evidence.
struct Identity {
  std::string kind;             ///< "dining chair"
  std::set<std::string> words;  ///< of the kind and of who saw the mesh, in the singular
  std::string basis;            ///< "label of Scopia/chair", "recipe kind"
};

Identity identify(const Object& object, const Vocabulary& vocabulary = Vocabulary::built_in());

/// How well a thing of this identity is what the category names (docs/evaluation.md); 0 is not at all.
/// 5: the same name, 4: another name of the same kind, 3: a kind of it, 2: it by all but words that say
/// how a thing is ("wooden desk"), by the last word of a name that nobody knows (a plate for "sushi
/// plate"), or merely without the rest of its name (a lamp for "floor lamp"), 1: a compound of it ("lava lamp" for "lamp").
int identity_rank(const Identity& identity, std::string_view category,
                  const Vocabulary& vocabulary = Vocabulary::built_in());

/// Is the thing of the sort because its kind is: a standing desk is a "sit stand" desk, since that is one of its
/// names and a desk is more than that. A candle is no "scented" one by being called so, for all candles are.
bool is_special_sort(const Identity& identity, std::string_view sort,
                     const Vocabulary& vocabulary = Vocabulary::built_in());

/// Which objects are which category, by index. An object is one category at most: the one of the
/// highest rank; among equals the one that it was placed as, then the one of which fewer were found.
std::map<std::string, std::vector<std::size_t>> identified_as(
    const std::vector<Object>& objects, const std::vector<std::string>& categories,
    const Vocabulary& vocabulary = Vocabulary::built_in());

}  // namespace roomgen
