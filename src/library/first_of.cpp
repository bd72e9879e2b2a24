#include "roomgen/library/library.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace roomgen {

namespace {

class FirstOf final : public AssetLibrary {
 public:
  explicit FirstOf(std::vector<std::shared_ptr<const AssetLibrary>> libraries)
      : libraries_(std::move(libraries)) {}

  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    std::vector<AssetMatch> contradicting;
    for (const auto& library : libraries_) {
      auto matches = library->search(query);
      if (!matches) return matches;
      const auto contradicts = [](const AssetMatch& match) {
        return match.contradicts != Contradiction::none;
      };
      const auto first = std::stable_partition(matches->begin(), matches->end(), std::not_fn(contradicts));
      contradicting.insert(contradicting.end(), first, matches->end());
      matches->erase(first, matches->end());
      if (!matches->empty()) return matches;
    }
    std::stable_sort(contradicting.begin(), contradicting.end(), [](const AssetMatch& a, const AssetMatch& b) {
      return a.contradicts < b.contradicts;
    });
    return contradicting;
  }

  Result<AssetInfo> find(std::string_view key) const override {
    for (const auto& library : libraries_) {
      auto asset = library->find(key);
      if (asset || asset.error().kind != Error::Kind::not_found) return asset;
    }
    return AssetLibrary::find(key);
  }

  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    Error error{Error::Kind::not_found, asset_key(ref) + ": no library is open"};
    for (const auto& library : libraries_) {
      auto model = library->load(ref);
      if (model || model.error().kind != Error::Kind::not_found) return model;
      error = model.error();
    }
    return error;
  }

 private:
  std::vector<std::shared_ptr<const AssetLibrary>> libraries_;
};

}  // namespace

Result<AssetInfo> AssetLibrary::find(std::string_view key) const {
  return Error{Error::Kind::not_found, std::string(key) + ": no open library has this asset"};
}

std::unique_ptr<AssetLibrary> make_first_of(
    std::vector<std::shared_ptr<const AssetLibrary>> libraries) {
  return std::make_unique<FirstOf>(std::move(libraries));
}

}  // namespace roomgen
