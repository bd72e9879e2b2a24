#include "roomgen/render/pictures.h"

#include <list>
#include <nlohmann/json.hpp>

#include "gl_context.h"
#include "overlay.h"
#include "picture.h"
#include "roomgen/base/json.h"
#include "scene/lights.h"
#include "scene/room_shell.h"
#include "shadow_map.h"

namespace roomgen {

namespace {

using namespace detail;

constexpr double shadow_width = 0.03;  // metres, of a shadow's soft edge
constexpr std::size_t kept_frames = 2;
const Eigen::Vector3f plan_wall_color(74, 76, 82), wall_top_color(214, 209, 200);
// Under marks: planks and shadows look like lines and furniture to who reads the picture.
const Eigen::Vector3f marked_floor_color(226, 223, 216);

bool is_marked(const View& view) { return view.marks && view.kind == View::Kind::top; }

// Everything a picture depends on but the objects.
std::string frame_key(const Scene& scene, const View& view, const Camera& camera) {
  Json key;
  for (const auto& room : rooms_of(scene)) key["rooms"].push_back(to_json(room));
  for (const double value : {camera.center.x(), camera.center.y(), camera.pixels_per_metre,
                             camera.near, camera.far, camera.backward.x(), camera.backward.y()})
    key["camera"].push_back(value);
  if (camera.eye)
    for (int axis = 0; axis < 3; ++axis) key["eye"].push_back((*camera.eye)[axis]);
  key["kind"] = static_cast<int>(view.kind);
  key["marks"] = is_marked(view);
  key["size"] = {camera.width, camera.height};
  return key.dump();
}

std::shared_ptr<const Model> shell_model(std::span<const Room> rooms, const ModelTable& models, const View& view,
                                         const Camera& camera) {
  const bool plan = view.kind == View::Kind::top;
  ShellOptions options;
  options.top_color = plan ? plan_wall_color : wall_top_color;
  if (is_marked(view)) options.floor_color = marked_floor_color;
  options.door_leaves = !plan;  // drawn open, as a symbol
  options.ceiling = view.kind == View::Kind::eye;
  auto merged = std::make_shared<Model>();
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    options.wall_heights = wall_heights(rooms, i, view, camera);
    for (auto& part : room_shell(rooms, i, options, models)) {
      const int first = static_cast<int>(merged->materials.size());
      for (auto& piece : part.model.parts)
        merged->parts.push_back({std::move(piece.mesh), piece.material + first});
      for (auto& material : part.model.materials) merged->materials.push_back(std::move(material));
    }
  }
  return merged;
}

// A finished picture, without marks, and what was in it.
struct Frame {
  std::string key;
  DrawList items;
  Sun sun;
  Image image;
};

Sun sun_of(std::span<const Room> rooms, const View& view, const Camera& camera) {
  std::vector<Vec3> points;
  for (const auto& room : rooms)
    for (const auto& p : offset_outward(room.polygon, wall_thickness))
      for (const double z : {-floor_thickness, room.height}) points.push_back({p.x(), p.y(), z});
  if (view.kind != View::Kind::eye) return make_sun(sun_direction(camera, view.kind), points);
  // Without a window the ceiling keeps it out.
  const auto sun = sunlight(rooms[0]);
  return make_sun(sun ? sun->to_sun : Vec3(0.0, 0.0, 1.0), points);
}

// How far the soft edge of a shadow may lie beside the shadow of a point.
int shadow_margin(const Camera& camera, const Sun& sun) {
  const double metres = 2.0 * shadow_width + 3.0 * ShadowMap::texel(sun);
  return static_cast<int>(std::ceil(metres * camera.pixels_per_metre)) + 2;
}

// The pixels that change when something in this box comes or goes: the box, its shadow, and around.
PixelRect touched_pixels(const Camera& camera, const Sun& sun, const Bounds3& box) {
  // Lamps reach everywhere.
  if (camera.eye) return {0, 0, camera.width, camera.height};
  Bounds3 lit = box;
  for (int corner = 0; corner < 4; ++corner) {
    const Vec3 p(corner & 1 ? box.high.x() : box.low.x(), corner & 2 ? box.high.y() : box.low.y(),
                 box.high.z());
    lit.add(p - sun.direction * ((p.z() + floor_thickness) / sun.direction.z()));
  }
  // Occlusion reaches around the thing itself, not around its shadow.
  PixelRect touched = covered_pixels(camera, box).grown(Picture::reach(camera));
  touched.cover(covered_pixels(camera, lit).grown(shadow_margin(camera, sun)));
  return touched;
}

// Items of one list that the other lacks, in either direction.
std::vector<Bounds3> differences(const DrawList& before, const DrawList& after) {
  std::vector<Bounds3> boxes;
  const auto lacks = [](const DrawList& list, const DrawItem& item) {
    return std::none_of(list.begin(), list.end(), [&](const auto& o) { return o.same_as(item); });
  };
  for (const auto& item : before)
    if (lacks(after, item)) boxes.push_back(item.box);
  for (const auto& item : after)
    if (lacks(before, item)) boxes.push_back(item.box);
  return boxes;
}

class OsmesaRenderer : public Renderer {
 public:
  OsmesaRenderer(std::unique_ptr<GlContext> context, ScenePainter painter, Picture picture)
      : context_(std::move(context)),
        cache_(context_->gl()),
        painter_(std::move(painter)),
        picture_(std::move(picture)),
        shadows_(context_->gl()) {}

  ~OsmesaRenderer() override { (void)context_->make_current(); }

  Result<Image> render(const Scene& scene, const ModelTable& models, const View& view) override {
    const auto camera = make_camera(scene, view);
    if (!camera) return camera.error();
    if (auto status = context_->make_current(); !status) return status.error();

    Frame& frame = frame_for(frame_key(scene, view, *camera), *camera);
    update(frame, scene, models, view, *camera);
    Image image = frame.image;
    if (view.kind == View::Kind::top)
      if (auto drawn = draw_over(image, scene, view, *camera); !drawn) return drawn.error();
    return image;
  }

 private:
  static Status draw_over(Image& image, const Scene& scene, const View& view,
                          const Camera& camera) {
    auto drawn = draw_overlay(image, plan_symbols(rooms_of(scene), camera));
    if (!drawn || !view.marks) return drawn;
    return draw_overlay(image, layout_marks(scene, camera, view));
  }

  Frame& frame_for(const std::string& key, const Camera& camera) {
    const auto known = std::find_if(frames_.begin(), frames_.end(),
                                    [&](const Frame& frame) { return frame.key == key; });
    if (known != frames_.end()) {
      frames_.splice(frames_.begin(), frames_, known);
      return frames_.front();
    }
    if (frames_.size() >= kept_frames) frames_.pop_back();
    frames_.push_front({key, {}, {}, Image(camera.width, camera.height)});
    return frames_.front();
  }

  DrawList draw_list(const Scene& scene, const ModelTable& models, const View& view,
                     const Camera& camera, const std::string& key) {
    // From above, lamps would hide what stands under them; their ceiling is off as well. From a corner,
    // what hangs on a lowered wall would float before the room.
    const auto rooms = rooms_of(scene);
    std::vector<std::vector<double>> heights;
    for (std::size_t i = 0; i < rooms.size(); ++i)
      heights.push_back(wall_heights(rooms, i, view, camera));
    const auto shown = [&](const Object& object) {
      if (view.kind == View::Kind::top) return object.mount != Mount::ceiling;
      const Room& room = room_of(scene, object);
      const auto index = static_cast<std::size_t>(&room - rooms.data());
      return !hangs_on_lowered_wall(room, object, heights[index]);
    };
    DrawList items = draw_objects(scene, models, shown, cache_);
    DrawItem shell;
    shell.source = cache_.source(key);
    if (!shell.source) shell.source = shell_model(rooms_of(scene), models, view, camera);
    shell.model = cache_.get(key, shell.source);
    shell.box = shell.model->model_bounds();
    items.push_back(std::move(shell));  // last: objects hide much of it
    return items;
  }

  // Brings the frame to what the scene shows now, drawing no more than what changed.
  void update(Frame& frame, const Scene& scene, const ModelTable& models, const View& view,
              const Camera& camera) {
    DrawList items = draw_list(scene, models, view, camera, frame.key);
    const bool fresh = frame.items.empty();
    PixelRect damage = fresh ? PixelRect{0, 0, camera.width, camera.height} : PixelRect{};
    PixelRect shadow_damage =
        fresh || shadow_owner_ != frame.key ? ShadowMap::whole() : PixelRect{};
    if (fresh) frame.sun = sun_of(rooms_of(scene), view, camera);
    for (const auto& box : differences(frame.items, items)) {
      damage.cover(touched_pixels(camera, frame.sun, box));
      shadow_damage.cover(ShadowMap::covered_by(frame.sun, box));
    }
    damage = damage.clipped({0, 0, camera.width, camera.height});
    if (!damage.empty()) {
      const bool continued = !fresh && depth_owner_ == frame.key;
      const DrawList none;
      shadows_.update(painter_, is_marked(view) ? none : items, frame.sun, shadow_damage);
      shadow_owner_ = frame.key;
      // A picture that was partly drawn after another one has strange depths around that part.
      if (!continued) depth_owner_ = fresh ? frame.key : std::string();
      picture_.draw(painter_, items, camera,
                    {&frame.sun, shadows_.texture(), shadow_width / frame.sun.extent,
                     camera.eye ? room_lights(scene) : std::vector<RoomLight>{}},
                    damage, continued, frame.image);
    }
    frame.items = std::move(items);
    cache_.drop_unused();
  }

  std::unique_ptr<GlContext> context_;  // first: outlives what it made
  GpuCache cache_;
  ScenePainter painter_;
  Picture picture_;
  ShadowMap shadows_;
  std::string shadow_owner_;  ///< key of the frame whose shadows the map holds
  std::string depth_owner_;   ///< key of the frame whose depths the buffers hold
  std::list<Frame> frames_;   ///< latest first
};

}  // namespace

Result<std::unique_ptr<Renderer>> make_osmesa_renderer() {
  auto context = GlContext::create();
  if (!context) return context.error();
  auto painter = ScenePainter::create((*context)->gl());
  if (!painter) return painter.error();
  auto picture = Picture::create((*context)->gl());
  if (!picture) return picture.error();
  return std::unique_ptr<Renderer>(std::make_unique<OsmesaRenderer>(
      std::move(*context), std::move(*painter), std::move(*picture)));
}

}  // namespace roomgen
