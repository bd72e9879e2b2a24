#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/geometry/model.h"
#include "roomgen/geometry/polygon.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// How to look at a room. The picture's longer side is `pixels` long.
struct View {
  enum class Kind {
    top,        ///< orthographic from above, walls cut at 1.2 m, ceiling off, +Y up the page
    isometric,  ///< from a corner, the walls towards the viewer left out
    eye,  ///< as a standing person sees it: from a door or a corner, ceiling on, lamps and sun lit
    /// A drawing of the walls side by side, each as seen from inside: openings, what stands before
    /// them and what hangs on them, with a grid in metres: up from the floor, and along the wall in
    /// the room's own coordinate where the wall runs along an axis, else from its first corner.
    elevation,
  };
  Kind kind = Kind::top;
  int pixels = 1024;
  /// Top only (set-of-mark): coordinate grid, axes, ids and fronts, what must stay free, sills and
  /// heads of windows. Kinds of many things are named briefly ("c3"), with a legend; in a crowded
  /// room what stands on others or hangs has no name.
  bool marks = false;
  bool paper_frame = false; ///< marks count x' = ymax - y down and y' = xmax - x to the left
  std::vector<Bounds2> free_floor = {};  ///< with marks: parts of the floor to be shaded as free
  /// With marks: where the thing goes that the picture is to help with. What hangs shows as a
  /// dashed outline when the question is about what stands, and is drawn when it is about what
  /// hangs. Without a question it is an outline where something is below it.
  std::optional<Mount> asked = {};
  std::vector<Object> refused = {};  ///< with marks: things where they found no room, dashed in red
  std::vector<std::string> in_the_way = {};  ///< with marks: ids of what is to be outlined in red
  /// Top only: this part of the room alone, with finer marks in the scene's own coordinates.
  std::optional<Bounds2> part = {};
};

/// A camera with parallel rays, or with an eye that all rays meet in (a pinhole). Its axes are unit vectors in
/// room coordinates; `backward` points from the scene to the viewer. Pixels count from the top left corner of
/// the picture: the middle of the first one is at (0.5, 0.5).
struct Camera {
  int width = 0, height = 0;  ///< pixels
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY(), backward = Vec3::UnitZ();
  Vec2 center = Vec2::Zero();  ///< of the picture, metres along right and up (with an eye: in the plane
                               ///< 1 m before it, from the point that it looks at)
  double pixels_per_metre = 100.0;  ///< with an eye: of what is 1 m before it, the focal length in pixels
  double near = 0.0, far = 0.0;  ///< the scene lies within, metres along backward; near > far
  std::optional<Vec3> eye = std::nullopt;

  /// Of a point before the eye, if there is one.
  Vec2 pixel(const Vec3& point) const;
  /// Metres along `backward`.
  double depth(const Vec3& point) const { return backward.dot(point); }
  /// Where it is: the eye; with parallel rays the middle of the picture in the near plane.
  Vec3 origin() const;
  /// Metres from the origin along the axis, which is not along the ray.
  double distance(const Vec3& point) const { return depth(origin()) - depth(point); }
};

/// The camera of a view: from above fitted to the room with its walls and to the objects; at eye level
/// before a door or in a corner, wherever it sees most, with upright verticals. Fails if `pixels` is out of
/// bounds or the room has no extent.
Result<Camera> make_camera(const Scene& scene, const View& view);
/// A camera in `eye` that looks at `target`, with the horizon level; `angle` is what it sees from side to side,
/// radians. Fails if the picture's size or the angle is out of bounds or the two points are one.
Result<Camera> pinhole_camera(const Vec3& eye, const Vec3& target, double angle, int width, int height);

struct NamedCamera {
  std::string name;  ///< of letters, digits, - and _
  Camera camera;
};
/// A list of pinhole cameras: cameras.json (docs/layers.md). Reports the first problem with its JSON pointer.
Result<std::vector<NamedCamera>> cameras_from_json(const Json& json, const std::string& source);

/// What layers are made of.
struct Shot {
  Camera camera;
  View::Kind kind = View::Kind::eye;  ///< what walls, ceiling and lamps are shown is as for this view
  bool color = true;   ///< the picture too
  bool alone = false;  ///< count what each thing would show with nothing else in the picture
};

/// Something that a pixel may show: an object, or a part of a room.
struct LayerThing {
  std::string id;        ///< "bed-0", "floor", "wall-2", "door-0"; of a dwelling's room "bedroom-0/wall-2"
  std::string category;  ///< "bed", "floor", "wall", "ceiling", "door", "window", "passage"
  std::uint16_t category_id = 0;
  std::size_t pixels = 0;        ///< that show it
  std::size_t pixels_alone = 0;  ///< that would if nothing hid it; 0 unless counted
};

/// A picture taken apart: what the middle of each pixel shows, row by row from the top. Glass and curtains hide
/// what is behind them here; holes in foliage and the like do not. The floor's and the walls' numbers, those of all
/// objects and of all categories do not depend on the camera.
struct Layers {
  Camera camera;
  View::Kind kind = View::Kind::eye;
  Image color;                           ///< empty unless asked for
  std::vector<float> depths;             ///< Camera::distance() in metres; infinity where nothing is
  std::vector<Eigen::Vector3f> normals;  ///< unit, of the triangle, in room axes, towards the viewer; or zero
  std::vector<std::uint16_t> objects;    ///< k shows things[k - 1]; 0 is nothing
  std::vector<std::uint16_t> categories; ///< the category_id of that; 0 is nothing
  std::vector<LayerThing> things;        ///< all of the scene, seen or not: objects first, in their order
};

/// Pixels of a camera's picture.
struct Visibility {
  std::size_t pixels = 0;        ///< that show an object
  std::size_t pixels_alone = 0;  ///< that would with nothing else in the picture
};

/// Things side by side, each alone, for who chooses among them: a row is drawn at one scale.
struct ContactSheet {
  struct Thing {
    Object object;  ///< its asset and size count, and its yaw, a half turn or none
    std::string label, caption;
  };
  struct Row {
    std::string title;
    std::vector<Thing> things;
  };
  std::vector<Row> rows;
  int pixels = 1024;  ///< wide
  double most_row = 260.0;  ///< a row's height at most, pixels
};

/// Draws a scene.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// Equal arguments give equal pixels. Objects without a model are drawn as boxes.
  virtual Result<Image> render(const Scene& scene, const ModelTable& models, const View& view) = 0;
  /// The same of what each pixel shows.
  virtual Result<Layers> layers(const Scene& scene, const ModelTable& models, const Shot& shot) = 0;
  /// What layers() counts of scene.objects[object], without the layers: only what may hide it is drawn. An object with
  /// less than `least_alone` pixels alone is of no interest: its `pixels` are not counted and are 0.
  virtual Result<Visibility> visibility(const Scene& scene, const ModelTable& models, const Camera& camera,
                                        std::size_t object, std::size_t least_alone) = 0;
  /// Things from their front quarter on plain ground, under their labels. Equal arguments give
  /// equal pixels.
  virtual Result<Image> sheet(const ContactSheet& sheet, const ModelTable& models) = 0;
};

/// Does the place lie in a room, or where a door or passage goes through a wall? A camera elsewhere is in a wall or
/// outdoors, and its pictures are of no use.
bool is_indoors(const Scene& scene, const Vec2& place);

}  // namespace roomgen
