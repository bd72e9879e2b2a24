#include "offers.h"

#include <algorithm>
#include <map>
#include <thread>

#include "base/threads.h"
#include "design/asset_text.h"
#include "evaluate/identity.h"
#include "library/asset_object.h"
#include "library/qualifiers.h"
#include "library/vocabulary.h"
#include "loads.h"
#include "retrieve.h"
#include "roomgen/base/text.h"
#include "roomgen/view/view.h"

namespace roomgen {

namespace {

constexpr std::size_t most_offers = 60;
constexpr std::size_t rows_of_offers = 10;
constexpr unsigned most_threads = 4;
constexpr int least_kind_rank = 3;  // of identity_rank(): it or a kind of it
constexpr std::size_t longest_title = 110, longest_caption = 40;  // bytes
// By these factors at most anything is stretched.
constexpr double least_factor = 0.05, most_factor = 20.0;

const PlanItem& item_of(const Workplace& place, const AssetOffer& offer) {
  return place.plan.items[offer.items.front()];
}

OfferedAsset offered(const Workplace& place, const PlanItem& item, const AssetInfo& asset) {
  const Vec3& usual = place.categories.get(item.category).size;
  return {asset, fitted_size(asset, usual, wanted_size(place, item)),
          fitted_size(asset, usual, least_factor * asset.size),
          fitted_size(asset, usual, most_factor * asset.size)};
}

// In other looks it is the same.
bool has(const std::vector<OfferedAsset>& assets, const AssetInfo& asset) {
  return std::any_of(assets.begin(), assets.end(), [&](const OfferedAsset& other) {
    AssetRef a = other.asset.ref, b = asset.ref;
    a.finish = b.finish = {};
    return asset_key(a) == asset_key(b);
  });
}

// Of another kind it would be no such thing, whatever it is called.
bool is_kin(const AssetInfo& asset, const PlanItem& item) {
  return asset.ref.procedural || Vocabulary::built_in().fit(asset.category, item.category) > 0.0 ||
         !Vocabulary::built_in().understand(item.category).known;
}

// `less`: than was asked for, which only what is in stock may be.
Status add_found(const Workplace& place, const PlanItem& item, bool less, std::size_t most,
                 AssetOffer& offer) {
  const PlannedObject planned{"", offer.items.front(), 0};
  auto found = retrieve({place.library, place.categories, place.options.seed}, {}, item, planned,
                        static_cast<int>(most + offer.assets.size()));
  if (!found) return found.error();
  for (auto& asset : *found)
    if (offer.assets.size() < most && !has(offer.assets, asset) && is_kin(asset, item) &&
        !(less && asset.ref.procedural))
      offer.assets.push_back(offered(place, item_of(place, offer), asset));
  return {};
}

// Who looks for a chair with arms in place of an office chair wants one.
std::string category_in(const std::string& words, const std::string& category) {
  const auto& vocabulary = Vocabulary::built_in();
  const KindPhrase own = own_name("", words);
  const bool is_related =
      own.known && (vocabulary.is_a(own.kind, category) || vocabulary.is_a(category, own.kind));
  return is_related ? own.kind : category;
}

PlanItem as_worded(PlanItem item, const std::string& words) {
  item.description = words;
  return item;
}

// Rules make things of many names, which seldom are them at a glance.
bool is_in_stock(const std::string& category, const AssetOffer& offer) {
  return std::any_of(offer.assets.begin(), offer.assets.end(), [&](const OfferedAsset& one) {
    Object object;
    object.asset = one.asset.ref;
    return !object.asset.procedural &&
           identity_rank(identify(object), category) >= least_kind_rank;
  });
}

// The library's answers, then those to less: of any size, then of any looks.
Status fill(const Workplace& place, const std::string& words, std::size_t most, AssetOffer& offer) {
  PlanItem item = item_of(place, offer);
  item.description = offer.words = words;
  item.category = category_in(words, item.category);
  item.varied = false;
  if (auto status = add_found(place, item, false, most, offer); !status) return status;
  item.asked = false;
  item.size.reset();
  if (auto status = add_found(place, item, true, most, offer); !status) return status;
  item.description.clear();
  if (auto status = add_found(place, item, true, most, offer); !status) return status;
  auto made = made_of(place, as_worded(item_of(place, offer), words), offer.size);
  if (!made) return made.error();
  offer.made = *std::move(made);
  const bool is_new = offer.made && offer.assets.size() < most && !has(offer.assets, *offer.made);
  if (is_new) offer.assets.push_back(offered(place, item_of(place, offer), *offer.made));
  offer.is_shown = is_in_stock(item_of(place, offer).category, offer);
  return {};
}

std::string words_key(const PlanItem& item) {
  std::string key = item.category + "|" + item.description + "|" + std::string(name(item.mount)) +
                    (item.varied ? "|varied" : "");
  if (item.size) key += "|" + size_text(*item.size);
  return key;
}

ContactSheet::Thing drawn(const AssetOffer& offer, std::size_t index) {
  const OfferedAsset& offered = offer.assets[index];
  Object object;
  object.category = offered.asset.category;
  object.asset = offered.asset.ref;
  object.size = offered.size;
  return {object, offer.label(index),
          shortened(size_text(offered.size) + " " + lower(offered.asset.name), longest_caption)};
}

// Meshes are read on all cores.
ModelTable models_of(const AssetLibrary& library, const std::vector<ContactSheet::Row>& rows) {
  std::map<std::string, AssetRef> assets;
  for (const auto& row : rows)
    for (const auto& thing : row.things)
      assets.emplace(asset_key(thing.object.asset), thing.object.asset);
  const std::vector<std::pair<std::string, AssetRef>> wanted(assets.begin(), assets.end());
  std::vector<std::shared_ptr<const Model>> read(wanted.size());
  const auto threads = std::clamp(std::thread::hardware_concurrency(), 1u, most_threads);
  share_out(wanted.size(), threads, [&](std::size_t, std::size_t i) {
    if (auto model = load_model(library, wanted[i].second)) read[i] = *std::move(model);
  });
  ModelTable models;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (read[i]) models.add(wanted[i].first, std::move(read[i]));
  return models;
}

}  // namespace

Vec3 wanted_size(const Workplace& place, const PlanItem& item) {
  return item.size.value_or(place.categories.get(item.category).size);
}

Result<std::optional<AssetInfo>> made_of(const Workplace& place, const PlanItem& item,
                                         const Vec3& size) {
  AssetQuery query;
  query.category = item.category;
  query.description = item.description;
  query.size = size;
  query.mount = item.mount;
  query.asked = query.sized = query.made = true;
  auto matches = place.library.search(query);
  if (!matches) return matches.error();
  for (auto& match : *matches)
    if (match.asset.ref.procedural) return std::optional(std::move(match.asset));
  return std::optional<AssetInfo>();
}

Result<std::vector<AssetOffer>> offers_of(Workplace& place, std::size_t& surplus) {
  std::vector<AssetOffer> offers;
  std::map<std::string, std::size_t> by_words;
  std::vector<std::string> carriers;
  surplus = 0;
  for (const auto& planned : planned_objects(place.plan)) {
    const PlanItem& item = place.plan.items[planned.item];
    const bool is_settled = !item.asset.empty() || !item.left_out.empty();
    if (is_settled || place.categories.get(item.category).covers_window) continue;
    const auto [known, is_new] = by_words.emplace(words_key(item), offers.size());
    if (is_new && offers.size() >= most_offers) {
      by_words.erase(known), ++surplus;
      continue;
    }
    if (is_new) {
      AssetOffer offer;
      offer.id = std::to_string(offers.size() + 1);
      offer.items = {planned.item};
      offer.count = 0;
      offer.size = wanted_size(place, item);
      const auto most = static_cast<std::size_t>(place.options.offers_per_item);
      if (auto status = fill(place, item.description, most, offer); !status) return status.error();
      offers.push_back(std::move(offer));
    }
    AssetOffer& offer = offers[known->second];
    ++offer.count;
    if (offer.items.back() != planned.item) offer.items.push_back(planned.item);
    offer.carries = offer.carries || !loads_on(planned.id, place).empty();
  }
  return offers;
}

Result<AssetOffer> searched_again(Workplace& place, const AssetOffer& offer,
                                  const std::string& words) {
  AssetOffer again = offer;
  again.assets.clear();
  const auto most = static_cast<std::size_t>(place.options.offers_per_item);
  if (auto status = fill(place, words, most, again); !status) return status.error();
  if (offer.assets.empty() || has(again.assets, offer.assets.front().asset)) return again;
  if (again.assets.size() >= most) again.assets.pop_back();
  again.assets.push_back(offer.assets.front());
  return again;
}

Result<std::vector<Image>> sheets_of(const Workplace& place,
                                     const std::vector<AssetOffer>& offers) {
  std::vector<ContactSheet::Row> rows;
  for (const auto& offer : offers) {
    if (offer.assets.empty()) continue;
    rows.push_back({shortened(design::offer_title(place.plan, offer), longest_title), {}});
    for (std::size_t a = 0; a < offer.assets.size(); ++a)
      rows.back().things.push_back(drawn(offer, a));
  }
  return pages_of(place, rows, rows_of_offers, ContactSheet().most_row);
}

Result<std::vector<Image>> pages_of(const Workplace& place,
                                    const std::vector<ContactSheet::Row>& rows,
                                    std::size_t rows_of_page, double most_row) {
  std::vector<Image> pages;
  const ModelTable models = models_of(place.library, rows);
  ContactSheet sheet;
  sheet.most_row = most_row;
  for (const auto& row : rows) {
    sheet.rows.push_back(row);
    if (sheet.rows.size() < rows_of_page && &row != &rows.back()) continue;
    auto page = place.options.renderer->sheet(sheet, models);
    if (!page) return page.error();
    pages.push_back(*std::move(page));
    sheet.rows.clear();
  }
  return pages;
}

}  // namespace roomgen
