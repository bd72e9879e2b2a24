#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json_fwd.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/footprint.h"
#include "roomgen/scene/kind_record.h"
#include "roomgen/scene/object.h"

namespace roomgen {

enum class Side { front, back, left, right };

/// Floor beside an object that a person needs to use it: the whole length of one side of its box,
/// `depth` metres deep.
struct UseZone {
  Side side = Side::front;
  double depth = 0.6;
  std::vector<std::string> partners;  ///< categories that may stand in it (a chair at its desk)
};

/// How far two things stand apart when they serve each other.
struct PreferredGap {
  std::string partner;  ///< category
  double low = 0.0;
  double high = 0.0;    ///< metres between footprints
};

/// The lamp in a kind of thing.
struct Lamp {
  double candela = 60.0;  ///< luminous intensity, the same in all directions within the cone
  double height = 0.8;    ///< of the light in parts of the thing's height; 0: just under the thing
  double cone = 0.0;      ///< degrees from straight down to the edge of its light; 0: all directions
};

/// What is known about a kind of thing. A category inherits what it does not say from its parent
/// ("is": dining chair is chair is seat).
struct Category {
  std::string name;    ///< "dining chair"
  std::string parent;  ///< may be empty
  std::vector<std::string> synonyms;
  Vec3 size{0.6, 0.6, 0.9};  ///< usual width, depth, height
  Mount mount = Mount::floor;
  double elevation = 0.0;    ///< usual height of the bottom above the floor, for Mount::wall
  bool covers_window = false;  ///< hangs before a window and is made to its measure: a curtain
  Traits traits;
  std::vector<UseZone> zones;  ///< usable when one is free and reachable; none: always usable
  std::vector<PreferredGap> gaps;
  std::vector<std::string> tucks_under;  ///< categories it may slide under (a chair, a table)
  std::optional<Lamp> lamp;              ///< things of this kind shine
  std::vector<std::string> lineage;      ///< itself and its ancestors; empty for an unknown kind
};

/// Is the category one of the kinds, or a descendant of one?
bool is_any_of(const Category& category, const std::vector<std::string>& kinds);

/// The kinds of things, from data/categories.json (docs/categories.md). Partners of zones and gaps and
/// what things tuck under are names of categories once the table is parsed.
///
/// The built-in table knows by name whatever can be built (data/shapes/kinds) and whatever libraries
/// name (data/vocabulary.json) as well; which kind a name means that several claim, docs/vocabulary.md
/// says.
class CategoryTable {
 public:
  static Result<CategoryTable> parse(std::string_view text, const std::string& source);
  /// The table compiled into the library, with the kinds and names of the other files.
  static const CategoryTable& built_in();

  /// Adds what other files know. A record whose name is known is that category, and adds its names; any
  /// other is a category of its own, which has from its parent what it does not say, or, without a size
  /// and a known parent, is passed over.
  void add(const std::vector<KindRecord>& records);

  /// The category that a name means: the name itself, a synonym, a plural, or the longest known ending
  /// ("oak writing desk" is a desk). Null if nothing matches.
  const Category* find(std::string_view name) const;
  /// Like find(), and a category without zones or gaps for names that mean nothing.
  const Category& get(std::string_view name) const;
  /// True if `name` means `kind` or one of its descendants.
  bool is_a(std::string_view name, std::string_view kind) const;
  bool is_any_of(std::string_view name, const std::vector<std::string>& kinds) const;
  const std::map<std::string, Category, std::less<>>& all() const { return categories_; }

 private:
  void resolve_references(const JsonReader& json);
  bool add_category(const KindRecord& record);
  void add_name(const std::string& name, const std::string& category);

  std::map<std::string, Category, std::less<>> categories_;
  std::map<std::string, std::string, std::less<>> names_;  ///< any spelling to the category's name
};

/// The floor that a zone of a placed object covers.
Footprint zone_footprint(const Footprint& object, const UseZone& zone);

}  // namespace roomgen
