#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json_fwd.h"
#include "roomgen/base/result.h"
#include "roomgen/kinds/kind.h"
#include "roomgen/kinds/kind_record.h"

namespace roomgen {

/// The kinds of things, from data/categories.json (docs/categories.md). Partners of zones and gaps and
/// what things tuck under are names of categories once the table is parsed.
///
/// The built-in table knows by name whatever can be built (data/shapes/kinds) and whatever libraries
/// name (data/vocabulary.json) as well; which kind a name means that several claim, docs/vocabulary.md
/// says.
class KindTable {
 public:
  static Result<KindTable> parse(std::string_view text, const std::string& source);
  /// The table compiled into the library, with the kinds and names of the other files.
  static const KindTable& built_in();

  /// Adds what other files know. A record whose name is known is that category, and adds its names; any
  /// other is a category of its own, which has from its parent what it does not say, or, without a size
  /// and a known parent, is passed over.
  void add(const std::vector<KindRecord>& records);

  /// The category that a name means: the name itself, a synonym, a plural, or the longest known ending
  /// ("oak writing desk" is a desk). Null if nothing matches.
  const Kind* find(std::string_view name) const;
  /// Like find(), and a category without zones or gaps for names that mean nothing.
  const Kind& get(std::string_view name) const;
  /// True if `name` means `kind` or one of its descendants.
  bool is_a(std::string_view name, std::string_view kind) const;
  bool is_any_of(std::string_view name, const std::vector<std::string>& kinds) const;
  const std::map<std::string, Kind, std::less<>>& all() const { return categories_; }

 private:
  void resolve_references(const JsonReader& json);
  bool add_category(const KindRecord& record);
  void add_name(const std::string& name, const std::string& category);

  std::map<std::string, Kind, std::less<>> categories_;
  std::map<std::string, std::string, std::less<>> names_;  ///< any spelling to the category's name
};

}  // namespace roomgen
