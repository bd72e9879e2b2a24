#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/shape/primitives.h"

/// A shape program: a piece of furniture as named parts, each a solid with a place, written in JSON
/// (docs/shapes.md, docs/shape.schema.json). Here it is concrete: numbers only. Recipes, below,
/// makes one from a document with parameters, shape/evaluate.h makes meshes of it.
namespace roomgen::shape {

inline constexpr std::size_t max_components = 4096;  ///< copies counted
inline constexpr double least_length = 0.0002, greatest_length = 20.0;

/// What a sweep's section can be, beside an outline: a disc of a radius, a rectangle with rounded
/// corners.
struct Disc {
  double radius = 0.01;

  bool operator==(const Disc&) const = default;
};
struct Rectangle {
  Vec2 size = Vec2::Ones();
  double bevel = 0.0;

  bool operator==(const Rectangle&) const = default;
};

/// A Sweep as it is written.
struct SweptPart {
  Curve<Vec3> path;
  std::variant<Disc, Rectangle, Curve<Vec2>> section;
  double taper = 1.0, twist = 0.0;  ///< radians

  bool operator==(const SweptPart&) const = default;
};

/// A level's outline by its size: `round` 0 is a rectangle, 1 an ellipse, superellipses between.
struct RoundedSize {
  Vec2 size = Vec2::Ones();
  double round = 0.0;

  bool operator==(const RoundedSize&) const = default;
};

/// A Loft as it is written.
struct LoftedPart {
  struct Level {
    double z = 0.0;
    std::variant<RoundedSize, Curve<Vec2>> outline;

    bool operator==(const Level&) const = default;
  };
  std::vector<Level> levels;
  bool straight = false;

  bool operator==(const LoftedPart&) const = default;
};

/// A HeightField whose height is an expression in u and v.
struct HeightPart {
  Vec2 size = Vec2::Ones();
  std::string height = "0.1";
  int divisions = 24;
  double least = 0.002, most = 5.0;

  bool operator==(const HeightPart&) const = default;
};

/// A slab upright in the XZ plane, standing on z = 0; its front (-Y) carries a painted picture.
struct PicturePart {
  Vec2 size = Vec2::Ones();
  double thickness = 0.02;
  std::string theme = "plain";  ///< one of picture_themes(); empty: the drawing
  std::uint64_t seed = 0;
  std::string drawing = {};  ///< its JSON (docs/shapes.md, Drawings), numbers only

  bool operator==(const PicturePart&) const = default;
};

/// Words upright in the XZ plane, half of their height above z = 0, drawn by one pen: tubes of a
/// radius, or flat letters of a pen's width that are as thick as `depth`.
struct TextPart {
  std::string words;
  std::string align = "center";  ///< left, center, right: where x = 0 is
  double height = 0.1;           ///< of a capital, between the middles of its strokes
  Vec2 fit = Vec2::Zero();       ///< they are smaller where they were wider or higher; 0: any
  double radius = 0.0;           ///< of tubes; 0: flat letters
  double width = 0.016, depth = 0.01;

  bool operator==(const TextPart&) const = default;
};

struct Component;

struct Group {
  std::vector<Component> components;
};

using Solid = std::variant<Box, Frustum, Ellipsoid, Prism, Plane, Lathe, SweptPart, Extrusion,
                           LoftedPart, HeightPart, Leaf, Cushion, PicturePart, TextPart, Group>;

/// The part of the solid that the normal points away from stays. In the component's own frame,
/// before its transform.
struct Cut {
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();

  bool operator==(const Cut&) const = default;
};
/// The rest act in the parent's frame, after the transform, in their order, on all copies so far.
struct Mirror {
  int axis = 0;  ///< 0: x becomes -x, 1: y becomes -y; what was there stays
};
struct Array {
  int count = 1;
  Vec3 step = Vec3::Zero();
};
/// About a vertical axis. A whole turn is divided evenly; otherwise the last copy is at `angle`.
struct Radial {
  int count = 1;
  Vec2 center = Vec2::Zero();
  double angle = 2 * pi, start = 0.0;
};
/// The centre of everything's box to 0 along these axes.
struct Center {
  bool x = false, y = false, z = false;
};
/// The lowest point of everything to z = 0.
struct Ground {};
/// All copies count as one body; those made later are copies of the whole.
struct Join {};
using Operation = std::variant<Cut, Mirror, Array, Radial, Center, Ground, Join>;

struct Component {
  std::string name;      ///< unique among its siblings: letters, digits, - and _
  std::string label;     ///< what part it is ("leg"); may be empty
  std::string material;  ///< a name in Program::materials; empty: the enclosing group's
  Solid solid;
  std::vector<Operation> operations;
  Vec3 scale = Vec3::Ones();   ///< first
  Vec3 rotate = Vec3::Zero();  ///< then about X, then Y, then Z of the parent, radians
  Vec3 at = Vec3::Zero();      ///< then moved
};

/// A surface as it is written. Colours are texts: "#rrggbb" or a name (docs/shapes.md).
struct Surface {
  std::string name;
  std::string color = "#cccccc";
  double roughness = 0.7, metalness = 0.0, opacity = 1.0;
  std::string pattern = "none";
  std::string second;  ///< the pattern's other colour; empty: a darker one
  double scale = 1.0;  ///< of the pattern
  double glow = 0.0;   ///< 0 to 1: how much of its colour it shows without any light
};

struct Program {
  std::string name, about;
  std::vector<Surface> materials;
  std::vector<Component> components;
  /// Names or labels of components that must touch; the second may be "floor" or "wall". Parts of a
  /// group are named "group.part".
  std::vector<std::pair<std::string, std::string>> connections;
  /// What the recipe that it was made by was told where it offers a choice: "leg_style": "pedestal". Not written.
  std::map<std::string, std::string> ways = {};
};

/// The patterns of surfaces and the themes of pictures.
std::vector<std::string> pattern_names();
std::vector<std::string> picture_themes();
/// What drawings may `use` (data/motifs.json), sorted.
std::vector<std::string> motif_names();

/// Reads a concrete program: expressions, `when`, `use` and `parameters` are errors that say so.
/// `source` names the document in messages, which give the JSON pointer.
Result<Program> read_program(const Json& json, const std::string& source);

/// Numbers are rounded to a micrometre (a millionth of a degree). Writing what was read from a
/// written program gives the same bytes.
Json write_program(const Program& program);

/// Solids after all copies were made, groups' parts each by themselves.
std::size_t component_count(const std::vector<Component>& components);

/// Does a name of `connections` mean the body or component of this path ("drawer-2.handle") or
/// label? A name means the part itself, all its copies and all that is in it.
bool refers_to(std::string_view reference, std::string_view path, std::string_view label);

// Shape programs with parameters (docs/shapes.md). A concrete program is a recipe without any.

inline constexpr std::size_t max_program_bytes = 1u << 20;
inline constexpr int max_use_depth = 8;

/// What an expression, a parameter or a let can be: a number or a word.
using Value = std::variant<double, std::string>;
using Values = std::map<std::string, Value, std::less<>>;

/// As people write it: 0.4, round.
std::string to_text(const Value& value);

struct Parameter {
  std::string name, about;
  Value value = 0.0;  ///< unless told otherwise
  double min = 0.0, max = 0.0;
  bool integer = false;
  bool color = false;                ///< any colour
  bool text = false;                 ///< any words of at most 240 bytes
  std::vector<std::string> choices;  ///< of a word
};

/// Finds a recipe by the name that `use` gives.
using RecipeSource = std::function<Result<Json>(const std::string& name)>;

/// JSON of at most max_program_bytes.
Result<Json> parse_recipe(std::string_view text, const std::string& source);
Result<Json> read_recipe(const std::filesystem::path& path);
/// Recipes of a folder: "leg" is leg.json in it.
RecipeSource recipes_in(const std::filesystem::path& folder);

/// `source` names the document in messages, here and below.
Result<std::vector<Parameter>> describe_parameters(const Json& recipe,
                                                   const std::string& source = "recipe");

/// A value of `text` for the parameter: a number, or a word.
Value parameter_value(const Parameter& parameter, const std::string& text);

/// The nearest values that the parameters allow: numbers moved into their range and made whole, a
/// word that is no choice replaced by the default; what no parameter is called is dropped.
Values clamped(const std::vector<Parameter>& parameters, const Values& values);

/// The concrete program for these values; parameters without one have their default. Equal
/// arguments give equal programs. A value out of range is an error that names the range.
///
/// What is used becomes a group of the component's name; its connections come along. Its seed
/// follows from the seed and that name.
Result<Program> instantiate(const Json& recipe, const Values& parameters = {},
                            std::uint64_t seed = 0, const RecipeSource& lookup = nullptr,
                            const std::string& source = "recipe");

}  // namespace roomgen::shape
