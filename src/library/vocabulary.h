#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen {

/// How a phrase was understood. A phrase whose ending is a known kind but whose other words are
/// neither colours, materials nor the like names another thing ("dog bed" is no bed): it is not
/// known.
struct KindPhrase {
  std::string kind;  ///< a known kind's name, or the phrase without colours, materials and the like
  std::string name;  ///< the words of the phrase that named it, in singular: "writing desk"
  bool known = false;
};

/// What phrases about furniture name, in the terms of libraries (Kind::stocked_as): the kinds of a table,
/// and the words of data/vocabulary.json for how things are (docs/kinds.md). The table must outlive it.
class Vocabulary {
 public:
  static Result<Vocabulary> parse(std::string_view text, const std::string& source,
                                  const KindTable& kinds = KindTable::built_in());
  /// The vocabulary compiled into the library.
  static const Vocabulary& built_in();

  const KindTable& kinds() const { return *kinds_; }
  /// Null if there is no kind of exactly this name (singular or plural).
  const Kind* find(std::string_view name) const;

  /// What a phrase names: "two white oak desks with drawers" is a desk.
  KindPhrase understand(std::string_view phrase) const;
  /// What an asset's own name says it is: like understand(), but a word that is not known does not
  /// make it another thing, since it is likely the maker's name for it ("Ektorp sofa").
  KindPhrase understand_name(std::string_view name) const;
  /// The known kinds that a text mentions anywhere, in order, the longest name at each place.
  std::vector<std::string> mentioned(std::string_view text) const;
  /// True if `name` is `ancestor`, or serves who asks for it.
  bool is_a(std::string_view name, std::string_view ancestor) const;

  /// How well a thing of kind `have` serves who asks for `want`, in [0, 1]; 0 is not at all. Both
  /// are kinds, or free phrases as understand() gives them.
  double fit(std::string_view have, std::string_view want) const;

  /// All words that mean nearly the same as `word`, itself first: oak, wood, wooden.
  std::vector<std::string> family(std::string_view word) const;
  /// The family that a word belongs to, by its first word ("wood"); empty if none.
  std::string family_name(std::string_view word) const;
  /// True for words that say how a thing is, not what it is: colours, materials, styles, sizes,
  /// rooms.
  bool is_modifier(std::string_view word) const;
  /// True for words without meaning in a search: a, the, with.
  bool is_filler(std::string_view word) const;

 private:
  explicit Vocabulary(const KindTable& kinds) : kinds_(&kinds) {}

  const KindTable* kinds_;
  std::map<std::string, std::size_t, std::less<>> family_of_;  ///< word to index in families_
  std::vector<std::vector<std::string>> families_;
  std::set<std::string, std::less<>> modifiers_, fillers_;
};

}  // namespace roomgen
