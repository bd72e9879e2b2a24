#include "roomgen/generate/generate.h"

#include <algorithm>
#include <cmath>

#include "roomgen/create/create.h"

namespace roomgen {

namespace {

constexpr double room_around = 3.0;  // metres of free floor on all sides of the first object
constexpr const char* library_name = "created";

/// The created objects as the only things in stock: an item's description is its number.
class CreatedThings final : public AssetLibrary {
 public:
  explicit CreatedThings(const create::Creation& creation) {
    for (const auto& object : creation.objects)
      models_.push_back(std::make_shared<const Model>(to_model(object.shape)));
  }

  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    const std::size_t number = number_of(query.description);
    if (number >= models_.size()) return std::vector<AssetMatch>{};
    AssetInfo info;
    info.ref.library = library_name;
    info.ref.id = query.description;
    info.ref.license = "CC0";
    info.name = query.category;
    info.category = query.category;
    info.size = bounds(*models_[number]).size();
    info.mount = query.mount.value_or(Mount::floor);
    info.support_height = info.size.z();
    return std::vector<AssetMatch>{{info, 1.0}};
  }

  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    const std::size_t number = number_of(ref.id);
    if (number >= models_.size())
      return Error{Error::Kind::not_found, "there is no created object " + ref.id};
    return models_[number];
  }

 private:
  static std::size_t number_of(const std::string& text) {
    const bool number = !text.empty() && text.size() < 4 &&
                        text.find_first_not_of("0123456789") == std::string::npos;
    return number ? static_cast<std::size_t>(std::stoi(text)) : static_cast<std::size_t>(-1);
  }

  std::vector<std::shared_ptr<const Model>> models_;
};

/// Answers what the sentence said.
class SaidRelations final : public Designer {
 public:
  SaidRelations(const create::Creation& creation, std::string first, Vec2 center)
      : creation_(creation), first_(std::move(first)), center_(center) {}

  Result<Plan> plan(const PlanRequest&) override {
    return Error{Error::Kind::unavailable, "the plan is given"};
  }

  Result<PlaceAdvice> place(const PlaceRequest& request) override {
    PlaceAdvice advice;
    if (request.planned.item == 0) {
      advice.location = center_;
      if (request.planned.number > 0) advice.relations = {{RelationKind::near, first_}};
      return advice;
    }
    const std::string& said = creation_.objects[request.planned.item].description.relation;
    const auto relation = parse_relation((said.empty() ? "near" : said) + ", " + first_);
    advice.relations = {relation ? *relation : Relation{RelationKind::near, first_}};
    return advice;
  }

 private:
  const create::Creation& creation_;
  std::string first_;
  Vec2 center_;
};

Room room_for(const create::Creation& creation) {
  double side = 2 * room_around;
  for (const auto& object : creation.objects)
    side += bounds(object.shape).size().head<2>().maxCoeff() *
            std::sqrt(static_cast<double>(std::max(1, object.description.count)));
  Room room;
  room.type = "empty room";
  room.polygon.points = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  return room;
}

Plan plan_for(const create::Creation& creation, std::uint64_t seed) {
  Plan plan;
  plan.prompt = creation.objects.front().description.prompt;
  plan.seed = seed;
  plan.room = room_for(creation);
  for (std::size_t i = 0; i < creation.objects.size(); ++i) {
    const auto& description = creation.objects[i].description;
    PlanItem item;
    item.category = description.kind.empty() ? description.noun : description.kind;
    item.description = std::to_string(i);
    item.quantity = std::max(1, description.count);
    if (i > 0 && description.relation == "on") item.mount = Mount::surface;
    plan.items.push_back(std::move(item));
  }
  return plan;
}

}  // namespace

Result<Generation> set_out(const create::Creation& creation, const KindTable& categories,
                           std::uint64_t seed) {
  if (creation.objects.empty())
    return Error{Error::Kind::invalid_input, "there is nothing to set out"};
  Plan plan = plan_for(creation, seed);
  const std::string first = planned_objects(plan).front().id;
  for (std::size_t i = 1; i < plan.items.size(); ++i)
    if (plan.items[i].mount == Mount::surface) plan.items[i].on = first;
  const CreatedThings library(creation);
  SaidRelations designer(creation, first, 0.5 * bounds(plan.room.polygon).size());
  BuildOptions options;
  options.seed = seed;
  return generate(plan, designer, library, categories, options);
}

Model merged_model(const Scene& scene, const ModelTable& models) {
  Model result;
  if (scene.objects.empty()) return result;
  const Vec3 origin(scene.objects[0].position.x(), scene.objects[0].position.y(), 0);
  for (const auto& object : scene.objects) {
    const auto model = models.find(asset_key(object.asset));
    if (!model) continue;
    const int first_material = static_cast<int>(result.materials.size());
    result.materials.insert(result.materials.end(), model->materials.begin(),
                            model->materials.end());
    const ModelPlacement placement = model_placement(object, bounds(*model));
    const auto turn = [&](const Vec3& v) -> Vec3 {
      const Vec2 turned = rotated(Vec2(v.head<2>()), placement.yaw);
      return {turned.x(), turned.y(), v.z()};
    };
    const Vec3 at = placement.position - origin;
    for (auto part : model->parts) {
      part.material += first_material;
      for (auto& p : part.mesh.positions)
        p = (turn(placement.scale.cwiseProduct(p.cast<double>())) + at).cast<float>();
      for (auto& n : part.mesh.normals)
        n = turn(n.cast<double>().cwiseQuotient(placement.scale)).normalized().cast<float>();
      result.parts.push_back(std::move(part));
    }
  }
  return result;
}

}  // namespace roomgen
