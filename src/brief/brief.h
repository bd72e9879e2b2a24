#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "formation.h"
#include "limits.h"
#include "opening_wish.h"
#include "outline.h"
#include "language/parse.h"
#include "roomgen/geometry/vec.h"
#include "roomgen/scene/requirement.h"
#include "roomgen/scene/object.h"
#include "roomgen/scene/relation.h"
#include "roomgen/scene/room.h"

namespace roomgen::brief {

/// Words of a prompt and what they were taken for.
struct HeardWords {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  language::Run tokens;
  Heard::As as = Heard::As::thing;
  std::string word;  ///< of an attribute the look, of an absence the category, of a room what of it
};

/// The part of the room that is each of its walls.
inline constexpr const char* each_wall = "walls";

/// "next to the bed": a relation of a mention to another one or to a part of the room.
struct Demand {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  RelationKind kind = RelationKind::near;
  std::size_t mention = none;  ///< index into Brief::mentions
  std::string part;            ///< "window-0", "wall-2", "wall" (the nearest), "walls" (each), "corner"; empty for edge and middle
  bool flank = false;          ///< left and right of the target in turn
  bool shared = false;         ///< with other mentions: each takes a side
  int nth = -1;                ///< which of the mention's things; -1: in turn
  bool listed = false;         ///< said of another thing of the same list
  std::size_t heard = HeardWords::none;  ///< of Brief::heard: the words that say it
  std::optional<RelationKind> said = {};  ///< what was asked for, where this is only the next best: the clause is that
  std::size_t said_of = none;             ///< the mention that it was asked of, where this is of no other
  bool is_means = false;                  ///< only serves another demand: no clause of its own
  Gap gap = {};                           ///< of RelationKind::gap
};

/// The word of what is heard as a length of a thing.
inline constexpr const char* said_length = "length";
/// The word of what is heard as a limit: "nothing else".
inline constexpr const char* said_limit = "limit";

/// "1.6 m wide", of a thing.
struct SaidLength {
  std::string side;  ///< width, depth, height, diameter; longer side where it is not said which
  double metres = 0.0;
  language::Measure::Limit limit = language::Measure::Limit::exact;
};

/// Things of one kind that the prompt names.
struct Mention {
  std::string category;     ///< of the table, or the prompt's own word if the table lacks it
  bool known = true;        ///< in the table
  std::string noun;         ///< the name that it has there: "desk"
  std::string description;  ///< "white wooden desk"
  std::vector<std::string> looks;  ///< of it: "white", "wooden"
  std::vector<std::string> naming;  ///< of the looks those that say what sort of thing it is: "coffee" of a grinder
  int quantity = 1;
  bool counted = false;      ///< the prompt gives the number
  bool at_least = false;     ///< "at least five": more are as good
  bool at_most = false;      ///< "no more than two"
  int least = 0, most = 0;   ///< "8 to 12", "about a dozen"; 0: no range. The quantity is between both
  bool open = false;         ///< a plural without a number
  int joined_to = 0;         ///< "eight desks and lamps": the number of what a plural without one is joined to; 0: none
  std::int32_t list = language::none;  ///< of the parse: where it is named among others
  bool varied = false;       ///< they shall differ
  bool contradicts = false;  ///< another number of the same things was asked for before: not planned
  int seats = 0;             ///< "a six-seater table", "tables for two"; 0: not said
  bool sized = false;        ///< the prompt says something about its size
  Vec3 size = Vec3::Ones();  ///< wanted
  Mount mount = Mount::floor;
  std::size_t mount_heard = HeardWords::none;  ///< of Brief::heard: "on the wall"
  std::vector<Demand> demands;
  int sentence = 0;  ///< of the prompt in which it is named first
  std::size_t part_of = Demand::none;  ///< the mention of which these are some: index into Brief::mentions
  std::vector<std::string> parts;  ///< what it has: "drawers", "a glass top"
  std::vector<SaidLength> lengths;
  std::optional<Formation> formation = {};
  std::size_t formation_heard = HeardWords::none;  ///< of Brief::heard
  Requirement::Source source = Requirement::Source::prompt;
  std::string owner;   ///< "teacher" of the teacher's desk: whose it is, and nobody else's
  std::vector<std::size_t> heard;  ///< of Brief::heard: what names, counts and describes it
};

/// A room is furnished for at most so many.
inline constexpr int most_people = 100;

/// What a prompt says, no more.
struct Brief {
  std::string type;  ///< "bedroom", or words that no room kind is known by
  bool type_known = false;
  bool type_inferred = false;  ///< by WordNet: the prompt's word is no name of the kind
  bool type_guessed = false;   ///< by its things and what is done there: the prompt names none
  std::optional<Vec2> size;    ///< width and depth, metres
  std::optional<double> area;  ///< square metres
  std::optional<double> height;  ///< of the ceiling, metres
  SaidShape shape;             ///< of the floor
  int people = 0;              ///< 0: not said
  int seated = 0;             ///< of the people those for whom such a room has seats
  std::optional<int> windows;  ///< how many, apart from those of `openings`
  bool wide_windows = false;
  bool told_from_door = false;  ///< sides of the room are those that who comes in sees: "the back wall"
  RoomMaterials materials;  ///< what it says about them
  std::vector<OpeningWish> openings;  ///< of which more is said than how many windows there are
  std::vector<Mention> mentions;
  bool bare = false;                  ///< nothing but what is mentioned
  std::vector<SharedOut> shared_out;
  std::vector<Limit> limits;
  std::vector<Denial> denials;
  std::vector<std::string> excluded;  ///< categories
  std::vector<std::pair<std::string, std::string>> excluded_looks;  ///< categories that are so: table, glass; no category: any
  std::vector<std::string> palette;   ///< colours and stuffs that are said of no thing
  std::vector<std::string> styles;    ///< words of style, as data/rooms.json knows them
  std::vector<std::string> notes;     ///< what was not understood or was bounded
  std::vector<HeardWords> heard;      ///< in no order
  bool understood = false;            ///< some word means a room, a thing or what it is like
  std::vector<language::Token> tokens;  ///< of the prompt
};

/// The words of the prompt, in lower case.
std::string words_of(const Brief& brief);

/// Adds words to what was heard; which of Brief::heard they are.
std::size_t hear(Brief& brief, const language::Run& tokens, Heard::As as, std::string word = "");

}  // namespace roomgen::brief
