#include "roomgen/export/exporter.h"

#include <map>
#include <tuple>
#include <vector>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

struct Credit {
  AssetRef asset;
  std::vector<std::string> objects;
};

// By library and id, so that the order does not depend on that of the objects.
std::vector<Credit> credits(const Scene& scene) {
  std::map<std::tuple<std::string, std::string>, Credit> by_asset;
  const auto add = [&](const AssetRef& asset, const std::string& user) {
    if (asset.id.empty() || asset.procedural) return;
    Credit& credit = by_asset[{asset.library, asset.id}];
    credit.asset = asset;
    credit.objects.push_back(asset.finish.empty() ? user : user + " (painted anew)");
  };
  for (const auto& room : rooms_of(scene))
    for (const auto& opening : room.openings) add(opening.joinery.asset, opening.id);
  for (const auto& object : scene.objects) add(object.asset, object.id);
  std::vector<Credit> result;
  for (auto& [key, credit] : by_asset) result.push_back(std::move(credit));
  return result;
}

std::string or_unknown(const std::string& text) {
  return text.empty() ? "unknown" : text;
}

// Text of strangers must not end a table cell or the line.
std::string cell(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '|') safe += '\\';
    safe += c == '\n' || c == '\r' ? ' ' : c;
  }
  return or_unknown(safe);
}

}  // namespace

std::string attribution_markdown(const Scene& scene) {
  const auto all = credits(scene);
  std::string text = "# Attribution\n\n";
  if (all.empty()) return text + "All meshes of this scene were made by roomgen.\n";
  text += "This scene contains the following works. Keep this list when you pass the scene on.\n\n";
  text += "| work | creator | licence | library | objects |\n|---|---|---|---|---|\n";
  for (const auto& credit : all)
    text += "| " + cell(credit.asset.id) + " | " + cell(credit.asset.creator) + " | " +
            cell(credit.asset.license) + " | " + cell(credit.asset.library) + " | " +
            cell(join(credit.objects, ", ")) + " |\n";
  return text;
}

std::string attribution_line(const Scene& scene) {
  std::vector<std::string> pieces;
  for (const auto& credit : credits(scene))
    pieces.push_back(credit.asset.id + " by " + or_unknown(credit.asset.creator) + " (" +
                     or_unknown(credit.asset.license) + ", " + credit.asset.library + ")");
  return join(pieces, "; ");
}

}  // namespace roomgen
