// What each model of the installed furniture libraries looks like, for who writes down what it is: four views of it as
// one picture, and a line of JSON with its size and its materials (name, share of the surface, mean colour).
//
//     bench_asset_portraits FOLDER [PIXELS]
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "roomgen/assets/catalogue.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/render/pictures.h"

namespace {

using namespace roomgen;

double surface(const Mesh& mesh) {
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    area += 0.5 * static_cast<double>((b - a).cross(c - a).norm());
  }
  return area;
}

// Of base colour times texture, sRGB 0 to 255; texels count alike.
std::array<int, 3> mean_color(const Material& material) {
  std::array<double, 3> sum{};
  double weight = 0.0;
  if (material.texture)
    for (std::size_t i = 0; i + 3 < material.texture->pixels.size(); i += 4) {
      const double alpha = material.texture->pixels[i + 3] / 255.0;
      for (std::size_t c = 0; c < 3; ++c) sum[c] += alpha * material.texture->pixels[i + c];
      weight += alpha;
    }
  std::array<int, 3> mean{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double texel = weight > 0.0 ? sum[c] / weight / 255.0 : 1.0;
    mean[c] = static_cast<int>(255.0 * std::clamp(texel * std::pow(material.base_color[c], 1.0 / 2.2), 0.0, 1.0) + 0.5);
  }
  return mean;
}

Json materials_json(const Model& model) {
  std::vector<double> areas(model.materials.size(), 0.0);
  double all = 0.0;
  for (const auto& part : model.parts) {
    const double area = surface(part.mesh);
    areas[static_cast<std::size_t>(part.material)] += area;
    all += area;
  }
  Json list = Json::array();
  for (std::size_t m = 0; m < areas.size(); ++m) {
    const Material& material = model.materials[m];
    list.push_back({{"name", material.name},
                    {"share", rounded(all > 0.0 ? areas[m] / all : 0.0, 3)},
                    {"rgb", mean_color(material)},
                    {"alpha", rounded(material.base_color[3], 2)},
                    {"metallic", rounded(material.metallic, 2)},
                    {"roughness", rounded(material.roughness, 2)}});
  }
  return list;
}

Status portray(const assets::Catalogue& catalogue, const AssetInfo& info, const std::filesystem::path& folder, int pixels,
               std::string& lines) {
  const auto model = catalogue.load(info.ref);
  if (!model) return model.error();
  const auto views = draw_views(**model, pixels);
  if (!views) return views.error();
  const auto place = folder / info.ref.library;
  if (auto status = make_folder(place); !status) return status;
  const Json line = {{"library", info.ref.library}, {"id", info.ref.id},     {"name", info.name},
                     {"category", info.category},   {"tags", info.tags},     {"size", {info.size.x(), info.size.y(), info.size.z()}},
                     {"mount", name(info.mount)},   {"colors", info.colors}, {"materials", materials_json(**model)}};
  lines += line.dump() + "\n";
  return write_png(place / (info.ref.id + ".png"), contact_sheet(*views, 4));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::puts("bench_asset_portraits FOLDER [PIXELS]"), 2;
  const std::filesystem::path folder = argv[1];
  const int pixels = argc > 2 ? std::atoi(argv[2]) : 224;
  const auto catalogue = assets::open_catalogue({});
  const auto all = catalogue ? (*catalogue)->all() : Result<std::vector<AssetInfo>>(catalogue.error());
  if (!all) return std::fprintf(stderr, "%s\n", all.error().message.c_str()), 1;
  std::string lines;
  for (const auto& info : *all)
    if (auto status = portray(**catalogue, info, folder, pixels, lines); !status)
      std::fprintf(stderr, "%s/%s: %s\n", info.ref.library.c_str(), info.ref.id.c_str(), status.error().message.c_str());
  return write_file(folder / "assets.jsonl", lines) ? 0 : 1;
}
