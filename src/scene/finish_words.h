#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/texture.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/room.h"

namespace roomgen {

using Tone = Eigen::Vector3f;  ///< sRGB, 0 to 255

enum class RoomPart { floor, walls, ceiling };

/// What a floor, a wall or a ceiling may be made of.
struct Surface {
  std::string name;                       ///< "boards"
  std::optional<TexturePattern> pattern;  ///< none: one plain tone
  Tone tone = Tone::Constant(200);        ///< unless words say another one
  Tone second = Tone::Constant(160);      ///< of the pattern's other half, or its joints
  double roughness = 0.9;
  std::map<RoomPart, std::string> instead;  ///< what it becomes on parts that do not wear it
  std::string alternating;  ///< the surface that it is in two colours; empty: it is in the first
};

/// A stuff that is named for both its tone and its surface: oak is boards.
struct Substance {
  Tone tone = Tone::Zero();
  std::string surface;
};

/// "dark", "pale": a tone on its way to another one.
struct Shade {
  Tone towards = Tone::Zero();
  double by = 0.0;
};

/// What a part of a room has when no words say it.
struct UsualFinish {
  std::vector<std::string> rooms;  ///< words of the room's type, of which one must occur; none: any
  std::string surface;
  std::optional<Tone> tone;
};

/// The words of data/materials.json (docs/materials.md).
struct FinishWords {
  template <typename T>
  using Words = std::map<std::string, T, std::less<>>;

  Words<Surface> surfaces;
  Words<std::string> surface_names;  ///< one word or several, to the name of a surface
  std::set<std::string, std::less<>> likenesses;  ///< of them those that the surface does not show
  Words<Substance> substances;
  Words<Tone> basic_colors;  ///< "green", which says less than "sage"
  Words<Tone> colors;
  Words<Tone> further_colors;  ///< "lightsteelblue": written, hardly said
  Words<Shade> shades;
  Words<Sky> skies;
  Words<double> levels;   ///< how bright, lux
  Words<double> warmths;  ///< of lamps, kelvin
  Words<Lighting> moods;  ///< "candlelit", "evening": what a wish says of the light
  std::set<std::string, std::less<>> fillers;  ///< may stand among the others, and change nothing
  Words<RoomPart> parts;                       ///< "floors"
  Words<RoomPart> alone;  ///< "hardwood", "exposed brick": name their part of the room themselves
  std::map<RoomPart, std::vector<UsualFinish>> usual;

  /// The longest phrase of light among words from `at` on, and of how many words it is; or null.
  const Lighting* mood_at(const std::vector<std::string>& words, std::size_t at,
                          std::size_t& length) const;
  /// Says the word what something is made of? Fillers and parts of the room do not.
  bool describes(std::string_view word) const;
};

/// Every surface that is referred to exists, and every part of a room has a usual finish for any
/// room.
Result<FinishWords> parse_finish_words(std::string_view text, const std::string& source);
/// The words compiled into the library.
const FinishWords& finish_words();

}  // namespace roomgen
