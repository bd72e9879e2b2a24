#include "noise.h"

#include "base/random.h"

namespace roomgen::shape {

Noise::Noise(int columns, int rows, std::uint64_t seed) : columns_(columns), rows_(rows) {
  Random random(seed);
  std::vector<double> once(static_cast<std::size_t>(columns * rows));
  for (double& value : once) value = random.uniform();
  values_.reserve(static_cast<std::size_t>((rows + 2) * stride()));
  for (int row = 0; row < rows + 2; ++row)
    for (int column = 0; column < columns + 2; ++column)
      values_.push_back(once[static_cast<std::size_t>(row % rows * columns + column % columns)]);
}

Clouds::Clouds(int columns, int rows, std::uint64_t seed)
    : broad_(columns, rows, seed),
      middle_(2 * columns + 1, 2 * rows + 1, seed + 1),
      fine_(4 * columns + 1, 4 * rows + 1, seed + 2) {}

}  // namespace roomgen::shape
