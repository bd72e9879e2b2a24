#include <thread>

#include "base/threads.h"
#include "library/asset_object.h"
#include "scene/rounded_pose.h"
#include "roomgen/lab/optimise.h"

namespace roomgen::lab {

namespace {

/// What a library has of one kind.
struct Shelf {
  std::vector<AssetInfo> assets;
  std::vector<std::shared_ptr<const Model>> models;  ///< of the assets
  Status status;
};

constexpr double usual_size = 0.02;  // as near to the kind's own a size says nothing

Shelf fill(const StockWish& wish, const Kind& kind, const AssetLibrary& library, std::size_t count) {
  Shelf shelf;
  AssetQuery query;
  query.category = kind.name;
  query.description = wish.description;
  query.size = wish.size.value_or(kind.size);
  query.mount = wish.mount.value_or(kind.mount);
  query.asked = wish.asked;
  query.sized = wish.size && !wish.size->isApprox(kind.size, usual_size);
  query.limit = count;
  const auto matches = library.search(query);
  if (!matches) return shelf.status = matches.error(), shelf;
  for (const auto& match : *matches) {
    if ((match.asset.stand_in && !wish.asked) || shelf.assets.size() == count) continue;
    auto model = library.load(match.asset.ref);
    if (!model) continue;  // one damaged mesh is no reason to do without the others
    shelf.assets.push_back(match.asset);
    shelf.models.push_back(*model);
  }
  return shelf;
}

// Meshes are read on all cores.
std::vector<Shelf> fill_all(const std::vector<StockWish>& wishes, const AssetLibrary& library, const KindTable& table,
                            std::size_t count) {
  std::vector<Shelf> shelves(wishes.size());
  const auto threads = std::max(1u, std::thread::hardware_concurrency());
  share_out(wishes.size(), threads, [&](std::size_t, std::size_t i) {
    shelves[i] = fill(wishes[i], table.get(wishes[i].kind), library, count);
  });
  return shelves;
}

// As scene.json keeps it, so that what is judged is what is written.
Vec3 fitted_to(const StockWish& wish, const AssetInfo& asset, const Kind& kind) {
  if (!wish.size) return rounded_position(asset.size);
  return rounded_position(fitted_size(asset, kind.size, *wish.size));
}

}  // namespace

std::vector<StockWish> wishes_for(const std::vector<std::string>& kinds) {
  std::vector<StockWish> wishes;
  for (const auto& kind : kinds) wishes.push_back({kind});
  return wishes;
}

Result<Stock> load_stock(const std::vector<StockWish>& wishes, const AssetLibrary& library, const KindTable& table,
                         std::size_t per_kind) {
  Stock stock;
  const auto shelves = fill_all(wishes, library, table, per_kind);
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    const std::string& kind = wishes[i].kind;
    const Shelf& shelf = shelves[i];
    if (!shelf.status) return shelf.status.error();
    if (shelf.assets.empty()) stock.missing.push_back(kind);
    for (std::size_t k = 0; k < shelf.assets.size(); ++k) {
      const AssetInfo& asset = shelf.assets[k];
      Object object =
          object_of_asset(asset, table.get(kind), fitted_to(wishes[i], asset, table.get(kind)), shelf.models[k].get());
      object.category = kind;
      object.description = asset.name;
      stock.articles[kind].push_back(std::move(object));
      stock.models.add(asset_key(asset.ref), shelf.models[k]);
      stock.assets.push_back(asset);
    }
  }
  return stock;
}

}  // namespace roomgen::lab
