#include "roomgen/render/pictures.h"

#include <list>
#include <optional>
#include <nlohmann/json.hpp>

#include "gl_context.h"
#include "layer_pass.h"
#include "numbered_shell.h"
#include "overlay.h"
#include "picture.h"
#include "roomgen/base/json.h"
#include "scene/lights.h"
#include "shadow_map.h"
#include "shown.h"
#include "view/layer_things.h"
#include "view/sheet_layout.h"

namespace roomgen {

namespace {

using namespace detail;

constexpr double shadow_width = 0.03;  // metres, of a shadow's soft edge
constexpr std::size_t kept_frames = 2;

// Everything a picture depends on but the objects.
std::string frame_key(const std::string& shell, const Camera& camera) {
  Json key = {{"shell", shell}, {"size", {camera.width, camera.height}}};
  for (const double value : {camera.center.x(), camera.center.y(), camera.pixels_per_metre, camera.near, camera.far})
    key["camera"].push_back(value);
  for (const Vec3& axis : {camera.right, camera.up, camera.eye.value_or(Vec3::Zero())})
    for (const double value : axis) key["axes"].push_back(value);
  key["eye"] = camera.eye.has_value();
  return key.dump();
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
  return pixel_at(std::ceil(metres * camera.pixels_per_metre)) + 2;
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

Image blank_picture(const Camera& camera) {
  Image image(camera.width, camera.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] =
        i % 4 == 3 ? 255 : static_cast<std::uint8_t>(255.0f * paper_background[i % 4] + 0.5f);
  return image;
}

class OsmesaRenderer : public Renderer {
 public:
  OsmesaRenderer(std::unique_ptr<GlContext> context, ScenePainter painter, Picture picture, LayerPass pass)
      : context_(std::move(context)),
        cache_(context_->gl()),
        painter_(std::move(painter)),
        picture_(std::move(picture)),
        layer_pass_(std::move(pass)),
        shadows_(context_->gl()) {}

  ~OsmesaRenderer() override {
    last_turn_.emplace();
    (void)context_->make_current();
  }

  Result<Image> render(const Scene& scene, const ModelTable& models, const View& view) override {
    if (view.kind == View::Kind::elevation) return drawn_elevation(scene, view);
    const auto camera = make_camera(scene, view);
    if (!camera) return camera.error();
    const GlTurn turn;
    if (auto status = context_->make_current(); !status) return status.error();

    auto image = picture_of(scene, models, view, *camera);
    if (image && view.kind == View::Kind::top)
      if (auto drawn = draw_over(*image, scene, view, *camera); !drawn) return drawn.error();
    return image;
  }

  Result<Layers> layers(const Scene& scene, const ModelTable& models, const Shot& shot) override {
    if (auto sound = check_camera(shot.camera); !sound) return sound.error();
    auto things = layer_things(scene);
    if (!things) return things.error();
    const GlTurn turn;
    if (auto status = context_->make_current(); !status) return status.error();

    Layers layers;
    layers.camera = shot.camera;
    layers.kind = shot.kind;
    layers.things = std::move(*things);
    View view;
    view.kind = shot.kind;
    if (shot.color) {
      auto color = picture_of(scene, models, view, shot.camera);
      if (!color) return color.error();
      layers.color = std::move(*color);
    }
    const auto items = numbered_items(scene, models, view, shot.camera, layers.things);
    layer_pass_.draw(items, layers);
    count_pixels(layers);
    if (shot.alone)
      for (const auto& item : items)
        layers.things[item.number - 1].pixels_alone += layer_pass_.count_alone(item, shot.camera);
    cache_.drop_unused();
    return layers;
  }

  Result<Visibility> visibility(const Scene& scene, const ModelTable& models, const Camera& camera,
                                std::size_t object, std::size_t least_alone) override {
    if (auto sound = check_camera(camera); !sound) return sound.error();
    const auto things = layer_things(scene);
    if (!things) return things.error();
    const GlTurn turn;
    if (auto status = context_->make_current(); !status) return status.error();
    View view;
    view.kind = View::Kind::eye;
    const auto items = numbered_items(scene, models, view, camera, *things);
    const auto item = std::find_if(items.begin(), items.end(),
                                   [&](const NumberedItem& one) { return one.number == object + 1; });
    Visibility seen;
    if (item != items.end()) {
      seen.pixels_alone = layer_pass_.count_alone(*item, camera);
      if (seen.pixels_alone >= least_alone) seen.pixels = layer_pass_.count(*item, items, camera);
    }
    cache_.drop_unused();
    return seen;
  }

  Result<Image> sheet(const ContactSheet& sheet, const ModelTable& models) override {
    const auto layout = lay_out(sheet);
    if (!layout) return layout.error();
    const GlTurn turn;
    if (auto status = context_->make_current(); !status) return status.error();
    const Camera& camera = layout->camera;
    DrawList items;
    std::vector<Vec3> corners;
    for (const auto& object : layout->objects) {
      items.push_back(draw_object(object, models, cache_));
      corners.insert(corners.end(), {items.back().box.low, items.back().box.high});
    }
    if (corners.empty()) corners = {Vec3::Zero(), Vec3::Ones()};
    const Sun sun = make_sun(sun_direction(camera, View::Kind::isometric), corners);
    update_shadows({}, sun);
    depth_owner_.clear();
    Image image = blank_picture(camera);
    const SceneLight light{&sun, shadows_.texture(), shadow_width / sun.extent, {}};
    Status status;
    // Most of the sheet is empty.
    for (const auto& item : items) {
      const PixelRect part =
          covered_pixels(camera, item.box).clipped({0, 0, camera.width, camera.height});
      if (status) status = picture_.draw(painter_, items, camera, light, part, false, image);
    }
    if (status) status = draw_overlay(image, layout->drawing);
    cache_.drop_unused();
    if (!status) return status.error();
    return image;
  }

 private:
  static Result<Image> drawn_elevation(const Scene& scene, const View& view) {
    const auto sheet = layout_elevation(scene, view);
    if (!sheet) return sheet.error();
    Image image(sheet->width, sheet->height);
    std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{255});
    if (auto drawn = draw_overlay(image, sheet->drawing); !drawn) return drawn.error();
    return image;
  }

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

  Result<Image> picture_of(const Scene& scene, const ModelTable& models, const View& view, const Camera& camera) {
    const std::string shell = shell_key(rooms_of(scene), view, camera);
    Frame& frame = frame_for(frame_key(shell, camera), camera);
    if (auto status = update(frame, scene, models, view, camera, shell); !status) {
      frames_.pop_front();  // half drawn
      return status.error();
    }
    return frame.image;
  }

  // Numbered as the things are: objects first, then the parts of the rooms.
  std::vector<NumberedItem> numbered_items(const Scene& scene, const ModelTable& models, const View& view,
                                           const Camera& camera, const std::vector<LayerThing>& things) {
    std::vector<NumberedItem> items;
    const auto shown = shown_objects(scene, view, camera);
    for (std::size_t k = 0; k < scene.objects.size(); ++k)
      if (shown(scene.objects[k]))
        items.push_back({draw_object(scene.objects[k], models, cache_), static_cast<std::uint16_t>(k + 1)});
    shell_.update(rooms_of(scene), models, view, camera);
    shell_.append_items(std::span(things).subspan(scene.objects.size()), scene.objects.size() + 1, cache_, items);
    return items;
  }

  // The rooms as one thing, and last: objects hide much of it.
  DrawList draw_list(const Scene& scene, const ModelTable& models, const View& view, const Camera& camera,
                     const std::string& shell) {
    DrawList items = draw_objects(scene, models, shown_objects(scene, view, camera), cache_);
    auto model = cache_.source(shell);
    if (!model) model = merged(shown_shell(rooms_of(scene), models, view, camera));
    items.push_back(fixed_item(shell, model, cache_));
    return items;
  }

  // Brings the frame to what the scene shows now, drawing no more than what changed.
  Status update(Frame& frame, const Scene& scene, const ModelTable& models, const View& view,
                const Camera& camera, const std::string& shell) {
    DrawList items = draw_list(scene, models, view, camera, shell);
    const bool fresh = frame.items.empty();
    PixelRect damage = fresh ? PixelRect{0, 0, camera.width, camera.height} : PixelRect{};
    if (fresh) frame.sun = sun_of(rooms_of(scene), view, camera);
    for (const auto& box : differences(frame.items, items)) damage.cover(touched_pixels(camera, frame.sun, box));
    damage = damage.clipped({0, 0, camera.width, camera.height});
    if (!damage.empty()) {
      const bool continued = !fresh && depth_owner_ == frame.key;
      const DrawList none;
      update_shadows(is_marked(view) ? none : items, frame.sun);
      // A picture that was partly drawn after another one has strange depths around that part.
      if (!continued) depth_owner_ = fresh ? frame.key : std::string();
      const SceneLight light{&frame.sun, shadows_.texture(), shadow_width / frame.sun.extent,
                             camera.eye ? room_lights(scene) : std::vector<RoomLight>{}};
      auto status = picture_.draw(painter_, items, camera, light, damage, continued, frame.image);
      if (!status) return status;
    }
    frame.items = std::move(items);
    cache_.drop_unused();
    return {};
  }

  // The shadows of a room are the same for every camera in it.
  void update_shadows(const DrawList& items, const Sun& sun) {
    PixelRect damage = shadow_sun_ && shadow_sun_->clip_from_room == sun.clip_from_room ? PixelRect{}
                                                                                       : ShadowMap::whole();
    for (const auto& box : differences(shadow_items_, items)) damage.cover(ShadowMap::covered_by(sun, box));
    shadows_.update(painter_, items, sun, damage);
    shadow_items_ = items;
    shadow_sun_ = sun;
  }

  std::optional<GlTurn> last_turn_;     // first: ends after all that is below
  std::unique_ptr<GlContext> context_;  // outlives what it made
  GpuCache cache_;
  ScenePainter painter_;
  Picture picture_;
  LayerPass layer_pass_;
  NumberedShell shell_;
  ShadowMap shadows_;
  DrawList shadow_items_;           ///< what casts the shadows that the map holds
  std::optional<Sun> shadow_sun_;
  std::string depth_owner_;   ///< key of the frame whose depths the buffers hold
  std::list<Frame> frames_;   ///< latest first
};

}  // namespace

Result<std::unique_ptr<Renderer>> make_osmesa_renderer() {
  const GlTurn turn;
  auto context = GlContext::create();
  if (!context) return context.error();
  auto painter = ScenePainter::create((*context)->gl());
  if (!painter) return painter.error();
  auto picture = Picture::create((*context)->gl());
  if (!picture) return picture.error();
  auto pass = LayerPass::create((*context)->gl());
  if (!pass) return pass.error();
  return std::unique_ptr<Renderer>(std::make_unique<OsmesaRenderer>(
      std::move(*context), std::move(*painter), std::move(*picture), std::move(*pass)));
}

}  // namespace roomgen
