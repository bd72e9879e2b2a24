#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "opening_wish.h"
#include "outline.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/scene/object.h"
#include "roomgen/scene/relation.h"
#include "roomgen/scene/room.h"

namespace roomgen::design {

/// "next to the bed": a relation of a mention to another one or to a part of the room.
struct Demand {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  RelationKind kind = RelationKind::near;
  std::size_t mention = none;  ///< index into Brief::mentions
  std::string part;            ///< "window-0", "wall-2", "corner"; empty for edge and middle
  bool flank = false;          ///< left and right of the target in turn
  bool shared = false;         ///< with other mentions: each takes a side
  int nth = -1;                ///< which of the mention's things; -1: in turn
  bool listed = false;         ///< said of another thing of the same list
};

/// Things of one kind that the prompt names.
struct Mention {
  std::string category;     ///< of the table, or the prompt's own word if the table lacks it
  bool known = true;        ///< in the table
  std::string noun;         ///< the name that it has there: "desk"
  std::string description;  ///< "white wooden desk"
  std::vector<std::string> looks;  ///< of it: "white", "wooden"
  int quantity = 1;
  bool counted = false;      ///< the prompt gives the number
  bool open = false;         ///< a plural without a number
  bool varied = false;       ///< they shall differ
  bool contradicts = false;  ///< another number of the same things was asked for before: not planned
  bool sized = false;        ///< the prompt says something about its size
  Vec3 size = Vec3::Ones();  ///< wanted
  Mount mount = Mount::floor;
  std::vector<Demand> demands;
  int sentence = 0;  ///< of the prompt in which it is named first
};

/// What a prompt says, no more.
struct Brief {
  std::string type;  ///< "bedroom", or words that no room kind is known by
  bool type_known = false;
  std::optional<Vec2> size;    ///< width and depth, metres
  std::optional<double> area;  ///< square metres
  SaidShape shape;             ///< of the floor
  int people = 0;              ///< 0: not said
  std::optional<int> windows;  ///< how many, apart from those of `openings`
  bool wide_windows = false;
  RoomMaterials materials;  ///< what it says about them
  std::vector<OpeningWish> openings;  ///< of which more is said than how many windows there are
  std::vector<Mention> mentions;
  bool bare = false;                  ///< nothing but what is mentioned
  std::vector<std::string> excluded;  ///< categories
  std::vector<std::string> styles;    ///< words of style, as data/rooms.json knows them
  std::vector<std::string> notes;     ///< what was not understood or was bounded
};

}  // namespace roomgen::design
