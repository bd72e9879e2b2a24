#include "finish.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t longest_name = 3;  ///< words of a surface's name

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

  SaidFinish run() const {
    SaidFinish said;
    said.surface = surface();
    if (!said.surface) said.surface = surface_of_stuff(), said.surface_is_of_stuff = true;
    said.unknown = unknown();
    set_tones(said);
    return said;
  }

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
    return nullptr;
  }
  const Surface* surface_of_stuff() const {
    for (const auto& word : all_)
      if (const auto found = words_.substances.find(word); found != words_.substances.end())
        return find_surface(words_, found->second.surface);
    return nullptr;
  }

  static Tone mean(const std::vector<Tone>& tones) {
    Tone sum = Tone::Zero();
    for (const auto& tone : tones) sum += tone;
    return sum / static_cast<float>(tones.size());
  }

  // "White oak" and "blue grey" are something between, and what "and" or "with" parts are two.
  void set_tones(SaidFinish& said) const {
    said.names = said.tones = codes_;
    std::vector<Tone> together;
    bool is_ground = true;
    const auto end_one = [&] {
      if (!together.empty()) said.tones.push_back(mean(together));
      said.names.insert(said.names.end(), together.begin(), together.end());
      together.clear();
      if (is_ground) said.grounds = said.tones.size();
    };
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (all_[i] == "and" || all_[i] == "with") end_one();
      is_ground = is_ground && all_[i] != "with";
      add_tones(i, together);
    }
    end_one();
  }

  void add_tones(std::size_t at, std::vector<Tone>& found) const {
    const std::string& word = all_[at];
    // "Navy blue" is navy.
    const bool is_said = at > 0 && words_.colors.count(all_[at - 1]) > 0;
    const auto basic = words_.basic_colors.find(word);
    const auto color = words_.colors.find(word);
    const auto stuff = words_.substances.find(word);
    if (basic != words_.basic_colors.end() && !is_said) found.push_back(shaded(basic->second));
    if (color != words_.colors.end()) found.push_back(shaded(color->second));
    if (stuff != words_.substances.end()) found.push_back(shaded(stuff->second.tone));
    const auto other = words_.further_colors.find(word);
    if (other != words_.further_colors.end() && !words_.describes(word))
      found.push_back(other->second);
  }

  // Those of no surface that shows what it is called, and of no colour.
  std::vector<std::string> unknown() const {
    static const std::set<std::string_view> small = {"and", "with", "of", "the",  "a", "an",
                                                     "in",  "on",   "or", "over", "to"};
    std::vector<bool> is_told(all_.size(), false);
    for (std::size_t length = longest_name; length > 0; --length)
      for (std::size_t at = 0; at + length <= all_.size(); ++at) {
        const auto begin = all_.begin() + static_cast<std::ptrdiff_t>(at);
        const std::string name = join({begin, begin + static_cast<std::ptrdiff_t>(length)}, " ");
        const bool is_named = words_.surface_names.count(name) || words_.alone.count(name);
        if (is_named && !words_.likenesses.count(name))
          std::fill_n(is_told.begin() + static_cast<std::ptrdiff_t>(at), length, true);
      }
    std::vector<std::string> found;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const std::string& word = all_[i];
      const bool is_likeness = words_.likenesses.count(word) > 0;
      if (!is_told[i] && (is_likeness || !is_drawn(word)) && !small.count(word) && !is_code(word))
        found.push_back(word);
    }
    return found;
  }
  bool is_drawn(const std::string& word) const {
    return words_.describes(word) || words_.fillers.count(word) || words_.parts.count(word) ||
           words_.further_colors.count(word);
  }
  bool is_code(const std::string& word) const {
    return !codes_.empty() && word.find_first_not_of("0123456789abcdef") == std::string::npos;
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

SaidFinish said_finish(std::string_view description, const FinishWords& words) {
  return FinishReader(description, words).run();
}

std::vector<Tone> DrawnFinish::tones() const {
  if (surface.pattern && has_two_tones(*surface.pattern)) return {tone, second};
  return {tone};
}

DrawnFinish drawn_finish(std::string_view description, RoomPart part, std::string_view room_type,
                         const FinishWords& words) {
  const FinishReader reader(description, words);
  const SaidFinish said = reader.run();
  const UsualFinish* usual = usual_finish(part, room_type, words);
  const Surface* surface = said.surface;
  if (!surface && usual) surface = find_surface(words, usual->surface);
  static const Surface plain;
  const Surface& worn = surface ? on_part(*surface, part, words) : plain;

  DrawnFinish drawn{worn, worn.tone, worn.second};
  const bool has_two = worn.pattern && has_two_tones(*worn.pattern);
  const Surface* alternating = find_surface(words, worn.alternating);
  if (said.tones.empty()) {
    drawn.tone = reader.shaded(!said.surface && usual && usual->tone ? *usual->tone : worn.tone);
  } else if (has_two) {
    const auto& both = said.tones.size() > 1 ? said.tones : said.names;
    if (both.size() > 1) drawn.tone = both[0];
    drawn.second = both[both.size() > 1 ? 1 : 0];  // one is that of the figure, on the usual ground
  } else if (alternating && said.grounds > 1) {
    drawn = {*alternating, said.tones[0], said.tones[1]};
  } else {
    // Joints follow half the way.
    drawn.tone = said.tones[0];
    drawn.second = 0.5f * (worn.second + drawn.tone);
  }
  return drawn;
}

Finish make_finish(std::string_view description, RoomPart part, std::string_view room_type,
                   const FinishWords& words) {
  const DrawnFinish drawn = drawn_finish(description, part, room_type, words);
  return covered(drawn.surface, drawn.tone, drawn.second, part);
}

double tone_distance(const Tone& a, const Tone& b) {
  const auto lab = [](const Tone& tone) {
    const Vec3 rgb(linear_from_srgb(tone.x()), linear_from_srgb(tone.y()),
                   linear_from_srgb(tone.z()));
    Eigen::Matrix3d to_xyz;  // over the white of D65
    to_xyz << 0.4339, 0.3763, 0.1899, 0.2126, 0.7152, 0.0722, 0.0177, 0.1095, 0.8728;
    const Vec3 f = (to_xyz * rgb).unaryExpr([](double t) {
      constexpr double dark = 216.0 / 24389.0;
      return t > dark ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    });
    return Vec3(116.0 * f.y() - 16.0, 500.0 * (f.x() - f.y()), 200.0 * (f.y() - f.z()));
  };
  return (lab(a) - lab(b)).norm();
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
