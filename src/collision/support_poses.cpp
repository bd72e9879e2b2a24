#include "support_poses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "resting_body.h"
#include "sized_mesh.h"

namespace roomgen {

namespace {

using detail::Columns;
using detail::RestingBody;
using detail::Underside;
using detail::is_over;
using detail::touching;

constexpr double headroom = 0.005;
constexpr double flat_range = 0.0005;   // of heights that count as one
constexpr double inset = 0.004;         // of the footprint that must be on the surface
constexpr double least_share = 0.9;     // of a footprint that hangs over
constexpr double reach = 0.04;          // of curved tops about the middle height
constexpr double most_places = 160;     // a surface and turn
constexpr std::size_t most_places_kept = 20000;  // places of one pair

// What the mask says of a footprint.
struct Under {
  double share = 0.0;
  double low = 1e9, high = -1e9;
  double clear_to = 1e9;  // the lowest of what is above
};

// Nothing if less than `share` of the footprint is on the surface.
std::optional<Under> look_under(const SupportSurface& surface, const Footprint& footprint,
                                double share) {
  const Vec2 half = (footprint.half().array() - inset).max(1e-3);
  const int nx = std::clamp(static_cast<int>(std::ceil(2 * half.x() / 0.018)), 2, 40);
  const int ny = std::clamp(static_cast<int>(std::ceil(2 * half.y() / 0.018)), 2, 40);
  const double most_missed = (1.0 - share) * (nx + 1) * (ny + 1) + 1e-9;
  Under under;
  int asked = 0, carried = 0;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const Vec2 unit(2.0 * i / nx - 1.0, 2.0 * j / ny - 1.0);
      if (footprint.round() && unit.squaredNorm() > 1.0) continue;
      ++asked;
      const auto* cell = surface.at(footprint.to_world(unit.cwiseProduct(half)));
      if (!cell && asked - carried > most_missed) return std::nullopt;
      if (!cell) continue;
      ++carried;
      under.low = std::min<double>(under.low, cell->height);
      under.high = std::max<double>(under.high, cell->height);
      under.clear_to = std::min<double>(under.clear_to, cell->height + cell->clearance);
    }
  under.share = static_cast<double>(carried) / std::max(1, asked);
  if (under.share < share) return std::nullopt;
  return under;
}

// Cells have their middles on the surface; the rim of the footprint is asked of the mesh itself.
bool rim_is_carried(const Columns& columns, const Footprint& footprint, double low, double high) {
  const Vec2 half = (footprint.half().array() - inset).max(1e-3);
  const double corner = footprint.round() ? std::sqrt(0.5) : 1.0;
  for (double x : {-1.0, 0.0, 1.0})
    for (double y : {-1.0, 0.0, 1.0}) {
      const double pull = x != 0.0 && y != 0.0 ? corner : 1.0;
      const Vec2 at = footprint.to_world({pull * x * half.x(), pull * y * half.y()});
      if (!columns.highest(at, low - 0.01, high + 0.01)) return false;
    }
  return true;
}

/// One thing on another, with what has been found of the pair.
class RestingPair {
 public:
  RestingPair(const Object& object, RestingBody& upper, RestingBody& lower)
      : size_(object.size),
        front_(object.traits.front),
        round_(object.traits.round),
        upper_(upper),
        lower_(lower) {}

  const std::vector<SupportPose>& everywhere() {
    if (everywhere_) return *everywhere_;
    everywhere_.emplace();
    for (double share : {1.0, least_share}) {
      visit_all(share, [&](const SupportPose& pose) {
        everywhere_->push_back(pose);
        return true;
      });
      if (!everywhere_->empty()) break;
    }
    return *everywhere_;
  }

  bool is_anywhere(double highest_bottom) {
    const auto is_low = [&](const SupportPose& pose) { return pose.bottom <= highest_bottom; };
    if (everywhere_) return std::any_of(everywhere_->begin(), everywhere_->end(), is_low);
    bool any = false, found = false;
    for (double share : {1.0, least_share}) {
      visit_all(share, [&](const SupportPose& pose) {
        any = true;
        found = is_low(pose);
        return !found;
      });
      if (any) break;
    }
    return found;
  }

  /// Searches ask for the same places beside the same things again and again.
  const std::vector<SupportPose>& at(const SupportPoses::Place& place) {
    const std::array<double, 3> key = {place.position.x(), place.position.y(), place.yaw};
    if (const auto known = at_.find(key); known != at_.end()) return known->second;
    if (at_.size() >= most_places_kept) at_.clear();
    std::vector<SupportPose> found;
    for (std::size_t k = 0; k < lower_.surfaces().size(); ++k)
      if (const auto pose = rest(k, place, 1.0)) found.push_back(*pose);
    return at_.emplace(key, std::move(found)).first->second;
  }

 private:
  // Lowers the object onto the mesh of the support.
  std::optional<double> lowered(const Underside& underside, const Columns& columns,
                                const SupportSurface& surface, const SupportPose& pose) const {
    struct Below {
      Vec2 at;
      double top, z;
    };
    std::vector<Below> found;
    double bottom = -1e9;
    for (const auto& p : underside.points) {
      const Vec2 at = pose.position + rotated(Vec2(p.head<2>()), pose.yaw);
      const auto top = columns.highest(at, surface.height - reach, surface.height + reach);
      if (!top) continue;
      found.push_back({at, *top, p.z()});
      bottom = std::max(bottom, *top - p.z());
    }
    std::vector<Vec2> contacts;
    for (const auto& below : found)
      if (bottom + below.z - below.top <= touching) contacts.push_back(below.at);
    const Vec2 centroid = pose.position + rotated(underside.centroid, pose.yaw);
    if (contacts.size() < 3 || (underside.stands && !is_over(centroid, contacts)))
      return std::nullopt;
    return bottom;
  }

  std::optional<SupportPose> rest(std::size_t index, const SupportPoses::Place& place,
                                  double share) {
    const SupportSurface& surface = lower_.surfaces()[index];
    const Footprint footprint(place.position, size_.head<2>(), place.yaw, round_);
    if (!surface.box().overlaps(footprint.bounds())) return std::nullopt;
    const auto under = look_under(surface, footprint, share);
    if (!under || under->low + size_.z() + headroom > under->clear_to) return std::nullopt;
    const Columns& columns = lower_.columns();
    if (share >= 1.0 && !rim_is_carried(columns, footprint, under->low, under->high))
      return std::nullopt;
    SupportPose pose{place.position, under->high, place.yaw, index};
    const bool whole = under->share >= 1.0;
    if (whole && under->high - under->low <= flat_range) return pose;
    const auto bottom = lowered(upper_.underside(), columns, surface, pose);
    if (!bottom || *bottom + size_.z() + headroom > under->clear_to) return std::nullopt;
    pose.bottom = *bottom;
    return pose;
  }

  template <typename Visit>
  void visit_all(double share, const Visit& visit) {
    for (std::size_t k = 0; k < lower_.surfaces().size(); ++k)
      if (!visit_on(k, share, visit)) return;
  }

  // Whether `visit` wants to see more.
  template <typename Visit>
  bool visit_on(std::size_t index, double share, const Visit& visit) {
    const SupportSurface& surface = lower_.surfaces()[index];
    const bool square = std::abs(size_.x() - size_.y()) < 1e-6;
    std::vector<double> turns = {0.0, pi / 2, pi, -pi / 2};
    if (!front_) turns.resize(square ? 1 : 2);
    const Bounds2 box = surface.box();
    for (double yaw : turns) {
      const Vec2 own = std::abs(std::sin(yaw)) > 0.5 ? Vec2(size_.y(), size_.x())
                                                     : Vec2(size_.head<2>());
      // What hangs over may do so by a tenth.
      const Vec2 spare = 0.5 * (box.size() - own) + (share < 1.0 ? 0.05 : 0.0) * own;
      if (spare.minCoeff() < -0.01) continue;
      const Vec2 room = spare.cwiseMax(0.0);
      const double step = std::max(0.03, std::sqrt(4.0 * room.x() * room.y() / most_places));
      const int nx = static_cast<int>(std::ceil(room.x() / step));
      const int ny = static_cast<int>(std::ceil(room.y() / step));
      const Vec2 middle = 0.5 * (box.low + box.high);
      for (int j = -ny; j <= ny; ++j)
        for (int i = -nx; i <= nx; ++i) {
          const Vec2 at(nx ? room.x() * i / nx : 0.0, ny ? room.y() * j / ny : 0.0);
          const auto pose = rest(index, {middle + at, yaw}, share);
          if (pose && !visit(*pose)) return false;
        }
    }
    return true;
  }

  Vec3 size_;
  bool front_, round_;
  RestingBody& upper_;
  RestingBody& lower_;
  std::optional<std::vector<SupportPose>> everywhere_;
  std::map<std::array<double, 3>, std::vector<SupportPose>> at_;
};

}  // namespace

struct SupportPoses::Impl {
  const ModelTable& models;
  std::map<std::string, RestingBody> bodies;
  std::map<std::string, RestingPair> pairs;

  RestingBody& body(const Object& object) {
    return body(object, detail::sized_key(object, models));
  }
  RestingBody& body(const Object& object, const std::string& key) {
    return bodies.try_emplace(key, object, models).first->second;
  }

  RestingPair& pair(const Object& object, const Object& support) {
    const std::string upper = detail::sized_key(object, models);
    const std::string lower = detail::sized_key(support, models);
    std::string key = upper + (object.traits.front ? "|front" : "") +
                      (object.traits.round ? "|round" : "") + " on " + lower;
    if (const auto known = pairs.find(key); known != pairs.end()) return known->second;
    return pairs.try_emplace(std::move(key), object, body(object, upper), body(support, lower))
        .first->second;
  }
};

SupportPoses::SupportPoses(const ModelTable& models)
    : impl_(std::make_unique<Impl>(Impl{models, {}, {}})) {}
SupportPoses::~SupportPoses() = default;

const std::vector<SupportSurface>& SupportPoses::surfaces(const Object& support) const {
  return impl_->body(support).surfaces();
}

const std::vector<SupportPose>& SupportPoses::everywhere(const Object& object,
                                                         const Object& support) const {
  return impl_->pair(object, support).everywhere();
}

bool SupportPoses::carries(const Object& object, const Object& support,
                           double highest_bottom) const {
  return impl_->pair(object, support).is_anywhere(highest_bottom);
}

std::vector<SupportPose> SupportPoses::at(const Object& object, const Object& support,
                                          std::span<const Place> places) const {
  std::vector<SupportPose> found;
  if (places.empty()) return found;
  RestingPair& pair = impl_->pair(object, support);
  for (const auto& place : places) {
    const auto& here = pair.at(place);
    found.insert(found.end(), here.begin(), here.end());
  }
  return found;
}

}  // namespace roomgen
