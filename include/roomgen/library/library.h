#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/scene/object.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// How the mesh of a door or window sits in a wall.
struct WallFit {
  double wall_front = 0.0;    ///< where the wall begins and ends, metres behind the mesh's front
  double wall_back = 0.0;
  std::vector<Vec2> outline;  ///< of the hole, as Opening::outline, seen from the front; empty: all
  int leaves = 0;             ///< that turn on hinges
  bool hinge_left = false;    ///< of a single leaf, seen from the front, towards which it opens

  bool operator==(const WallFit&) const = default;
};

/// What a catalogue knows about one mesh.
struct AssetInfo {
  AssetRef ref;
  std::string name;                    ///< "Double bed"
  std::string category;                ///< what it is, as kinds are named: "bed"
  std::vector<std::string> tags;
  std::string group;                   ///< the library's own category: "Bedroom"
  Vec3 size = Vec3::Ones();            ///< width, depth, height in metres
  Mount mount = Mount::floor;          ///< in a match: the one that the query asked for
  double elevation = 0.0;              ///< of the bottom above the floor, metres
  std::optional<double> support_height;  ///< of the surface that carries things; none: nothing on top
  bool has_front = true;
  bool round = false;                  ///< covers the ellipse inscribed in its rectangle
  std::vector<std::string> colors;     ///< names of its main colours, largest area first: "white"
  std::size_t triangles = 0;
  std::optional<WallFit> wall_fit;     ///< of doors and windows
  bool approximate = false;            ///< put together from words: nobody knows what it really is
  bool stand_in = false;               ///< a plain shape in place of what nobody has a model of
};

struct AssetQuery {
  std::string category = {};      ///< "desk": what the thing must be
  std::string description = {};   ///< "a white wooden desk": which of them is preferred
  std::optional<Vec3> size = {};  ///< wanted box, metres
  std::optional<Mount> mount = {};
  std::size_t limit = 10;
  /// Somebody named it: nothing that would do instead is an answer, and what contradicts the
  /// description comes after what can be made.
  bool asked = false;
  bool sized = false;  ///< the size was said too, and is not just what is usual
  bool made = false;   ///< only what is made from the words, and nothing in stock
};

/// What of a query an asset does not have.
enum class Contradiction {
  none,
  looks,  ///< its colour or its material
  form,   ///< its outline or a side that was said
};

struct AssetMatch {
  AssetInfo asset;
  double score = 0.0;  ///< in [0, 1], best first
  Contradiction contradicts = Contradiction::none;
};

/// A source of meshes.
class AssetLibrary {
 public:
  virtual ~AssetLibrary() = default;

  /// The assets that are what the query asks for, best first; empty when nothing fits, never something
  /// of another kind. Equal queries give equal answers.
  virtual Result<std::vector<AssetMatch>> search(const AssetQuery& query) const = 0;

  /// The mesh of an asset, in the frame of Model, its box exactly AssetInfo::size. Asked for what does not
  /// lean: load_model() sees to that.
  virtual Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const = 0;

  /// The asset of an asset_key(), with the looks that the key names; not_found where this library
  /// has none.
  virtual Result<AssetInfo> find(std::string_view key) const;
};

/// The mesh of an asset as a scene has it: leaning by its tilt.
Result<std::shared_ptr<const Model>> load_model(const AssetLibrary& library, const AssetRef& ref);

/// Several libraries as one: a search asks them in order and takes the answers of the first that
/// has any that does not contradict the query, so that a catalogue of real furniture goes before one
/// that builds what is asked for, and what is built before what looks otherwise than asked. Matches that
/// contradict are answers when there are no others. A failing search is an error; load() asks the libraries in order until one knows the asset.
std::unique_ptr<AssetLibrary> make_first_of(
    std::vector<std::shared_ptr<const AssetLibrary>> libraries);

/// Where else a mesh may come from, by asset_key(); null if not from there either.
using SpareModels = std::function<std::shared_ptr<const Model>(const std::string& key)>;

/// A stranger's scene of 5,000 things, each of another model, would take minutes and gigabytes.
struct ModelLimits {
  std::size_t models = 1000;                 ///< that differ
  std::size_t bytes = std::size_t{1} << 30;  ///< of their meshes and textures
};

/// The meshes of all objects and openings of a scene. An asset that neither the library has (any more)
/// nor `spare` is reported to `log`; its objects stay boxes, its openings keep the room's own woodwork.
/// So do those that come when the limits are reached, which is reported once.
ModelTable load_models(const Scene& scene, const AssetLibrary& library, const LogSink& log = {},
                       const SpareModels& spare = {}, const ModelLimits& limits = {});

}  // namespace roomgen
