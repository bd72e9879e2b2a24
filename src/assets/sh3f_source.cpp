// Sweet Home 3D furniture libraries: a ZIP of OBJ models and a properties file with keys such as
// "width#12" (the format of its "Furniture Library Editor"). Lengths are centimetres; models are
// Y-up with their front towards +Z once "modelRotation" has been applied.

#include <charconv>
#include <cmath>

#include "asset_source.h"
#include "base/relative_name.h"
#include "properties.h"
#include "roomgen/base/text.h"
#include "scene/opening_kind.h"

namespace roomgen::assets {

namespace {

using Properties = std::map<std::string, std::string, std::less<>>;

constexpr int max_models = 20000;
constexpr double centimetre = 0.01;
constexpr double largest = 50.0;  // metres
constexpr double least_in_wall = 0.005;  // metres
constexpr std::size_t most_sashes = 20;

// The properties of one model.
class Entry {
 public:
  Entry(const Properties& all, int number) : all_(all), suffix_("#" + std::to_string(number)) {}

  std::string text(std::string_view key) const {
    const auto found = all_.find(std::string(key) + suffix_);
    return found == all_.end() ? std::string() : found->second;
  }
  std::optional<double> number(std::string_view key) const {
    const std::string value = text(key);
    double result = 0.0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), result);
    if (error != std::errc{} || !std::isfinite(result)) return std::nullopt;
    return result;
  }
  std::optional<double> metres(std::string_view key) const {
    const auto value = number(key);
    return value ? std::optional(*value * centimetre) : std::nullopt;
  }

 private:
  const Properties& all_;
  std::string suffix_;
};

std::string library_text(const Properties& all, std::string_view key) {
  const auto found = all.find(key);
  return found == all.end() ? std::string() : found->second;
}

// The libraries name their licence in words.
std::string license_id(const std::string& words) {
  const std::string text = lower(words);
  const auto has = [&](std::string_view part) { return text.find(part) != std::string::npos; };
  if (has("public domain") || has("cc0") || has("cc-0")) return "CC0-1.0";
  if (has("attribution 3.0 united states")) return "CC-BY-3.0-US";
  if (has("attribution 3.0")) return "CC-BY-3.0";
  if (has("attribution 4.0")) return "CC-BY-4.0";
  return words;
}

// Two models of the public-domain library are not, by the licence files beside them.
std::string license_of(const std::string& id, const std::string& library_license) {
  if (id == "winchesterSofa" || id == "winchesterArmchair") return "CC-BY-3.0";
  return license_id(library_license);
}

// Numbers separated by blanks, one for each sash.
std::vector<double> numbers(const std::string& text) {
  std::vector<double> values;
  for (const auto& piece : split(text, ' ')) {
    double value = 0.0;
    if (std::from_chars(piece.data(), piece.data() + piece.size(), value).ec == std::errc{})
      values.push_back(value);
  }
  return values;
}

// Row-major 3x3, applied to the file's coordinates; nearly orthonormal, or it is ignored.
Eigen::Matrix3d rotation(const std::string& text) {
  Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
  const auto values = numbers(text);
  if (values.size() != 9) return result;
  for (int i = 0; i < 9; ++i) result(i / 3, i % 3) = values[static_cast<std::size_t>(i)];
  const bool orthonormal = (result * result.transpose()).isIdentity(1e-3);
  return orthonormal ? result : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

Eigen::Matrix3d ours_from_sh3d(const Entry& entry) {
  Eigen::Matrix3d ours_from_y_up;
  ours_from_y_up << 1, 0, 0,  //
      0, 0, -1,               //
      0, 1, 0;
  return ours_from_y_up * rotation(entry.text("modelRotation"));
}

std::vector<std::string> tags(const std::string& text) {
  std::vector<std::string> result;
  for (auto& tag : split(text, ','))
    if (!tag.empty() && tag != "Blend Swap") result.push_back(std::move(tag));
  return result;
}

std::string short_id(const std::string& id) {
  return id.substr(id.find('#') + 1);
}

std::string relative(std::string path) {
  while (path.starts_with('/')) path.erase(0, 1);
  return path;
}

// The figures of that package are people, not furniture.
bool is_human(const std::string& creator) {
  return creator == "Reallusion";
}

// Doors and windows stand with their back in the wall, the room before them; "wall thickness" is
// the wall's share of their depth and "wall distance" what stands out behind it. Sashes turn on
// hinges at "sash x", counted from the left for who looks at the front.
Result<std::optional<WallFit>> read_wall_fit(const Entry& entry, const Vec3& size) {
  if (entry.text("doorOrWindow") != "true") return std::optional<WallFit>();
  WallFit fit;
  const double behind = std::max(0.0, entry.metres("doorOrWindowWallDistance").value_or(0.0));
  const double thickness = entry.metres("doorOrWindowWallThickness").value_or(size.y() - behind);
  fit.wall_back = size.y() - behind;
  fit.wall_front = std::max(0.0, fit.wall_back - thickness);
  if (!(fit.wall_back - fit.wall_front >= least_in_wall))
    return Error{Error::Kind::invalid_input, "no part of it is in the wall"};
  const auto hinges = numbers(entry.text("doorOrWindowSashXAxis"));
  fit.leaves = static_cast<int>(std::min(hinges.size(), most_sashes));
  fit.hinge_left = !hinges.empty() && centimetre * hinges.front() < 0.5 * size.x();
  if (const std::string path = entry.text("doorOrWindowCutOutShape"); !path.empty()) {
    auto outline = outline_of_cut_out(path);
    if (!outline) return with_context(outline.error(), "doorOrWindowCutOutShape");
    fit.outline = *std::move(outline);
  }
  return std::optional<WallFit>(std::move(fit));
}

Result<SourceAsset> read_entry(const Entry& entry, const FileTree& tree, const std::string& library,
                               const std::string& license) {
  const auto refuse = [&](const std::string& what) {
    return Error{Error::Kind::invalid_input, library + "/" + entry.text("id") + ": " + what};
  };
  SourceAsset asset;
  AssetInfo& info = asset.info;
  info.ref.library = library;
  info.ref.id = short_id(entry.text("id").empty() ? entry.text("model") : entry.text("id"));
  info.ref.license = license_of(info.ref.id, license);
  info.ref.creator = entry.text("creator");
  info.name = entry.text("name");
  info.tags = tags(entry.text("tags"));
  info.group = entry.text("category");
  const auto width = entry.metres("width"), depth = entry.metres("depth"),
             height = entry.metres("height");
  if (!width || !depth || !height) return refuse("has no size");
  info.size = Vec3(*width, *depth, *height);
  if (!(info.size.minCoeff() > 0.0) || info.size.maxCoeff() > largest)
    return refuse("has an absurd size");
  info.elevation = std::max(0.0, entry.metres("elevation").value_or(0.0));
  if (const auto top = entry.metres("dropOnTopElevation")) {
    asset.carries_nothing = *top < 0.0;
    if (*top > 0.0) info.support_height = *top;
  }
  auto wall_fit = read_wall_fit(entry, info.size);
  if (!wall_fit) return refuse(wall_fit.error().message);
  info.wall_fit = *std::move(wall_fit);
  asset.frame.size = info.size;
  asset.frame.ours_from_source = ours_from_sh3d(entry);
  asset.mesh = relative(entry.text("model"));
  if (!stays_below(asset.mesh) || !tree.contains(asset.mesh))
    return refuse("its model \"" + asset.mesh + "\" is not in the library");
  return asset;
}

}  // namespace

std::vector<SourceAsset> list_sh3f(const FileTree& tree, const std::string& library,
                                   const LogSink& log) {
  std::vector<SourceAsset> assets;
  const auto text = tree.read(std::string(sh3f_catalogue));
  if (!text) {
    roomgen::log(log, LogLevel::warning, text.error().message);
    return assets;
  }
  const auto properties = parse_properties(*text);
  if (!properties) {
    roomgen::log(log, LogLevel::warning, library + ": " + properties.error().message);
    return assets;
  }
  const Properties& all = *properties;
  for (int number = 1; number <= max_models; ++number) {
    const Entry entry(all, number);
    if (entry.text("name").empty()) break;  // Sweet Home 3D stops at the first gap, too
    if (is_human(entry.text("creator"))) continue;
    auto asset = read_entry(entry, tree, library, library_text(all, "license"));
    if (asset)
      assets.push_back(*std::move(asset));
    else
      roomgen::log(log, LogLevel::warning, asset.error().message);
  }
  return assets;
}

}  // namespace roomgen::assets
