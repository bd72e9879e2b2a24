#include "finish.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t longest_name = 3;  ///< words of a surface's name

/// What a description says, no more.
struct Described {
  const Surface* surface = nullptr;
  std::vector<Tone> tones;  ///< in the order of the words
};

const Surface* find_surface(const FinishWords& words, const std::string& name) {
  const auto found = words.surfaces.find(name);
  return found == words.surfaces.end() ? nullptr : &found->second;
}

// All "#rrggbb" of a text.
std::vector<Tone> color_codes(std::string_view text) {
  constexpr std::size_t digits = 6;
  std::vector<Tone> found;
  for (std::size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1)) {
    const char* const begin = text.data() + at + 1;
    const char* const end = begin + std::min(digits, text.size() - at - 1);
    unsigned code = 0;
    const auto [last, error] = std::from_chars(begin, end, code, 16);
    const std::size_t after = at + 1 + digits;
    const bool is_longer =
        after < text.size() && std::isxdigit(static_cast<unsigned char>(text[after]));
    if (error != std::errc() || last != begin + digits || is_longer) continue;
    found.push_back(Eigen::Vector3i(code >> 16, code >> 8 & 0xff, code & 0xff).cast<float>());
  }
  return found;
}

class FinishReader {
 public:
  FinishReader(std::string_view text, const FinishWords& words)
      : all_(roomgen::words(text)), codes_(color_codes(text)), words_(words) {
    for (const auto& word : all_)
      if (const auto shade = words_.shades.find(word); shade != words_.shades.end())
        shades_.push_back(shade->second);
  }

  Described run() const { return {surface(), tones()}; }

  Tone shaded(Tone tone) const {
    for (const auto& shade : shades_) tone += static_cast<float>(shade.by) * (shade.towards - tone);
    return tone;
  }

 private:
  // The longest name counts, of equally long ones the first: "white subway tiles" are no tiles of
  // any kind, and a "checkerboard tile" is a checkerboard.
  const Surface* surface() const {
    for (std::size_t length = longest_name; length > 0; --length)
      for (std::size_t at = 0; at + length <= all_.size(); ++at) {
        const auto begin = all_.begin() + static_cast<std::ptrdiff_t>(at);
        const auto found = words_.surface_names.find(
            join({begin, begin + static_cast<std::ptrdiff_t>(length)}, " "));
        if (found != words_.surface_names.end()) return find_surface(words_, found->second);
      }
    for (const auto& word : all_)
      if (const auto found = words_.substances.find(word); found != words_.substances.end())
        return find_surface(words_, found->second.surface);
    return nullptr;
  }

  std::vector<Tone> tones() const {
    std::vector<Tone> found = codes_;
    bool specific = false;  // the word before was: "navy blue" is navy
    for (const auto& word : all_) {
      const auto basic = words_.basic_colors.find(word);
      const auto color = words_.colors.find(word);
      const auto stuff = words_.substances.find(word);
      if (basic != words_.basic_colors.end() && !specific) found.push_back(shaded(basic->second));
      if (color != words_.colors.end()) found.push_back(shaded(color->second));
      if (stuff != words_.substances.end()) found.push_back(shaded(stuff->second.tone));
      specific = color != words_.colors.end();
      const auto other = words_.further_colors.find(word);
      if (other != words_.further_colors.end() && !words_.describes(word))
        found.push_back(other->second);
    }
    return found;
  }

  std::vector<std::string> all_;
  std::vector<Tone> codes_;
  std::vector<Shade> shades_;
  const FinishWords& words_;
};

const UsualFinish* usual_finish(RoomPart part, std::string_view room_type,
                                const FinishWords& finishes) {
  const auto entries = finishes.usual.find(part);
  if (entries == finishes.usual.end()) return nullptr;
  const auto type = words(room_type);
  for (const auto& entry : entries->second) {
    const bool fits = std::any_of(entry.rooms.begin(), entry.rooms.end(), [&](const auto& word) {
      return std::find(type.begin(), type.end(), word) != type.end();
    });
    if (fits || entry.rooms.empty()) return &entry;
  }
  return nullptr;
}

Tone mean(const std::vector<Tone>& tones) {
  Tone sum = Tone::Zero();
  for (const auto& tone : tones) sum += tone;
  return sum / static_cast<float>(tones.size());
}

const Surface& on_part(const Surface& surface, RoomPart part, const FinishWords& words) {
  const auto other = surface.instead.find(part);
  if (other == surface.instead.end()) return surface;
  const Surface* found = find_surface(words, other->second);
  return found ? *found : surface;
}

std::string_view name(RoomPart part) {
  return part == RoomPart::floor ? "floor" : part == RoomPart::walls ? "wall" : "ceiling";
}

Finish covered(const Surface& surface, const Tone& tone, const Tone& second, RoomPart part) {
  Finish finish;
  finish.material.name = name(part);
  finish.material.roughness = static_cast<float>(surface.roughness);
  finish.plain = finish.material.base_color = material_color(tone);
  if (!surface.pattern) return finish;
  finish.extent = texture_extent(*surface.pattern);
  finish.material.base_color = {1, 1, 1, 1};
  finish.material.texture = std::make_shared<Image>(paint_texture(*surface.pattern, tone, second));
  return finish;
}

}  // namespace

std::array<float, 4> material_color(const Eigen::Vector3f& srgb, float alpha) {
  return {linear_from_srgb(srgb.x()), linear_from_srgb(srgb.y()), linear_from_srgb(srgb.z()),
          alpha};
}

Finish make_finish(std::string_view description, RoomPart part, std::string_view room_type,
                   const FinishWords& words) {
  const FinishReader reader(description, words);
  const Described said = reader.run();
  const UsualFinish* usual = usual_finish(part, room_type, words);
  const Surface* surface = said.surface;
  if (!surface && usual) surface = find_surface(words, usual->surface);
  static const Surface plain;
  const Surface& worn = surface ? on_part(*surface, part, words) : plain;

  Tone tone = !said.surface && usual && usual->tone ? *usual->tone : worn.tone;
  Tone second = worn.second;
  if (said.tones.empty()) {
    tone = reader.shaded(tone);
  } else if (worn.pattern && has_two_tones(*worn.pattern) && said.tones.size() > 1) {
    tone = said.tones[0];
    second = said.tones[1];
  } else if (worn.pattern && has_two_tones(*worn.pattern)) {
    // One name is that of the figure, on the usual ground.
    second = said.tones[0];
  } else {
    // "white oak", "blue grey": something between. Joints follow half the way.
    tone = mean(said.tones);
    second = 0.5f * (worn.second + tone);
  }
  return covered(worn, tone, second, part);
}

Finish floor_finish(const Room& room) {
  return make_finish(room.materials.floor, RoomPart::floor, room.type);
}

Finish ceiling_finish(const Room& room) {
  return make_finish(room.materials.ceiling, RoomPart::ceiling, room.type);
}

WallCoat wall_coat(const Room& room, std::size_t wall) {
  const WallCover cover = cover_of(room, wall);
  WallCoat coat{make_finish(cover.finish, RoomPart::walls, room.type), {}, 0.0};
  if (!cover.lower) return coat;
  const std::string& said = cover.lower->finish.empty() ? cover.finish : cover.lower->finish;
  coat.lower = make_finish(said, RoomPart::walls, room.type);
  coat.height = cover.lower->height;
  return coat;
}

bool says_finish(std::string_view description, const FinishWords& words) {
  const auto all = roomgen::words(description);
  return !color_codes(description).empty() ||
         std::any_of(all.begin(), all.end(), [&](const std::string& word) {
           return words.describes(word) || words.further_colors.count(word) ||
                  words.alone.count(word);
         });
}

}  // namespace roomgen
