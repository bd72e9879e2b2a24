#include <algorithm>
#include <cstdint>
#include <cstring>

#include "catch.h"
#include "fixture.h"

using namespace roomgen;

namespace {

// A 1 x 1 PNG, pure red.
const unsigned char red_png[] = {
    0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48,
    0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00,
    0x00, 0x90, 0x77, 0x53, 0xDE, 0x00, 0x00, 0x00, 0x0C, 0x49, 0x44, 0x41, 0x54, 0x78,
    0xDA, 0x63, 0xF8, 0xCF, 0xC0, 0x00, 0x00, 0x03, 0x01, 0x01, 0x00, 0xF7, 0x03, 0x41,
    0x43, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};

template <typename T>
void put(std::string& out, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

void pad(std::string& chunk, char fill) {
  while (chunk.size() % 4 != 0) chunk += fill;
}

// A wall of 2 m x 1 m at z = 0.5 that looks to +Z, textured red, as one GLB file.
std::string textured_quad_glb() {
  std::string bin;
  const float corners[4][3] = {{-1, 0, 0.5f}, {1, 0, 0.5f}, {1, 1, 0.5f}, {-1, 1, 0.5f}};
  for (const auto& corner : corners)
    for (const float value : corner) put(bin, value);
  const float uvs[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  for (const auto& uv : uvs)
    for (const float value : uv) put(bin, value);
  for (const std::uint16_t index : {0, 1, 2, 0, 2, 3}) put(bin, index);
  bin.append(reinterpret_cast<const char*>(red_png), sizeof red_png);
  const std::string size = std::to_string(bin.size()), image = std::to_string(sizeof red_png);
  pad(bin, '\0');
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]}],)"
      R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"roughnessFactor":0.25,"metallicFactor":0}}],)"
      R"("textures":[{"source":0}],"images":[{"bufferView":3,"mimeType":"image/png"}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,0,0.5],"max":[1,1,0.5]},)"
      R"({"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"},)"
      R"({"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"}],)"
      R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":32},)"
      R"({"buffer":0,"byteOffset":80,"byteLength":12},{"buffer":0,"byteOffset":92,"byteLength":)" +
      image + R"(}],"buffers":[{"byteLength":)" + size + "}]}";
  pad(json, ' ');
  std::string glb = "glTF";
  put(glb, std::uint32_t{2});
  put(glb, static_cast<std::uint32_t>(28 + json.size() + bin.size()));
  put(glb, static_cast<std::uint32_t>(json.size()));
  glb += "JSON" + json;
  put(glb, static_cast<std::uint32_t>(bin.size()));
  glb += std::string("BIN\0", 4) + bin;
  return glb;
}

}  // namespace

TEST_CASE("A GLB file with an embedded texture is read, in metres, front +Z to -Y") {
  const TemporaryFolder folder;
  folder.write("mine/sub/wall picture.glb", textured_quad_glb());
  assets::CatalogueOptions options;
  options.libraries = {folder.path() / "mine"};
  options.cache_dir = folder.path() / "cache";
  const auto catalogue = assets::open_catalogue(options);
  if (!catalogue) FAIL(catalogue.error().message);
  const auto info = (*catalogue)->find("mine/sub/wall picture");
  REQUIRE(info);
  CHECK(info->category == "picture");
  CHECK(info->mount == Mount::wall);
  CHECK(info->colors == std::vector<std::string>{"red"});
  CHECK(info->size.x() == Approx(2.0));
  CHECK(info->size.z() == Approx(1.0));

  const auto model = (*catalogue)->load(info->ref);
  REQUIRE(model);
  REQUIRE((*model)->parts.size() == 1);
  const Mesh& mesh = (*model)->parts[0].mesh;
  for (const auto& normal : mesh.normals) CHECK(normal.y() == Approx(-1.0f));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    CHECK(mesh.uvs[i].x() == Approx(mesh.positions[i].x() < 0 ? 0.0f : 1.0f));
    CHECK(mesh.uvs[i].y() == Approx(mesh.positions[i].z() < 0.5f ? 1.0f : 0.0f));  // v from the top
  }
  const Material& material = (*model)->materials[0];
  REQUIRE(material.texture);
  CHECK(material.texture->at(0, 0)[0] == 255);
  CHECK(material.roughness == Approx(0.25f));
}

TEST_CASE("Damaged GLB files are left out or read, and never crash") {
  const TemporaryFolder folder;
  const std::string good = textured_quad_glb();
  folder.write("mine/good.glb", good);
  for (std::size_t at = 4; at < good.size(); at += 13) {
    std::string damaged = good;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x15);
    folder.write("mine/damaged" + std::to_string(at) + ".glb", damaged);
    if (at % 5 == 0) folder.write("mine/short" + std::to_string(at) + ".glb", good.substr(0, at));
  }
  assets::CatalogueOptions options;
  options.libraries = {folder.path() / "mine"};
  options.cache_dir = folder.path() / "cache";
  const auto catalogue = assets::open_catalogue(options);
  REQUIRE(catalogue);
  CHECK((*catalogue)->find("good"));
}
