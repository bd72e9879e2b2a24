#include <chrono>
#include <fstream>
#include <sstream>

#include "assets/properties.h"
#include "catch.h"
#include "fixture.h"
#include "roomgen/base/file.h"

using namespace roomgen;
namespace fs = std::filesystem;

namespace {

constexpr const char* table_properties =
    "id=Test\nname=Test\nlicense=CC0\n"
    "id#1=Test#table\nname#1=Table\\u00e9\ntags#1=\ncategory#1=Living room\nicon#1=/t.png\n"
    "model#1=/t/table.obj\nwidth#1=120\ndepth#1=80\nheight#1=75\ncreator#1=Some\\\n  one\n";

Result<std::unique_ptr<assets::Catalogue>> open(const TemporaryFolder& folder,
                                                const fs::path& library,
                                                std::string* warnings = nullptr) {
  assets::CatalogueOptions options;
  options.libraries = {library};
  options.cache_dir = folder.path() / "cache";
  if (warnings)
    options.log = [warnings](LogLevel, std::string_view text) {
      *warnings += std::string(text) + "\n";
    };
  return assets::open_catalogue(options);
}

bool one_line(const std::string& message) {
  return !message.empty() && message.find('\n') == std::string::npos;
}

std::string table_archive(const TemporaryFolder& folder, const std::vector<ZipEntry>& more = {},
                          const std::string& mesh = cube_obj()) {
  std::vector<ZipEntry> entries = {{"PluginFurnitureCatalog.properties", table_properties},
                                   {"t/table.obj", mesh}};
  entries.insert(entries.end(), more.begin(), more.end());
  const fs::path path = folder.path() / "test.sh3f";
  write_zip(path, entries);
  return path;
}

}  // namespace

TEST_CASE("A small .sh3f archive is read") {
  const TemporaryFolder folder;
  const auto catalogue = open(folder, table_archive(folder));
  if (!catalogue) FAIL(catalogue.error().message);
  const auto table = (*catalogue)->find("test/table");
  REQUIRE(table);
  CHECK(table->name == "Table\xC3\xA9");
  CHECK(table->ref.creator == "Someone");
  CHECK(table->ref.license == "CC0-1.0");
  CHECK(table->size.isApprox(Vec3(1.2, 0.8, 0.75)));
}

TEST_CASE("A broken .sh3f is one clear line") {
  const TemporaryFolder folder;
  const auto bytes = *read_file(table_archive(folder));
  const std::string text = "this is no archive";
  for (const auto& broken : {bytes.substr(0, bytes.size() / 2), text, std::string()}) {
    const auto catalogue = open(folder, folder.write("broken.sh3f", broken));
    REQUIRE_FALSE(catalogue);
    CHECK(one_line(catalogue.error().message));
    CHECK(catalogue.error().message.find("broken.sh3f") != std::string::npos);
  }
}

TEST_CASE("An archive with damaged bytes inside never crashes") {
  const TemporaryFolder folder;
  const auto bytes = *read_file(table_archive(folder));
  for (std::size_t at = 0; at < bytes.size(); at += 7) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x5A);
    const auto catalogue = open(folder, folder.write("damaged.sh3f", damaged));
    if (!catalogue) CHECK(one_line(catalogue.error().message));
  }
}

TEST_CASE("Entries that lead outside an archive are left out") {
  const TemporaryFolder folder;
  std::string warnings;
  const auto path = table_archive(folder, {{"../evil.obj", cube_obj()},
                                           {"/abs.obj", cube_obj()},
                                           {"C:\\evil.obj", cube_obj()},
                                           {"a/../../evil2.obj", cube_obj()}});
  const auto catalogue = open(folder, path, &warnings);
  REQUIRE(catalogue);
  for (const auto* name : {"../evil.obj", "/abs.obj", "C:\\evil.obj", "a/../../evil2.obj"})
    CHECK(warnings.find(name) != std::string::npos);
  CHECK((*catalogue)->all()->size() == 1);
  CHECK_FALSE(fs::exists(folder.path().parent_path() / "evil.obj"));
}

TEST_CASE("A model path that leads outside is refused") {
  const TemporaryFolder folder;
  folder.write("secret.obj", cube_obj());
  std::string properties = table_properties;
  properties.replace(properties.find("/t/table.obj"), 12, "../secret.obj");
  write_zip(folder.path() / "test.sh3f",
            {{"PluginFurnitureCatalog.properties", properties}, {"t/table.obj", cube_obj()}});
  CHECK_FALSE(open(folder, folder.path() / "test.sh3f"));
}

TEST_CASE("Materials and textures are looked for in the model's folder only") {
  const TemporaryFolder folder;
  folder.write("secret.mtl", "newmtl m\nKd 1 0 0\n");
  folder.write("mine/table.obj", "mtllib ../secret.mtl\nusemtl m\n" + cube_obj());
  folder.write("mine/chair.obj", "mtllib chair.mtl\nusemtl m\n" + cube_obj());
  folder.write("mine/chair.mtl",
               "newmtl m\nKd 0 0 1\nmap_Kd " + (folder.path() / "secret.png").string() + "\t \n");
  std::string warnings;
  const auto catalogue = open(folder, folder.path() / "mine", &warnings);
  REQUIRE(catalogue);
  CHECK((*catalogue)->find("table")->colors != std::vector<std::string>{"red"});
  CHECK((*catalogue)->find("chair")->colors == std::vector<std::string>{"blue"});
  CHECK(warnings.find("secret.png") != std::string::npos);
}

TEST_CASE("Links that lead out of a folder are left out") {
  const TemporaryFolder folder;
  folder.write("secret/sofa.obj", cube_obj());
  folder.write("mine/table.obj", cube_obj());
  fs::create_symlink(folder.path() / "secret" / "sofa.obj", folder.path() / "mine" / "sofa.obj");
  fs::create_directory_symlink(folder.path() / "secret", folder.path() / "mine" / "more");
  const auto catalogue = open(folder, folder.path() / "mine");
  REQUIRE(catalogue);
  CHECK((*catalogue)->all()->size() == 1);
}

TEST_CASE("Meshes without triangles are left out with a warning") {
  const TemporaryFolder folder;
  folder.write("mine/table.obj", cube_obj());
  folder.write("mine/empty.obj", "");
  folder.write("mine/points.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\n");
  folder.write("mine/line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
  folder.write("mine/flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  folder.write("mine/nan.obj", "v nan nan nan\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  folder.write("mine/range.obj", "v 0 0 0\nf 1 99 -7\n");
  folder.write("mine/rubbish.glb", std::string("glTF\x02\0\0\0\xFF\xFF\xFF\x7F", 12));
  std::string warnings;
  const auto catalogue = open(folder, folder.path() / "mine", &warnings);
  if (!catalogue) FAIL(catalogue.error().message);
  CHECK((*catalogue)->all()->size() == 1);
  for (const auto* name :
       {"empty.obj", "points.obj", "line.obj", "flat.obj", "nan.obj", "range.obj", "rubbish.glb"})
    CHECK(warnings.find(name) != std::string::npos);
}

TEST_CASE("A mesh larger than any furniture is left out with a warning") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "things");
  folder.write("things/cube.obj", cube_obj());
  folder.write("things/vast.obj", "v 0 0 0\nv 1e30 0 0\nv 0 1e30 0\nv 0 0 1e30\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n");
  std::string warnings;
  const auto catalogue = open(folder, folder.path() / "things", &warnings);
  REQUIRE(catalogue);
  CHECK((*catalogue)->all()->size() == 1);
  REQUIRE((*catalogue)->left_out()->size() == 1);
  CHECK((*catalogue)->left_out()->front().reason.find("larger than 1000 m") != std::string::npos);
}

TEST_CASE("A library of nothing usable is an error") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "mine");
  CHECK(one_line(open(folder, folder.path() / "mine").error().message));
  folder.write("mine/empty.obj", "");
  CHECK(one_line(open(folder, folder.path() / "mine").error().message));
  CHECK(open(folder, folder.path() / "none").error().kind == Error::Kind::not_found);
  CHECK(one_line(open(folder, folder.write("sofa.txt", "sofa")).error().message));
}

TEST_CASE("A mesh of two million triangles is refused soon and clearly") {
  const TemporaryFolder folder;
  constexpr int side = 1000;
  std::ostringstream obj;
  for (int y = 0; y <= side; ++y)
    for (int x = 0; x <= side; ++x) obj << "v " << x << ' ' << y << " 0\n";
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const int a = y * (side + 1) + x + 1, b = a + side + 1;
      obj << "f " << a << ' ' << a + 1 << ' ' << b + 1 << "\nf " << a << ' ' << b + 1 << ' ' << b
          << '\n';
    }
  folder.write("mine/huge.obj", obj.str());
  folder.write("mine/table.obj", cube_obj());
  std::string warnings;
  const auto start = std::chrono::steady_clock::now();
  const auto catalogue = open(folder, folder.path() / "mine", &warnings);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  REQUIRE(catalogue);
  CHECK(warnings.find("huge.obj: ") != std::string::npos);
  CHECK(warnings.find("500000 triangles") != std::string::npos);
  CHECK(elapsed.count() < 20.0);
  CHECK((*catalogue)->all()->size() == 1);
}

TEST_CASE("A cache folder that cannot be made is one clear line") {
  const TemporaryFolder folder;
  folder.write("mine/table.obj", cube_obj());
  folder.write("cache", "a file where the folder should be");
  const auto catalogue = open(folder, folder.path() / "mine");
  REQUIRE_FALSE(catalogue);
  CHECK(one_line(catalogue.error().message));
}

TEST_CASE("Absurd queries get an answer, if an empty one") {
  const TemporaryFolder folder;
  folder.write("mine/table.obj", cube_obj());
  const auto catalogue = open(folder, folder.path() / "mine");
  REQUIRE(catalogue);
  for (const std::string& text :
       {std::string(), std::string("\"' OR 1=1 --"), std::string(100000, 'x'),
        std::string("\xFF\xFE"), std::string("NEAR(*) : ^"), std::string("table table table"),
        std::string("табуретка")}) {
    CHECK((*catalogue)->search({.category = text, .description = text}));
    CHECK((*catalogue)->search({.description = text, .limit = 0}));
  }
  CHECK((*catalogue)->search({.category = "table", .size = Vec3(0, -1, 1e308)}));
}

TEST_CASE("A line of properties goes on as long as lines end in a lone backslash") {
  const auto value = [](const std::string& text) {
    const auto all = assets::parse_properties("a=" + text + "\nb=last\n");
    REQUIRE(all);
    CHECK(all->count("b") == 1);
    return all->at("a");
  };
  CHECK(value("one") == "one");
  CHECK(value("one\\\n  two") == "onetwo");
  CHECK(value("one\\\\") == "one\\");
  CHECK(value("one\\\\\\\ntwo") == "one\\two");
  CHECK(value("one\\\n\\\n two\\\nthree") == "onetwothree");
  // Backslashes before the end of one line do not count for the next.
  CHECK(value("\\\\\\\n\\\n\\\\") == "\\\\");
  std::string many;
  for (int i = 0; i <= 2'000'000; ++i) many += std::to_string(i) + "\n";
  CHECK(!assets::parse_properties(many));
}
