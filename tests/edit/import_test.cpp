// Scenes that another program has changed: the file is written by the exporter, and altered as other writers do.
#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/export/exporter.h"
#include "roomgen/edit/session.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

struct GlbFile {
  nlohmann::json gltf;
  std::string rest;
};

GlbFile parts_of_file(const std::string& bytes) {
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, 4);
  return {nlohmann::json::parse(bytes.substr(20, length)), bytes.substr(20 + length)};
}

std::string bytes_of(const GlbFile& file) {
  std::string json = file.gltf.dump();
  json.append((4 - json.size() % 4) % 4, ' ');
  const auto word = [](std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&number), 4);
  };
  return "glTF" + word(2) + word(20 + json.size() + file.rest.size()) + word(json.size()) + "JSON" + json + file.rest;
}

nlohmann::json& node(GlbFile& file, const std::string& name) {
  for (auto& one : file.gltf["nodes"])
    if (one.value("name", "") == name) return one;
  FAIL("no node " << name);
  throw;
}

/// A bedroom in a folder, and its file.
struct Bedroom {
  TemporaryFolder folder;
  std::unique_ptr<AssetLibrary> library = create::make_created_library();
  std::optional<Session> session;
  GlbFile file;

  Bedroom() {
    const auto designer = make_rule_designer();
    PlanRequest request;
    request.prompt = "a bedroom with a bed, two nightstands with a lamp on each, a desk with a laptop on it and a wardrobe, 5 x 5 m";
    const auto plan = designer->plan(request);
    REQUIRE(plan);
    const auto room = generate(*plan, *designer, *library, KindTable::built_in());
    REQUIRE(room);
    REQUIRE(write_file(folder / "scene.json", dump_json(to_json(room->scene))));
    auto opened = Session::open(folder / "scene.json", *library, KindTable::built_in());
    REQUIRE(opened);
    session.emplace(*std::move(opened));
    const auto glb = make_glb(session->scene(), session->models());
    REQUIRE(glb);
    file = parts_of_file(*glb);
  }

  Result<HandEdits> compare(const GlbFile& changed) {
    REQUIRE(write_file(folder / "edited.glb", bytes_of(changed)));
    const auto nodes = read_glb_nodes(folder / "edited.glb");
    if (!nodes) return nodes.error();
    return session->compare(*nodes);
  }
};

// All nodes of the scene under one that is moved and turned; where they are in the world stays.
void put_under_group(GlbFile& file, Random& random) {
  Eigen::Affine3d group = Eigen::Affine3d::Identity();
  group.translate(Vec3(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)));
  group.rotate(Eigen::AngleAxisd(random.uniform(-3, 3), Vec3(1, 2, random.uniform(-1, 1)).normalized()));
  auto& roots = file.gltf["scenes"][0]["nodes"];
  const auto column = [](const Eigen::Matrix4d& m) { return std::vector<double>(m.data(), m.data() + 16); };
  for (const auto& index : roots) {
    auto& one = file.gltf["nodes"][index.get<std::size_t>()];
    Eigen::Affine3d own = Eigen::Affine3d::Identity();
    if (one.contains("translation")) {
      const auto t = one["translation"].get<std::vector<double>>();
      own.translate(Vec3(t[0], t[1], t[2]));
    }
    if (one.contains("rotation")) {
      const auto q = one["rotation"].get<std::vector<double>>();
      own.rotate(Eigen::Quaterniond(q[3], q[0], q[1], q[2]));
    }
    if (one.contains("scale")) {
      const auto s = one["scale"].get<std::vector<double>>();
      own.scale(Vec3(s[0], s[1], s[2]));
    }
    for (const char* key : {"translation", "rotation", "scale"}) one.erase(key);
    one["matrix"] = column((group.inverse() * own).matrix());
  }
  const auto children = roots;
  file.gltf["nodes"].push_back({{"name", "group"}, {"matrix", column(group.matrix())}, {"children", children}});
  roots = {file.gltf["nodes"].size() - 1};
}

}  // namespace

TEST_CASE("A file that says the same in other words changes nothing") {
  Bedroom room;
  Random random(5);
  CHECK(room.compare(room.file)->operations.empty());
  for (int round = 0; round < 20; ++round) {
    GlbFile nested = room.file;
    put_under_group(nested, random);
    const auto edits = room.compare(nested);
    REQUIRE(edits);
    CHECK(edits->operations.empty());
    CHECK(edits->missing.empty());
    CHECK(edits->notes.empty());
  }
}

TEST_CASE("What changed places in another program changes places, with what stands on it") {
  Bedroom room;
  GlbFile swapped = room.file;
  std::swap(node(swapped, "nightstand-0")["translation"], node(swapped, "nightstand-1")["translation"]);
  const auto edits = room.compare(swapped);
  REQUIRE(edits);
  REQUIRE(edits->operations.size() == 1);
  const Scene before = room.session->scene();
  const auto report = room.session->apply(edits->operations, {"import"});
  INFO((report ? "" : report.error().message));
  REQUIRE(report);
  const Scene& after = room.session->scene();
  const Vec3 first = find_object(before, "nightstand-0")->position, second = find_object(after, "nightstand-1")->position;
  CHECK((first - second).norm() < 0.06);
  for (const auto& object : after.objects) {
    const Object& was = *find_object(before, object.id);
    const bool may_move = object.category == "nightstand" || !object.on.empty();
    if (!may_move) CHECK(object.position == was.position);
    CHECK(object.on == was.on);
  }
  CHECK(examine(after, room.session->models(), KindTable::built_in()).violations.empty());
  REQUIRE(room.session->undo());
  CHECK(dump_json(to_json(room.session->scene())) == dump_json(to_json(before)));
}

TEST_CASE("What three.js or Blender have renamed is found, and nothing counts as removed") {
  Bedroom room;
  const auto moved = [&](bool keeps_extras, const std::function<std::string(std::string)>& rename) {
    GlbFile file = room.file;
    auto& bed = node(file, "bed-0")["translation"];
    bed[0] = bed[0].get<double>() + 0.15;
    for (auto& one : file.gltf["nodes"]) {
      one["name"] = rename(one["name"]);
      if (!keeps_extras) one.erase("extras");
    }
    const auto edits = room.compare(file);
    REQUIRE(edits);
    CHECK(edits->missing.empty());
    REQUIRE(edits->operations.size() == 1);
    const auto& spots = std::get<edit::Arrange>(edits->operations[0]).spots;
    REQUIRE(spots.size() == 1);
    CHECK(spots[0].object == "bed-0");
  };
  const auto threejs = [](std::string name) {
    std::replace(name.begin(), name.end(), ' ', '_');
    std::erase_if(name, [](char c) { return std::string_view("[].:/").find(c) != std::string_view::npos; });
    return name;
  };
  moved(true, [](const std::string& name) { return name + ".002"; });
  moved(true, threejs);
  moved(false, threejs);
}

TEST_CASE("Nodes that cannot be followed are named, and the others are") {
  Bedroom room;
  GlbFile bad = room.file;
  node(bad, "wardrobe-0")["matrix"] = {1, 0.4, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  node(bad, "nightstand-1")["extras"].erase("id");
  node(bad, "nightstand-1")["name"] = "nightstand-1.001";
  node(bad, "bed-0")["rotation"] = {0.3, 0.0, 0.0, 0.954};
  auto& desk = node(bad, "desk-0")["translation"];
  desk[0] = desk[0].get<double>() + 0.01;
  const auto edits = room.compare(bad);
  REQUIRE(edits);
  CHECK(edits->missing == std::vector<std::string>{"nightstand-1"});
  const std::string notes = [&] {
    std::string all;
    for (const auto& note : edits->notes) all += note + "; ";
    return all;
  }();
  INFO(notes);
  CHECK(notes.find("wardrobe-0 is sheared") != std::string::npos);
  CHECK(notes.find("bed-0 is tilted") != std::string::npos);
  CHECK(notes.find("nightstand-1.001 is a copy of nightstand-1") != std::string::npos);
  REQUIRE(edits->operations.size() == 1);
  const auto& arrange = std::get<edit::Arrange>(edits->operations.front());
  REQUIRE(arrange.spots.size() == 1);
  CHECK(arrange.spots.front().object == "desk-0");
}

TEST_CASE("A scaled node is another size") {
  Bedroom room;
  GlbFile scaled = room.file;
  auto& wardrobe = node(scaled, "wardrobe-0");
  auto scale = wardrobe.value("scale", std::vector<double>{1, 1, 1});
  scale[1] *= 0.9;  // up, in glTF
  wardrobe["scale"] = scale;
  const auto edits = room.compare(scaled);
  REQUIRE(edits);
  REQUIRE(edits->operations.size() == 1);
  const auto& spot = std::get<edit::Arrange>(edits->operations.front()).spots.front();
  REQUIRE(spot.size);
  const Object before = *find_object(room.session->scene(), "wardrobe-0");
  CHECK(spot.size->z() == Approx(0.9 * before.size.z()).margin(1e-4));
  CHECK(spot.size->x() == Approx(before.size.x()).margin(1e-4));
  REQUIRE(room.session->apply(edits->operations));
  CHECK(find_object(room.session->scene(), "wardrobe-0")->size.z() == Approx(0.9 * before.size.z()).margin(1e-3));
}

TEST_CASE("Files that are no scene, or go in a circle, are refused") {
  Bedroom room;
  REQUIRE(write_file(room.folder / "junk.glb", "junk"));
  CHECK(!read_glb_nodes(room.folder / "junk.glb"));
  GlbFile circle = room.file;
  circle.gltf["nodes"].push_back({{"name", "a"}, {"children", {circle.gltf["nodes"].size()}}});
  CHECK(!room.compare(circle));
  GlbFile renamed = room.file;
  for (auto& one : renamed.gltf["nodes"]) {
    one["name"] = "x" + one.value("name", "");
    one.erase("extras");
  }
  CHECK(!room.compare(renamed));
  Random random(9);
  const std::string bytes = bytes_of(room.file);
  for (int round = 0; round < 300; ++round) {
    std::string broken = bytes.substr(0, round % 3 == 0 ? static_cast<std::size_t>(random.integer(0, 4000)) : bytes.size());
    for (int n = 0; n < 5 && !broken.empty(); ++n)
      broken[static_cast<std::size_t>(random.integer(0, static_cast<int>(std::min<std::size_t>(broken.size(), 8000)) - 1))] =
          static_cast<char>(random.integer(0, 255));
    REQUIRE(write_file(room.folder / "broken.glb", broken));
    if (const auto nodes = read_glb_nodes(room.folder / "broken.glb"); nodes) (void)room.session->compare(*nodes);
  }
}
