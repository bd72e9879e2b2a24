#include "roomgen/export/exporter.h"

#include <Eigen/Geometry>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "base/random.h"
#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "support/furnished_room.h"

using namespace roomgen;

namespace {

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

// A reader of its own: shares nothing with the writer.
struct Glb {
  Json json;
  std::string binary;

  const Json& node(const std::string& name) const {
    for (const auto& n : json["nodes"])
      if (n.value("name", "") == name) return n;
    throw std::runtime_error("no node " + name);
  }
  std::vector<Eigen::Vector3d> vectors(const Json& accessor) const {
    const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    std::size_t at = view.value("byteOffset", 0u) + accessor.value("byteOffset", 0u);
    std::vector<Eigen::Vector3d> result;
    for (std::size_t i = 0; i < accessor["count"]; ++i, at += 12) {
      float v[3];
      std::memcpy(v, binary.data() + at, 12);
      result.push_back({v[0], v[1], v[2]});
    }
    return result;
  }
  std::vector<Eigen::Vector3d> positions_of(const Json& n) const {
    std::vector<Eigen::Vector3d> all;
    for (const auto& primitive : json["meshes"][n["mesh"].get<std::size_t>()]["primitives"]) {
      const auto& accessor =
          json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
      for (const auto& p : vectors(accessor)) all.push_back(p);
    }
    return all;
  }
};

Glb parse(const std::string& bytes) {
  REQUIRE(bytes.size() > 20);
  REQUIRE(bytes.substr(0, 4) == "glTF");
  REQUIRE(word(bytes, 4) == 2);
  REQUIRE(word(bytes, 8) == bytes.size());
  const std::size_t json_size = word(bytes, 12);
  REQUIRE(json_size % 4 == 0);
  REQUIRE(bytes.substr(16, 4) == "JSON");
  Glb glb;
  glb.json = Json::parse(bytes.substr(20, json_size));
  const std::size_t next = 20 + json_size;
  REQUIRE(bytes.substr(next + 4, 3) == "BIN");
  glb.binary = bytes.substr(next + 8);
  REQUIRE(word(bytes, next) == glb.binary.size());
  return glb;
}

Glb write_and_parse(const Scene& scene, const ModelTable& models, const ExportOptions& options = {}) {
  const auto bytes = make_glb(scene, models, options);
  REQUIRE(bytes);
  return parse(*bytes);
}

Eigen::Vector3d vector_of(const Json& json) {
  return Eigen::Vector3d(json[0].get<double>(), json[1].get<double>(), json[2].get<double>());
}

Eigen::Affine3d transform_of(const Json& node) {
  Eigen::Affine3d t = Eigen::Affine3d::Identity();
  if (node.contains("translation")) t.translate(vector_of(node["translation"]));
  if (node.contains("rotation")) {
    const auto& q = node["rotation"];
    t.rotate(Eigen::Quaterniond(q[3].get<double>(), q[0].get<double>(), q[1].get<double>(),
                                q[2].get<double>()));
  }
  if (node.contains("scale")) t.scale(vector_of(node["scale"]));
  return t;
}

// The corners of an object's box in glTF's frame, from scene.json's words alone: Y up, front +Z.
std::vector<Eigen::Vector3d> expected_corners(const Object& o) {
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {0.0, 1.0}) {
        const double lx = x * o.size.x(), ly = y * o.size.y();
        const double rx = o.position.x() + std::cos(o.yaw) * lx - std::sin(o.yaw) * ly;
        const double ry = o.position.y() + std::sin(o.yaw) * lx + std::cos(o.yaw) * ly;
        corners.push_back({rx, o.position.z() + z * o.size.z(), -ry});
      }
  return corners;
}

ImageEncoder counting_encoder(int& calls) {
  return [&calls](const Image& image) -> Result<EncodedImage> {
    ++calls;
    return EncodedImage{"image/png", std::string(image.pixels.begin(), image.pixels.end())};
  };
}

Model textured_box(bool hollow) {
  Model model = test::colored_box({1, 1, 1}, {255, 255, 255});
  model.materials[0].texture = test::checkerboard(hollow);
  return model;
}

}  // namespace

TEST_CASE("a wall's mesh has the colours of its upper and its lower part, and no other wall has") {
  Scene scene = test::furnished_room();
  scene.room.materials.covers = {{"wall-1", "#ff0000", WallBand{"#0000ff", 1.0}}};
  const Glb glb = write_and_parse(scene, {});
  for (std::size_t k = 0; k < scene.room.polygon.size(); ++k) {
    const Json& node = glb.node("wall-" + std::to_string(k));
    // Heights that faces of this colour reach; glTF is Y up.
    const auto heights = [&](const std::vector<double>& color) {
      Bounds3 box;
      for (const auto& primitive : glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"]) {
        const Json& material = glb.json["materials"][primitive["material"].get<std::size_t>()];
        const auto& factor = material["pbrMetallicRoughness"]["baseColorFactor"];
        const bool is_wall = material["name"].get<std::string>().starts_with("wall");
        if (!is_wall || !factor.is_array() || factor.get<std::vector<double>>() != color) continue;
        for (const auto& p : glb.vectors(glb.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()])) box.add(p);
      }
      return box;
    };
    const Bounds3 red = heights({1, 0, 0, 1}), blue = heights({0, 0, 1, 1});
    INFO("wall " << k);
    if (k != 1) {
      CHECK(red.low.y() > red.high.y());
      CHECK(blue.low.y() > blue.high.y());
      continue;
    }
    CHECK(red.high.y() == Approx(scene.room.height));
    CHECK(blue.low.y() == Approx(0.0).margin(1e-6));
    CHECK(blue.high.y() == Approx(1.0));
  }
}

TEST_CASE("nodes put every object's box where the scene says") {
  Scene scene = test::furnished_room();
  ModelTable models;
  // A model of another size than its object: the node scales it.
  test::use_model(scene.objects[2], models, "chair", test::colored_box({1, 2, 3}, {200, 0, 0}));
  const Glb glb = write_and_parse(scene, models);
  for (const auto& object : scene.objects) {
    INFO(object.id);
    const Json& node = glb.node(object.id);
    const auto transform = transform_of(node);
    std::vector<Eigen::Vector3d> points;
    for (const auto& p : glb.positions_of(node)) points.push_back(transform * p);
    // Round things fill their box without reaching its corners: compare extents for them.
    if (object.traits.round) {
      Bounds3 got, want;
      for (const auto& p : points) got.add(p);
      for (const auto& p : expected_corners(object)) want.add(p);
      CHECK((got.low - want.low).norm() + (got.high - want.high).norm() < 0.01);
      continue;
    }
    for (const auto& corner : expected_corners(object)) {
      double nearest = 1e9;
      for (const auto& p : points) nearest = std::min(nearest, (p - corner).norm());
      CHECK(nearest < 1e-5);
    }
  }
}

TEST_CASE("the front of an object looks to +Z of its node") {
  Scene scene = test::furnished_room();
  ModelTable models;
  Model arrow = test::colored_box({1, 1, 1}, {200, 0, 0});
  // A vertex that marks the front: the only one at half height.
  for (auto& p : arrow.parts[0].mesh.positions)
    if (p.y() < 0 && p.x() < 0 && p.z() > 0.5f) p.z() = 0.5f;
  test::use_model(scene.objects[0], models, "arrow", arrow);
  const Glb glb = write_and_parse(scene, models);
  for (const auto& p : glb.positions_of(glb.node("bed-0")))
    if (std::abs(p.y() - 0.5) < 1e-6) CHECK(p.z() > 0.4);
}

TEST_CASE("accessors tell the true extent of their positions and normals are unit vectors") {
  const Glb glb = write_and_parse(test::furnished_room(), {});
  for (const auto& mesh : glb.json["meshes"])
    for (const auto& primitive : mesh["primitives"]) {
      const auto& attributes = primitive["attributes"];
      const auto& accessor = glb.json["accessors"][attributes["POSITION"].get<std::size_t>()];
      Bounds3 box;
      for (const auto& p : glb.vectors(accessor)) box.add(p);
      CHECK(vector_of(accessor["min"]) == box.low);
      CHECK(vector_of(accessor["max"]) == box.high);
      for (const auto& n :
           glb.vectors(glb.json["accessors"][attributes["NORMAL"].get<std::size_t>()]))
        CHECK(n.norm() == Approx(1.0).margin(1e-3));
    }
}

TEST_CASE("objects of one asset share a mesh") {
  Scene scene = test::furnished_room();
  ModelTable models;
  for (auto& object : scene.objects) test::use_model(object, models, "cube", textured_box(false));
  const Glb glb = write_and_parse(scene, models);
  std::set<int> meshes;
  for (const auto& object : scene.objects) meshes.insert(glb.node(object.id)["mesh"].get<int>());
  CHECK(meshes.size() == 1);
}

TEST_CASE("the room is there by name, with its openings as nodes") {
  const Glb glb = write_and_parse(test::furnished_room(), {});
  CHECK(glb.node("room")["children"].size() == 8);
  for (const auto* part :
       {"floor", "wall-0", "wall-1", "wall-2", "wall-3", "ceiling", "door-0", "window-0"})
    CHECK(glb.node(part).contains("mesh"));
  CHECK(glb.node("door-0")["extras"]["category"] == "door");
}

TEST_CASE("lamps and the sun are lights where they are in the room") {
  Scene scene = test::furnished_room();
  scene.objects.push_back(test::box("x-0", {0.2, 0.3, 0.5}, {1.0, 1.0, 0.7}));
  scene.objects.back().category = "desk lamp";
  const Glb glb = write_and_parse(scene, {});
  CHECK(glb.json["extensionsUsed"] == Json({"KHR_lights_punctual"}));
  const Json& lights = glb.json["extensions"]["KHR_lights_punctual"]["lights"];
  const auto light_of = [&](const Json& node) -> const Json& {
    return lights[node["extensions"]["KHR_lights_punctual"]["light"].get<std::size_t>()];
  };
  CHECK(glb.node("lights")["children"].size() == 3);
  const Json& lamp = glb.node("lamp-0 light");
  CHECK(light_of(lamp)["type"] == "point");
  CHECK(light_of(lamp)["intensity"].get<double>() > 10.0);
  const Vec3 at = vector_of(lamp["translation"]);
  CHECK(at.x() == Approx(0.3));
  CHECK(at.z() == Approx(-2.4));
  CHECK(at.y() > 0.74);
  CHECK(at.y() < 0.74 + 0.4);
  // Lights look along -Z of their node.
  const auto direction = [&](const Json& node) -> Vec3 {
    return transform_of(node).rotation() * Vec3(0, 0, -1);
  };
  const Json& spot = glb.node("x-0 light");
  CHECK(light_of(spot)["type"] == "spot");
  CHECK((direction(spot) - Vec3(0, -1, 0)).norm() < 1e-6);
  const Json& cone = light_of(spot)["spot"];
  CHECK(cone["innerConeAngle"].get<double>() < cone["outerConeAngle"].get<double>());
  const Json& sun = glb.node("sun");
  CHECK(light_of(sun)["type"] == "directional");
  // Down, and in through the window of the north wall: glTF's +Z is south.
  CHECK(direction(sun).y() < -0.3);
  CHECK(direction(sun).z() > 0.5);
}

TEST_CASE("lights can be left out, and equal ones are written once") {
  Scene scene = test::furnished_room();
  ExportOptions dark;
  dark.lights = false;
  const Glb without = write_and_parse(scene, {}, dark);
  CHECK_FALSE(without.json.contains("extensions"));
  CHECK_FALSE(without.json.contains("extensionsUsed"));
  scene.objects.push_back(scene.objects[3]);
  scene.objects.back().id = "lamp-1";
  const Glb glb = write_and_parse(scene, {});
  CHECK(glb.json["extensions"]["KHR_lights_punctual"]["lights"].size() == 2);
  CHECK(glb.node("lights")["children"].size() == 3);
}

TEST_CASE("nodes say what the thing is") {
  Scene scene = test::furnished_room();
  scene.objects[0].description = "a wide bed";
  scene.objects[0].relations = {{RelationKind::edge, ""}, {RelationKind::far, "door-0"}};
  const Glb glb = write_and_parse(scene, {});
  const Json& extras = glb.node("bed-0")["extras"];
  CHECK(extras["category"] == "bed");
  CHECK(extras["description"] == "a wide bed");
  CHECK(vector_of(extras["size"]) == Vec3(1.6, 2.0, 0.5));
  CHECK(extras["relations"] == Json({"edge", "far, door-0"}));
}

namespace {

// What strangers call things: any script, marks of programs and of file names, and very long.
std::string nasty_text(Random& random) {
  static const std::vector<std::string> pieces = {
      "chair", "Chair", "a b", "a_b", "a.b", "{\"kind\":", "}", "/", "\\", "[0]", ":", "%s", "{0}",
      " ", ".", "_", "-", "кресло", "椅子", "é", "\xff", "\n", "\t", "0", "1", "\"", "'", "🪑"};
  std::string text;
  const int most = random.chance(0.1) ? 90 : 3;
  for (int n = random.integer(1, most); n > 0; --n)
    text += random.pick(pieces);
  return text;
}

Scene nasty_scene(Random& random, ModelTable& models) {
  Scene scene = test::random_scene(random.next());
  scene.room.openings = test::plain_room().openings;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    auto& object = scene.objects[i];
    object.id = nasty_text(random);
    object.category = random.chance(0.2) ? "desk lamp" : nasty_text(random);
    object.description = nasty_text(random);
    Model model = textured_box(false);
    model.materials[0].name = nasty_text(random);
    model.materials[0].roughness = static_cast<float>(random.uniform(0, 1));
    if (random.chance(0.8)) test::use_model(object, models, nasty_text(random), std::move(model));
  }
  std::set<std::string> ids;
  std::erase_if(scene.objects, [&](const Object& o) { return !ids.insert(o.id).second; });
  return scene;
}

// Plain, and none of them twice: written on its own, from the words of the header.
void check_names(const Json& things) {
  std::set<std::string> seen;
  for (const auto& thing : things) {
    const auto name = thing["name"].get<std::string>();
    INFO(name);
    CHECK(!name.empty());
    CHECK(name.size() < 64);
    CHECK(std::regex_match(name, std::regex("[-A-Za-z0-9 _.]+")));
    const std::string threejs =
        std::regex_replace(std::regex_replace(name, std::regex(" "), "_"), std::regex("[.]"), "");
    CHECK(seen.insert(threejs).second);
  }
}

}  // namespace

TEST_CASE("names are plain and single whatever things are called, and ids stand beside them") {
  int calls = 0;
  ExportOptions options;
  options.encode_image = counting_encoder(calls);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    ModelTable models;
    const Scene scene = nasty_scene(random, models);
    const Glb glb = write_and_parse(scene, models, options);
    for (const char* kind : {"nodes", "meshes", "materials", "textures", "images", "scenes"})
      check_names(glb.json[kind]);
    std::vector<std::string> ids, wanted;
    for (const auto& node : glb.json["nodes"])
      if (const Json extras = node.value("extras", Json::object()); !extras.contains("shell") && extras.contains("id"))
        ids.push_back(extras["id"]);
    // As JSON has them: what is no UTF-8 is replaced.
    for (const auto& object : scene.objects) wanted.push_back(Json::parse(json_line(object.id)));
    CHECK(ids == wanted);
  }
}

TEST_CASE("plain ids are names as they are, before those of the room") {
  Scene scene = test::furnished_room();
  scene.objects[0].id = "floor";
  scene.objects[1].id = "wall-0";
  const Glb glb = write_and_parse(scene, {});
  for (const auto& object : scene.objects) CHECK(glb.node(object.id)["extras"]["id"] == object.id);
  CHECK(glb.node("floor 2")["extras"] == Json({{"category", "floor"}, {"id", "floor"}, {"shell", true}}));
}

TEST_CASE("rooms of a dwelling and their walls have names of their own") {
  Scene scene;
  scene.rooms = {test::plain_room(), test::plain_room()};
  scene.rooms[0].id = "kitchen-0";
  scene.rooms[1].id = "bedroom-0";
  for (auto& p : scene.rooms[1].polygon.points) p.x() += 4.1;
  const Glb glb = write_and_parse(scene, {});
  check_names(glb.json["nodes"]);
  const Json& wall = glb.node("bedroom-0 wall-0")["extras"];
  CHECK(wall["id"] == "wall-0");
  CHECK(wall["room"] == "bedroom-0");
}

TEST_CASE("a texture is embedded once, whoever uses it") {
  Scene scene = test::furnished_room();
  ModelTable models;
  // Two models with images that are equal but not the same.
  test::use_model(scene.objects[0], models, "a", textured_box(false));
  test::use_model(scene.objects[1], models, "b", textured_box(false));
  int calls = 0;
  ExportOptions options;
  options.encode_image = counting_encoder(calls);
  const Glb glb = write_and_parse(scene, models, options);
  CHECK(calls == 3);  // with the floor's
  CHECK(glb.json["images"].size() == 2);
  CHECK(glb.json["textures"].size() == 2);
  CHECK(glb.json["images"][0]["mimeType"] == "image/png");
}

TEST_CASE("without an encoder textures become their mean colour") {
  Scene scene = test::furnished_room();
  ModelTable models;
  test::use_model(scene.objects[0], models, "a", textured_box(false));
  const Glb glb = write_and_parse(scene, models);
  CHECK_FALSE(glb.json.contains("images"));
  const auto& mesh = glb.json["meshes"][glb.node("bed-0")["mesh"].get<std::size_t>()];
  const auto& material =
      glb.json["materials"][mesh["primitives"][0]["material"].get<std::size_t>()];
  const auto& color = material["pbrMetallicRoughness"]["baseColorFactor"];
  CHECK(color[0].get<double>() == Approx(1.0));
  CHECK(color[1].get<double>() == Approx(0.5));  // half the squares, in linear light
  CHECK(color[2].get<double>() == Approx(0.0));
}

TEST_CASE("glass blends and leaves are cut out") {
  Scene scene = test::furnished_room();
  ModelTable models;
  test::use_model(scene.objects[0], models, "glass", test::colored_box({1, 1, 1}, {9, 9, 9}, 0.3f));
  test::use_model(scene.objects[1], models, "leaves", textured_box(true));
  const Glb glb = write_and_parse(scene, models);
  const auto mode = [&](const char* id) {
    const auto& mesh = glb.json["meshes"][glb.node(id)["mesh"].get<std::size_t>()];
    return glb.json["materials"][mesh["primitives"][0]["material"].get<std::size_t>()].value(
        "alphaMode", "OPAQUE");
  };
  CHECK(mode("bed-0") == "BLEND");
  CHECK(mode("desk-0") == "MASK");
  CHECK(mode("chair-0") == "OPAQUE");
}

TEST_CASE("the file names creators and licences") {
  Scene scene = test::furnished_room();
  ModelTable models;
  test::use_model(scene.objects[0], models, "a", textured_box(false));
  const Glb glb = write_and_parse(scene, models);
  CHECK(glb.json["asset"]["generator"] == "roomgen");
  CHECK(glb.json["asset"]["copyright"] == "a by nobody (CC0, test)");
  CHECK_FALSE(write_and_parse(test::furnished_room(), {}).json["asset"].contains("copyright"));
}

TEST_CASE("equal scenes give equal bytes") {
  CHECK(*make_glb(test::furnished_room(), {}) == *make_glb(test::furnished_room(), {}));
}

TEST_CASE("a failing encoder fails the export and leaves no file") {
  ExportOptions options;
  options.encode_image = [](const Image&) -> Result<EncodedImage> {
    return Error{Error::Kind::io, "no ink"};
  };
  const auto path = std::filesystem::temp_directory_path() / "roomgen-export-test.glb";
  std::filesystem::remove(path);
  const auto status = GlbExporter(options).write(test::furnished_room(), {}, path);
  REQUIRE_FALSE(status);
  CHECK(status.error().message.find("no ink") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("A model alone is one node in the axes of glTF") {
  Model model;
  model.materials.emplace_back();
  model.parts.push_back({make_box({-0.5, -0.2, 0}, {0.5, 0.3, 2}), 0});
  const auto bytes = make_glb("stool", model);
  REQUIRE(bytes);
  const Glb glb = parse(*bytes);
  CHECK(glb.json["nodes"].size() == 1);
  CHECK(glb.json["asset"].count("copyright") == 0);
  double highest = 0, front = -1;
  for (const auto& p : glb.positions_of(glb.node("stool"))) {
    highest = std::max(highest, p.y());
    front = std::max(front, p.z());
  }
  CHECK(highest == Approx(2));
  CHECK(front == Approx(0.2).margin(1e-6));
}
