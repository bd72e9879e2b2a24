#include "made.h"

#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"
#include "roomgen/generate/generate.h"
#include "roomgen/render/pictures.h"
#include "roomgen/shape/evaluate.h"

namespace roomgen::cli {

namespace {

// One thing alone stands for itself; several are set out by the solver.
Status stand_together(const create::Creation& creation, std::uint64_t seed, MadeAll& made) {
  const auto& objects = creation.objects;
  if (objects.size() == 1 && objects[0].description.count <= 1) {
    made.model = to_model(objects[0].shape);
    return {};
  }
  const auto group = set_out(creation, KindTable::built_in(), seed);
  if (!group) return group.error();
  made.model = merged_model(group->scene, group->models);
  for (const auto& missing : group->scene.unplaced)
    made.notes.push_back(missing.id + " was left out: " + missing.reason);
  return {};
}

Json bodies_json(const shape::Shape& made) {
  Json json = Json::array();
  for (const auto& body : made.bodies) {
    const Vec3 size = bounds(body.mesh).size();
    json.push_back({{"name", body.name},
                    {"label", body.label},
                    {"triangles", body.mesh.triangles.size()},
                    {"size", {rounded(size.x()), rounded(size.y()), rounded(size.z())}}});
  }
  return json;
}

}  // namespace

Made made_of(create::CreatedObject object) {
  // Triangles that a model wrote were not measured.
  const bool judged = object.soundness.bodies > 0;
  return {std::move(object.program), std::move(object.shape),   std::move(object.soundness), judged,
          object.fell_back,          std::move(object.repairs), std::move(object.notes)};
}

Result<MadeAll> made_of(create::Creation creation, std::uint64_t seed) {
  MadeAll result;
  if (auto status = stand_together(creation, seed, result); !status) return status.error();
  for (auto& object : creation.objects) result.objects.push_back(made_of(std::move(object)));
  return result;
}

Json object_json(const Made& made) {
  const Vec3 size = shape::bounds(made.shape).size();
  Json json;
  json["name"] = made.program.name;
  json["size"] = {rounded(size.x()), rounded(size.y()), rounded(size.z())};
  json["components"] = made.shape.bodies.size();
  json["triangles"] = shape::triangle_count(made.shape);
  json["materials"] = made.program.materials.size();
  if (made.judged) {
    json["pieces"] = made.soundness.pieces;
    json["grounded"] = made.soundness.grounded;
    json["stable"] = made.soundness.stable;
    json["problems"] = made.soundness.problems;
    json["repairs"] = made.repairs;
  }
  if (made.judged || !made.notes.empty()) json["notes"] = made.notes;
  if (made.by_rules) json["by_rules"] = true;
  json["bodies"] = bodies_json(made.shape);
  return json;
}

Json objects_json(const MadeAll& all) {
  Json json = object_json(all.objects.front());
  for (std::size_t i = 1; i < all.objects.size(); ++i)
    json["others"].push_back(object_json(all.objects[i]));
  if (!all.notes.empty()) json["together"] = all.notes;
  if (all.scores) json["scores"] = create::to_json(*all.scores);
  return json;
}

}  // namespace roomgen::cli
