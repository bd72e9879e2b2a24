#include "fit_openings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace roomgen {

namespace {

constexpr double least_stretch = 0.75, most_stretch = 1.3;
constexpr int most_side_by_side = 8;
// Meshes whose distortion differs by less fit equally well.
constexpr double equal_fit = 0.12;
constexpr std::size_t most_meshes = 200;

bool is_fair(double stretch) {
  return stretch >= least_stretch && stretch <= most_stretch;
}

struct Fit {
  Joinery joinery;
  std::vector<Vec2> outline;
  double distortion = 0.0;
};

// Does the hinge of a door's only leaf hang at the left of who looks at the mesh's front? The front
// looks where the door opens; from inside the room the wall runs from right to left.
bool hinge_is_left(const Opening& door) {
  return door.swing == DoorSwing::out ? door.hinge_at_from : !door.hinge_at_from;
}

bool is_hinged(const Opening& opening) {
  return opening.type == OpeningType::door && opening.swing != DoorSwing::sliding;
}

// The mesh's outline is seen from its front, which for a window is the room.
std::vector<Vec2> along_the_wall(std::vector<Vec2> outline) {
  for (auto& p : outline) p.x() = 1.0 - p.x();
  std::reverse(outline.begin(), outline.end());
  return outline;
}

std::optional<Fit> fit_of(const Opening& opening, const AssetInfo& asset) {
  if (!asset.wall_fit) return std::nullopt;
  const WallFit& wall = *asset.wall_fit;
  const bool window = opening.type == OpeningType::window;
  if (wall.outline.empty() != opening.outline.empty()) return std::nullopt;
  if (!window && !opening.outline.empty()) return std::nullopt;
  if (is_hinged(opening) && wall.leaves != opening.leaves) return std::nullopt;
  const double high = (opening.head - opening.sill) / asset.size.z();
  const int most = window && opening.outline.empty() ? most_side_by_side : 1;
  std::optional<Fit> best;
  for (int n = 1; n <= most; ++n) {
    const double wide = opening.width() / n / asset.size.x();
    if (!is_fair(wide) || !is_fair(high)) continue;
    const double distortion = std::abs(std::log(wide / high)) +
                              0.3 * (std::abs(std::log(wide)) + std::abs(std::log(high)));
    if (best && best->distortion <= distortion) continue;
    best = Fit{{asset.ref, wall.wall_front, wall.wall_back, false, n},
               along_the_wall(wall.outline),
               distortion};
    best->joinery.mirrored =
        is_hinged(opening) && wall.leaves == 1 && wall.hinge_left != hinge_is_left(opening);
  }
  return best;
}

bool has_tag(const AssetInfo& asset, const std::string& word) {
  return std::find(asset.tags.begin(), asset.tags.end(), word) != asset.tags.end();
}

class OpeningFitter {
 public:
  OpeningFitter(const OpeningKinds& kinds, const AssetLibrary& library, const Random& random)
      : kinds_(kinds), library_(library), random_(random) {}

  Status run(Room& room) {
    for (auto& opening : room.openings) {
      const OpeningKind* kind = kinds_.of(opening);
      if (!kind || !opening.joinery.asset.is_box()) continue;
      for (const auto& word : kind->meshes) {
        const auto done = give(opening, *kind, word);
        if (!done) return done.error();
        if (*done) break;
      }
    }
    return {};
  }

  std::vector<AssetInfo> take_used() { return std::move(used_); }

 private:
  // All meshes that this word names, in an order of their own.
  Result<const std::vector<AssetInfo>*> meshes(OpeningType type, const std::string& word) {
    const std::string key = std::string(name(type)) + " " + word;
    if (const auto known = meshes_.find(key); known != meshes_.end()) return &known->second;
    AssetQuery query;
    query.category = name(type);
    query.description = word;
    query.limit = most_meshes;
    auto matches = library_.search(query);
    if (!matches) return matches.error();
    std::vector<AssetInfo> found;
    for (const auto& match : *matches)
      if (has_tag(match.asset, word)) found.push_back(match.asset);
    return &meshes_.emplace(key, std::move(found)).first->second;
  }

  // Doors may be windows that reach the floor, and are found under that name.
  Result<bool> give(Opening& opening, const OpeningKind& kind, const std::string& word) {
    for (const auto type : {opening.type, OpeningType::window, OpeningType::door}) {
      const auto all = meshes(type, word);
      if (!all) return all.error();
      const AssetInfo* best = choose(opening, kind, **all);
      if (!best) continue;
      const Fit fit = *fit_of(opening, *best);
      opening.joinery = fit.joinery;
      if (!fit.outline.empty()) opening.outline = fit.outline;
      remember(kind, *best);
      return true;
    }
    return false;
  }

  const AssetInfo* choose(const Opening& opening, const OpeningKind& kind,
                          const std::vector<AssetInfo>& all) {
    const auto last = chosen_.find(kind.name);
    std::vector<std::pair<const AssetInfo*, double>> fitting;
    double least = 1e9;
    for (const auto& asset : all) {
      const auto fit = fit_of(opening, asset);
      if (!fit) continue;
      if (last != chosen_.end() && last->second == asset.ref) return &asset;
      fitting.emplace_back(&asset, fit->distortion);
      least = std::min(least, fit->distortion);
    }
    std::erase_if(fitting, [&](const auto& one) { return one.second > least + equal_fit; });
    if (fitting.empty()) return nullptr;
    return random_.fork(kind.name).pick(fitting).first;
  }

  void remember(const OpeningKind& kind, const AssetInfo& asset) {
    chosen_.try_emplace(kind.name, asset.ref);
    const bool known = std::any_of(used_.begin(), used_.end(),
                                   [&](const AssetInfo& one) { return one.ref == asset.ref; });
    if (!known) used_.push_back(asset);
  }

  const OpeningKinds& kinds_;
  const AssetLibrary& library_;
  const Random& random_;
  std::map<std::string, std::vector<AssetInfo>> meshes_;  ///< by type and word
  std::map<std::string, AssetRef> chosen_;                ///< by kind
  std::vector<AssetInfo> used_;
};

}  // namespace

Result<std::vector<AssetInfo>> fit_openings(Room& room, const OpeningKinds& kinds,
                                            const AssetLibrary& library, const Random& random) {
  OpeningFitter joiner(kinds, library, random);
  if (auto status = joiner.run(room); !status) return status.error();
  return joiner.take_used();
}

}  // namespace roomgen
