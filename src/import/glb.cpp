#include "roomgen/import/import.h"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/json_reader.h"
#include "geometry/conventions.h"
#include "glb_file.h"

namespace roomgen {

namespace {

constexpr long long component_float = 5126, component_uint16 = 5123, component_uint32 = 5125;
constexpr long long most = 1ll << 40;  // of any offset or count
constexpr std::size_t most_elements = 1'000'000;
constexpr std::size_t longest_name = 1 << 20;  // the key of a thing made from words
constexpr double widest = 1e6;  // of a factor or colour that is believed

class GlbReader {
 public:
  GlbReader(const Json& gltf, std::string_view binary, const ImageDecoder& decode,
            JsonReader::Problems& problems)
      : root_(gltf, problems), binary_(binary), decode_(decode) {
    accessors_ = root_["accessors"].elements_or_none(most_elements);
    views_ = root_["bufferViews"].elements_or_none(most_elements);
  }

  ModelTable read() {
    for (const auto& material : root_["materials"].elements_or_none(most_elements))
      materials_.push_back(read_material(material));
    ModelTable models;
    for (const auto& mesh : root_["meshes"].elements_or_none(most_elements))
      models.add(key_of(mesh), std::make_shared<const Model>(read_model(mesh)));
    return models;
  }

 private:
  static std::optional<std::size_t> index_in(const std::vector<JsonReader>& list,
                                             const JsonReader& index) {
    const long long value = index.integer_or(-1, 0, most);
    if (value >= 0 && static_cast<std::size_t>(value) < list.size())
      return static_cast<std::size_t>(value);
    if (index.exists()) index.report("names nothing that is in the file");
    return std::nullopt;
  }

  // Older files have keys for names.
  static std::string key_of(const JsonReader& mesh) {
    const std::string key = detail::text_in_extras(mesh, "key");
    return key.empty() ? mesh["name"].text_or("", longest_name) : key;
  }

  // The part of the binary chunk that a buffer view is; empty if it has none.
  std::string_view bytes_of(const JsonReader& view) const {
    const auto offset = static_cast<std::size_t>(view["byteOffset"].integer_or(0, 0, most));
    const auto length = static_cast<std::size_t>(view["byteLength"].integer_or(0, 0, most));
    if (offset <= binary_.size() && length <= binary_.size() - offset)
      return binary_.substr(offset, length);
    view.report("reaches beyond the end of the file");
    return {};
  }

  struct Elements {
    std::string_view bytes;
    std::size_t count = 0;
    long long component = 0;
  };

  // The exporter writes vertex data without gaps: `components` values of a type one after the other.
  std::optional<Elements> elements_of(const JsonReader& index, std::size_t components) const {
    const auto number = index_in(accessors_, index);
    if (!number) return std::nullopt;
    const JsonReader& accessor = accessors_[*number];
    const auto view = index_in(views_, accessor["bufferView"]);
    if (!view) return std::nullopt;
    Elements elements;
    elements.component = accessor["componentType"].integer_or(0, 0, most);
    elements.count = static_cast<std::size_t>(accessor["count"].integer_or(0, 0, most));
    const std::size_t each = components * (elements.component == component_uint16 ? 2 : 4);
    const std::string_view bytes = bytes_of(views_[*view]);
    const auto offset = static_cast<std::size_t>(accessor["byteOffset"].integer_or(0, 0, most));
    if (offset > bytes.size() || elements.count > (bytes.size() - offset) / each) {
      accessor.report("reaches beyond its buffer view");
      return std::nullopt;
    }
    elements.bytes = bytes.substr(offset, elements.count * each);
    return elements;
  }

  template <typename Vector>
  std::vector<Vector> vectors(const JsonReader& index) const {
    const auto elements = elements_of(index, Vector::RowsAtCompileTime);
    if (!elements || elements->component != component_float) return {};
    std::vector<Vector> result(elements->count);
    static_assert(sizeof(Vector) == Vector::RowsAtCompileTime * sizeof(float));
    if (!result.empty())
      std::memcpy(result.front().data(), elements->bytes.data(), elements->bytes.size());
    return result;
  }

  std::vector<Triangle> triangles(const JsonReader& index, std::size_t vertices) const {
    const auto elements = elements_of(index, 1);
    if (!elements) return {};
    std::vector<Triangle> result(elements->count / 3);
    const bool is_short = elements->component == component_uint16;
    if (!is_short && elements->component != component_uint32) return {};
    for (std::size_t k = 0; k < 3 * result.size(); ++k) {
      std::uint32_t vertex = 0;
      const std::size_t width = is_short ? 2 : 4;
      std::memcpy(&vertex, elements->bytes.data() + k * width, width);
      if (vertex >= vertices) {
        index.report("names a vertex that is not there");
        return {};
      }
      result[k / 3][k % 3] = vertex;
    }
    return result;
  }

  Mesh read_mesh(const JsonReader& primitive) const {
    static const Eigen::Matrix3f turn =
        find_axis_convention("gltf")->theirs_from_ours.transpose().cast<float>();
    Mesh mesh;
    const JsonReader attributes = primitive["attributes"];
    mesh.positions = vectors<Eigen::Vector3f>(attributes["POSITION"]);
    mesh.normals = vectors<Eigen::Vector3f>(attributes["NORMAL"]);
    mesh.uvs = vectors<Eigen::Vector2f>(attributes["TEXCOORD_0"]);
    if (mesh.normals.size() != mesh.positions.size()) mesh.normals.clear();
    if (mesh.uvs.size() != mesh.positions.size()) mesh.uvs.clear();
    for (auto& position : mesh.positions) position = turn * position;
    for (auto& normal : mesh.normals) normal = turn * normal;
    mesh.triangles = triangles(primitive["indices"], mesh.positions.size());
    remove_degenerate(mesh);
    return mesh;
  }

  Model read_model(const JsonReader& mesh) const {
    Model model;
    for (const auto& primitive : mesh["primitives"].elements_or_none(most_elements)) {
      const auto material = static_cast<std::size_t>(primitive["material"].integer_or(most, 0, most));
      model.parts.push_back({read_mesh(primitive), static_cast<int>(model.materials.size())});
      model.materials.push_back(material < materials_.size() ? materials_[material] : Material());
    }
    return model;
  }

  Material read_material(const JsonReader& json) {
    Material material;
    material.name = detail::text_in_extras(json, "name");
    if (material.name.empty()) material.name = json["name"].text_or("");
    const JsonReader surface = json["pbrMetallicRoughness"];
    if (surface["baseColorFactor"].exists()) {
      const auto color = surface["baseColorFactor"].numbers(4, 0.0, 1.0);
      for (std::size_t c = 0; c < color.size(); ++c)
        material.base_color[c] = static_cast<float>(color[c]);
    }
    material.metallic = static_cast<float>(surface["metallicFactor"].number_or(1.0, 0.0, widest));
    material.roughness = static_cast<float>(surface["roughnessFactor"].number_or(1.0, 0.0, widest));
    material.double_sided = json["doubleSided"].boolean_or(false);
    material.texture = read_texture(surface["baseColorTexture"]["index"]);
    return material;
  }

  std::shared_ptr<const Image> read_texture(const JsonReader& index) {
    if (!decode_ || !index.exists()) return nullptr;
    const auto textures = root_["textures"].elements_or_none(most_elements);
    const auto images = root_["images"].elements_or_none(most_elements);
    const auto texture = index_in(textures, index);
    if (!texture) return nullptr;
    const auto image = index_in(images, textures[*texture]["source"]);
    if (!image) return nullptr;
    if (const auto known = pictures_.find(*image); known != pictures_.end()) return known->second;
    const auto view = index_in(views_, images[*image]["bufferView"]);
    auto picture = view ? decode_(bytes_of(views_[*view])) : Result<Image>(Image());
    if (!picture) images[*image].report(picture.error().message);
    auto shared = picture ? std::make_shared<const Image>(*std::move(picture)) : nullptr;
    return pictures_.emplace(*image, std::move(shared)).first->second;
  }

  JsonReader root_;
  std::string_view binary_;
  const ImageDecoder& decode_;
  std::vector<JsonReader> accessors_, views_;
  std::vector<Material> materials_;
  std::map<std::size_t, std::shared_ptr<const Image>> pictures_;
};

}  // namespace

Result<ModelTable> read_glb_models(const std::filesystem::path& path, const ImageDecoder& decode) {
  const auto file = detail::read_glb_file(path);
  if (!file) return file.error();
  JsonReader::Problems problems(path.string());
  ModelTable models = GlbReader(file->json, file->binary(), decode, problems).read();
  if (const auto& problem = problems.first()) return *problem;
  return models;
}

}  // namespace roomgen
