#include "roomgen/create/create.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "finish_look.h"
#include "library/looks.h"
#include "library/seen_assets.h"
#include "library/shown_colors.h"
#include "library/style_words.h"
#include "library/vocabulary.h"
#include "repaint.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"
#include "shape/motifs.h"

namespace roomgen::create {

namespace {

bool says_any(const AssetInfo& asset, const std::vector<std::string>& wanted) {
  auto told = words(asset.name + " " + asset.category + " " + join(asset.tags, " "));
  return std::any_of(wanted.begin(), wanted.end(), [&](const std::string& word) {
    return std::find(told.begin(), told.end(), word) != told.end();
  });
}

// "wooden" is no sort of wood: it looks like wood.
bool says_stuff(const std::string& word, const std::string& stuff) {
  return word == stuff || finish_table().substances.at(word).color == finish_table().substances.at(stuff).color;
}

bool has_pattern(const AssetInfo& asset, const PartLook& look) {
  for (const auto& said : look.said)
    if (finish_table().patterns.count(said)) return says_any(asset, Vocabulary::built_in().family(said));
  return true;
}

// Names are believed of stuffs, not of their sorts: what is called oak may be as dark as walnut.
bool has_substance(const AssetInfo& asset, const PartLook& look) {
  if (!look.substance) return true;
  const bool has_own_color = look.stuff == "wood" || look.stuff == "metal";
  for (const auto& said : look.said)
    if (const auto stuff = finish_table().stuffs.find(said); stuff != finish_table().stuffs.end())
      if (!says_any(asset, {said}) || (has_own_color && !says_stuff(said, stuff->second))) return false;
  return true;
}

// Only the plainest words of colour can be told by the largest colour alone.
bool has_tone(const AssetInfo& asset, const PartLook& look) {
  if (!look.shades.empty()) return false;
  if (look.tones.empty()) return true;
  if (look.tones.size() > 1 || asset.colors.empty()) return false;
  const std::string name = color_name(look.tones[0][0], look.tones[0][1], look.tones[0][2]);
  const bool is_plain = std::find(look.said.begin(), look.said.end(), name) != look.said.end();
  return is_plain && asset.colors.front() == name;
}

bool is_known_to_look(const AssetInfo& asset, const PartLook& look) {
  return !asset.ref.procedural && !look.gloss && has_tone(asset, look) && has_substance(asset, look) &&
         has_pattern(asset, look);
}

// Who makes it knows its colours, and paint would cover what is printed on it.
bool is_made_cloth(const AssetInfo& asset) {
  return asset.ref.procedural && KindTable::built_in().is_any_of(asset.category, printed_cloths);
}

// Of tables of glass only the legs could be painted.
bool is_of_glass(const AssetInfo& asset) {
  const auto* seen = seen_asset(asset.ref);
  if (seen && !seen->parts.empty())
    return seen->parts.front().material.find("glass") != std::string::npos;
  return says_any(asset, {"glass", "transparent", "acrylic"}) && !says_any(asset, {"wood", "wooden"});
}

// Without the words that name the kind: a coffee table is not to be the colour of coffee. Of a name that nobody
// knows ("travertine nightstand") all but the category may be looks.
std::string words_of_looks(const AssetQuery& query) {
  const auto& vocabulary = Vocabulary::built_in();
  auto all = words(query.description);
  const auto phrase = vocabulary.understand(query.description);
  for (const std::string& name : {phrase.known ? phrase.name : std::string(), query.category}) {
    const auto of_kind = words(name);
    const bool ends_so = !of_kind.empty() && of_kind.size() <= all.size() &&
                         std::equal(of_kind.rbegin(), of_kind.rend(), all.rbegin(),
                                    [](const auto& a, const auto& b) { return singular(a) == singular(b); });
    if (ends_so) all.resize(all.size() - of_kind.size());
  }
  return join(all, " ");
}

// A style says how its things look where the words say neither tone nor substance: a "rustic chest". Where they say
// but the tone, or nothing is known of such things, it says how they shine: a "sleek black dresser".
std::string in_style(const std::string& looks, const std::string& kind) {
  const StyleMeaning* style = StyleWords::built_in().named_in(looks);
  const PartLook said = read_look(looks);
  if (!style || said.substance) return looks;
  for (const auto& look : style->looks)
    if (said.tones.empty() && KindTable::built_in().is_any_of(kind, look.kinds))
      return look.words.front() + " " + looks;
  return said.gloss || style->sheen.empty() ? looks : style->sheen + " " + looks;
}

class FinishingLibrary final : public AssetLibrary {
 public:
  explicit FinishingLibrary(std::shared_ptr<const AssetLibrary> library) : library_(std::move(library)) {}

  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override {
    auto matches = library_->search(query);
    if (!matches) return matches;
    const std::string looks = words_of_looks(query);
    const bool has_print = !shape::motifs_on_cloth(query.description).empty();
    for (auto& match : *matches)
      if (!(has_print && is_made_cloth(match.asset)))
        finish(match, wanted_finish(in_style(looks, match.asset.category), match.asset.category));
    std::stable_sort(matches->begin(), matches->end(), [](const AssetMatch& a, const AssetMatch& b) {
      return a.contradicts < b.contradicts;
    });
    return matches;
  }

  // The looks stand at the end of a key ("Scopia/sofa#upholstery=navy velvet"); ids may have such
  // signs too.
  Result<AssetInfo> find(std::string_view key) const override {
    std::map<std::string, std::string> finish;
    for (std::string_view rest = key;;) {
      auto asset = library_->find(rest);
      if (asset) wear(*asset, std::move(finish));
      if (asset || asset.error().kind != Error::Kind::not_found) return asset;
      const auto sign = rest.rfind('#'), equals = rest.find('=', sign == rest.npos ? 0 : sign);
      if (sign == rest.npos || equals == rest.npos) return AssetLibrary::find(key);
      finish.emplace(rest.substr(sign + 1, equals - sign - 1), rest.substr(equals + 1));
      rest = rest.substr(0, sign);
    }
  }

  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override {
    if (ref.finish.empty()) return library_->load(ref);
    const std::string key = asset_key(ref);
    std::unique_lock lock(mutex_);
    if (const auto known = models_.find(key); known != models_.end()) return known->second;
    lock.unlock();  // several are read and painted beside each other
    AssetRef plain = ref;
    plain.finish.clear();
    auto loaded = library_->load(plain);
    if (!loaded) return loaded;
    Model model = **loaded;
    repaint(model, ref.finish, paints_);
    lock.lock();
    return models_.emplace(key, std::make_shared<const Model>(std::move(model))).first->second;
  }

 private:
  static void finish(AssetMatch& match, std::map<std::string, std::string> wanted) {
    AssetInfo& asset = match.asset;
    bool needs_glass = false;
    std::erase_if(wanted, [&](const auto& entry) {
      const PartLook look = read_look(entry.second);
      const bool is_glass = look.stuff == "glass" && look.substance;
      // What is made from words is made of the glass that they name.
      if (is_glass && asset.ref.procedural) return true;
      const bool is_new_glass = is_glass && !has_substance(asset, look);
      needs_glass = needs_glass || is_new_glass;
      return look.empty() || is_known_to_look(asset, look);
    });
    if (wanted.empty()) return;
    const bool can_be_given = !needs_glass && !is_of_glass(asset);
    if (can_be_given && match.contradicts == Contradiction::looks) match.contradicts = Contradiction::none;
    if (!can_be_given && match.contradicts == Contradiction::none) match.contradicts = Contradiction::looks;
    wear(asset, std::move(wanted));
  }

  static void wear(AssetInfo& asset, std::map<std::string, std::string> looks) {
    for (const auto& [stuff, text] : looks)
      if (const auto tone = read_look(text).tone()) asset.colors = {color_name((*tone)[0], (*tone)[1], (*tone)[2])};
    asset.ref.finish = std::move(looks);
  }

  std::shared_ptr<const AssetLibrary> library_;
  mutable std::mutex mutex_;
  mutable PaintBox paints_;
  mutable std::map<std::string, std::shared_ptr<const Model>> models_;
};

}  // namespace

std::unique_ptr<AssetLibrary> make_finishing_library(std::shared_ptr<const AssetLibrary> library) {
  return std::make_unique<FinishingLibrary>(std::move(library));
}

}  // namespace roomgen::create
