#include "roomgen/create/create.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/sha256.h"
#include "kinds.h"
#include "kinds/noun_kind.h"
#include "library/asset_object.h"
#include "library/attribute_words.h"
#include "library/looks.h"
#include "library/qualifiers.h"
#include "library/ranking.h"
#include "library/vocabulary.h"
#include "parts.h"
#include "roomgen/base/json.h"
#include "roomgen/create/maker.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/program.h"
#include "rule_steps.h"
#include "scene/written_asset.h"
#include "stock.h"

namespace roomgen::create {

namespace {

constexpr const char* recipe_name = "words";
constexpr double created_score = 0.1;  // any real thing that fits is better
constexpr double usual_elevation = 1.2;
constexpr double most_over = 1.5, most_under = 0.4;  // of its kind's sizes, where one is said
constexpr double least_stored_side = 0.002, greatest_stored_side = 20.0;

/// What is built.
struct Order {
  std::string kind;  ///< of data/shapes/kinds; what is approximate may be of none
  std::string description;
  Vec3 size = Vec3::Ones();
  std::uint64_t seed = 0;
  bool approximate = false;  ///< nobody knows what the words name
  bool stand_in = false;     ///< only as large as such things are
};

// Equal words build equal things.
std::uint64_t seed_of(const std::string& words) {
  return std::strtoull(sha256_hex(words).substr(0, 12).c_str(), nullptr, 16);
}

ProceduralSource source_of(const Order& order) {
  ProceduralSource source;
  source.recipe = recipe_name;
  source.seed = order.seed;
  Json params = {
      {"kind", order.kind},
      {"description", order.description},
      {"size", {rounded(order.size.x()), rounded(order.size.y()), rounded(order.size.z())}}};
  if (order.approximate) params["approximate"] = true;
  if (order.stand_in) params["stand_in"] = true;
  source.params = params.dump();
  return source;
}

Result<Order> order_of(const AssetRef& ref) {
  const Error unknown{Error::Kind::not_found, asset_key(ref) + ": nothing is built this way"};
  if (!ref.procedural || ref.procedural->recipe != recipe_name) return unknown;
  JsonReader::Problems problems("asset " + asset_key(ref));
  const auto json = parse_json(ref.procedural->params, "asset " + asset_key(ref));
  if (!json) return json.error();
  const JsonReader params(*json, problems);
  Order order;
  order.kind = params["kind"].text();
  order.description = params["description"].text_or("");
  order.approximate = params["approximate"].boolean_or(false);
  order.stand_in = params["stand_in"].boolean_or(false);
  const auto sides = params["size"].numbers(3, least_stored_side, greatest_stored_side);
  if (const auto& problem = problems.first()) return *problem;
  order.size = Vec3(sides[0], sides[1], sides[2]);
  order.seed = ref.procedural->seed;
  return order;
}

// The words about the object itself: what the description says of others is for other queries.
Description describe(const Order& order) {
  Description description;
  if (built_in_words() && ShapeKinds::built_in()) {
    auto read = read_phrase(order.description, *built_in_words(), *ShapeKinds::built_in());
    // "a pastel pink chair" may name a pastel too.
    const auto meant = std::find_if(read.begin(), read.end(), [&](const Description& object) {
      return !object.approximate && object.kind == order.kind;
    });
    if (!read.empty()) description = meant == read.end() ? std::move(read.front()) : std::move(*meant);
  }
  if (!order.approximate) {
    if (description.noun.empty() || description.approximate) description.noun = order.kind;
    description.kind = order.kind;
    description.approximate = false;
  }
  description.prompt = order.description;
  const auto& kinds = ShapeKinds::built_in();
  const ShapeKind* kind = kinds ? kinds->find(order.kind) : nullptr;
  description.size = kind ? order.size.cwiseMax(kind->least).cwiseMin(kind->most) : order.size;
  description.count = 1;
  return description;
}

// Fills the box exactly: what is left to do is below a hundredth.
void fit(Model& model, const Vec3& size) {
  const Vec3 actual = bounds(model).size();
  const Eigen::Vector3f factors = size.cwiseQuotient(actual.cwiseMax(1e-6)).cast<float>();
  for (auto& part : model.parts) {
    for (auto& p : part.mesh.positions) p = p.cwiseProduct(factors);
    for (auto& n : part.mesh.normals) n = n.cwiseQuotient(factors).normalized();
  }
}

Result<Model> build(const Order& order) {
  const auto maker = make_rule_maker();
  CreateOptions options;
  options.seed = order.seed;
  auto object = create_described(describe(order), *maker, options);
  if (!object) return object.error();
  Model model = to_model(object->shape);
  fit(model, order.size);
  model.making = {all_parts(object->program), object->program.ways};
  model.making.ways["letters"] = letters_of(object->program.components);
  return model;
}

Result<Model> build_program(const AssetRef& ref) {
  auto json = shape::parse_recipe(ref.procedural->params, "a program among the assets");
  if (!json) return json.error();
  auto program = shape::instantiate(*json, {}, 0, nullptr, "a program among the assets");
  if (!program) return program.error();
  const auto shape = shape::evaluate_within(*program);
  if (!shape) return shape.error();
  Model model = to_model(*shape);
  model.making.ways["letters"] = letters_of(program->components);
  return model;
}

Result<Model> made(const AssetRef& ref) {
  if (is_written(ref)) return build_program(ref);
  const auto order = order_of(ref);
  if (!order) return order.error();
  return build(*order);
}

class CreatedLibrary final : public AssetLibrary {
 public:
  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    std::vector<AssetMatch> matches;
    const ShapeKind* kind = kind_asked(query);
    if (query.limit == 0 || (!kind && !query.asked)) return matches;
    if (!kind) return unknown(query);
    const Mount mount = query.mount.value_or(kind->mount);
    const Kind* known = Vocabulary::built_in().find(kind->name);
    const std::vector<Mount> also = known ? known->also : std::vector<Mount>{};
    Order order{kind->name, query.description, size_for(query, *kind)};
    // Who asks for a lantern at the ceiling gets it there.
    if (!query.asked && mount_fit(kind->mount, mount, also, order.size.z()) <= 0.0) return matches;
    order.seed = seed_of(query.category + "\n" + query.description);
    AssetMatch match{info_of(order, kind->name, mount), created_score};
    // Better than a real one that is another thing.
    if (query.asked && !is_as_wanted(match.asset.ref, query.description))
      match.contradicts = Contradiction::looks;
    matches.push_back(std::move(match));
    return matches;
  }

  Result<AssetInfo> find(std::string_view key) const override {
    AssetRef ref;
    ref.procedural = source_of_key(key);
    if (!ref.procedural) return AssetLibrary::find(key);
    if (is_written(ref)) return info_of_program(ref);
    auto order = order_of(ref);
    if (!order) return Error{Error::Kind::not_found, order.error().message};
    const std::string& kind = order->kind.empty() ? order->description : order->kind;
    const Kind* known = Vocabulary::built_in().find(kind);
    AssetInfo info = info_of(*order, kind, known ? known->mount : Mount::floor);
    info.stand_in = order->stand_in;
    return info;
  }

  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    const std::string key = asset_key(ref);
    {
      const std::lock_guard lock(mutex_);
      if (const auto known = models_.find(key); known != models_.end()) return known->second;
    }
    auto model = made(ref);
    if (!model) return model.error();
    const auto shared = std::make_shared<const Model>(*std::move(model));
    const std::lock_guard lock(mutex_);
    return models_.emplace(key, shared).first->second;
  }

 private:
  // Drawers that nobody counts need not be made to be counted.
  bool is_as_wanted(const AssetRef& ref, const std::string& description) const {
    const WantedLooks wanted = wanted_looks(description);
    if (wanted.making.empty()) return true;
    const auto model = load(ref);
    return model && is_made_as_wanted((*model)->making, wanted);
  }

  Result<AssetInfo> info_of_program(const AssetRef& ref) const {
    const auto model = load(ref);
    if (!model) return Error{Error::Kind::not_found, model.error().message};
    AssetInfo info;
    info.ref = ref;
    info.ref.license = "CC0";
    info.name = text_parameter(*ref.procedural, "name");
    const auto phrase = Vocabulary::built_in().understand(info.name);
    info.category = phrase.known ? phrase.kind : info.name;
    info.group = "made from words";
    info.size = bounds(**model).size();
    info.elevation = usual_elevation;
    describe_by_kind(info, info.category, true);
    return info;
  }

  // The kind that the thing's own name means, an armoire where a wardrobe is asked, else the
  // category's. By its own name, or by another that the vocabulary has for it.
  static const ShapeKind* kind_asked(const AssetQuery& query) {
    const auto& kinds = ShapeKinds::built_in();
    if (!kinds) return nullptr;
    const KindPhrase own = own_name(query.category, query.description);
    const KindPhrase asked = Vocabulary::built_in().understand(query.category);
    const bool is_named = !query.category.empty() && query.category.ends_with(own.name);
    std::vector<std::string> names = {query.category};
    if (own.known) names.push_back(own.kind);
    if (own.known && own.kind != asked.kind) names.insert(names.begin(), own.kind);
    if (own.known && !is_named) names.insert(names.begin(), own.name);
    for (const auto& name : names)
      if (const ShapeKind* kind = kinds->find(name)) return kind;
    return nullptr;
  }

  // What nobody knows: of its parts, if the words name some, else a plain shape.
  static Result<std::vector<AssetMatch>> unknown(const AssetQuery& query) {
    auto made = composed(query);
    if (!made || made->empty()) return stand_in(query);
    return made;
  }

  static std::vector<AssetMatch> stand_in(const AssetQuery& query) {
    const Kind* like = stand_in_for(KindTable::built_in(), query.category);
    const ShapeKind* kind = like ? ShapeKinds::built_in()->find(like->built_as) : nullptr;
    if (!kind) return {};
    Order order{kind->name, query.description, query.size.value_or(kind->size)};
    order.stand_in = true;
    AssetMatch match{info_of(order, query.category, query.mount.value_or(kind->mount)), created_score};
    match.asset.stand_in = true;
    return {match};
  }

  // Made as its words say it, or like what it is named after.
  static Result<std::vector<AssetMatch>> composed(const AssetQuery& query) {
    std::vector<AssetMatch> matches;
    const std::string& words = query.description.empty() ? query.category : query.description;
    const auto maker = make_rule_maker();
    const auto verdict = maker->classify(words);
    if (!verdict) return verdict.error();
    const auto objects = maker->decompose(words);
    if (!verdict->passes || !objects || objects->empty()) return matches;
    const ShapeKind* kind = ShapeKinds::built_in()->find(objects->front().kind);
    Order order{"", words, Vec3::Ones(), 0, true};
    if (kind) order.kind = kind->name;
    if (kind && !query.sized) order.size = kind->size;
    else if (query.size) order.size = *query.size;
    order.seed = seed_of(query.category + "\n" + query.description);
    const Mount mount = query.mount.value_or(kind ? kind->mount : Mount::floor);
    matches.push_back({info_of(order, query.category, mount), created_score});
    return matches;
  }

  // What is said is made, a little beyond what people would believe; the usual size as they would.
  static Vec3 size_for(const AssetQuery& query, const ShapeKind& kind) {
    const double over = query.sized ? most_over : 1.0, under = query.sized ? most_under : 1.0;
    Vec3 size = query.size.value_or(kind.size);
    size = size.cwiseMax(under * kind.least).cwiseMin(over * kind.most);
    const Kind* usual = KindTable::built_in().find(query.category);
    const auto is_told = [&](int axis) {
      return usual && is_length_told(size[axis], usual->size[axis]);
    };
    const bool is_regular = wanted_looks(query.description).has_equal_sides();
    if (is_regular && !is_told(0) && !is_told(1) && kind.mount != Mount::wall)
      size.x() = size.y() = std::min(size.x(), size.y());
    return {rounded(size.x()), rounded(size.y()), rounded(size.z())};
  }

  static AssetInfo info_of(const Order& order, const std::string& kind, Mount mount) {
    AssetInfo info;
    info.ref.procedural = source_of(order);
    info.ref.license = "CC0";
    info.name = kind;
    info.category = kind;
    info.approximate = order.approximate;
    info.group = "made from words";
    info.size = order.size;
    info.mount = mount;
    const Kind* category = KindTable::built_in().find(kind);
    if (mount == Mount::wall)
      info.elevation = category && category->elevation > 0.0 ? category->elevation : usual_elevation;
    describe_by_kind(info, kind, mount == Mount::floor);
    const Description description = describe(order);
    for (const auto& said : {description.color, description.material})
      if (!said.empty()) info.colors.push_back(said);
    return info;
  }

  mutable std::mutex mutex_;
  mutable std::map<std::string, std::shared_ptr<const Model>> models_;
};

}  // namespace

std::unique_ptr<AssetLibrary> make_created_library() {
  return std::make_unique<CreatedLibrary>();
}

}  // namespace roomgen::create
