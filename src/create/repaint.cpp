#include "repaint.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "finish_look.h"
#include "library/shown_colors.h"
#include "part_paint.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

// Of what may be painted: by which a thing is called red, and by which it is said to be of marble.
constexpr double least_painted = 1.0 / 3.0, least_of_substance = 1.0 / 6.0;
constexpr float metallic_surface = 0.5f;
constexpr std::size_t least_within = 5;  // letters of a word that is looked for within others: "whitewood"

std::string without_digits(std::string word) {
  std::erase_if(word, [](char c) { return c >= '0' && c <= '9'; });
  return word;
}

const std::string* stuff_of_word(const std::string& word, const FinishTable& table) {
  if (const auto found = table.surfaces.find(word); found != table.surfaces.end()) return &found->second;
  const std::pair<const std::string, std::string>* best = nullptr;
  for (const auto& entry : table.surfaces)
    if (entry.first.size() >= std::min(least_within, word.size()) && word.find(entry.first) != std::string::npos &&
        (!best || entry.first.size() > best->first.size()))
      best = &entry;
  return best ? &best->second : nullptr;
}

bool is_metal(const std::string& stuff) { return stuff == "metal"; }

class Repainter {
 public:
  Repainter(const Model& model, const FinishTable& table) : table_(table) {
    for (const auto& part : model.parts) {
      const Material& material = model.materials[static_cast<std::size_t>(part.material)];
      stuffs_.push_back(stuff_of(material, table));
      areas_.push_back(surface_area(part.mesh));
    }
    taken_.resize(model.parts.size());
    for (std::size_t i = 0; i < taken_.size(); ++i)
      if (!table_.untouched.count(stuffs_[i])) paintable_ += areas_[i];
  }

  // Legs of metal are for the metal that was named, before what is left over is shared out.
  void share_out(const std::map<std::string, std::string>& finish) {
    for (const auto& [stuff, text] : finish)
      take(stuff, [&, &wanted = stuff](std::size_t part) { return stuffs_[part] == wanted; });
    for (const auto& [stuff, text] : finish) {
      const PartLook look = read_look(text, table_);
      const bool is_shared = table_.untouched.count(stuff) || (is_metal(stuff) && finish.size() > 1);
      if (!is_shared) spread(stuff, look.substance ? least_of_substance : least_painted);
    }
  }

  void paint(Model& model, const std::string& stuff, const PartLook& look, PaintBox& paints) const {
    if (look.empty()) return;
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      if (taken_[i] != stuff) continue;
      ModelPart& part = model.parts[i];
      // Parts of one material may get different looks.
      model.materials.push_back(model.materials[static_cast<std::size_t>(part.material)]);
      part.material = static_cast<int>(model.materials.size()) - 1;
      paint_part(part, model.materials.back(), look, stuffs_[i] == look.stuff, paints);
    }
  }

  double share_of(const std::string& stuff) const {
    double taken = 0.0, all = 0.0;
    for (std::size_t i = 0; i < taken_.size(); ++i) {
      all += areas_[i];
      if (taken_[i] == stuff) taken += areas_[i];
    }
    return all > 0.0 ? taken / all : 0.0;
  }

 private:
  template <typename Fits>
  void take(const std::string& stuff, const Fits& fits) {
    for (std::size_t i = 0; i < taken_.size(); ++i)
      if (taken_[i].empty() && fits(i)) taken_[i] = stuff;
  }

  bool covers(const std::string& stuff, double share) const {
    double covered = 0.0;
    for (std::size_t i = 0; i < taken_.size(); ++i)
      if (taken_[i] == stuff) covered += areas_[i];
    return covered >= share * paintable_;
  }

  void spread(const std::string& stuff, double share) {
    const auto may = [&](std::size_t part) { return !table_.untouched.count(stuffs_[part]); };
    if (!covers(stuff, share)) take(stuff, [&](std::size_t part) { return stuffs_[part].empty(); });
    if (!covers(stuff, share)) take(stuff, [&](std::size_t part) { return may(part) && !is_metal(stuffs_[part]); });
    if (!covers(stuff, share)) take(stuff, may);
  }

  const FinishTable& table_;
  std::vector<std::string> stuffs_, taken_;  ///< by part: what it is of, whose look it gets
  std::vector<double> areas_;
  double paintable_ = 0.0;
};

// Materials that no part has any more would be written into files.
void drop_unused_materials(Model& model) {
  std::vector<Material> kept;
  std::vector<std::optional<int>> places(model.materials.size());
  for (auto& part : model.parts) {
    auto& place = places[static_cast<std::size_t>(part.material)];
    if (!place) {
      place = static_cast<int>(kept.size());
      kept.push_back(std::move(model.materials[static_cast<std::size_t>(part.material)]));
    }
    part.material = *place;
  }
  model.materials = std::move(kept);
}

}  // namespace

std::string stuff_of(const Material& material, const FinishTable& table) {
  if (material.transparent()) return "glass";
  if (material.texture && !is_opaque(*material.texture)) return "growth";
  if (material.metallic >= metallic_surface) return "metal";
  for (const auto& word : words(material.name))
    if (const auto* stuff = stuff_of_word(without_digits(word), table)) return *stuff;
  return "";
}

void repaint(Model& model, const std::map<std::string, std::string>& finish, PaintBox& paints, const FinishTable& table) {
  Repainter repainter(model, table);
  repainter.share_out(finish);
  for (const auto& [stuff, text] : finish) repainter.paint(model, stuff, read_look(text, table), paints);
  drop_unused_materials(model);
}

std::map<std::string, double> painted_shares(const Model& model, const std::map<std::string, std::string>& finish,
                                             const FinishTable& table) {
  Repainter repainter(model, table);
  repainter.share_out(finish);
  std::map<std::string, double> shares;
  for (const auto& [stuff, text] : finish) shares[stuff] = repainter.share_of(stuff);
  return shares;
}

}  // namespace roomgen::create
