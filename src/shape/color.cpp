#include "color.h"

#include <charconv>
#include <utility>

#include "roomgen/base/text.h"

namespace roomgen::shape {

namespace {

constexpr std::pair<std::string_view, std::uint32_t> table[] = {
    {"white", 0xffffff},      {"ivory", 0xfffff0},     {"cream", 0xf3ead7},
    {"beige", 0xe3d5b8},      {"sand", 0xd2bd94},      {"tan", 0xd2b48c},
    {"brown", 0x7b4f2e},      {"chocolate", 0x4f2f1c}, {"black", 0x191919},
    {"charcoal", 0x36393d},   {"gray", 0x808080},      {"grey", 0x808080},
    {"silver", 0xc0c0c0},     {"red", 0xb3282d},       {"crimson", 0xdc143c},
    {"maroon", 0x701c23},     {"pink", 0xf2b8c0},      {"orange", 0xe07b2a},
    {"terracotta", 0xb9603f}, {"yellow", 0xe8c33f},    {"mustard", 0xc89b2c},
    {"gold", 0xd1a84a},       {"olive", 0x707a3a},     {"green", 0x3f7a45},
    {"sage", 0x9aa98a},       {"mint", 0xb6dcc4},      {"teal", 0x227a7a},
    {"turquoise", 0x40c0b4},  {"blue", 0x2f5fa8},      {"navy", 0x1f2f55},
    {"lightblue", 0xadcbe3},  {"purple", 0x6b3f7f},    {"lavender", 0xb7a8d6},
    {"oak", 0xb58a58},        {"birch", 0xdcc39a},     {"pine", 0xd3a867},
    {"beech", 0xc99b6b},      {"walnut", 0x5c3d28},    {"mahogany", 0x6b2f20},
    {"cherry", 0x8f4a2d},     {"teak", 0x9c6b3c},      {"ebony", 0x2a211c},
    {"steel", 0xa9adb2},      {"iron", 0x4c4d50},      {"chrome", 0xd9dcdf},
    {"brass", 0xb8963e},      {"copper", 0xb56d43},    {"bronze", 0x8a6537},
    {"glass", 0xdfeef0}};

Rgb rgb(std::uint32_t code) {
  return {static_cast<std::uint8_t>(code >> 16), static_cast<std::uint8_t>(code >> 8),
          static_cast<std::uint8_t>(code)};
}

}  // namespace

std::optional<Rgb> parse_color(std::string_view text) {
  if (text.size() > 1 && text[0] == '#') {
    std::uint32_t code = 0;
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data() + 1, end, code, 16);
    if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
    if (text.size() == 7) return rgb(code);
    if (text.size() != 4) return std::nullopt;
    return rgb((code >> 8) * 0x110000 + ((code >> 4) & 15) * 0x1100 + (code & 15) * 0x11);
  }
  const std::string name = lower(text);
  for (const auto& [known, code] : table)
    if (known == name) return rgb(code);
  return std::nullopt;
}

std::vector<std::string_view> color_names() {
  std::vector<std::string_view> names;
  for (const auto& [name, ignored] : table) names.push_back(name);
  return names;
}

}  // namespace roomgen::shape
