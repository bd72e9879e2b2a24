#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "chat/loose_json.h"
#include "maker_replies.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/shape/primitives.h"
#include "shape/color.h"

namespace roomgen::create {

namespace {

constexpr std::size_t max_vertices = 3 * max_reply_triangles;
constexpr std::size_t max_bodies = 500;
constexpr std::size_t max_label = 60;  // bytes
constexpr double farthest = 20.0;      // metres

/// A face as it was written: its triangles, one or (of four corners) two.
struct Faces {
  std::vector<Triangle> triangles;
  std::vector<std::size_t> first;  ///< triangle of each face, and the end
};

std::vector<Eigen::Vector3f> read_vertices(const JsonReader& list) {
  std::vector<Eigen::Vector3f> vertices;
  for (const auto& vertex : list.elements(max_vertices)) {
    const auto p = vertex.numbers(3, -farthest, farthest);
    if (p.size() != 3) break;
    vertices.push_back(Vec3(p[0], p[1], p[2]).cast<float>());
  }
  return vertices;
}

bool read_face(const JsonReader& json, std::size_t vertices, Faces& faces) {
  std::vector<std::uint32_t> corners;
  for (const auto& corner : json.elements(4)) {
    const auto index = corner.integer_or(-1, 0, 1'000'000'000);
    if (index < 0 || static_cast<std::size_t>(index) >= vertices) {
      corner.report("there is no vertex " + std::to_string(index) + "; there are " +
                    std::to_string(vertices) + ", counted from 0");
      return false;
    }
    corners.push_back(static_cast<std::uint32_t>(index));
  }
  if (corners.size() < 3) {
    json.report("expected three indices of vertices");
    return false;
  }
  faces.first.push_back(faces.triangles.size());
  faces.triangles.push_back({corners[0], corners[1], corners[2]});
  if (corners.size() == 4) faces.triangles.push_back({corners[0], corners[2], corners[3]});
  return true;
}

Faces read_faces(const JsonReader& list, std::size_t vertices) {
  Faces faces;
  for (const auto& face : list.elements(max_reply_triangles))
    if (!read_face(face, vertices, faces)) break;
  faces.first.push_back(faces.triangles.size());
  return faces;
}

/// A run of faces that make a part.
struct Run {
  std::string label, color;
  std::size_t first = 0, count = 0;
};

std::vector<Run> read_runs(const JsonReader& list, std::size_t faces, const std::string& noun) {
  std::vector<Run> runs;
  const auto last = static_cast<long long>(faces);
  for (const auto& json : list.elements_or_none(max_bodies)) {
    Run run;
    run.label = shortened(json["label"].text(), max_label);
    run.color = json["color"].text_or("");
    run.first = static_cast<std::size_t>(json["first"].integer_or(0, 0, last));
    const auto rest = last - static_cast<long long>(run.first);
    run.count = static_cast<std::size_t>(json["count"].integer_or(rest, 0, rest));
    runs.push_back(std::move(run));
  }
  std::stable_sort(runs.begin(), runs.end(),
                   [](const Run& a, const Run& b) { return a.first < b.first; });
  // What no part has is a part of its own, and no triangle is in two.
  std::vector<Run> whole;
  std::size_t at = 0;
  for (auto& run : runs) {
    if (run.first < at) {
      list.report("the parts share triangle " + std::to_string(run.first));
      return {};
    }
    if (run.first > at) whole.push_back({noun, "", at, run.first - at});
    at = run.first + run.count;
    whole.push_back(std::move(run));
  }
  if (at < faces) whole.push_back({noun, "", at, faces - at});
  return whole;
}

Material material_of(const std::string& color) {
  Material material;
  const auto rgb = shape::parse_color(color);
  if (!rgb) return material;
  material.name = color;
  for (std::size_t k = 0; k < 3; ++k) material.base_color[k] = linear_from_srgb((*rgb)[k]);
  return material;
}

/// Makes bodies of runs and says what they lack.
class BodyMaker {
 public:
  BodyMaker(const std::vector<Eigen::Vector3f>& vertices, const Faces& faces,
            std::vector<std::string>& repairs)
      : vertices_(vertices), faces_(faces), repairs_(repairs) {}

  void add(const Run& run, shape::Shape& shape) {
    shape::Body body;
    body.label = run.label.empty() ? "part" : run.label;
    body.name = join(words(body.label), "-") + "-" + std::to_string(shape.bodies.size());
    body.mesh = mesh_of(run);
    if (remove_degenerate(body.mesh) > 0)
      note("triangles without an area were left out of the " + body.label);
    if (body.mesh.triangles.empty()) return;
    close(body);
    repair_normals(body.mesh);
    body.material = material(run.color, shape);
    shape.bodies.push_back(std::move(body));
  }

 private:
  void note(const std::string& what) {
    if (std::find(repairs_.begin(), repairs_.end(), what) == repairs_.end())
      repairs_.push_back(what);
  }

  // Only the vertices that the run uses: a mesh of many parts has all of them once.
  Mesh mesh_of(const Run& run) {
    Mesh mesh;
    local_.resize(vertices_.size(), unused);
    std::vector<std::uint32_t> used;
    for (std::size_t k = faces_.first[run.first]; k < faces_.first[run.first + run.count]; ++k) {
      Triangle triangle = faces_.triangles[k];
      for (auto& corner : triangle) {
        if (local_[corner] == unused) {
          local_[corner] = static_cast<std::uint32_t>(mesh.positions.size());
          mesh.positions.push_back(vertices_[corner]);
          used.push_back(corner);
        }
        corner = local_[corner];
      }
      mesh.triangles.push_back(triangle);
    }
    for (const auto corner : used) local_[corner] = unused;
    return mesh;
  }

  void close(shape::Body& body) {
    if (!shape::is_closed(body.mesh)) return note("the surface of the " + body.label + " has gaps");
    if (shape::volume(body.mesh) >= 0.0) return;
    for (auto& triangle : body.mesh.triangles) std::swap(triangle[1], triangle[2]);
    note("the " + body.label + " was turned inside out");
  }

  static int material(const std::string& color, shape::Shape& shape) {
    const Material wanted = material_of(color);
    for (std::size_t k = 0; k < shape.materials.size(); ++k)
      if (shape.materials[k].name == wanted.name) return static_cast<int>(k);
    shape.materials.push_back(wanted);
    return static_cast<int>(shape.materials.size()) - 1;
  }

  static constexpr std::uint32_t unused = 0xffffffffu;

  const std::vector<Eigen::Vector3f>& vertices_;
  const Faces& faces_;
  std::vector<std::string>& repairs_;
  std::vector<std::uint32_t> local_;  ///< a vertex's index in the mesh that is made
};

}  // namespace

Result<Reading<shape::Shape>> read_mesh_reply(const std::string& text, const std::string& noun) {
  auto loose = find_json(text, {{"vertices", "triangles"}, {"faces"}});
  if (!loose) return loose.error();
  JsonReader::Problems problems("the mesh");
  const JsonReader root(loose->json, problems);
  const auto vertices = read_vertices(root["vertices"]);
  if (problems.first()) return *problems.first();
  const bool faces_instead = !root["triangles"].exists() && root["faces"].exists();
  const Faces faces = read_faces(root[faces_instead ? "faces" : "triangles"], vertices.size());
  if (problems.first()) return *problems.first();
  if (faces.triangles.size() > max_reply_triangles)
    return Error{Error::Kind::limit,
                 "the mesh: more than " + std::to_string(max_reply_triangles) + " triangles"};
  const auto runs = read_runs(root["parts"], faces.first.size() - 1, noun);
  if (problems.first()) return *problems.first();
  Reading<shape::Shape> reading{{}, std::move(loose->repairs)};
  BodyMaker maker(vertices, faces, reading.repairs);
  for (const auto& run : runs) maker.add(run, reading.value);
  if (reading.value.bodies.empty())
    return Error{Error::Kind::invalid_input, "the mesh has no triangle with an area"};
  if (auto status = check_extent(reading.value); !status) return status.error();
  return reading;
}

}  // namespace roomgen::create
