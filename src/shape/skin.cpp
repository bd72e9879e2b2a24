#include "skin.h"

#include <algorithm>

namespace roomgen::shape {

namespace {

// Caps and skins of one body never share a group: they meet in creases.
constexpr int cap_group = -1;

// Numbers of bands between creases; band k lies between line k and line k + 1.
std::vector<int> bands(const std::vector<bool>& crease, std::size_t lines, bool closed) {
  std::vector<int> band(closed ? lines : lines - 1, 0);
  for (std::size_t k = 1; k < band.size(); ++k)
    band[k] = band[k - 1] + (k < crease.size() && crease[k] ? 1 : 0);
  return band;
}

// The band that a piece's line is shaded with: its own, but where a closed direction runs on
// without a crease, the last piece ends in the band that the first begins.
int shading(const std::vector<int>& band, const std::vector<bool>& crease, std::size_t piece,
            bool is_end) {
  const bool wraps = is_end && piece + 1 == band.size() && !crease.empty() && !crease[0];
  return wraps ? band[0] : band[piece];
}

class SkinBuilder {
 public:
  SkinBuilder(const Skin& skin) : skin_(skin) {
    rows_ = skin.rows.size();
    columns_ = skin.rows.front().size();
    measure_along();
    measure_around();
    upright_ = along_.back() > widest_;
  }

  void add(SurfaceBuilder& surface) const {
    const auto row_band = bands(skin_.row_crease, rows_, skin_.rows_closed);
    const auto column_band = bands(skin_.column_crease, columns_, skin_.columns_closed);
    for (std::size_t i = 0; i < row_band.size(); ++i)
      for (std::size_t j = 0; j < column_band.size(); ++j) {
        const auto at = [&](bool upper, bool right) {
          Corner result = corner(i + upper, j + right);
          result.group =
              shading(row_band, skin_.row_crease, i, upper && skin_.rows_closed) * 65536 +
              shading(column_band, skin_.column_crease, j, right && skin_.columns_closed);
          return result;
        };
        surface.quad(at(false, false), at(false, true), at(true, true), at(true, false));
      }
  }

 private:
  const Vec3& point(std::size_t i, std::size_t j) const {
    return skin_.rows[i % rows_][j % columns_];
  }

  // The way along is the mean of the columns, so that a row stays one line of the texture.
  void measure_along() {
    along_.push_back(0.0);
    for (std::size_t i = 1; i < rows_ + (skin_.rows_closed ? 1 : 0); ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < columns_; ++j) sum += (point(i, j) - point(i - 1, j)).norm();
      along_.push_back(along_.back() + sum / static_cast<double>(columns_));
    }
  }

  // The way around is measured in each row from the middle column: what little a taper shears the
  // texture grows towards the seam.
  void measure_around() {
    const std::size_t places = columns_ + (skin_.columns_closed ? 1 : 0), middle = columns_ / 2;
    for (std::size_t i = 0; i < rows_; ++i) {
      auto& row = around_.emplace_back(places, 0.0);
      for (std::size_t j = 1; j < places; ++j)
        row[j] = row[j - 1] + (point(i, j) - point(i, j - 1)).norm();
      widest_ = std::max(widest_, row.back());
      const double zero = row[middle];
      for (auto& length : row) length -= zero;
    }
  }

  Corner corner(std::size_t i, std::size_t j) const {
    Corner result{point(i, j), surface_uv(around_[i % rows_][j], along_[i], upright_), Vec3::Zero(),
                  0};
    if (i == 0 && skin_.first_normal) result.normal = *skin_.first_normal;
    if (i + 1 == rows_ && skin_.last_normal) result.normal = *skin_.last_normal;
    return result;
  }

  const Skin& skin_;
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<double> along_;
  std::vector<std::vector<double>> around_;
  double widest_ = 0.0;
  bool upright_ = false;
};

}  // namespace

void add_skin(SurfaceBuilder& surface, const Skin& skin) {
  SkinBuilder(skin).add(surface);
}

void add_cap(SurfaceBuilder& surface, const std::vector<Loop>& loops, const std::vector<Vec3>& points,
             const Vec3& normal) {
  Vec2 low = Vec2::Constant(1e300), high = -low;
  for (const auto& loop : loops)
    for (const auto& p : loop) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  const bool upright = (high - low).y() > (high - low).x();
  std::vector<Corner> corners;
  for (const auto& loop : loops)
    for (const auto& p : loop)
      corners.push_back(
          {points[corners.size()], surface_uv(p.x(), p.y(), upright), normal, cap_group});
  for (const auto& t : triangulate(loops)) surface.triangle(corners[t[0]], corners[t[1]], corners[t[2]]);
}

void add_level_cap(SurfaceBuilder& surface, std::vector<Loop> loops, double z, bool upward) {
  std::vector<Vec3> points;
  for (auto& loop : loops) {
    if (!upward) std::reverse(loop.begin(), loop.end());
    for (auto& p : loop) {
      points.push_back({p.x(), p.y(), z});
      if (!upward) p.x() = -p.x();  // as seen from below
    }
  }
  add_cap(surface, loops, points, upward ? Vec3::UnitZ() : Vec3(-Vec3::UnitZ()));
}

std::vector<Vec3> raised(const Loop& loop, double z) {
  std::vector<Vec3> result;
  for (const auto& p : loop) result.push_back({p.x(), p.y(), z});
  return result;
}

}  // namespace roomgen::shape
