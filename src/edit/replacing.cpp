#include <algorithm>

#include "comparison.h"
#include "draft_changes.h"
#include "generate/asset_task.h"
#include "kinds/mounting.h"
#include "library/asset_object.h"
#include "operations.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t most_alternatives = 12;

bool is_same_mesh(const AssetRef& a, const AssetRef& b) {
  return a.library == b.library && a.id == b.id && a.procedural == b.procedural;
}

void rename_thing(Draft& draft, const std::string& from, const std::string& to) {
  for (auto& object : draft.scene.objects) {
    if (object.id == from) object.id = to;
    if (object.on == from) object.on = to;
    for (auto& relation : object.relations)
      if (relation.target == from) relation.target = to;
  }
}

/// What is to come instead, as words and sizes say.
struct Replacement {
  std::string category;
  std::string description;
  std::optional<Vec3> size;  ///< where it is said, or as the thing before
  bool is_told = false;      ///< the size is
  Comparison comparison;     ///< with the thing before
  std::string asset = {};    ///< key of what was written for it; empty: the library finds it
};

Replacement replacement_for(const Object& object, const std::string& category, const edit::Replace& replace) {
  Replacement other{category, "", replace.size, replace.size.has_value(),
                    comparison_in(replace.description)};
  other.description = other.comparison.description;
  if (!other.size && !other.comparison.ways.empty()) {
    other.size = compared_size(other.comparison, object.size, object.mount == Mount::floor);
    other.is_told = true;
  }
  if (!other.size && category == object.category) other.size = object.size;
  return other;
}

AssetQuery query_for(const Object& object, const Replacement& other) {
  AssetQuery query;
  query.category = other.category;
  query.description = other.description.empty() ? other.category : other.description;
  query.size = other.size;
  query.sized = other.is_told;
  query.mount = object.mount;
  query.asked = true;
  query.limit = most_alternatives;
  return query;
}

// The thing as another mesh makes it; its relations stay.
Object remade(const Draft& draft, const Object& object, const Replacement& other, const Kind& kind,
              const AssetInfo& asset, const Model* model) {
  PlanItem item;
  if (other.is_told) item.size = other.size;
  if (!other.asset.empty()) item.size = asset.size;
  item.category = other.category;
  item.description = other.description.empty() ? object.description : other.description;
  item.mount = object.mount;
  item.asked = true;
  item.relations = object.relations;
  Object made = task_of_asset(object.id, item, kind, asset, model, room_of(draft.scene, object)).object;
  made.position = object.position;
  made.yaw = object.yaw;
  made.on = object.on;
  made.room = object.room;
  made.locked = object.locked;
  return made;
}

// A finish of its own makes another one of the same mesh, where words ask for it. Sizes that are told are looked at
// with the thing as it would be.
bool is_another(const AssetMatch& match, const Object& object, const Replacement& other) {
  if (!other.asset.empty()) return true;
  const bool has_words = !other.description.empty() && other.description != other.category;
  if (!is_same_mesh(match.asset.ref, object.asset)) return !has_words || match.contradicts == Contradiction::none;
  return has_words && match.contradicts == Contradiction::none && match.asset.ref.finish != object.asset.finish;
}

constexpr std::size_t most_sizes = 3;  // that a message names

void note_size(std::vector<std::string>& sizes, const Vec3& size) {
  const std::string text = size_text(size);
  if (sizes.size() < most_sizes && std::find(sizes.begin(), sizes.end(), text) == sizes.end()) sizes.push_back(text);
}

Status none_is_so(const Object& object, const Replacement& other, const std::vector<std::string>& sizes,
                  const Status& stretched) {
  const std::string wanted = other.comparison.ways.empty()
                                 ? "about " + size_text(*other.size) + " m large"
                                 : other.comparison.words + " than " + object.id + " (" + size_text(object.size) + " m)";
  const std::string there = sizes.empty() ? "" : "; there are others of " + join(sizes, ", ") + " m";
  return cannot("no " + other.category + " that is " + wanted + " fits there: " + stretched.error().message + there);
}

constexpr double most_off_size = 0.1;  // share by which a side that is told may differ

bool is_as_told(const Replacement& other, const Kind& kind, const Vec3& size, const Vec3& before) {
  if (!other.asset.empty()) return true;
  if (!other.comparison.ways.empty()) return holds(other.comparison, size, before);
  for (int axis = 0; other.is_told && axis < 3; ++axis) {
    const double told = (*other.size)[axis];
    if (is_length_told(told, kind.size[axis]) && std::abs(size[axis] - told) > most_off_size * told) return false;
  }
  return true;
}

// Those that have the size that is told, and then others whose size is looked at with the thing as it would be.
Result<std::vector<AssetMatch>> alternatives(const Draft& draft, const Object& object, const Replacement& other) {
  if (!other.asset.empty()) {
    const auto asset = draft.shop.library().find(other.asset);
    if (!asset) return asset.error();
    return std::vector<AssetMatch>{{*asset, 1.0}};
  }
  AssetQuery query = query_for(object, other);
  auto matches = draft.shop.library().search(query);
  if (!matches || !query.sized) return matches;
  query.sized = false;
  const auto more = draft.shop.library().search(query);
  if (more) matches->insert(matches->end(), more->begin(), more->end());
  return matches;
}

Status put_instead(Draft& draft, const Object& object, Object made) {
  Draft trial = draft;
  const auto status = put_changed(trial, cluster_of(draft.scene, object), std::move(made));
  if (status) draft.take_over(std::move(trial));
  return status;
}

// Where no other is so, the same one comes in another size.
Status stretch_instead(Draft& draft, const Object& object, const Replacement& other) {
  auto changed = with_size(draft, object, *other.size);
  if (!changed) return changed.error();
  return put_instead(draft, object, *std::move(changed));
}

// Another kind of thing has another name, and its number is asked for.
void call_by_kind(Draft& draft, const std::string& old_id, const std::string& category,
                  const std::string& description) {
  const std::string id = next_id(draft.scene, category);
  rename_thing(draft, old_id, id);
  draft.named.insert(id);
  draft.added.push_back(id);
  Requirement wish = wish_for(*find_object(draft.scene, id), description.empty() ? category : description,
                              Requirement::Kind::count);
  wish.at_least = true;
  draft.wishes.push_back(std::move(wish));
}

// A plant that takes the place of a vase on a table is a small one.
const Kind& kind_instead(const KindTable& kinds, const Object& object, const std::string& category) {
  const Kind& kind = kinds.get(category.empty() ? object.category : category);
  if (may_be_put_up(kind, object.mount) || object.mount != Mount::surface || kind.forms.small.empty()) return kind;
  const Kind* small = kinds.by_name(kind.forms.small);
  return small ? kinds.planned(*small) : kind;
}

// What is drawn may be put up as anything is.
Status check_mount(const Object& object, const Kind& kind, const edit::Replace& replace) {
  const bool is_free = !replace.program.empty() || is_of_no_kind(kind);
  if (is_free || may_be_put_up(kind, object.mount)) return {};
  return cannot("a " + kind.name + " is not put up like " + object.id +
                "; remove the one and add the other");
}

Status write_asset(Draft& draft, const Object& object, const std::string& program,
                   Replacement& other) {
  if (program.empty()) return {};
  PlanItem item;
  item.category = other.category;
  item.description = other.description.empty() ? object.description : other.description;
  if (other.is_told) item.size = other.size;
  item.mount = object.mount;
  auto status = build_as_written(draft, program, item);
  other.asset = item.asset;
  return status;
}

}  // namespace

Status carry_out(Draft& draft, const edit::Replace& replace) {
  const auto object = object_to_change(draft, replace.object, true);
  if (!object) return object.error();
  const Kind& kind = kind_instead(draft.shop.kinds(), *object, replace.category);
  const std::string called = replace.category.empty() ? object->category : lower(replace.category);
  const std::string category = is_of_no_kind(kind) ? called : kind.name;
  const bool is_other_kind = category != object->category;
  if (auto status = check_mount(*object, kind, replace); is_other_kind && !status) return status;
  Replacement other = replacement_for(*object, category, replace);
  if (auto status = write_asset(draft, *object, replace.program, other); !status) return status;
  const auto matches = alternatives(draft, *object, other);
  if (!matches) return matches.error();
  std::vector<std::string> sizes;  // of those that are not as they should be in comparison
  std::string why = "there is no other " + category;
  for (const auto& match : *matches) {
    if (!is_another(match, *object, other)) continue;
    const auto model = draft.shop.fetch_model(match.asset.ref);
    if (!model) return model.error();
    Object made = remade(draft, *object, other, kind, match.asset, model->get());
    if (!is_as_told(other, kind, made.size, object->size)) {
      note_size(sizes, made.size);
      continue;
    }
    if (auto status = put_instead(draft, *object, std::move(made)); !status) {
      why = status.error().message;
      continue;
    }
    draft.new_categories.insert({object->category, category});
    if (is_other_kind) call_by_kind(draft, object->id, category, other.description);
    return {};
  }
  if (is_other_kind || !other.is_told) return cannot(object->id + " cannot be replaced: " + why);
  if (auto status = stretch_instead(draft, *object, other); !status) return none_is_so(*object, other, sizes, status);
  return {};
}

}  // namespace roomgen
