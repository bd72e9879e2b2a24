#include <atomic>
#include <thread>

#include "library/asset_object.h"
#include "roomgen/optimise/optimise.h"

namespace roomgen {

namespace {

/// What a library has of one kind.
struct Shelf {
  std::vector<AssetInfo> assets;
  std::vector<std::shared_ptr<const Model>> models;  ///< of the assets
  Status status;
};

Shelf fill(const Kind& kind, const AssetLibrary& library, std::size_t count) {
  Shelf shelf;
  AssetQuery query;
  query.category = kind.name;
  query.size = kind.size;
  query.mount = kind.mount;
  query.limit = count;
  const auto matches = library.search(query);
  if (!matches) return shelf.status = matches.error(), shelf;
  for (const auto& match : *matches) {
    if (match.asset.stand_in || shelf.assets.size() == count) continue;
    auto model = library.load(match.asset.ref);
    if (!model) continue;  // one damaged mesh is no reason to do without the others
    shelf.assets.push_back(match.asset);
    shelf.models.push_back(*model);
  }
  return shelf;
}

// Meshes are read on all cores.
std::vector<Shelf> fill_all(const std::vector<std::string>& kinds, const AssetLibrary& library, const KindTable& table,
                            std::size_t count) {
  std::vector<Shelf> shelves(kinds.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < kinds.size(); i = next++) shelves[i] = fill(table.get(kinds[i]), library, count);
  };
  std::vector<std::thread> others;
  for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i) others.emplace_back(work);
  work();
  for (auto& other : others) other.join();
  return shelves;
}

}  // namespace

Result<Stock> load_stock(const std::vector<std::string>& kinds, const AssetLibrary& library, const KindTable& table,
                         std::size_t per_kind) {
  Stock stock;
  const auto shelves = fill_all(kinds, library, table, per_kind);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const Shelf& shelf = shelves[i];
    if (!shelf.status) return shelf.status.error();
    for (std::size_t k = 0; k < shelf.assets.size(); ++k) {
      const AssetInfo& asset = shelf.assets[k];
      Object object = object_of_asset(asset, table.get(kinds[i]), asset.size, shelf.models[k].get());
      object.category = kinds[i];
      object.description = asset.name;
      stock.articles[kinds[i]].push_back(std::move(object));
      stock.models.add(asset_key(asset.ref), shelf.models[k]);
      stock.assets.push_back(asset);
    }
  }
  return stock;
}

}  // namespace roomgen
