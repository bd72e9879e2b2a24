#pragma once

#include <memory>

#include "roomgen/kinds/kind_table.h"
#include "roomgen/library/library.h"

/// Has of each kind a box of its usual size.
class BoxLibrary final : public roomgen::AssetLibrary {
 public:
  roomgen::Result<std::vector<roomgen::AssetMatch>> search(const roomgen::AssetQuery& query) const override {
    const roomgen::Kind& kind = roomgen::KindTable::built_in().get(query.category);
    if (kind.lineage.empty()) return std::vector<roomgen::AssetMatch>{};
    roomgen::AssetMatch match;
    match.asset.ref.library = "boxes";
    match.asset.ref.id = kind.name;
    match.asset.name = match.asset.category = kind.name;
    match.asset.size = kind.size;
    match.asset.mount = query.mount.value_or(kind.mount);
    match.asset.has_front = kind.traits.front;
    match.score = 1.0;
    return std::vector<roomgen::AssetMatch>{match};
  }

  roomgen::Result<std::shared_ptr<const roomgen::Model>> load(const roomgen::AssetRef& ref) const override {
    const roomgen::Vec3 size = roomgen::KindTable::built_in().get(ref.id).size;
    auto model = std::make_shared<roomgen::Model>();
    model->materials.push_back({});
    model->parts.push_back(
        {roomgen::make_box({-0.5 * size.x(), -0.5 * size.y(), 0.0}, {0.5 * size.x(), 0.5 * size.y(), size.z()}), 0});
    return std::shared_ptr<const roomgen::Model>(model);
  }
};
