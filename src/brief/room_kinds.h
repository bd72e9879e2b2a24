#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/scene/room.h"

namespace roomgen::brief {

struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// A word and how likely it is drawn.
using Weighted = std::vector<std::pair<std::string, double>>;

/// Something that a kind of room usually holds.
struct Piece {
  Weighted any;              ///< categories, one of which is drawn
  Weighted of;               ///< variants of size, one of which is drawn ("" is the usual one)
  std::optional<Vec3> size;  ///< instead of the category's
  int low = 1, high = 1;     ///< how many
  bool people = false;       ///< one for each person that the prompt speaks of
  int for_people = 0;        ///< so many people share one: a table for four; 0: their number means nothing for it
  double chance = 1.0;
  double weight = 1.0;              ///< among the extras
  double area = 0.0;                ///< only in rooms of at least so many square metres
  std::string each;                 ///< so many for each thing of this category
  bool shared = false;              ///< neighbours share: of several, each has one
  std::string needs;                ///< only with such a thing
  std::string serves;               ///< pointless when this category is excluded ("for")
  std::vector<std::string> unless;  ///< not beside any of these
  std::vector<Piece> then;          ///< what comes with it
};

struct WindowHabit {
  int low = 1, high = 1;
  Range width{1.2, 1.8};
  double sill = default_sill;
  double head = default_window_head;
};

/// A kind of room: size, openings and contents.
struct RoomKind {
  std::string type;
  std::vector<std::string> names;  ///< others than its type
  /// Names that mean the room only where the prompt begins with them: "a bar" may be a thing.
  std::vector<std::string> leading;
  /// Names that mean the room only where no other noun stands before: a post office is no office.
  std::vector<std::string> alone;
  /// What tells that a room of no name is of this kind; the first piece of its core unless told.
  std::optional<std::vector<std::string>> known_by;
  std::vector<std::string>
      purposes;  ///< who it is for, what is done there: such a room where none is named
  std::vector<std::string> instead_of;  ///< kinds that are this one for those people
  /// Kinds of things of which it has at least one, or is none of its kind; empty: nothing makes it
  /// what it is.
  std::vector<std::string> made_by;
  Range width, depth;
  double height = default_room_height;
  double smallest = 3.0;                   ///< least side of a room whose size is chosen
  Range share;                             ///< of the floor that furniture covers
  int objects_low = 8, objects_high = 12;  ///< on the floor
  WindowHabit windows;
  double door = 0.9;
  bool door_on_long_side = false;
  DoorSwing swing = DoorSwing::in;
  std::vector<std::string> floors, walls;
  std::map<std::string, std::string, std::less<>> means;  ///< what a word means in such a room
  std::vector<Piece> core, extras, details;
};

/// How a word of style changes a room.
struct Style {
  std::string adjective;  ///< for descriptions, may be empty
  std::vector<std::string> more, fewer;
  double fullness = 1.0;  ///< factor on the number of things
  double size = 1.0;      ///< factor on the sides of the room
  int windows = 0;        ///< more of them
};

struct Variant {
  std::optional<Vec3> size;
  Vec3 scale = Vec3::Ones();
};

struct Finish {
  std::vector<std::string> kinds, words;
};

/// data/rooms.json (docs/rooms.md).
struct RoomKinds {
  std::map<std::string, RoomKind, std::less<>> types;
  RoomKind any;  ///< for a type that is not known
  std::map<std::string, Variant, std::less<>> variants;
  std::vector<Finish> finishes;
  std::map<std::string, Style, std::less<>> styles;
  std::map<std::string, std::string, std::less<>> style_words;  ///< word to the name of a style

  const RoomKind& get(std::string_view type) const;
  const Style* style(std::string_view word) const;
};

Result<RoomKinds> parse_room_kinds(std::string_view text, const std::string& source);
/// Kinds of rooms by all their names, in words parted by single spaces.
using RoomNames = std::map<std::string, std::string, std::less<>>;
RoomNames room_names(const RoomKinds& kinds);
/// The same with those that mean a room only at the beginning of a prompt.
RoomNames all_room_names(const RoomKinds& kinds);
/// A name as it stands there: "Doctor's office" is "doctor office".
std::string room_name(std::string_view said);
/// The names of the rooms that a design is for: the first list of its file that is called "for".
std::vector<std::string> rooms_of_design(std::string_view text);
/// The knowledge compiled into the library, with the rooms of data/designs.
const Result<RoomKinds>& built_in_room_kinds();

}  // namespace roomgen::brief
