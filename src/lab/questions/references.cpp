#include "references.h"

#include <algorithm>

#include "forms.h"
#include "library/shown_colors.h"
#include "roomgen/base/text.h"

namespace roomgen::lab::detail {

namespace {

constexpr double darkest_hue = 0.28, lightest_hue = 0.85;  // lightness of what has another name than black or white
constexpr float green_slack = 0.1f, lit = 1.25f;  // how much more or less green, and light, may be without another name
constexpr double most_of_it = 0.6;          // share of what is seen that has the colour
constexpr double sure_height = 1.15;        // times the next height
constexpr double sure_metres = 0.4, sure_times = 1.5;  // nearer than the next one
constexpr std::size_t sure_frames = 2;      // earlier than the next one

// Between yellow and brown, or orange and red, people differ; and lamps make things look lighter.
bool is_sure_hue(const ShownColor& color) {
  const auto is_named = [&](float green, float all) {
    const auto [r, g, b] = color.mean;
    return color_name(std::min(255.0f, all * r), std::min(255.0f, all * green * g), std::min(255.0f, all * b)) == color.name;
  };
  return is_named(1.0f - green_slack, 1.0f) && is_named(1.0f + green_slack, 1.0f) && is_named(1.0f, lit);
}

std::string main_color(const Object& object, const ModelTable& models) {
  const auto model = models.find(asset_key(object.asset));
  if (!model) return "";
  const auto colors = shown_colors(*model);
  if (colors.empty() || colors.front().share < most_of_it) return "";
  // A sofa of the darkest brown is black to who sees it indoors, a cream one white.
  const double light = lightness(colors.front().mean);
  const std::string& name = colors.front().name;
  const bool sure = (light >= darkest_hue || name == "black") && (light <= lightest_hue || name == "white");
  return sure && is_sure_hue(colors.front()) ? name : "";
}

bool has_one_color(const KindTable& kinds, const std::string& kind) {
  const auto& without = question_forms().no_color;
  return std::none_of(without.begin(), without.end(), [&](const std::string& one) { return kinds.is_a(kind, one); });
}

std::string last_word(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

}  // namespace

References::References(const Scene& scene, const ModelTable& models, const KindTable& kinds,
                       const std::vector<Appearance>& appearances)
    : scene_(scene), kinds_(kinds), appearances_(appearances) {
  std::map<std::string, std::string> known;
  for (const auto& object : scene.objects) {
    const std::string key = asset_key(object.asset);
    if (!known.count(key)) known[key] = main_color(object, models);
    colors_.push_back(has_one_color(kinds, object.category) ? known[key] : "");
  }
  for (std::size_t k = 0; k < scene.objects.size(); ++k) plain_.push_back(by_kind(k));
  for (std::size_t k = 0; k < scene.objects.size(); ++k) references_.push_back(find(k));
}

std::vector<const Reference*> References::all() const {
  std::vector<const Reference*> list;
  for (const auto& reference : references_)
    if (reference && !reference->by_time) list.push_back(&*reference);
  return list;
}

bool References::is_settled(const std::string& kind) const {
  return std::all_of(scene_.objects.begin(), scene_.objects.end(), [&](const Object& object) {
    if (object.stand_in) return false;
    const bool sounds = last_word(object.category) == last_word(kind);
    return !sounds || object.category == kind || kinds_.is_a(object.category, kind) || kinds_.is_a(kind, object.category) ||
           kind != last_word(kind);
  });
}

std::vector<std::size_t> References::rivals(std::size_t object) const {
  const std::string& kind = scene_.objects[object].category;
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < scene_.objects.size(); ++k) {
    const std::string& other = scene_.objects[k].category;
    const bool same_sound = kind == last_word(kind) && last_word(other) == kind;
    if (k != object && (other == kind || kinds_.is_a(other, kind) || kinds_.is_a(kind, other) || same_sound))
      list.push_back(k);
  }
  return list;
}

bool References::may_be_asked_about(std::size_t object) const {
  return appearances_[object].clear && !scene_.objects[object].stand_in;
}

Reference References::reference(std::size_t object, const std::string& way, const std::string& words,
                                const std::string& color, std::optional<std::size_t> other) const {
  const Fillings fillings = {{"kind", scene_.objects[object].category}, {"color", color}, {"a", other ? plain_[*other]->text : ""}};
  return {object, filled_inside(words, fillings), way == "first seen", way == "twin", way,
          other ? scene_.objects[*other].id : ""};
}

std::optional<Reference> References::by_kind(std::size_t object) const {
  if (!may_be_asked_about(object) || !rivals(object).empty()) return std::nullopt;
  return reference(object, "kind", "the {kind}");
}

std::optional<Reference> References::find(std::size_t object) const {
  if (plain_[object]) return plain_[object];
  if (!may_be_asked_about(object)) return std::nullopt;
  const auto others = rivals(object);
  for (const auto way : {&References::by_color, &References::by_carrier, &References::by_neighbour,
                         &References::by_height, &References::by_time})
    if (auto found = (this->*way)(object, others)) return found;
  return std::nullopt;
}

std::optional<Reference> References::by_color(std::size_t object, const std::vector<std::size_t>& others) const {
  const std::string& color = colors_[object];
  if (color.empty()) return std::nullopt;
  for (const std::size_t k : others)
    if (colors_[k].empty() || colors_[k] == color) return std::nullopt;
  return reference(object, "color", question_forms().words.at("by color"), color);
}

std::optional<Reference> References::by_carrier(std::size_t object, const std::vector<std::size_t>& others) const {
  const std::string& on = scene_.objects[object].on;
  if (on.empty()) return std::nullopt;
  for (const std::size_t k : others)
    if (scene_.objects[k].on == on) return std::nullopt;
  for (std::size_t k = 0; k < scene_.objects.size(); ++k)
    if (scene_.objects[k].id == on && plain_[k]) return reference(object, "on", question_forms().words.at("on"), "", k);
  return std::nullopt;
}

std::optional<Reference> References::by_neighbour(std::size_t object, const std::vector<std::size_t>& others) const {
  for (std::size_t k = 0; k < scene_.objects.size(); ++k) {
    if (!plain_[k] || k == object || std::count(others.begin(), others.end(), k) > 0) continue;
    const auto distance = [&](std::size_t one) { return gap(footprint(scene_.objects[one]), footprint(scene_.objects[k])); };
    const double mine = distance(object);
    const bool nearest = std::all_of(others.begin(), others.end(), [&](std::size_t other) {
      return distance(other) >= std::max(mine + sure_metres, sure_times * mine);
    });
    if (nearest) return reference(object, "nearest", question_forms().words.at("nearest"), "", k);
  }
  return std::nullopt;
}

std::optional<Reference> References::by_height(std::size_t object, const std::vector<std::size_t>& others) const {
  const double mine = scene_.objects[object].size.z();
  const auto all = [&](auto test) {
    return std::all_of(others.begin(), others.end(), [&](std::size_t k) { return test(scene_.objects[k].size.z()); });
  };
  if (all([&](double height) { return mine >= sure_height * height; }))
    return reference(object, "tallest", question_forms().words.at("tallest"));
  if (all([&](double height) { return height >= sure_height * mine; }))
    return reference(object, "lowest", question_forms().words.at("shortest"));
  return std::nullopt;
}

std::optional<Reference> References::by_time(std::size_t object, const std::vector<std::size_t>& others) const {
  const Appearance& mine = appearances_[object];
  if (!mine.is_seen()) return std::nullopt;
  for (const std::size_t k : others)
    if (appearances_[k].first_faint != Appearance::never && appearances_[k].first_faint < mine.first_seen + sure_frames)
      return std::nullopt;
  return reference(object, "first seen", question_forms().words.at("first seen"));
}

std::optional<Reference> References::twin(std::size_t object) const {
  if (references_[object] || !may_be_asked_about(object)) return std::nullopt;
  const Object& mine = scene_.objects[object];
  for (const std::size_t k : rivals(object)) {
    const Object& other = scene_.objects[k];
    if (!(other.asset == mine.asset) || (other.size - mine.size).norm() > 0.005) return std::nullopt;
  }
  return reference(object, "twin", question_forms().words.at("twin"));
}

}  // namespace roomgen::lab::detail
