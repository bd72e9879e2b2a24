#include "retrieve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/written_asset.h"

namespace roomgen {

namespace {

// Scores that differ by less are equally good answers to the same words.
constexpr double equal_score = 0.06;
constexpr double same_size = 0.02;

// What is asked for in the same words looks the same: six chairs of which three stand on each side.
std::string words_of(const PlanItem& item) {
  if (!item.asset.empty()) return item.asset;
  std::string text = item.category + "|" + item.description;
  if (item.size)
    for (int axis = 0; axis < 3; ++axis)
      text += "|" + std::to_string(std::lround(1000 * (*item.size)[axis]));
  return text;
}

// The equally good ones at the top change places by the seed; of things that vary each begins with another
// one, and what is built is built anew for each.
void shuffle_top(std::vector<AssetMatch>& matches, Random random, const PlanItem& item,
                 const PlannedObject& planned) {
  std::vector<AssetMatch> top;
  for (const auto& match : matches)
    if (match.contradicts == matches.front().contradicts &&
        match.score >= matches.front().score - equal_score)
      top.push_back(match);
  random.shuffle(top);
  if (item.varied && !top.empty()) {
    std::rotate(top.begin(), top.begin() + planned.number % static_cast<int>(top.size()), top.end());
    Random looks = random.fork(std::to_string(planned.number));
    for (auto& match : top)
      if (auto& built = match.asset.ref.procedural)
        built->seed = static_cast<std::uint64_t>(looks.integer(0, std::numeric_limits<int>::max()));
  }
  std::copy(top.begin(), top.end(), matches.begin());
}

AssetQuery query_for(const PlanItem& item, const KindTable& categories) {
  const Kind* kind = categories.find(item.category);
  const Vec3 usual_size = kind ? kind->size : categories.get(item.category).size;
  AssetQuery query;
  query.category = item.category;
  query.description = item.description;
  query.size = item.size.value_or(usual_size);
  // A picture that leans is one that hangs elsewhere.
  query.mount = kind && !item.tilt.isZero() ? kind->mount : item.mount;
  query.asked = item.asked;
  query.sized = item.size && (kind || !item.size->isApprox(usual_size, same_size));
  return query;
}

// By its key. Of things that vary the first one takes it, and all what was written for them alone.
std::optional<AssetInfo> chosen_for(const AssetSearch& search, const Favourites& favourites,
                                    const PlanItem& item, const PlannedObject& planned) {
  if (item.asset.empty()) return std::nullopt;
  std::optional<AssetInfo> chosen;
  if (const auto known = favourites.find(item.asset); known != favourites.end())
    chosen = known->second;
  else if (auto asset = search.library.find(item.asset))
    chosen = *std::move(asset);
  const bool is_own = chosen && is_written(chosen->ref);
  if (item.varied && planned.number > 0 && !is_own) return std::nullopt;
  return chosen;
}

}  // namespace

Result<std::vector<AssetInfo>> retrieve(const AssetSearch& search, const Favourites& favourites,
                                        const PlanItem& item, const PlannedObject& planned,
                                        int count) {
  const AssetQuery query = query_for(item, search.categories);
  if (auto chosen = chosen_for(search, favourites, item, planned)) {
    chosen->mount = query.mount.value_or(chosen->mount);
    return std::vector<AssetInfo>{*std::move(chosen)};  // nothing takes its place unasked
  }
  auto matches = search.library.search(query);
  if (!matches) return matches.error();

  shuffle_top(*matches, Random(search.seed).fork("item " + std::to_string(planned.item)), item,
              planned);

  std::vector<AssetInfo> result;
  if (const AssetInfo* known = favourite(favourites, item)) result.push_back(*known);
  for (const auto& match : *matches) {
    if (static_cast<int>(result.size()) >= count) break;
    const bool again = !result.empty() && result.front().ref == match.asset.ref;
    if (!again) result.push_back(match.asset);
  }
  return result;
}

const AssetInfo* favourite(const Favourites& favourites, const PlanItem& item) {
  const auto chosen = item.varied ? favourites.end() : favourites.find(words_of(item));
  return chosen == favourites.end() ? nullptr : &chosen->second;
}

void remember(Favourites& favourites, const PlanItem& item, const AssetInfo& asset) {
  favourites.try_emplace(words_of(item), asset);
}

}  // namespace roomgen
