#include <algorithm>

#include "index.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::assets {

namespace {

constexpr double hangs_from = 0.9;  // metres: what the library puts this high is on a wall
constexpr double near_ceiling = 2.0;
constexpr double small_side = 0.45;  // metres: what is this small stands on something
constexpr double small_height = 0.5;
constexpr double usual_wall_elevation = 1.2;

// The name first; where it says nothing that is known, the id, which often is the older name.
std::string kind_from_name(const SourceAsset& asset, const Vocabulary& vocabulary) {
  const auto by_name = vocabulary.understand_name(asset.info.name);
  if (by_name.known) return by_name.kind;
  const auto by_id = vocabulary.understand_name(file_name_of(asset.info.ref.id));
  return by_id.known ? by_id.kind : by_name.kind;
}

std::string kind_of(const SourceAsset& asset, const SeenAsset* seen, const Vocabulary& vocabulary) {
  if (seen) {
    const Kind* kind = vocabulary.find(seen->kind);
    return kind ? kind->name : seen->kind;
  }
  return asset.category ? vocabulary.understand(*asset.category).kind
                        : kind_from_name(asset, vocabulary);
}

bool is_small(const Vec3& size) {
  return size.head<2>().maxCoeff() <= small_side && size.z() <= small_height;
}

Mount guess_mount(const AssetInfo& info) {
  if (info.elevation >= near_ceiling) return Mount::ceiling;
  if (info.elevation >= hangs_from) return Mount::wall;
  return is_small(info.size) ? Mount::surface : Mount::floor;
}

Mount mount_of(const SourceAsset& asset, const AssetInfo& info, const SeenAsset* seen,
               const Kind* kind) {
  if (seen && seen->mount) return *seen->mount;
  if (asset.mount) return *asset.mount;
  // A small one of what usually is large and stands on the floor stands on something.
  if (kind && (kind->mount != Mount::floor || is_small(kind->size))) return kind->mount;
  return guess_mount(info);
}

// The height at which the kind usually hangs, if the library does not say.
double elevation_of(const AssetInfo& info, const KindTable& kinds) {
  if (info.mount != Mount::wall) return info.mount == Mount::ceiling ? info.elevation : 0.0;
  if (info.elevation > 0.0) return info.elevation;
  const Kind* category = kinds.find(info.category);
  return category && category->elevation > 0.0 ? category->elevation : usual_wall_elevation;
}

bool round_of(const SourceAsset& asset, const SeenAsset* seen) {
  return seen ? seen->shape == "round" || seen->shape == "oval" : asset.round.value_or(false);
}

bool front_of(const SourceAsset& asset, const AssetInfo& info, const SeenAsset* seen,
              const KindTable& kinds) {
  if (seen && !seen->front) return false;
  if (asset.front) return *asset.front;
  const Kind* category = kinds.find(info.category);
  return category ? category->traits.front : true;
}

// What is shown most is its colour where one of its two largest parts is seen so; else the largest
// part's goes first: meshes are drawn in colours that nobody sees as such.
void take_seen_color(const SeenAsset& seen, std::vector<std::string>& colors) {
  for (std::size_t i = std::min<std::size_t>(seen.parts.size(), 2); i-- > 0;) {
    const auto* meaning = AttributeWords::built_in().find(seen.parts[i].color);
    if (!meaning || meaning->colors.empty()) continue;
    const auto& names = meaning->colors;
    const auto is_named = [&](const std::string& color) {
      return std::find(names.begin(), names.end(), color) != names.end();
    };
    if (!colors.empty() && is_named(colors.front())) return;
    if (i > 0) continue;
    const auto shown = std::find_if(colors.begin(), colors.end(), is_named);
    if (shown == colors.end()) colors.insert(colors.begin(), names.front());
    else std::rotate(colors.begin(), shown, shown + 1);
  }
}

}  // namespace

AssetInfo classify(const SourceAsset& asset, const SeenAsset* seen, const Vocabulary& vocabulary) {
  AssetInfo info = asset.info;
  info.category = kind_of(asset, seen, vocabulary);
  const Kind* kind = vocabulary.find(info.category);
  info.mount = mount_of(asset, info, seen, kind);
  info.elevation = elevation_of(info, vocabulary.kinds());
  info.round = round_of(asset, seen);
  info.has_front = front_of(asset, info, seen, vocabulary.kinds());
  if (seen) {
    for (auto& word : seen->told()) info.tags.push_back(std::move(word));
    take_seen_color(*seen, info.colors);
  }
  if (!info.support_height && !asset.carries_nothing && kind && kind->supports)
    info.support_height = info.size.z();
  return info;
}

}  // namespace roomgen::assets
