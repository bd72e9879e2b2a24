#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/object.h"

namespace roomgen {

/// A kind of thing as people name it: what a query asks for and what an asset is.
struct StockKind {
  std::string name;                ///< "dining chair"
  std::string parent;              ///< "chair": every dining chair is a chair; may be empty
  std::vector<std::string> names;  ///< other names: "kitchen chair"
  std::map<std::string, double> substitutes;  ///< kinds that will do, and how well, in (0, 1)
  bool usual = false;                         ///< what people mean when they say the parent's name
  bool supports = false;                      ///< its top carries things
  std::optional<Mount> mount;
  std::vector<Mount> also;  ///< other ways to put it (a television on the wall)
};

/// How a phrase was understood. A phrase whose ending is a known kind but whose other words are
/// neither colours, materials nor the like names another thing ("dog bed" is no bed): it is not
/// known.
struct KindPhrase {
  std::string kind;  ///< a known kind's name, or the phrase without colours, materials and the like
  std::string name;  ///< the words of the phrase that named it, in singular: "writing desk"
  bool known = false;
};

/// Words about furniture, from data/vocabulary.json (docs/vocabulary.md). The built-in one knows all
/// kinds and names of KindTable::built_in() too, and hence all that can be built.
class Vocabulary {
 public:
  static Result<Vocabulary> parse(std::string_view text, const std::string& source);
  /// The vocabulary compiled into the library.
  static const Vocabulary& built_in();

  /// Adds the kinds and names that it lacks. A category whose name is a name here is that kind, and adds
  /// its other names; one that is named after its outline or size ("round table") is no kind of its own.
  void add(const KindTable& categories);

  /// Null if there is no kind of exactly this name or synonym (singular or plural).
  const StockKind* find(std::string_view name) const;
  const std::map<std::string, StockKind, std::less<>>& kinds() const { return kinds_; }

  /// What a phrase names: "two white oak desks with drawers" is a desk.
  KindPhrase understand(std::string_view phrase) const;
  /// What an asset's own name says it is: like understand(), but a word that is not known does not
  /// make it another thing, since it is likely the maker's name for it ("Ektorp sofa").
  KindPhrase understand_name(std::string_view name) const;
  /// The known kinds that a text mentions anywhere, in order, the longest name at each place.
  std::vector<std::string> mentioned(std::string_view text) const;
  /// True if `name` is `ancestor` or one of its descendants.
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
  const StockKind* by_name(std::string_view name) const;

  std::map<std::string, StockKind, std::less<>> kinds_;
  std::map<std::string, std::string, std::less<>> names_;      ///< any spelling to a kind
  std::map<std::string, std::size_t, std::less<>> family_of_;  ///< word to index in families_
  std::vector<std::vector<std::string>> families_;
  std::map<std::string, bool, std::less<>> modifiers_;
  std::map<std::string, bool, std::less<>> fillers_;
};

}  // namespace roomgen
