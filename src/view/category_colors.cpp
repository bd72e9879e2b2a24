#include "category_colors.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace roomgen {

namespace {

// What rooms are made of: floor and walls as on a plan, quiet.
const std::map<std::string, Rgb, std::less<>> part_colors = {
    {"ceiling", {250, 250, 250}}, {"door", {160, 90, 44}}, {"floor", {240, 236, 226}},
    {"passage", {196, 170, 130}}, {"wall", {70, 72, 78}},  {"window", {120, 205, 255}}};

// Each as far as can be from those before it and from the above, in OKLab (Ottosson 2020).
constexpr std::array<Rgb, 32> distinct_colors = {
    {Rgb{238, 0, 255}, Rgb{0, 0, 255}, Rgb{0, 255, 0}, Rgb{0, 153, 0}, Rgb{136, 0, 170},
     Rgb{119, 119, 255}, Rgb{255, 34, 119}, Rgb{255, 153, 255}, Rgb{34, 136, 153}, Rgb{238, 221, 0},
     Rgb{51, 255, 204}, Rgb{187, 119, 170}, Rgb{153, 0, 68}, Rgb{68, 204, 102}, Rgb{0, 102, 0},
     Rgb{255, 102, 0}, Rgb{0, 85, 170}, Rgb{119, 17, 255}, Rgb{204, 0, 170}, Rgb{136, 85, 136},
     Rgb{153, 153, 0}, Rgb{221, 0, 0}, Rgb{255, 136, 153}, Rgb{0, 187, 187}, Rgb{0, 170, 255},
     Rgb{255, 85, 204}, Rgb{204, 119, 255}, Rgb{255, 170, 0}, Rgb{170, 68, 238}, Rgb{102, 119, 51},
     Rgb{255, 187, 204}, Rgb{0, 102, 238}}};
// Where there are more categories than colours, they come again, darker.
constexpr std::array<int, 4> shades = {100, 70, 50, 36};  // per cent

std::size_t preferred_slot(std::string_view category) {
  std::uint32_t hash = 2166136261u;  // FNV-1a
  for (const char c : category) hash = (hash ^ static_cast<std::uint8_t>(c)) * 16777619u;
  return (hash >> 8) % distinct_colors.size();
}

Rgb color_of_slot(std::size_t slot) {
  Rgb color = distinct_colors[slot % distinct_colors.size()];
  const int shade = shades[std::min(slot / distinct_colors.size(), shades.size() - 1)];
  for (auto& value : color) value = static_cast<std::uint8_t>(value * shade / 100);
  return color;
}

// The preferred one of the first round with a free slot, or the next free one in it.
std::size_t free_slot(std::vector<bool>& taken, std::size_t preferred) {
  constexpr std::size_t round = distinct_colors.size();
  for (std::size_t first = 0;; first += round) {
    taken.resize(std::max(taken.size(), first + round));
    for (std::size_t step = 0; step < round; ++step)
      if (const std::size_t slot = first + (preferred + step) % round; !taken[slot]) return slot;
  }
}

}  // namespace

std::map<std::string, Rgb> category_colors(const std::set<std::string>& categories) {
  std::map<std::string, Rgb> colors;
  std::vector<bool> taken;
  for (const auto& category : categories) {
    if (const auto part = part_colors.find(category); part != part_colors.end()) {
      colors[category] = part->second;
      continue;
    }
    const std::size_t slot = free_slot(taken, preferred_slot(category));
    taken[slot] = true;
    colors[category] = color_of_slot(slot);
  }
  return colors;
}

}  // namespace roomgen
