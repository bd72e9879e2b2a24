#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/polygon.h"
#include "roomgen/geometry/vec.h"

namespace roomgen {

/// What carries a thing; `surface` is the top of another thing.
enum class Mount { floor, wall, ceiling, surface };

std::string_view name(Mount mount);
/// Null if the text is none of floor, wall, ceiling, surface.
std::optional<Mount> parse_mount(std::string_view text);

/// How a thing fills its box and whether it has a front.
struct Traits {
  bool front = true;   ///< has a front side; without it any yaw is as good
  bool flat = false;   ///< a rug: other things stand on it
  bool round = false;  ///< covers the ellipse inscribed in its rectangle

  bool operator==(const Traits&) const = default;
};

enum class Side { front, back, left, right };

/// How far the direction of a side is turned from that of the front: counter-clockwise, radians.
double turn_of(Side side);

/// Floor beside an object that a person needs to use it: the whole length of one side of its box,
/// `depth` metres deep.
struct UseZone {
  Side side = Side::front;
  double depth = 0.6;
  std::vector<std::string> partners;  ///< categories that may stand in it (a chair at its desk)
  double inset = 0.0;  ///< metres of the side, from the back, that it leaves out: the head of a bed
  /// Of a bed: left and right mean its long sides, front and back of one wider than deep.
  bool lengthwise = false;
};

/// Of a table's edge, for each who sits there; metres (NKBA Kitchen & Bathroom Planning Guidelines).
inline constexpr double seat_width = 0.61;

/// The floor that a zone of a placed object covers.
Footprint zone_footprint(const Footprint& object, const UseZone& zone);

/// How far two things stand apart when they serve each other.
struct PreferredGap {
  std::string partner;  ///< a kind
  double low = 0.0;
  double high = 0.0;    ///< metres between footprints
};

/// The lamp in a kind of thing.
struct Lamp {
  double candela = 60.0;  ///< luminous intensity, the same in all directions within the cone
  double height = 0.8;    ///< of the light in parts of the thing's height; 0: just under the thing
  double cone = 0.0;      ///< degrees from straight down to the edge of its light; 0: all directions
};

/// Kinds of the same sort of thing for other places, by name; empty: there is none.
struct Forms {
  std::string small;    ///< stands on other things: a table lamp
  std::string wall;     ///< hangs on a wall: a wall lamp
  std::string ceiling;  ///< hangs from the ceiling: a pendant lamp
  std::string round;    ///< a round table
};

/// What is known about a kind of thing (docs/kinds.md). What an entry does not say of size, mount and
/// use, its parent says ("is": dining chair is chair is seat).
struct Kind {
  std::string name;    ///< "dining chair"
  std::string parent;  ///< may be empty
  std::vector<std::string> names;  ///< other names: "dinner chair"
  /// Other names among furniture only: a "screen" is a room divider in a list of what a room holds, and
  /// part of many things in a description of one.
  std::vector<std::string> loose_names;
  /// Loose names of what it only looks like: who asks for a harp gets a guitar, and nothing shows that it is a harp.
  std::vector<std::string> resembles;
  std::vector<std::string> lineage;  ///< itself and its ancestors; empty for an unknown kind

  Vec3 size{0.6, 0.6, 0.9};  ///< usual width, depth, height
  Mount mount = Mount::floor;
  std::vector<Mount> also;   ///< other ways to put it up (a television on the wall)
  double elevation = 0.0;    ///< usual height of the bottom above the floor, for Mount::wall
  Traits traits;
  /// The side that people say it faces with, where its user looks: who sits at a desk's front looks
  /// over it; a screen and a mirror look at those before them.
  Side faces = Side::front;
  bool supports = false;       ///< its top carries things
  /// Metres across that what stands of it takes of the floor, where the rest hangs above people's heads: a
  /// parasol's foot; 0: all of it stands.
  double foot = 0.0;
  bool covers_window = false;  ///< hangs before a window and is made to its measure: a curtain
  std::vector<UseZone> zones;  ///< usable when one is free and reachable; none: always usable
  std::vector<PreferredGap> gaps;
  std::vector<std::string> tucks_under;  ///< kinds it may slide under (a chair, a table)
  std::optional<Lamp> lamp;              ///< things of this kind shine
  Forms forms;

  bool variant = false;    ///< plans and scenes call it by its parent: an armoire is a wardrobe there
  std::string stocked_as;  ///< the kind as which libraries hold it: itself, or a variant's parent, unless said
  std::string built_as;    ///< the kind of data/shapes/kinds that is built for it: itself unless said
  std::string serves;      ///< who asks for that kind is served by this one: the parent unless said
  bool usual = false;      ///< what people mean when they say the name of the kind that it serves
  std::map<std::string, double> substitutes;  ///< kinds that will do, and how well, in (0, 1)

  /// How many steps more special than its names a word may be in WordNet and still mean the kind.
  int hyponyms = 2;
  /// Senses of WordNet ("machine.n.1"): the kind is a plain stand-in for all such things that no other kind
  /// is; empty for others.
  std::vector<std::string> stands_for;
  bool is_stand_in() const { return !stands_for.empty(); }
};

/// Is the kind the one of this name, or a descendant of it?
bool is_of(const Kind& kind, std::string_view name);
/// Is the kind one of these, or a descendant of one?
bool is_any_of(const Kind& kind, const std::vector<std::string>& kinds);

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
  /// longest known ending after a blank, no mere likeness ("oak writing desk"). Never a variant; or
  /// null.
  const Kind* find(std::string_view name) const;
  /// Like find(); for other names the stand-in for such things, or a kind without zones or gaps.
  const Kind& get(std::string_view name) const;
  /// The kind of exactly this name, singular or plural, variants and loose names included; or null.
  const Kind* named(std::string_view name) const;
  /// The kind of this very name, as other kinds refer to it; or null.
  const Kind* by_name(std::string_view name) const;
  /// Like named(), but by no loose name.
  const Kind* called(std::string_view name) const;
  /// Whether the kind of this name only looks like what is called so (Kind::resembles).
  bool only_resembles(std::string_view name) const;
  /// The planned kind of a name as the data spell it, in lower case: "lamps" means nothing.
  const Kind* spelled(std::string_view name) const;
  /// The kind as which plans and scenes know this one: itself unless it is a variant.
  const Kind& planned(const Kind& kind) const;

  /// The stand-in for what lies below that synset of WordNet; or null.
  const Kind* stand_in(std::uint32_t synset) const;

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
    bool resembling = false;
  };
  class Reader;

  void index_names();
  void add_name(const std::string& spelling, const Name& name);
  const Name* look_up(std::string_view name) const;

  std::map<std::string, Kind, std::less<>> kinds_;
  std::map<std::string, Name, std::less<>> names_;  ///< by any spelling
  std::map<std::uint32_t, std::string> stand_ins_;  ///< by synset
};

}  // namespace roomgen
