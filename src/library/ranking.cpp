#include "ranking.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace roomgen {

namespace {

constexpr double softening = 0.1;  // metres
constexpr double largest_ratio = 2.1;
constexpr double falloff = 1.4;  // a ratio of 1.3 on one axis costs about 7 %
constexpr double text_share = 0.45;
constexpr double size_share = 0.6;
constexpr double low_enough = 0.7;  // metres: stands on the floor or on something

double axis_similarity(double have, double want) {
  const double ratio = (have + softening) / (want + softening);
  const double distance = std::abs(std::log(ratio));
  if (distance > std::log(largest_ratio)) return 0.0;
  return std::exp(-falloff * distance * distance / std::log(largest_ratio));
}

}  // namespace

double size_similarity(const Vec3& have, const Vec3& want) {
  return axis_similarity(have.x(), want.x()) * axis_similarity(have.y(), want.y()) *
         axis_similarity(have.z(), want.z());
}

double text_relevance(const std::vector<WeightedWord>& wanted) {
  double found = 0.0, all = 0.0;
  for (const auto& word : wanted) {
    all += word.weight;
    found += word.weight * word.found;
  }
  return all > 0.0 ? found / all : 1.0;
}

double match_score(const MatchTerms& terms) {
  if (terms.kind <= 0.0 || terms.size <= 0.0 || terms.mount <= 0.0) return 0.0;
  const double text = 1.0 - text_share + text_share * terms.text;
  const double size = 1.0 - size_share + size_share * terms.size;
  return std::clamp(terms.kind * terms.mount * text * size, 0.0, 1.0);
}

double mount_fit(Mount have, Mount want, const std::vector<Mount>& also, double height) {
  if (have == want) return 1.0;
  if (std::find(also.begin(), also.end(), want) != also.end()) return 0.9;
  const bool standing = (have == Mount::floor && want == Mount::surface) ||
                        (have == Mount::surface && want == Mount::floor);
  return standing && height <= low_enough ? 0.7 : 0.0;
}

void rank(std::vector<AssetMatch>& matches, std::size_t limit) {
  const auto better = [](const AssetMatch& a, const AssetMatch& b) {
    const auto worth = [](double score) { return std::round(-score * 1e6); };
    return std::make_tuple(a.contradicts, worth(a.score), a.asset.ref.library, a.asset.ref.id) <
           std::make_tuple(b.contradicts, worth(b.score), b.asset.ref.library, b.asset.ref.id);
  };
  std::sort(matches.begin(), matches.end(), better);
  if (matches.size() > limit) matches.resize(limit);
}

}  // namespace roomgen
