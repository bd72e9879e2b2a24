#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/scene/room.h"

namespace roomgen {

/// A kind of door, window or passage: what prompts and files call it, and what it is like where
/// nobody says.
struct OpeningKind {
  std::string name;  ///< "double door"
  std::vector<std::string> names;
  OpeningType type = OpeningType::door;
  std::optional<double> width, sill, head;  ///< usual, metres; none: as the room's kind has it
  double least_width = 0.4;                 ///< a narrower one is none of this kind
  bool to_ceiling = false;                  ///< its head is just under the ceiling
  std::optional<DoorSwing> swing;           ///< none: as the room's kind has it
  int leaves = 1;
  bool glazed = false;
  std::vector<Vec2> outline;        ///< as Opening::outline
  std::vector<std::string> meshes;  ///< words for meshes of libraries that will do, the best first
};

/// data/openings.json (docs/openings.md). A kind has from the one that it "is" what it does not
/// say.
class OpeningKinds {
 public:
  static Result<OpeningKinds> parse(std::string_view text, const std::string& source);
  /// The kinds compiled into the library.
  static const Result<OpeningKinds>& built_in();

  /// Null if there is none of exactly this name, in singular or plural.
  const OpeningKind* find(std::string_view name) const;
  /// The kind of an opening: the one it names, else the plain one of its type. Null if the file
  /// lacks it.
  const OpeningKind* of(const Opening& opening) const;
  const std::map<std::string, OpeningKind, std::less<>>& all() const { return kinds_; }

 private:
  std::map<std::string, OpeningKind, std::less<>> kinds_;
  std::map<std::string, std::string, std::less<>> names_;  ///< any name to the kind's
};

/// The outline of a hole (Opening::outline) that a path of SVG draws in the unit square, y
/// downwards, as Sweet Home 3D's doorOrWindowCutOutShape has it: seen from the side where x runs to
/// the right. Empty when it is the whole square. Fails when it is no outline that a hole can have.
Result<std::vector<Vec2>> outline_of_cut_out(std::string_view path);

}  // namespace roomgen
