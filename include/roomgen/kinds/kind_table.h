#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json_fwd.h"
#include "roomgen/base/result.h"
#include "roomgen/kinds/kind.h"

namespace roomgen {

/// A file of kinds, and what to call it in messages.
struct KindFile {
  std::string_view text;
  std::string source;
};

/// The kinds of things, from data/kinds (docs/kinds.md says which kind a name means). A value: who has
/// kinds of their own reads a table of their own. Partners of zones and gaps and what things tuck under
/// are names of kinds once the table is read.
class KindTable {
 public:
  static Result<KindTable> read(std::span<const KindFile> files);
  /// Of one file.
  static Result<KindTable> parse(std::string_view text, const std::string& source);
  /// The table compiled into the library.
  static const KindTable& built_in();

  /// The kind that plans and scenes mean by a name: the name itself, another name, a plural, or the
  /// longest known ending ("oak writing desk" is a desk). Never a variant. Null if nothing matches.
  const Kind* find(std::string_view name) const;
  /// Like find(), and a kind without zones or gaps for names that mean nothing.
  const Kind& get(std::string_view name) const;
  /// The kind of exactly this name, singular or plural, variants and loose names included; or null.
  const Kind* named(std::string_view name) const;
  /// The kind of this very name, as other kinds refer to it; or null.
  const Kind* by_name(std::string_view name) const;
  /// Like named(), but by no loose name.
  const Kind* called(std::string_view name) const;
  /// The planned kind of a name as the data spell it, in lower case: "lamps" means nothing.
  const Kind* spelled(std::string_view name) const;
  /// The kind as which plans and scenes know this one: itself unless it is a variant.
  const Kind& planned(const Kind& kind) const;

  /// True if `name` means `kind` or one of its descendants.
  bool is_a(std::string_view name, std::string_view kind) const;
  bool is_any_of(std::string_view name, const std::vector<std::string>& kinds) const;
  /// All kinds by name, variants too.
  const std::map<std::string, Kind, std::less<>>& all() const { return kinds_; }

 private:
  struct Name {
    std::string kind;
    bool loose = false;
    bool derived = false;  ///< the singular of a name
  };
  class Reader;

  void index_names();
  void add_name(const std::string& spelling, const Name& name);
  const Name* look_up(std::string_view name) const;

  std::map<std::string, Kind, std::less<>> kinds_;
  std::map<std::string, Name, std::less<>> names_;  ///< by any spelling
};

}  // namespace roomgen
