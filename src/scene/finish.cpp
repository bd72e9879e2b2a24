#include "roomgen/scene/finish.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/text.h"
#include "roomgen/geometry/texture.h"

namespace roomgen {

namespace {

using Rgb = Eigen::Vector3f;
using Words = std::vector<std::string>;

struct PatternWord {
  std::string_view word;
  TexturePattern pattern;
};

constexpr PatternWord pattern_words[] = {
    {"deck", TexturePattern::decking},       {"decking", TexturePattern::decking},
    {"wood", TexturePattern::planks},        {"wooden", TexturePattern::planks},
    {"hardwood", TexturePattern::planks},    {"planks", TexturePattern::planks},
    {"plank", TexturePattern::planks},       {"boards", TexturePattern::planks},
    {"parquet", TexturePattern::planks},     {"laminate", TexturePattern::planks},
    {"oak", TexturePattern::planks},         {"walnut", TexturePattern::planks},
    {"pine", TexturePattern::planks},        {"bamboo", TexturePattern::planks},
    {"marble", TexturePattern::stone},       {"stone", TexturePattern::stone},
    {"granite", TexturePattern::stone},      {"slate", TexturePattern::stone},
    {"tile", TexturePattern::tiles},         {"tiles", TexturePattern::tiles},
    {"tiled", TexturePattern::tiles},        {"ceramic", TexturePattern::tiles},
    {"porcelain", TexturePattern::tiles},    {"terracotta", TexturePattern::tiles},
    {"carpet", TexturePattern::carpet},      {"carpeted", TexturePattern::carpet},
    {"wool", TexturePattern::carpet},        {"concrete", TexturePattern::concrete},
    {"cement", TexturePattern::concrete},    {"screed", TexturePattern::concrete},
};

struct ColorWord {
  std::string_view word;
  float r, g, b;
};

// Muted tones: walls and floors, not paint samples.
constexpr ColorWord color_words[] = {
    {"walnut", 128, 92, 66},   {"oak", 196, 160, 116},       {"pine", 214, 178, 128},
    {"bamboo", 213, 186, 138}, {"terracotta", 190, 116, 84}, {"slate", 112, 118, 124},
    {"granite", 134, 132, 130}, {"marble", 226, 222, 216},   {"white", 236, 234, 229},
    {"cream", 238, 229, 208},  {"ivory", 238, 232, 215},     {"beige", 222, 207, 182},
    {"sand", 216, 198, 164},   {"grey", 176, 176, 174},      {"gray", 176, 176, 174},
    {"charcoal", 84, 86, 90},  {"black", 58, 58, 60},        {"brown", 138, 102, 74},
    {"red", 172, 88, 80},      {"pink", 226, 188, 188},      {"blush", 230, 204, 196},
    {"orange", 218, 152, 98},  {"yellow", 234, 212, 142},    {"green", 158, 178, 146},
    {"sage", 178, 188, 164},   {"olive", 136, 138, 98},      {"mint", 196, 220, 204},
    {"blue", 156, 180, 200},   {"navy", 68, 84, 112},        {"teal", 108, 152, 152},
    {"lavender", 206, 200, 222}, {"purple", 158, 138, 172},
};

bool has(const Words& all, std::string_view word) {
  return std::find(all.begin(), all.end(), word) != all.end();
}

std::optional<TexturePattern> pattern_of(const Words& all) {
  for (const auto& entry : pattern_words)
    if (has(all, entry.word)) return entry.pattern;
  return std::nullopt;
}

std::optional<Rgb> color_of(const Words& all) {
  std::optional<Rgb> color;
  // The last name counts: "white oak" is a pale oak, handled by the shades below.
  for (const auto& word : all)
    for (const auto& entry : color_words)
      if (word == entry.word) color = Rgb(entry.r, entry.g, entry.b);
  if (!color) return color;
  if (has(all, "dark")) *color *= 0.8f;
  if (has(all, "light") || has(all, "pale")) *color = 0.6f * *color + 0.4f * Rgb(245, 240, 230);
  return color;
}

Rgb default_tone(TexturePattern pattern) {
  switch (pattern) {
    case TexturePattern::planks: return {198, 162, 118};
    case TexturePattern::decking: return {162, 122, 88};
    case TexturePattern::tiles: return {214, 212, 206};
    case TexturePattern::stone: return {222, 217, 209};
    case TexturePattern::carpet: return {190, 184, 174};
    case TexturePattern::concrete: return {184, 182, 178};
  }
  return {200, 200, 200};
}

Finish textured(TexturePattern pattern, const Rgb& tone, std::string name) {
  Finish finish;
  finish.extent = texture_extent(pattern);
  finish.material.name = std::move(name);
  finish.material.base_color = {1, 1, 1, 1};
  finish.material.texture = std::make_shared<Image>(paint_texture(pattern, tone));
  const bool polished = pattern == TexturePattern::tiles || pattern == TexturePattern::stone;
  finish.material.roughness = polished ? 0.35f : pattern == TexturePattern::planks ? 0.55f : 0.9f;
  return finish;
}

TexturePattern usual_floor(std::string_view type) {
  const Words all = words(type);
  for (const auto* wet : {"bathroom", "kitchen", "toilet", "wc", "laundry", "restroom", "shower"})
    if (has(all, wet)) return TexturePattern::tiles;
  for (const auto* outside : {"balcony", "terrace", "patio", "deck"})
    if (has(all, outside)) return TexturePattern::decking;
  for (const auto* bare : {"garage", "workshop", "warehouse", "lab", "laboratory", "basement"})
    if (has(all, bare)) return TexturePattern::concrete;
  return TexturePattern::planks;
}

Rgb usual_wall(std::string_view type) {
  const Words all = words(type);
  if (has(all, "bathroom")) return {214, 226, 228};
  if (has(all, "kitchen")) return {236, 231, 218};
  if (has(all, "bedroom")) return {226, 222, 214};
  if (has(all, "dining")) return {228, 219, 203};
  if (has(all, "balcony")) return {224, 214, 200};
  return {232, 226, 216};
}

}  // namespace

std::array<float, 4> material_color(const Eigen::Vector3f& srgb, float alpha) {
  return {linear_from_srgb(srgb.x()), linear_from_srgb(srgb.y()), linear_from_srgb(srgb.z()), alpha};
}

Finish floor_finish(const Room& room) {
  const Words all = words(room.materials.floor);
  const TexturePattern pattern = pattern_of(all).value_or(usual_floor(room.type));
  return textured(pattern, color_of(all).value_or(default_tone(pattern)), "floor");
}

Finish wall_finish(const Room& room) {
  const Words all = words(room.materials.walls);
  const Rgb tone = color_of(all).value_or(usual_wall(room.type));
  if (const auto pattern = pattern_of(all); pattern && *pattern != TexturePattern::carpet)
    return textured(*pattern, color_of(all).value_or(default_tone(*pattern)), "wall");
  Finish finish;
  finish.material.name = "wall";
  finish.material.base_color = material_color(tone);
  finish.material.roughness = 0.95f;
  return finish;
}

}  // namespace roomgen
