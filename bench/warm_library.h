#pragma once

#include <map>
#include <memory>
#include <string>

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

}  // namespace roomgen::bench
