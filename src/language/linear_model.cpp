#include "linear_model.h"

namespace roomgen::language {

namespace {

std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t width) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < width; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

}  // namespace

LinearModel::LinearModel(std::string_view bytes, std::string_view magic) {
  if (!bytes.starts_with(magic)) return;
  bytes.remove_prefix(magic.size());
  const std::uint32_t count = number_at(bytes, 0, 4);
  slots_ = bytes.substr(4, slot_size * count);
  weights_ = bytes.substr(4 + slots_.size());
  mask_ = count - 1;
}

void LinearModel::add_to(std::span<int> sums, std::uint32_t feature) const {
  if (slots_.empty()) return;
  for (std::uint32_t slot = feature & mask_;; slot = (slot + 1) & mask_) {
    const std::uint32_t found = number_at(slots_, slot * slot_size, 4);
    if (found == 0) return;
    if (found != feature) continue;
    const std::size_t first = number_at(slots_, slot * slot_size + 4, 3);
    const std::size_t many = number_at(slots_, slot * slot_size + 7, 1);
    for (std::size_t i = first; i < first + many; ++i)
      sums[number_at(weights_, i * weight_size, 1)] +=
          static_cast<std::int16_t>(number_at(weights_, i * weight_size + 1, 2));
    return;
  }
}

}  // namespace roomgen::language
