#include "decode/decoder.h"

#include "catch.h"
#include "decode/obj_numbers.h"
#include "meshes.h"
#include "roomgen/base/file.h"

using namespace roomgen;
using decode::Decoder;

namespace {

// Less time than usual: half of the bad meshes take all that there is.
decode::DecoderOptions built() { return {.program = ROOMGEN_DECODER, .seconds = 1.0}; }

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

std::string gltf(const std::string& rest) { return R"({"asset":{"version":"2.0"},)" + rest + "}"; }

std::string node_chain(int length) {
  std::string nodes;
  for (int i = 0; i + 1 < length; ++i) nodes += R"({"children":[)" + std::to_string(i + 1) + "]},";
  return gltf(R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes + "{}]");
}

// Each node twice in the one above: 2^30 of them once they are unfolded.
std::string node_tree() {
  std::string nodes;
  for (int i = 1; i < 30; ++i) {
    const std::string next = std::to_string(i);
    nodes += R"({"children":[)" + next + "," + next + "]},";
  }
  return gltf(R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes + "{}]");
}

std::string wide_face(int corners) {
  std::string vertices, face = "f";
  for (int i = 1; i <= corners; ++i) {
    vertices += "v " + std::to_string(i) + " " + std::to_string(i % 7) + " 0\n";
    face += " " + std::to_string(i);
  }
  return vertices + face + "\n";
}

// Files that made a reader in the program itself crash, hang or take gigabytes.
std::map<std::string, std::string> bad_meshes() {
  using namespace std::string_literals;
  return {
      {"cut.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty floa"},
      {"face.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                   "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n0\n"},
      {"chain.gltf", node_chain(100000)},
      {"skin.gltf", gltf(R"("skins":[{"joints":[0]}],"nodes":[{"mesh":0,"skin":0}])")},
      {"tree.gltf", node_tree()},
      {"huge.glb", "glTF\x02\0\0\0\xff\xff\xff\xff\xf0\xff\xff\xffJSON{}"s},
      {"circle.dae", R"(<COLLADA version="1.4.1"><library_nodes><node id="a"><instance_node url="#b"/></node>)"
                     R"(<node id="b"><instance_node url="#a"/></node></library_nodes><library_visual_scenes>)"
                     R"(<visual_scene id="s"><node id="r"><instance_node url="#a"/></node></visual_scene>)"
                     R"(</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)"},
      {"deep.fbx", "; FBX 7.3.0 project file\n" + repeated("A: {\n", 100000)},
      {"wide.obj", wide_face(300000)}};
}

}  // namespace

TEST_CASE("A process of its own reads what reading in this one gives") {
  const auto tree = tree_of({{"cube.obj", cube_obj()}, {"cube.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n"}});
  Decoder apart(built()), here({.in_process = true});
  const auto a = apart.decode(tree, "cube.obj", {}), b = here.decode(tree, "cube.obj", {});
  REQUIRE(a);
  REQUIRE(b);
  REQUIRE(a->parts.size() == 2);
  REQUIRE(b->parts.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(a->parts[i].mesh.positions == b->parts[i].mesh.positions);
    CHECK(a->parts[i].mesh.triangles == b->parts[i].mesh.triangles);
    CHECK(a->materials[i].name == b->materials[i].name);
    CHECK(a->materials[i].base_color == b->materials[i].base_color);
  }
  CHECK(triangle_count(*a) == 12);
}

TEST_CASE("A mesh that kills or overruns its reader costs only itself") {
  auto files = bad_meshes();
  files["cube.obj"] = cube_obj();
  const auto tree = tree_of(files);
  Decoder decoder(built());
  for (const auto& [name, bytes] : bad_meshes()) {
    const auto model = decoder.decode(tree, name, {});
    INFO(name);
    REQUIRE_FALSE(model);
    INFO(model.error().message);
    CHECK(model.error().message.starts_with(name + ": "));
    CHECK(model.error().message.find('\n') == std::string::npos);
    CHECK(model.error().message.find("std::") == std::string::npos);
    const bool of_the_file =
        model.error().kind == Error::Kind::limit || model.error().kind == Error::Kind::invalid_input;
    CHECK(of_the_file);
    CHECK(decoder.decode(tree, "cube.obj", {}));
  }
}

TEST_CASE("A picture is read apart as it is here, and a bad one costs only itself") {
  Decoder apart(built()), here({.in_process = true});
  const auto bytes = [](const std::string& name) {
    return *read_file(std::filesystem::path(ROOMGEN_SOURCE_DIR) / "tests/fuzz/corpus/decoder_input" / name);
  };
  for (const char* name : {"small.png", "torn.png", "huge.png", "wide.png"}) {
    const auto a = apart.decode_picture(bytes(name), 64), b = here.decode_picture(bytes(name), 64);
    INFO(name);
    REQUIRE(a.ok() == b.ok());
    if (a) CHECK(a->pixels == b->pixels);
    else CHECK(a.error().message == b.error().message);
  }
  CHECK(apart.decode_picture(bytes("small.png"), 64));
  const auto none = apart.decode_picture("no picture", 64);
  REQUIRE_FALSE(none);
  CHECK(none.error().message.starts_with("picture: "));
}

TEST_CASE("Files are read by the format that their name says") {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto tree = tree_of({{"a.ply", ply}, {"b.off", ply}, {"c.x3d", "<X3D/>"}, {"d.md5mesh", ""}});
  Decoder decoder(built());
  CHECK(decoder.decode(tree, "a.ply", {}));
  for (const char* other : {"b.off", "c.x3d", "d.md5mesh"}) CHECK_FALSE(decoder.decode(tree, other, {}));
}

TEST_CASE("Numbers of Wavefront files may begin with their point") {
  const char* name = "point four stool.obj";
  const auto tree = tree_of({{name, *read_file(std::filesystem::path(ROOMGEN_TEST_DATA) / "meshes" / name)}});
  Decoder decoder(built());
  const auto model = decoder.decode(tree, name, {});
  REQUIRE(model);
  CHECK(triangle_count(*model) == 12);
  const auto box = bounds(*model);
  CHECK((box.high - box.low - Vec3(0.4, 0.45, 0.4)).norm() < 1e-6);
  // Nothing but numbers of vertices is touched.
  const std::string others = "mtllib a .4.mtl\no chair .5\nv 1 -.5 1.5 # a.b\nvt 0.5\t1.\nusemtl oak .3\nf 1 2 3\n# v .4\n";
  CHECK(decode::with_leading_zeros(others) == others);
  CHECK(decode::with_leading_zeros("  v .4\t.5 \\\r\n .6\r\nvn .1 0 .2\no .5") ==
        "  v 0.4\t0.5 \\\r\n 0.6\r\nvn 0.1 0 0.2\no .5");
}

TEST_CASE("Several libraries are read by one decoder, each with files of its own") {
  const auto one = tree_of({{"cube.obj", cube_obj()}});
  const auto two = tree_of({{"empty.obj", ""}, {"more/cube.obj", cube_obj()}});
  Decoder decoder(built());
  for (int round = 0; round < 3; ++round) {
    CHECK(decoder.decode(one, "cube.obj", {}));
    CHECK(decoder.decode(two, "more/cube.obj", {}));
    CHECK_FALSE(decoder.decode(two, "empty.obj", {}));
    CHECK_FALSE(decoder.decode(two, "cube.obj", {}));
  }
}

TEST_CASE("A decoder stops when it is told to") {
  const auto tree = tree_of(bad_meshes());
  auto options = built();
  Decoder decoder(options);
  options.cancel.cancel();
  const auto model = decoder.decode(tree, "cut.ply", {});
  REQUIRE_FALSE(model);
  CHECK(model.error().kind == Error::Kind::cancelled);
}

TEST_CASE("What holds the decoder is said, and can be required") {
  const auto report = decode::decoder_confinement(built());
  REQUIRE(report);
  CHECK(report->size() == 3);
  const bool filtered = report->at(1).find("not") == std::string::npos;
  auto options = built();
  options.require_sandbox = true;
  const auto tree = tree_of({{"cube.obj", cube_obj()}});
  const auto model = Decoder(options).decode(tree, "cube.obj", {});
  CHECK(model.ok() == filtered);
  if (!model) CHECK(model.error().kind == Error::Kind::unavailable);
}
