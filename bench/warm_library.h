#pragma once

#include <cstdio>
#include <map>
#include <memory>
#include <string>

#include "roomgen/assets/catalogue.h"
#include "roomgen/create/create.h"
#include "roomgen/library/library.h"

namespace roomgen::bench {

/// A library that keeps what it has loaded, so that reading meshes is measured once only.
class WarmLibrary final : public AssetLibrary {
 public:
  /// `library` must outlive this.
  explicit WarmLibrary(const AssetLibrary& library) : library_(library) {}

  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    return library_.search(query);
  }
  Result<AssetInfo> find(std::string_view key) const override { return library_.find(key); }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    auto& kept = models_[asset_key(ref)];
    if (kept) return kept;
    auto model = library_.load(ref);
    if (model) kept = *model;
    return model;
  }

 private:
  const AssetLibrary& library_;
  mutable std::map<std::string, std::shared_ptr<const Model>> models_;
};

/// The furniture that is installed, then what is built from words; null, which is told, where none is installed.
inline std::unique_ptr<AssetLibrary> installed_library() {
  auto catalogue = assets::open_catalogue({});
  if (!catalogue) return std::puts("(no furniture)"), nullptr;
  return make_first_of({*std::move(catalogue), create::make_created_library()});
}

}  // namespace roomgen::bench
