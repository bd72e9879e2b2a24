#include "support_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "columns.h"

namespace roomgen {

namespace {

using detail::Columns;
using detail::Crossing;

constexpr double pitch = SupportSurface::pitch;
constexpr double level = 0.9659;            // cosine of 15 degrees
constexpr double least_clearance = 0.05;
constexpr double step_up = 0.008;           // between neighbours of one surface
constexpr double spread = 0.025;            // about the median height
constexpr double flat_step = 0.00175;       // 5 degrees over one cell
constexpr double flat_share = 0.25;
constexpr double least_area = 0.008;        // m2
constexpr double look_in = 0.03;            // above a surface, where the way in must be free
constexpr int bridged = 2;                  // cells: joints between slats and leaves
constexpr int most_cells = 300;             // a side: 6 m

// What the mesh fills of a layer of cells, and which of the rest can be reached from around it.
struct Layer {
  std::vector<char> filled;
  std::vector<char> reached;
};

class Finder {
 public:
  explicit Finder(const Mesh& mesh) : mesh_(mesh), columns_(mesh) {
    const Vec3 size = columns_.box().size();
    nx_ = std::max(1, static_cast<int>(std::ceil(size.x() / pitch - 1e-9)));
    ny_ = std::max(1, static_cast<int>(std::ceil(size.y() / pitch - 1e-9)));
    origin_ = columns_.box().center().head<2>() - 0.5 * pitch * Vec2(nx_, ny_);
  }

  std::vector<SupportSurface> run() {
    if (nx_ > most_cells || ny_ > most_cells || mesh_.triangles.empty()) return {};
    find_ledges();
    fill_layers();
    reach_layers();
    std::erase_if(ledges_, [&](const Ledge& ledge) { return !is_reached(ledge); });
    index_ledges();
    std::vector<SupportSurface> surfaces;
    for (std::size_t k = 0; k < ledges_.size(); ++k)
      if (!ledges_[k].taken) add_surface(component_from(k), surfaces);
    std::stable_sort(
        surfaces.begin(), surfaces.end(),
        [](const SupportSurface& a, const SupportSurface& b) { return a.area > b.area; });
    return surfaces;
  }

 private:
  // A cell of a column where something might stand.
  struct Ledge {
    int i = 0, j = 0;
    double z = 0.0;
    double clearance = 0.0;
    bool taken = false;
  };

  Vec2 middle(int i, int j) const { return origin_ + pitch * Vec2(i + 0.5, j + 0.5); }
  std::size_t cell(int i, int j) const { return static_cast<std::size_t>(j * nx_ + i); }
  int layer_of(double z) const {
    return static_cast<int>(std::floor((z - columns_.box().low.z()) / pitch));
  }

  void find_ledges() {
    std::vector<Crossing> line;
    for (int j = 0; j < ny_; ++j)
      for (int i = 0; i < nx_; ++i) {
        columns_.crossings(middle(i, j), line);
        for (std::size_t k = 0; k < line.size(); ++k) {
          if (std::abs(line[k].slope) < level) continue;
          const bool top = k + 1 == line.size();
          const double clearance = top ? SupportSurface::open : line[k + 1].z - line[k].z;
          if (clearance < least_clearance) continue;
          // The underside of something thick, unless the winding is wrong.
          if (line[k].slope < 0 && !top && line[k + 1].slope > 0) continue;
          ledges_.push_back({i, j, line[k].z, clearance});
          layers_[layer_of(line[k].z + look_in)];
        }
      }
  }

  // Marks what triangles fill, by halving them until they are smaller than cells.
  void fill(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double low = std::min({a.z(), b.z(), c.z()}), high = std::max({a.z(), b.z(), c.z()});
    const auto first = layers_.lower_bound(layer_of(low));
    if (first == layers_.end() || first->first > layer_of(high)) return;
    const double ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
    const double longest = std::max({ab, bc, ca});
    if (longest <= 0.25 * pitch * pitch) {
      for (const Vec3& p : {a, b, c}) {
        const auto layer = layers_.find(layer_of(p.z()));
        if (layer == layers_.end()) continue;
        const int i = std::clamp(static_cast<int>((p.x() - origin_.x()) / pitch), 0, nx_ - 1);
        const int j = std::clamp(static_cast<int>((p.y() - origin_.y()) / pitch), 0, ny_ - 1);
        layer->second.filled[cell(i, j)] = 1;
      }
      return;
    }
    const auto halve = [&](const Vec3& from, const Vec3& to, const Vec3& across) {
      const Vec3 half = 0.5 * (from + to);
      fill(from, half, across);
      fill(half, to, across);
    };
    if (longest == ab) return halve(a, b, c);
    if (longest == bc) return halve(b, c, a);
    halve(c, a, b);
  }

  void fill_layers() {
    for (auto& [k, layer] : layers_) layer.filled.assign(cell(0, ny_), 0);
    for (const auto& t : mesh_.triangles)
      fill(mesh_.positions[t[0]].cast<double>(), mesh_.positions[t[1]].cast<double>(),
           mesh_.positions[t[2]].cast<double>());
  }

  // From the rim of the box and from what is open above, through what is free.
  void reach_layers() {
    std::map<int, std::vector<std::pair<int, int>>> front;
    for (auto& [k, layer] : layers_) {
      layer.reached.assign(layer.filled.size(), 0);
      for (int i = 0; i < nx_; ++i) front[k].insert(front[k].end(), {{i, 0}, {i, ny_ - 1}});
      for (int j = 0; j < ny_; ++j) front[k].insert(front[k].end(), {{0, j}, {nx_ - 1, j}});
    }
    for (const auto& ledge : ledges_)
      if (ledge.clearance == SupportSurface::open)
        front[layer_of(ledge.z + look_in)].push_back({ledge.i, ledge.j});
    for (auto& [k, layer] : layers_) {
      auto& open = front[k];
      while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        if (i < 0 || j < 0 || i >= nx_ || j >= ny_) continue;
        if (layer.filled[cell(i, j)] || layer.reached[cell(i, j)]) continue;
        layer.reached[cell(i, j)] = 1;
        open.insert(open.end(), {{i + 1, j}, {i - 1, j}, {i, j + 1}, {i, j - 1}});
      }
    }
  }

  bool is_reached(const Ledge& ledge) const {
    return layers_.at(layer_of(ledge.z + look_in)).reached[cell(ledge.i, ledge.j)] != 0;
  }

  void index_ledges() {
    of_cell_.assign(cell(0, ny_), {});
    for (std::size_t k = 0; k < ledges_.size(); ++k)
      of_cell_[cell(ledges_[k].i, ledges_[k].j)].push_back(k);
  }

  const Ledge* neighbour(const Ledge& ledge, int di, int dj) const {
    const int i = ledge.i + di, j = ledge.j + dj;
    if (i < 0 || j < 0 || i >= nx_ || j >= ny_) return nullptr;
    for (std::size_t k : of_cell_[cell(i, j)])
      if (std::abs(ledges_[k].z - ledge.z) <= step_up) return &ledges_[k];
    return nullptr;
  }

  std::vector<std::size_t> component_from(std::size_t seed) {
    std::vector<std::size_t> found = {seed};
    ledges_[seed].taken = true;
    for (std::size_t next = 0; next < found.size(); ++next) {
      const Ledge ledge = ledges_[found[next]];
      for (int reach = 1; reach <= bridged; ++reach)
        for (const auto& [di, dj] : {std::pair{reach, 0}, {-reach, 0}, {0, reach}, {0, -reach}})
          if (const Ledge* other = neighbour(ledge, di, dj); other && !other->taken) {
            const auto k = static_cast<std::size_t>(other - ledges_.data());
            ledges_[k].taken = true;
            found.push_back(k);
          }
    }
    return found;
  }

  bool is_flat(const Ledge& ledge) const {
    for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const Ledge* other = neighbour(ledge, di, dj);
      if (other && std::abs(other->z - ledge.z) > flat_step) return false;
    }
    return true;
  }

  static double median(std::vector<double> values) {
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    return *half;
  }

  void add_surface(std::vector<std::size_t> members, std::vector<SupportSurface>& surfaces) const {
    std::vector<double> heights;
    for (std::size_t k : members) heights.push_back(ledges_[k].z);
    SupportSurface surface;
    surface.height = median(heights);
    std::erase_if(members, [&](std::size_t k) {
      return std::abs(ledges_[k].z - surface.height) > spread;
    });
    const double enough = least_area / (pitch * pitch);
    if (static_cast<double>(members.size()) < enough) return;
    const auto flat = std::count_if(members.begin(), members.end(),
                                    [&](std::size_t k) { return is_flat(ledges_[k]); });
    if (static_cast<double>(flat) < std::max(flat_share * static_cast<double>(members.size()),
                                             0.5 * enough))
      return;
    lay_out(members, surface);
    bridge(surface);
    if (!has_width(surface)) return;
    std::vector<double> clearances;
    for (std::size_t k : members) clearances.push_back(ledges_[k].clearance);
    surface.clearance = median(clearances);
    surface.area = pitch * pitch * static_cast<double>(members.size());
    surfaces.push_back(std::move(surface));
  }

  void lay_out(const std::vector<std::size_t>& members, SupportSurface& surface) const {
    int i0 = nx_, i1 = 0, j0 = ny_, j1 = 0;
    for (std::size_t k : members) {
      i0 = std::min(i0, ledges_[k].i), i1 = std::max(i1, ledges_[k].i);
      j0 = std::min(j0, ledges_[k].j), j1 = std::max(j1, ledges_[k].j);
    }
    surface.columns = i1 - i0 + 1, surface.rows = j1 - j0 + 1;
    surface.low = origin_ + pitch * Vec2(i0, j0);
    surface.cells.resize(static_cast<std::size_t>(surface.columns * surface.rows));
    for (std::size_t k : members) {
      const Ledge& ledge = ledges_[k];
      auto& at = surface.cells[static_cast<std::size_t>((ledge.j - j0) * surface.columns + ledge.i - i0)];
      if (at.free && at.height >= ledge.z) continue;
      at = {true, static_cast<float>(ledge.z), static_cast<float>(ledge.clearance)};
    }
  }

  // Joints between slats carry what is wider, where nothing rises from them.
  void bridge(SupportSurface& surface) const {
    const auto source = surface.cells;
    const auto before = [&](int i, int j) -> const SupportSurface::Cell* {
      if (i < 0 || j < 0 || i >= surface.columns || j >= surface.rows) return nullptr;
      const auto& found = source[static_cast<std::size_t>(j * surface.columns + i)];
      return found.free ? &found : nullptr;
    };
    const int i0 = static_cast<int>(std::lround((surface.low.x() - origin_.x()) / pitch));
    const int j0 = static_cast<int>(std::lround((surface.low.y() - origin_.y()) / pitch));
    const auto layer = layers_.find(layer_of(surface.height + look_in));
    if (layer == layers_.end()) return;
    for (int j = 0; j < surface.rows; ++j)
      for (int i = 0; i < surface.columns; ++i) {
        if (before(i, j) || layer->second.filled[cell(i0 + i, j0 + j)]) continue;
        const auto* left = before(i - 1, j);
        const auto* right = before(i + 1, j);
        if (!left || !right) left = before(i, j - 1), right = before(i, j + 1);
        if (!left || !right) continue;
        surface.cells[static_cast<std::size_t>(j * surface.columns + i)] = {
            true, 0.5f * (left->height + right->height), std::min(left->clearance, right->clearance)};
      }
  }

  static bool has_width(const SupportSurface& surface) {
    for (int j = 1; j + 1 < surface.rows; ++j)
      for (int i = 1; i + 1 < surface.columns; ++i) {
        bool all = true;
        for (int dj = -1; dj <= 1; ++dj)
          for (int di = -1; di <= 1; ++di)
            all = all &&
                  surface.cells[static_cast<std::size_t>((j + dj) * surface.columns + i + di)].free;
        if (all) return true;
      }
    return false;
  }

  const Mesh& mesh_;
  Columns columns_;
  int nx_ = 0, ny_ = 0;
  Vec2 origin_ = Vec2::Zero();
  std::vector<Ledge> ledges_;
  std::map<int, Layer> layers_;
  std::vector<std::vector<std::size_t>> of_cell_;
};

}  // namespace

const SupportSurface::Cell* SupportSurface::at(const Vec2& point) const {
  const Vec2 local = (point - low) / pitch;
  const int i = static_cast<int>(std::floor(local.x())), j = static_cast<int>(std::floor(local.y()));
  if (i < 0 || j < 0 || i >= columns || j >= rows) return nullptr;
  const Cell& cell = cells[static_cast<std::size_t>(j * columns + i)];
  return cell.free ? &cell : nullptr;
}

std::vector<SupportSurface> support_surfaces(const Mesh& mesh) {
  return Finder(mesh).run();
}

}  // namespace roomgen
