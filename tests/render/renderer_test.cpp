#include "roomgen/render/pictures.h"

#include "base/threads.h"
#include "catch.h"
#include "drawing.h"
#include "support/furnished_room.h"
#include "view/camera.h"

using namespace roomgen;

namespace {

View view_of(View::Kind kind, int pixels = 256, bool marks = false) {
  View view;
  view.kind = kind;
  view.pixels = pixels;
  view.marks = marks;
  return view;
}

Image draw(Renderer& renderer, const Scene& scene, const View& view,
           const ModelTable& models = {}) {
  auto image = renderer.render(scene, models, view);
  if (!image) FAIL(image.error().message);
  return std::move(*image);
}

struct Pixel {
  int r, g, b;
  bool is_red() const { return r > 100 && r > 2 * g && r > 2 * b; }
  int brightness() const { return (r + g + b) / 3; }
};

// The pixel at a point of the floor, from the picture's scale alone.
Pixel pixel_at(const Image& image, const Scene& scene, const View& view, const Vec3& point) {
  const auto camera = make_camera(scene, view);
  const Vec2 p = camera->pixel(point);
  const auto* raw = image.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
  return {raw[0], raw[1], raw[2]};
}

// Pixels that are not the same; a number says more than two long lists.
std::size_t differing(const Image& a, const Image& b) {
  if (a.pixels.size() != b.pixels.size()) return std::max(a.pixels.size(), b.pixels.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 4)
    count += !std::equal(&a.pixels[i], &a.pixels[i] + 4, &b.pixels[i]);
  return count;
}

Scene red_box_scene(ModelTable& models, double yaw = 0.0) {
  Scene scene;
  scene.room = test::plain_room();
  scene.objects = {test::box("box-0", {1.0, 0.5, 0.8}, {2.5, 1.2, 0}, yaw)};
  test::use_model(scene.objects[0], models, "red",
                  test::colored_box({1.0, 0.5, 0.8}, {220, 20, 20}));
  return scene;
}

}  // namespace

TEST_CASE("a red box lies where the plan says, turned as it says") {
  auto renderer = make_renderer();
  const View view = view_of(View::Kind::top, 512);
  for (const double degrees : {0.0, 90.0, 45.0}) {
    ModelTable models;
    const Scene scene = red_box_scene(models, radians(degrees));
    const Image image = draw(*renderer, scene, view, models);
    for (double x = 1.6; x < 3.4; x += 0.07)
      for (double y = 0.3; y < 2.1; y += 0.07) {
        const Vec2 local = rotated(Vec2(x - 2.5, y - 1.2), -radians(degrees)).cwiseAbs();
        const double outside = std::max(local.x() - 0.5, local.y() - 0.25);
        if (std::abs(outside) < 0.02) continue;  // the edge itself
        INFO(degrees << " at " << x << ", " << y);
        CHECK(pixel_at(image, scene, view, {x, y, 0}).is_red() == (outside < 0));
      }
  }
}

TEST_CASE("each wall is drawn as it is covered, below and above its panelling") {
  auto renderer = make_renderer();
  Scene scene;
  scene.room = test::plain_room();
  scene.room.openings.clear();
  scene.room.materials.covers = {{"north", "#e02020", WallBand{"#20e020", 1.2}}, {"east", "#2020e0", {}}};
  const View view = view_of(View::Kind::isometric, 400);
  const Image image = draw(*renderer, scene, view);
  const Bounds2 floor = bounds(scene.room.polygon);
  const auto strongest = [&](const Vec3& point) {
    const Pixel pixel = pixel_at(image, scene, view, point);
    return pixel.r > pixel.g && pixel.r > pixel.b ? 'r' : pixel.g > pixel.b ? 'g' : 'b';
  };
  for (double t = 0.2; t < 0.9; t += 0.1) {
    INFO(t);
    const double x = floor.low.x() + t * floor.size().x(), y = floor.low.y() + t * floor.size().y();
    CHECK(strongest({x, floor.high.y(), 2.0}) == 'r');
    CHECK(strongest({x, floor.high.y(), 0.6}) == 'g');
    CHECK(strongest({floor.high.x(), y, 0.6}) == 'b');
  }
}

TEST_CASE("the same scene gives the same pixels, from one renderer or another") {
  auto one = make_renderer(), other = make_renderer();
  const Scene scene = test::furnished_room();
  for (const auto& view : {view_of(View::Kind::top), view_of(View::Kind::isometric),
                           view_of(View::Kind::eye), view_of(View::Kind::top, 400, true)}) {
    const Image first = draw(*one, scene, view);
    CHECK(differing(draw(*one, scene, view), first) == 0);
    CHECK(differing(draw(*other, scene, view), first) == 0);
  }
}

TEST_CASE("Renderers of several threads draw what one draws alone") {
  const Scene scene = test::furnished_room();
  const View eye = view_of(View::Kind::eye, 96), top = view_of(View::Kind::top, 96, true);
  const Model box = test::colored_box({1.0, 0.5, 0.8}, {220, 20, 20});
  const auto all = [&]() -> std::vector<Image> {
    auto renderer = make_osmesa_renderer();
    auto views = draw_views(box, 48);
    if (!renderer || !views) return {};
    for (const auto& view : {eye, top, eye})
      if (auto image = (*renderer)->render(scene, {}, view)) views->push_back(*std::move(image));
    return *std::move(views);
  };
  constexpr std::size_t threads = 3, rounds = 2;
  const auto alone = all();
  REQUIRE(alone.size() == model_view_names().size() + 3);
  std::vector<std::vector<Image>> drawn(threads * rounds);
  on_threads(threads, [&](std::size_t thread) {
    for (std::size_t round = 0; round < rounds; ++round) drawn[rounds * thread + round] = all();
  });
  for (const auto& images : drawn) {
    REQUIRE(images.size() == alone.size());
    for (std::size_t k = 0; k < alone.size(); ++k) CHECK(differing(images[k], alone[k]) == 0);
  }
}

TEST_CASE("drawing only what changed gives what drawing everything gives") {
  auto kept = make_renderer();
  const Scene whole = test::furnished_room();
  for (const auto& view : {view_of(View::Kind::top, 300), view_of(View::Kind::top, 300, true)}) {
    Scene scene = whole;
    scene.objects.clear();
    const auto check = [&](const std::string& what) {
      INFO(what);
      auto fresh = make_renderer();
      CHECK(differing(draw(*kept, scene, view), draw(*fresh, scene, view)) == 0);
    };
    for (const auto& object : whole.objects) {
      scene.objects.push_back(object);
      check("added " + object.id);
    }
    scene.objects[0].position.x() -= 0.3;
    scene.objects[2].yaw = 1.0;
    check("moved");
    (void)draw(*kept, scene, view_of(View::Kind::isometric, 200));  // another sun in between
    scene.objects.erase(scene.objects.begin() + 1);
    check("removed");
    scene.room.openings.pop_back();
    check("another room");
  }
}

TEST_CASE("repainting is exact in crowded rooms of any size") {
  for (const int seed : {2, 5, 9}) {
    auto kept = make_renderer(), fresh = make_renderer();
    Scene scene = test::random_scene(seed);
    scene.objects.resize(std::min<std::size_t>(scene.objects.size(), 12));
    const auto all = scene.objects;
    scene.objects.pop_back();
    const View view = view_of(View::Kind::top, 400);
    (void)draw(*kept, scene, view);
    for (std::size_t i = 0; i < all.size(); ++i) {
      scene.objects = all;
      scene.objects.erase(scene.objects.begin() + static_cast<std::ptrdiff_t>(i));
      (void)draw(*kept, scene, view);
    }
    scene.objects = all;
    INFO("seed " << seed);
    CHECK(differing(draw(*kept, scene, view), draw(*fresh, scene, view)) == 0);
  }
}

TEST_CASE("a large picture made of tiles has no seams") {
  auto renderer = make_renderer();
  ModelTable models;
  const Scene scene = red_box_scene(models);
  const View view = view_of(View::Kind::top, 1300);
  const Image image = draw(*renderer, scene, view, models);
  CHECK(image.width == 1300);
  // Down the column at the border of two tiles, neighbours differ no more than elsewhere.
  const auto step = [&](int x) {
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y)
      sum += std::abs(image.at(x, y)[0] - image.at(x - 1, y)[0]);
    return sum / image.height;
  };
  CHECK(step(1024) < 2.0 * (step(1020) + step(1028)) + 1.0);
}

TEST_CASE("what lies behind glass shows, what lies behind a box does not") {
  auto renderer = make_renderer();
  const View view = view_of(View::Kind::top, 256);
  ModelTable models;
  Scene scene = red_box_scene(models);
  scene.objects.push_back(test::box("glass-0", {0.6, 0.4, 0.1}, {2.5, 1.2, 1.0}));
  test::use_model(scene.objects[1], models, "glass",
                  test::colored_box({0.6, 0.4, 0.1}, {255, 255, 255}, 0.3f));
  const Pixel through = pixel_at(draw(*renderer, scene, view, models), scene, view, {2.5, 1.2, 0});
  CHECK(through.r > through.g + 40);
  test::use_model(scene.objects[1], models, "solid",
                  test::colored_box({0.6, 0.4, 0.1}, {255, 255, 255}));
  const Pixel on = pixel_at(draw(*renderer, scene, view, models), scene, view, {2.5, 1.2, 0});
  CHECK(on.r < on.g + 20);
}

TEST_CASE("a mesh wound the wrong way is not black") {
  auto renderer = make_renderer();
  const View view = view_of(View::Kind::top, 256);
  ModelTable models;
  Scene scene = red_box_scene(models);
  const auto bright = [&](Model model, const char* id) {
    test::use_model(scene.objects[0], models, id, std::move(model));
    return pixel_at(draw(*renderer, scene, view, models), scene, view, {2.5, 1.2, 0}).brightness();
  };
  Model model = test::colored_box({1.0, 0.5, 0.8}, {200, 200, 200});
  const int usual = bright(model, "usual");
  for (auto& t : model.parts[0].mesh.triangles) std::swap(t[1], t[2]);
  for (auto& n : model.parts[0].mesh.normals) n = -n;
  CHECK(std::abs(bright(model, "inverted") - usual) <= 2);
}

TEST_CASE("what glows is brighter than the light makes it, the more the more it glows") {
  auto renderer = make_renderer();
  const View view = view_of(View::Kind::top, 256);
  ModelTable models;
  Scene scene = red_box_scene(models);
  const auto bright = [&](float glow, const char* id) {
    Model model = test::colored_box({1.0, 0.5, 0.8}, {60, 60, 60});
    for (auto& material : model.materials) material.glow = glow;
    test::use_model(scene.objects[0], models, id, std::move(model));
    return pixel_at(draw(*renderer, scene, view, models), scene, view, {2.5, 1.2, 0}).brightness();
  };
  const int dull = bright(0.0f, "dull"), faint = bright(0.4f, "faint");
  CHECK(faint > dull + 10);
  CHECK(bright(1.0f, "bright") > faint + 10);
}

TEST_CASE("textures lie the right way up") {
  auto renderer = make_renderer();
  const View view = view_of(View::Kind::top, 512);
  ModelTable models;
  Scene scene = red_box_scene(models);
  auto image = std::make_shared<Image>(8, 8);  // the upper left quarter is red, the rest blue
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const bool red = x < 4 && y < 4;
      const std::uint8_t pixel[4] = {static_cast<std::uint8_t>(red ? 255 : 0), 0,
                                     static_cast<std::uint8_t>(red ? 0 : 255), 255};
      std::copy(pixel, pixel + 4, image->at(x, y));
    }
  Model model;
  model.materials.resize(1);
  model.materials[0].base_color = {1, 1, 1, 1};
  model.materials[0].texture = image;
  Mesh& top = model.parts.emplace_back().mesh;
  top.positions = {
      {-0.5f, -0.5f, 0.5f}, {0.5f, -0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}, {-0.5f, 0.5f, 0.5f}};
  top.normals.assign(4, {0, 0, 1});
  top.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  top.triangles = {{0, 1, 2}, {0, 2, 3}};
  test::use_model(scene.objects[0], models, "flag", model);
  const Image picture = draw(*renderer, scene, view, models);
  CHECK(pixel_at(picture, scene, view, {2.25, 1.32, 0}).is_red());        // back left
  CHECK_FALSE(pixel_at(picture, scene, view, {2.75, 1.32, 0}).is_red());  // back right
  CHECK_FALSE(pixel_at(picture, scene, view, {2.25, 1.08, 0}).is_red());  // front left
}

TEST_CASE("a new model under an old key replaces it") {
  auto renderer = make_renderer();
  const View view = view_of(View::Kind::top, 128);
  ModelTable models;
  const Scene scene = red_box_scene(models);
  CHECK(pixel_at(draw(*renderer, scene, view, models), scene, view, {2.5, 1.2, 0}).is_red());
  models.add(asset_key(scene.objects[0].asset),
             std::make_shared<Model>(test::colored_box({1, 0.5, 0.8}, {20, 20, 220})));
  CHECK_FALSE(pixel_at(draw(*renderer, scene, view, models), scene, view, {2.5, 1.2, 0}).is_red());
}

TEST_CASE("marks are drawn over the top view only") {
  auto renderer = make_renderer();
  const Scene scene = test::furnished_room();
  const auto plain = draw(*renderer, scene, view_of(View::Kind::isometric, 200));
  CHECK(differing(draw(*renderer, scene, view_of(View::Kind::isometric, 200, true)), plain) == 0);
  const auto top = draw(*renderer, scene, view_of(View::Kind::top, 200));
  CHECK(differing(draw(*renderer, scene, view_of(View::Kind::top, 200, true)), top) > 0);
}

TEST_CASE("free floor is shaded green where it is, under the marks only") {
  Scene scene;
  scene.room = test::plain_room();
  auto renderer = make_renderer();
  View view = view_of(View::Kind::top, 512, true);
  const Image before = draw(*renderer, scene, view);
  view.free_floor = {{Vec2(2.1, 0.6), Vec2(2.9, 1.4)}};
  const Image after = draw(*renderer, scene, view);
  const auto greener = [&](double x, double y) {
    const auto a = pixel_at(before, scene, view, {x, y, 0}), b = pixel_at(after, scene, view, {x, y, 0});
    return (b.g - b.r) - (a.g - a.r);
  };
  CHECK(greener(2.7, 1.2) > 10);
  CHECK(greener(2.3, 0.8) > 10);
  CHECK(greener(2.3, 1.7) == 0);
  CHECK(greener(1.2, 0.8) == 0);
  view.marks = false;
  const Image plain = draw(*renderer, scene, view);
  view.free_floor.clear();
  CHECK(differing(plain, draw(*renderer, scene, view)) == 0);
}

TEST_CASE("absurd sizes, empty rooms and empty meshes give an error or a picture") {
  auto renderer = make_renderer();
  Scene scene = test::furnished_room();
  for (const int pixels : {0, -1, 15, 4097, 1 << 30})
    CHECK_FALSE(renderer->render(scene, {}, view_of(View::Kind::top, pixels)));
  CHECK_FALSE(renderer->render(Scene{}, {}, view_of(View::Kind::top)));
  ModelTable models;
  test::use_model(scene.objects[0], models, "nothing", Model{});
  CHECK(renderer->render(scene, models, view_of(View::Kind::isometric)));
  scene.objects.clear();
  CHECK(renderer->render(scene, models, view_of(View::Kind::top, 16, true)));
}

TEST_CASE("at eye level a red box is where the camera says") {
  auto renderer = make_renderer();
  ModelTable models;
  const Scene scene = red_box_scene(models, radians(30));
  const View view = view_of(View::Kind::eye, 512);
  const auto camera = make_camera(scene, view);
  REQUIRE(camera);
  const Image image = draw(*renderer, scene, view, models);
  REQUIRE(image.width == camera->width);
  REQUIRE(image.height == camera->height);
  // What the rays through the pixels meet, by a reckoning of its own.
  const Footprint box = footprint(scene.objects[0]);
  int red = 0, checked = 0;
  for (int y = 2; y < image.height; y += 7)
    for (int x = 2; x < image.width; x += 7) {
      const double u = (x + 0.5 - 0.5 * image.width) / camera->pixels_per_metre + camera->center.x();
      const double v = (0.5 * image.height - y - 0.5) / camera->pixels_per_metre + camera->center.y();
      const Vec3 ray = u * camera->right + v * camera->up - camera->backward;
      // March along the ray; near an edge of the box nobody knows.
      bool meets = false, near = false;
      for (double t = 0.05; t < 6.0; t += 0.004) {
        const Vec3 p = *camera->eye + t * ray;
        const Vec2 local = box.to_local(p.head<2>()).cwiseAbs() - box.half();
        const double outside = std::max({local.x(), local.y(), p.z() - 0.8, -p.z()});
        meets = meets || outside < 0.0;
        near = near || std::abs(outside) < 0.03;
      }
      if (near && !meets) continue;
      bool deep = false;
      for (double t = 0.05; t < 6.0 && !deep; t += 0.004) {
        const Vec3 p = *camera->eye + t * ray;
        const Vec2 local = box.to_local(p.head<2>()).cwiseAbs() - box.half();
        deep = std::max({local.x(), local.y(), p.z() - 0.8, -p.z()}) < -0.03;
      }
      if (meets && !deep) continue;
      const auto* raw = image.at(x, y);
      const Pixel pixel{raw[0], raw[1], raw[2]};
      INFO(x << ", " << y);
      CHECK((pixel.r > 2 * pixel.g) == meets);
      red += meets;
      ++checked;
    }
  CHECK(red > 50);
  CHECK(checked > 2 * red);
}

TEST_CASE("at eye level a lamp lights what is around it") {
  auto renderer = make_renderer();
  Scene scene;
  scene.room = test::plain_room();
  scene.room.openings.pop_back();  // no sun
  const View view = view_of(View::Kind::eye);
  const auto brightness = [&](const Image& image) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4)
      sum += image.pixels[i] + image.pixels[i + 1] + image.pixels[i + 2];
    return sum / (0.75 * static_cast<double>(image.pixels.size()));
  };
  const double without = brightness(draw(*renderer, scene, view));
  scene.objects = {test::box("lamp-0", {0.4, 0.4, 0.2}, {2.0, 1.5, 2.5})};
  scene.objects[0].category = "ceiling lamp";
  scene.objects[0].mount = Mount::ceiling;
  const double with = brightness(draw(*renderer, scene, view));
  CHECK(with > without + 3.0);
  // Neither night nor glare.
  CHECK(without > 60.0);
  CHECK(with < 235.0);
}
