#include "support_poses.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "columns.h"
#include "geometry/centroid.h"
#include "geometry/convex_hull.h"
#include "scene/box_model.h"
#include "sized_mesh.h"

namespace roomgen {

namespace {

using detail::Columns;

constexpr double touching = 0.002;      // metres
constexpr double headroom = 0.005;
constexpr double flat_range = 0.0005;   // of heights that count as one
constexpr double inset = 0.004;         // of the footprint that must be on the surface
constexpr double least_share = 0.9;     // of a footprint that hangs over
constexpr double reach = 0.04;          // of curved tops about the middle height
constexpr double low_part = 0.06;       // of an object that may touch a curved top
constexpr double most_places = 160;     // a surface and turn
constexpr double hull_slack = 0.002;

bool is_upright(const Mesh& mesh, const Triangle& t) {
  const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
             c = mesh.positions[t[2]].cast<double>();
  const Vec3 normal = (b - a).cross(c - a);
  return std::abs(normal.z()) < 0.5 * normal.norm();
}

// What rests: sampled points of its underside, and where its weight is.
struct Underside {
  std::vector<Vec3> points;
  Vec2 centroid = Vec2::Zero();
  bool stands = false;  // upright on a level floor
};

struct RestingBody {
  explicit RestingBody(Mesh scaled) : mesh(std::move(scaled)), columns(mesh) {}
  Mesh mesh;
  Columns columns;
  std::optional<std::vector<SupportSurface>> surfaces;
  std::optional<Underside> underside;
};

bool is_over(const Vec2& point, std::vector<Vec2> contacts) {
  const auto hull = convex_hull(std::move(contacts));
  return hull.size() >= 3 && depth_in(hull, point) >= -hull_slack;
}

Underside underside_of(const Mesh& mesh, const Columns& columns) {
  Underside underside;
  underside.centroid = surface_centroid(mesh).head<2>();
  const Vec3 size = columns.box().size();
  const double step = std::clamp(size.head<2>().maxCoeff() / 24.0, 0.004, 0.03);
  const int nx = std::max(2, static_cast<int>(size.x() / step));
  const int ny = std::max(2, static_cast<int>(size.y() / step));
  const Vec2 low = columns.box().low.head<2>();
  const Vec2 cell(size.x() / nx, size.y() / ny);
  const double bottom = columns.box().low.z();
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const Vec2 at = low + Vec2((i + 0.5) * cell.x(), (j + 0.5) * cell.y());
      const auto z = columns.lowest(at);
      if (z && *z < bottom + low_part) underside.points.push_back({at.x(), at.y(), *z - bottom});
    }
  // What the grid misses: the lowest vertex of each of its cells.
  std::map<std::pair<int, int>, Vec3> lowest;
  for (const auto& p : mesh.positions) {
    if (p.z() > bottom + low_part) continue;
    const Vec3 point(p.x(), p.y(), p.z() - bottom);
    const std::pair<int, int> key(static_cast<int>((p.x() - low.x()) / cell.x()),
                                  static_cast<int>((p.y() - low.y()) / cell.y()));
    const auto [at, is_new] = lowest.try_emplace(key, point);
    if (!is_new && point.z() < at->second.z()) at->second = point;
  }
  for (const auto& [key, point] : lowest) underside.points.push_back(point);
  std::vector<Vec2> contacts;
  for (const auto& p : underside.points)
    if (p.z() <= touching) contacts.push_back(p.head<2>());
  underside.stands = is_over(underside.centroid, contacts);
  return underside;
}

// What the mask says of a footprint.
struct Under {
  double share = 0.0;
  double low = 1e9, high = -1e9;
  double clear_to = 1e9;  // the lowest of what is above
};

Under look_under(const SupportSurface& surface, const Footprint& footprint) {
  const Vec2 half = (footprint.half().array() - inset).max(1e-3);
  const int nx = std::clamp(static_cast<int>(std::ceil(2 * half.x() / 0.018)), 2, 40);
  const int ny = std::clamp(static_cast<int>(std::ceil(2 * half.y() / 0.018)), 2, 40);
  Under under;
  int asked = 0, carried = 0;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const Vec2 unit(2.0 * i / nx - 1.0, 2.0 * j / ny - 1.0);
      if (footprint.round() && unit.squaredNorm() > 1.0) continue;
      ++asked;
      const auto* cell = surface.at(footprint.to_world(unit.cwiseProduct(half)));
      if (!cell) continue;
      ++carried;
      under.low = std::min<double>(under.low, cell->height);
      under.high = std::max<double>(under.high, cell->height);
      under.clear_to = std::min<double>(under.clear_to, cell->height + cell->clearance);
    }
  under.share = static_cast<double>(carried) / std::max(1, asked);
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

}  // namespace

struct SupportPoses::Impl {
  const ModelTable& models;
  std::map<std::string, RestingBody> bodies;
  std::map<std::string, std::vector<SupportPose>> places;

  std::string key(const Object& object) const { return detail::sized_key(object, models); }

  RestingBody& body(const Object& object) {
    const std::string name = key(object);
    if (const auto found = bodies.find(name); found != bodies.end()) return found->second;
    return bodies.try_emplace(name, detail::sized_mesh(object, models)).first->second;
  }

  const std::vector<SupportSurface>& surfaces(const Object& object) {
    RestingBody& own = body(object);
    if (!own.surfaces)
      own.surfaces = object.traits.flat ? std::vector<SupportSurface>{}
                                        : support_surfaces(without_panes(object));
    return *own.surfaces;
  }

  // Without upright panes: what is behind the glass of a cabinet is seen, and its doors open.
  Mesh without_panes(const Object& object) const {
    Model open = *model_or_box(object, models);
    const Vec3 scale = model_placement(object, bounds(open)).scale;
    for (auto& part : open.parts)
      if (open.materials[static_cast<std::size_t>(part.material)].transparent())
        std::erase_if(part.mesh.triangles, [&](const auto& t) { return is_upright(part.mesh, t); });
    Mesh mesh;
    append(mesh, merged_mesh(open), scale);
    return mesh;
  }

  const Underside& underside(const Object& object) {
    RestingBody& own = body(object);
    if (!own.underside) own.underside = underside_of(own.mesh, own.columns);
    return *own.underside;
  }

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

  std::optional<SupportPose> rest(const Object& object, const Object& support, std::size_t index,
                            const Vec2& position, double yaw, double share) {
    const SupportSurface& surface = surfaces(support)[index];
    const Footprint footprint(position, object.size.head<2>(), yaw, object.traits.round);
    if (!surface.box().overlaps(footprint.bounds())) return std::nullopt;
    const Under under = look_under(surface, footprint);
    if (under.share < share) return std::nullopt;
    if (under.low + object.size.z() + headroom > under.clear_to) return std::nullopt;
    const Columns& columns = body(support).columns;
    const bool whole = under.share >= 1.0;
    if (share >= 1.0 && !rim_is_carried(columns, footprint, under.low, under.high))
      return std::nullopt;
    SupportPose pose{position, under.high, yaw, index};
    if (whole && under.high - under.low <= flat_range) return pose;
    const auto bottom = lowered(underside(object), columns, surface, pose);
    if (!bottom || *bottom + object.size.z() + headroom > under.clear_to) return std::nullopt;
    pose.bottom = *bottom;
    return pose;
  }

  void find_on(const Object& object, const Object& support, std::size_t index, double share,
               std::vector<SupportPose>& found) {
    const SupportSurface& surface = surfaces(support)[index];
    const bool square = std::abs(object.size.x() - object.size.y()) < 1e-6;
    std::vector<double> turns = {0.0, pi / 2, pi, -pi / 2};
    if (!object.traits.front) turns.resize(square ? 1 : 2);
    const Bounds2 box = surface.box();
    for (double yaw : turns) {
      const Vec2 own = std::abs(std::sin(yaw)) > 0.5 ? Vec2(object.size.y(), object.size.x())
                                                     : Vec2(object.size.head<2>());
      // What hangs over may do so by a tenth.
      const Vec2 slack = 0.5 * (box.size() - own) + (share < 1.0 ? 0.05 : 0.0) * own;
      if (slack.minCoeff() < -0.01) continue;
      const Vec2 room = slack.cwiseMax(0.0);
      const double step = std::max(0.03, std::sqrt(4.0 * room.x() * room.y() / most_places));
      const int nx = static_cast<int>(std::ceil(room.x() / step));
      const int ny = static_cast<int>(std::ceil(room.y() / step));
      const Vec2 middle = 0.5 * (box.low + box.high);
      for (int j = -ny; j <= ny; ++j)
        for (int i = -nx; i <= nx; ++i) {
          const Vec2 at(nx ? room.x() * i / nx : 0.0, ny ? room.y() * j / ny : 0.0);
          if (const auto pose = rest(object, support, index, middle + at, yaw, share))
            found.push_back(*pose);
        }
    }
  }
};

SupportPoses::SupportPoses(const ModelTable& models)
    : impl_(std::make_unique<Impl>(Impl{models, {}, {}})) {}
SupportPoses::~SupportPoses() = default;

const std::vector<SupportSurface>& SupportPoses::surfaces(const Object& support) const {
  return impl_->surfaces(support);
}

const std::vector<SupportPose>& SupportPoses::everywhere(const Object& object,
                                                         const Object& support) const {
  std::string key = impl_->key(object) + (object.traits.front ? "|front" : "") +
                    (object.traits.round ? "|round" : "") + " on " + impl_->key(support);
  if (const auto found = impl_->places.find(key); found != impl_->places.end())
    return found->second;
  std::vector<SupportPose> places;
  for (double share : {1.0, least_share}) {
    for (std::size_t k = 0; k < impl_->surfaces(support).size(); ++k)
      impl_->find_on(object, support, k, share, places);
    if (!places.empty()) break;
  }
  return impl_->places.emplace(std::move(key), std::move(places)).first->second;
}

std::optional<SupportPose> SupportPoses::at(const Object& object, const Object& support,
                                            std::size_t surface, const Vec2& position,
                                            double yaw) const {
  return impl_->rest(object, support, surface, position, yaw, 1.0);
}

}  // namespace roomgen
