#include <algorithm>
#include <cmath>

#include "handles.h"
#include "search.h"

namespace roomgen::create::detail {

namespace {

constexpr double same_level = 0.002;
constexpr double too_low = -0.001;

}  // namespace

double floor_level(const Assembly& assembly, const std::vector<Link>& links) {
  std::vector<double> bottoms;
  double lowest = 1e300;
  for (const auto& part : assembly.parts()) lowest = std::min(lowest, part.box().low.z());
  for (const auto& link : links) {
    if (!link.floor) continue;
    double low = 1e300;
    for (std::size_t k : link.one) low = std::min(low, assembly.parts()[k].box().low.z());
    bottoms.push_back(low);
  }
  std::sort(bottoms.begin(), bottoms.end());
  std::size_t most = 0;
  double level = lowest;
  for (std::size_t k = 0; k < bottoms.size(); ++k) {
    const auto end = std::upper_bound(bottoms.begin(), bottoms.end(), bottoms[k] + same_level);
    const auto count = static_cast<std::size_t>(end - bottoms.begin()) - k;
    if (count <= most) continue;
    most = count;
    level = bottoms[k];
  }
  return level;
}

void shift_level(Assembly& assembly, double height) {
  if (std::abs(height) < 1e-6) return;
  for (std::size_t top = 0; top < assembly.program().components.size(); ++top)
    pull(assembly, {Handle::Kind::move, {top}}, Vec3(0, 0, -height));
}

void try_lifting(Trials& trials) {
  const Assembly& assembly = trials.from().assembly;
  const auto& parts = assembly.parts();
  for (std::size_t k = 0; k < parts.size() && !trials.exhausted(); ++k) {
    const double low = parts[k].box().low.z();
    if (low >= too_low) continue;
    Vec3 bottom = parts[k].box().center();
    bottom.z() -= 100.0;
    const Wish wish{k, nearest_vertex(parts[k], bottom), Vec3(0, 0, -low)};
    for (std::size_t length = parts[k].source.size(); length > 0; --length) {
      const ComponentPath path(parts[k].source.begin(), parts[k].source.begin() + length);
      std::vector<Handle> handles = {{Handle::Kind::move, path}};
      for (int axis : {2, 0, 1})
        for (double anchor : {0.0, 1.0})
          handles.push_back({Handle::Kind::stretch, path, axis, anchor});
      for (const auto& handle : handles) {
        Assembly trial = assembly;
        const auto amounts = solve(trial, handle, {wish});
        if (amounts && pull(trial, handle, *amounts))
          trials.consider(std::move(trial), parts[k].name + ": lifted to the floor");
      }
    }
  }
}

}  // namespace roomgen::create::detail
