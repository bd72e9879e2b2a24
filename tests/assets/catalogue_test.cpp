#include "roomgen/assets/catalogue.h"

#include <Eigen/Geometry>
#include <chrono>
#include <fstream>
#include <thread>

#include "catch.h"
#include "fixture.h"

using namespace roomgen;
namespace fs = std::filesystem;

namespace {

assets::CatalogueOptions options_for(const fs::path& library, const TemporaryFolder& cache) {
  assets::CatalogueOptions options;
  options.libraries = {library};
  options.cache_dir = cache.path() / "cache";
  return options;
}

std::string warnings;

assets::CatalogueOptions listening(assets::CatalogueOptions options) {
  warnings.clear();
  options.log = [](LogLevel, std::string_view message) { warnings += std::string(message) + "\n"; };
  return options;
}

bool warned(const std::string& text) {
  return warnings.find(text) != std::string::npos;
}

// A thing that shows which way it was turned: a seat with a back at the rear (-Z) and one arm at
// its own left (+X), Y-up, front +Z.
std::string chair_obj() {
  std::string obj = "mtllib chair.mtl\nusemtl seat\n";
  int vertices = 0;
  const auto box = [&](double x0, double y0, double z0, double x1, double y1, double z1) {
    for (const double z : {z0, z1})
      for (const double y : {y0, y1})
        for (const double x : {x0, x1})
          obj +=
              "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    const int faces[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                             {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
    for (const auto& face : faces) {
      obj += "f";
      for (const int v : face) obj += " " + std::to_string(vertices + v);
      obj += "\n";
    }
    vertices += 8;
  };
  box(-25, 0, -25, 25, 45, 25);
  box(-25, 45, -25, 25, 90, -20);
  box(20, 45, -20, 25, 65, 25);
  return obj;
}

}  // namespace

TEST_CASE("A folder of meshes is a library, a sidecar tells what the mesh does not") {
  const TemporaryFolder folder;
  folder.write("mine/oak_dining-table.obj", cube_obj());
  folder.write("mine/thing7.obj", cube_obj());
  folder.write("mine/thing7.json", R"({"name": "My grandmother's seat", "category": "armchair",
    "size": [0.8, 0.9, 1.0], "license": "CC-BY-4.0", "creator": "Grandmother", "tags": ["velvet"],
    "support_height": 0.45})");
  auto catalogue = assets::open_catalogue(options_for(folder.path() / "mine", folder));
  if (!catalogue) FAIL(catalogue.error().message);

  const auto table = (*catalogue)->find("mine/oak_dining-table");
  REQUIRE(table);
  CHECK(table->name == "oak dining table");
  CHECK(table->category == "dining table");
  CHECK(table->support_height == Approx(1.0));

  const auto seat = (*catalogue)->find("thing7");
  REQUIRE(seat);
  CHECK(seat->category == "armchair");
  CHECK(seat->size.isApprox(Vec3(0.8, 0.9, 1.0)));
  CHECK(seat->ref.license == "CC-BY-4.0");
  CHECK(seat->ref.creator == "Grandmother");
  CHECK(seat->ref.sha256.size() == 64);
  const auto model = (*catalogue)->load(seat->ref);
  REQUIRE(model);
  CHECK((bounds(**model).size() - seat->size).norm() < 1e-5);
  CHECK(triangle_count(**model) == 12);

  const auto matches = (*catalogue)->search({.category = "easy chair", .description = "velvet"});
  REQUIRE(matches);
  REQUIRE(matches->size() == 1);
  CHECK(matches->front().asset.ref.id == "thing7");
}

TEST_CASE("A model stands on its bottom centre with its front to -Y, in metres") {
  const TemporaryFolder folder;
  folder.write("mine/chair.obj", chair_obj());
  folder.write("mine/chair.mtl", "newmtl seat\nKd 1 0 0\nmap_Kd C:\\\\tex\\\\lost.jpg\n");
  auto catalogue = assets::open_catalogue(listening(options_for(folder.path() / "mine", folder)));
  REQUIRE(catalogue);
  CHECK(warned("lost.jpg"));
  const auto info = (*catalogue)->find("chair");
  REQUIRE(info);
  CHECK(info->size.isApprox(Vec3(0.5, 0.5, 0.9), 1e-6));
  CHECK(info->colors == std::vector<std::string>{"red"});
  const auto model = (*catalogue)->load(info->ref);
  REQUIRE(model);
  const Bounds3 box = bounds(**model);
  CHECK(box.low.isApprox(Vec3(-0.25, -0.25, 0.0), 1e-6));
  for (const auto& part : (*model)->parts)
    for (const auto& p : part.mesh.positions) {
      if (p.z() > 0.66f)
        CHECK(p.y() > 0.19f);  // the back is at +Y
      else if (p.z() > 0.46f && p.y() < 0.19f)
        CHECK(p.x() > 0.19f);  // the arm at +X
    }
  CHECK((*model)->materials[0].base_color[0] > 0.9f);
}

TEST_CASE("Up and front of a sidecar turn the mesh") {
  const TemporaryFolder folder;
  folder.write("mine/wedge.obj",
               "v 0 0 0\nv 4 0 0\nv 0 1 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  folder.write("mine/wedge.json", R"({"up": "+z", "front": "+x", "units": "ft"})");
  auto catalogue = assets::open_catalogue(options_for(folder.path() / "mine", folder));
  REQUIRE(catalogue);
  const auto info = (*catalogue)->find("wedge");
  REQUIRE(info);
  // The file's x becomes depth, its y width.
  CHECK(info->size.isApprox(Vec3(0.3048, 4 * 0.3048, 2 * 0.3048), 1e-6));
}

TEST_CASE("A sidecar with mistakes is reported with its place, and the mesh left out") {
  const TemporaryFolder folder;
  folder.write("mine/good.obj", cube_obj());
  folder.write("mine/bad.obj", cube_obj());
  folder.write("mine/bad.json", R"({"size": [1, 2]})");
  folder.write("mine/worse.obj", cube_obj());
  folder.write("mine/worse.json", R"({"up": "+z", "front": "-z"})");
  auto catalogue = assets::open_catalogue(listening(options_for(folder.path() / "mine", folder)));
  REQUIRE(catalogue);
  CHECK(warned("bad.json: /size"));
  CHECK(warned("worse.json: /front"));
  CHECK((*catalogue)->find("good"));
  CHECK((*catalogue)->find("bad").error().kind == Error::Kind::not_found);
}

TEST_CASE("The catalogue is kept, and made again when a file changes") {
  const TemporaryFolder folder;
  folder.write("mine/table.obj", cube_obj());
  auto options = options_for(folder.path() / "mine", folder);
  int reads = 0;
  options.progress = [&](const assets::IndexProgress&) { ++reads; };
  REQUIRE(assets::open_catalogue(options));
  CHECK(reads == 1);
  REQUIRE(assets::open_catalogue(options));
  CHECK(reads == 1);
  folder.write("mine/sofa.obj", cube_obj());
  auto catalogue = assets::open_catalogue(options);
  REQUIRE(catalogue);
  CHECK(reads == 3);
  CHECK((*catalogue)->find("sofa"));
  fs::remove(folder.path() / "mine" / "table.obj");
  catalogue = assets::open_catalogue(options);
  REQUIRE(catalogue);
  CHECK_FALSE((*catalogue)->find("table"));
}

TEST_CASE("A damaged catalogue file is made again") {
  const TemporaryFolder folder;
  folder.write("mine/table.obj", cube_obj());
  const auto options = options_for(folder.path() / "mine", folder);
  REQUIRE(assets::open_catalogue(options));
  for (const auto& entry : fs::directory_iterator(options.cache_dir))
    std::ofstream(entry.path(), std::ios::binary) << "not a database";
  const auto catalogue = assets::open_catalogue(options);
  REQUIRE(catalogue);
  CHECK((*catalogue)->find("table"));
}

TEST_CASE("Several openers at once all get a whole catalogue and leave no rubbish") {
  const TemporaryFolder folder;
  for (int i = 0; i < 20; ++i) folder.write("mine/table" + std::to_string(i) + ".obj", cube_obj());
  const auto options = options_for(folder.path() / "mine", folder);
  std::atomic<int> good = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      const auto catalogue = assets::open_catalogue(options);
      if (catalogue && (*catalogue)->all()->size() == 20) ++good;
    });
  for (auto& thread : threads) thread.join();
  CHECK(good == 4);
  // The catalogue and its seal.
  CHECK(std::distance(fs::directory_iterator(options.cache_dir), fs::directory_iterator()) == 2);
}

TEST_CASE("A catalogue with any damaged bytes is made anew") {
  const TemporaryFolder folder;
  for (int i = 0; i < 5; ++i) folder.write("mine/table" + std::to_string(i) + ".obj", cube_obj());
  auto options = options_for(folder.path() / "mine", folder);
  REQUIRE(assets::open_catalogue(options));
  fs::path file;
  for (const auto& entry : fs::directory_iterator(options.cache_dir))
    if (entry.path().extension() == ".sqlite") file = entry.path();
  std::string told;
  options.log = [&](LogLevel level, std::string_view text) {
    if (level == LogLevel::warning) told += text;
  };
  const auto size = fs::file_size(file);
  for (std::uintmax_t at = 64; at < size; at += size / 12) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(at));
    stream << std::string(40, '\x5a');
    stream.close();
    told.clear();
    const auto catalogue = assets::open_catalogue(options);
    REQUIRE(catalogue);
    CHECK((*catalogue)->all()->size() == 5);
    CHECK(told.find("damaged") != std::string::npos);
  }
}

TEST_CASE("A mesh that was too much for its reader is named, and tried again only when it changes") {
  const TemporaryFolder folder;
  folder.write("mine/table.obj", cube_obj());
  folder.write("mine/cut.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty floa");
  auto options = options_for(folder.path() / "mine", folder);
  auto catalogue = assets::open_catalogue(options);
  REQUIRE(catalogue);
  auto left_out = (*catalogue)->left_out();
  REQUIRE(left_out);
  REQUIRE(left_out->size() == 1);
  CHECK(left_out->front().mesh == "cut.ply");
  CHECK(left_out->front().too_much);
  CHECK((*catalogue)->all()->size() == 1);

  folder.write("mine/table2.obj", cube_obj());
  catalogue = assets::open_catalogue(options);
  REQUIRE(catalogue);
  CHECK((*catalogue)->left_out()->size() == 1);
  folder.write("mine/cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                               "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                               "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  catalogue = assets::open_catalogue(options);
  REQUIRE(catalogue);
  CHECK((*catalogue)->left_out()->empty());
  CHECK((*catalogue)->all()->size() == 3);
}

TEST_CASE("Indexing that was stopped leaves no catalogue") {
  const TemporaryFolder folder;
  folder.write("mine/table.obj", cube_obj());
  auto options = options_for(folder.path() / "mine", folder);
  options.cancel.cancel();
  const auto catalogue = assets::open_catalogue(options);
  REQUIRE_FALSE(catalogue);
  CHECK(catalogue.error().kind == Error::Kind::cancelled);
  CHECK(fs::is_empty(options.cache_dir));
}

TEST_CASE("A mount that an asset does not have is no match") {
  const TemporaryFolder folder;
  folder.write("mine/wardrobe.obj", cube_obj());
  auto catalogue = assets::open_catalogue(options_for(folder.path() / "mine", folder));
  REQUIRE(catalogue);
  CHECK((*catalogue)->search({.category = "wardrobe", .mount = Mount::floor})->size() == 1);
  CHECK((*catalogue)->search({.category = "wardrobe", .mount = Mount::wall})->empty());
}

TEST_CASE("The installed furniture is whole: boxes, normals, licences") {
  const auto* catalogue = furniture();
  if (!catalogue) return;
  const auto all = catalogue->all();
  REQUIRE(all);
  CHECK(all->size() == 789);  // of 795, without the six that do not stand
  std::size_t index = 0;
  for (const auto& info : *all) {
    INFO(info.ref.library << "/" << info.ref.id);
    CHECK_FALSE(info.ref.license.empty());
    CHECK_FALSE(info.ref.creator.empty());
    CHECK_FALSE(info.category.empty());
    if (index++ % 16 != 0) continue;  // reading all of them takes long under sanitizers
    const auto model = catalogue->load(info.ref);
    REQUIRE(model);
    const Bounds3 box = bounds(**model);
    for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(box.size()[axis] - info.size[axis]) < 2e-3);
    CHECK(std::abs(box.low.z()) < 1e-6);
    for (const auto& part : (*model)->parts) {
      CHECK(part.mesh.normals.size() == part.mesh.positions.size());
      const bool unit =
          std::all_of(part.mesh.normals.begin(), part.mesh.normals.end(),
                      [](const auto& n) { return std::abs(n.norm() - 1.0f) < 1e-3f; });
      CHECK(unit);
    }
  }
}

TEST_CASE("Two sofas of the public-domain library carry their own licence") {
  const auto* catalogue = furniture();
  if (!catalogue) return;
  CHECK(catalogue->find("winchesterSofa")->ref.license == "CC-BY-3.0");
  CHECK(catalogue->find("winchesterArmchair")->ref.license == "CC-BY-3.0");
  CHECK(catalogue->find("BlendSwap-CC-0/oakTable")->ref.license == "CC0-1.0");
  CHECK(catalogue->find("KatorLegaz/oriental-rug")->ref.license == "CC-BY-3.0-US");
}

TEST_CASE("Furniture is known to hang, stand and carry") {
  const auto* catalogue = furniture();
  if (!catalogue) return;
  CHECK(catalogue->find("kitchenUpperCabinet")->mount == Mount::wall);
  CHECK(catalogue->find("kitchenUpperCabinet")->elevation == Approx(1.45));
  CHECK(catalogue->find("chandelier-lamp")->mount == Mount::ceiling);
  CHECK(catalogue->find("BlendSwap-CC-BY/laptop")->mount == Mount::surface);
  CHECK(catalogue->find("BlendSwap-CC-0/bed1")->mount == Mount::floor);
  CHECK(catalogue->find("oakTable")->support_height);
  CHECK(catalogue->find("oakTable")->round);
  CHECK_FALSE(catalogue->find("chandelier-lamp")->support_height);
}
