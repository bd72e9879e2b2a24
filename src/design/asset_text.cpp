#include "asset_text.h"

#include <algorithm>
#include <array>

#include "library/seen_assets.h"
#include "roomgen/base/text.h"
#include "scene/written_asset.h"

namespace roomgen::design {

namespace {

constexpr std::size_t most_parts = 4;
constexpr double same_size = 0.02, small_stretch = 0.03;
constexpr std::array<const char*, 3> narrower = {"narrower", "shallower", "lower"};
constexpr std::array<const char*, 3> wider = {"wider", "deeper", "higher"};

std::string own_words(const AssetInfo& asset) {
  if (is_written(asset.ref) && !asset.name.empty()) {
    const std::string about = text_parameter(*asset.ref.procedural, "about");
    return about.empty() ? asset.name : about;
  }
  if (asset.ref.procedural) {
    const std::string said = text_parameter(*asset.ref.procedural, "description");
    return said.empty() ? asset.category : said;
  }
  const SeenAsset* seen = seen_asset(asset.ref);
  return seen && !seen->is.empty() ? seen->is : asset.name;
}

// "0.20 narrower, 0.05 higher than asked"
std::string difference_text(const Vec3& have, const Vec3& want) {
  std::vector<std::string> sides;
  for (int axis = 0; axis < 3; ++axis) {
    const double off = have[axis] - want[axis];
    const auto& words = off < 0.0 ? narrower : wider;
    if (std::abs(off) > same_size * want[axis] && std::abs(off) > 0.01)
      sides.push_back(format_number(std::abs(off), 2) + " " +
                      words[static_cast<std::size_t>(axis)]);
  }
  return sides.empty() ? "as asked" : join(sides, ", ") + " than asked";
}

std::string stretch_text(const OfferedAsset& offered) {
  const bool is_stiff =
      (offered.most.cwiseQuotient(offered.least.cwiseMax(1e-6)).array() < 1.0 + small_stretch)
          .all();
  return is_stiff ? std::string()
                  : "; can be " + size_text(offered.least) + " to " + size_text(offered.most);
}

// As the mesh has them by itself.
std::string parts_text(const AssetInfo& asset) {
  if (asset.ref.procedural) return "";
  const SeenAsset* seen = seen_asset(asset.ref);
  if (!seen) return asset.colors.empty() ? "" : "; " + join(asset.colors, ", ");
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < std::min(seen->parts.size(), most_parts); ++i)
    parts.push_back(seen->parts[i].part + " " + seen->parts[i].color + " " +
                    seen->parts[i].material);
  const std::string unpainted = asset.ref.finish.empty() ? "; " : "; unpainted: ";
  return parts.empty() ? "" : unpainted + join(parts, ", ");
}

std::string kind_of_making(const AssetInfo& asset) {
  if (asset.stand_in) return "; a plain stand-in, for nobody knows how such a thing is made";
  if (asset.approximate) return "; put together from the words, for its kind is not known";
  return asset.ref.procedural ? "; made from these words" : "";
}

std::string asset_line(const AssetOffer& offer, std::size_t index) {
  const OfferedAsset& offered = offer.assets[index];
  const bool is_turned = !offered.asset.has_front &&
                         (offered.size.x() < offered.size.y()) != (offer.size.x() < offer.size.y());
  const Vec3 asked = is_turned ? Vec3(offer.size.y(), offer.size.x(), offer.size.z()) : offer.size;
  const bool is_worded = offered.asset.ref.procedural && own_words(offered.asset) == offer.words;
  const std::string looks = is_worded ? offered.asset.category : told_looks(offered.asset);
  std::string line = "   " + offer.label(index) + ": " + looks + ", " + size_text(offered.size) +
                     " m (" + difference_text(offered.size, asked) + stretch_text(offered) + ")" +
                     kind_of_making(offered.asset) + parts_text(offered.asset);
  const bool is_known = !offered.asset.ref.procedural;  // of what is made it is seen when it is
  if (is_known && offer.carries && !offered.asset.support_height) line += "; nothing can stand on it";
  return line;
}

std::string making_line(const AssetOffer& offer) {
  for (std::size_t i = 0; i < offer.assets.size() && offer.made; ++i)
    if (offer.assets[i].asset.ref.procedural == offer.made->ref.procedural)
      return "   make: of these words " + offer.label(i) + "; or of others";
  if (!offer.made)
    return "   make: its kind is not known; only of words that name its parts, their shapes and "
           "materials";
  if (offer.made->stand_in) return "   make: only a plain stand-in";
  if (offer.made->approximate)
    return "   make: its kind is not known; what parts the words name are put together";
  return "   make: a " + offer.made->category + ", its kind is known; " +
         size_text(offer.made->size) + " m";
}

}  // namespace

std::string told_looks(const AssetInfo& asset) {
  std::vector<std::string> painted;
  for (const auto& [stuff, looks] : asset.ref.finish) painted.push_back(stuff + " " + looks);
  return own_words(asset) + (painted.empty() ? "" : ", painted: " + join(painted, ", "));
}

std::string offer_title(const Plan& plan, const AssetOffer& offer) {
  const PlanItem& item = plan.items[offer.items.front()];
  std::string text = offer.id + ". " +
                     (offer.count > 1 ? std::to_string(offer.count) + " x " : "") + item.category;
  if (!offer.words.empty() && offer.words != item.category) text += ": " + offer.words;
  return text + ", " + size_text(offer.size) + " m";
}

std::string room_line(const Room& room) {
  const Vec2 size = bounds(room.polygon).size();
  return room.type + ", " + format_number(size.x(), 1) + " x " + format_number(size.y(), 1) + " m";
}

std::string offer_head(const Plan& plan, const AssetOffer& offer) {
  const PlanItem& item = plan.items[offer.items.front()];
  std::string text = offer_title(plan, offer);
  if (item.mount == Mount::wall) text += ", on a wall";
  if (item.mount == Mount::ceiling) text += ", under the ceiling";
  if (item.mount == Mount::surface) text += item.on.empty() ? ", on a surface" : ", on " + item.on;
  if (item.varied && offer.count > 1) text += ", each another one";
  if (item.asked) text += ", asked for by the wish";
  if (offer.carries) text += ", carries things";
  return text;
}

std::string offer_text(const Plan& plan, const AssetOffer& offer, bool by_rules) {
  std::string text = offer_head(plan, offer);
  if (!offer.is_shown) text += "; NOTHING IN STOCK IS ONE";
  for (std::size_t i = 0; i < offer.assets.size(); ++i) text += "\n" + asset_line(offer, i);
  return by_rules ? text + "\n" + making_line(offer) : text;
}

}  // namespace roomgen::design
