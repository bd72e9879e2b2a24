#include "attributes.h"

#include <algorithm>

#include "library/attribute_words.h"
#include "library/style_words.h"
#include "library/vocabulary.h"
#include "roomgen/base/text.h"
#include "shape/motifs.h"
#include "stated_size.h"

namespace roomgen {

namespace {

constexpr double shown_share = 0.3;     // of a colour that a thing has in a viewer's eyes
constexpr double material_share = 0.2;  // of a colour that fits the material
constexpr double part_share = 0.04;     // of the colour of one part
constexpr double counted_share = 0.08;  // of each colour of something colourful
constexpr int most_counted = 1000;
constexpr int least_rank = 3;           // of identity_rank(): it or a kind of it

AttributeVerdict yes(std::string reason) { return {true, true, std::move(reason)}; }
AttributeVerdict no(std::string reason) { return {false, true, std::move(reason)}; }
AttributeVerdict unknown(std::string reason) { return {false, false, std::move(reason)}; }

bool has_word(const std::set<std::string>& said, const std::string& word) {
  return said.count(word) > 0 || said.count(singular(word)) > 0;
}

std::string shown_text(const KnownLooks& looks) {
  std::vector<std::string> names;
  for (const auto& color : looks.colors)
    if (color.share >= material_share) names.push_back(color.name);
  return names.empty() ? "no colour is known" : "it is " + join(names, " and ");
}

bool has_part(const KnownLooks& looks, const std::string& name) {
  return looks.making.parts.count(name) + looks.making.parts.count(singular(name)) > 0;
}

class Judge {
 public:
  /// `of_part`: what is judged is said of one of its parts.
  explicit Judge(const KnownLooks& looks, bool of_part = false)
      : looks_(looks), of_part_(of_part), table_(AttributeWords::built_in()) {}

  AttributeVerdict phrase(const std::string& text) const {
    const AttributeMeaning* meaning = table_.find(text);
    if (!meaning) {
      const StyleMeaning* style = StyleWords::built_in().find(text);
      return style ? of_style(*style) : unlisted(text);
    }
    if (const auto* kind = first_of(meaning->kinds)) return yes("as any " + *kind);
    for (const auto& word : meaning->said)
      if (has_word(looks_.identity.words, word)) return yes("its label says " + word);
    if (meaning->of_making()) {
      AttributeVerdict made = making(text, *meaning);
      if (made.held || !meaning->measured()) return made;
    }
    if (!meaning->drawings.empty()) return drawing(text, *meaning);
    if (!meaning->materials.empty()) return material(text, *meaning);
    if (meaning->measured()) return measured(*meaning);
    return unlisted(text);
  }

 private:
  // The first of the kinds that the thing is; null if it is none.
  const std::string* first_of(const std::vector<std::string>& kinds) const {
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const std::string& kind) {
      return identity_rank(looks_.identity, kind) >= least_rank;
    });
    return found == kinds.end() ? nullptr : &*found;
  }

  // Its parts and how they are built; of a mesh from a file who saw it tells the parts.
  AttributeVerdict making(const std::string& text, const AttributeMeaning& meaning) const {
    if (is_made_so(looks_.making, meaning)) return yes("it is made so");
    const AttributeVerdict told = unlisted(text);
    return told.judged || !looks_.making.known() ? told : no("it is not made so");
  }

  // Only its kind, a choice of its recipe or the label can tell; another word of the same family is as good.
  AttributeVerdict unlisted(const std::string& text) const {
    const auto& ways = looks_.making.ways;
    if (std::any_of(ways.begin(), ways.end(), [&](const auto& way) { return way.second == text; }))
      return yes("it is made so");
    if (is_special_sort(looks_.identity, text)) return yes("as such things are");
    const auto pieces = words(text);
    const auto& vocabulary = Vocabulary::built_in();
    const bool said = std::all_of(pieces.begin(), pieces.end(), [&](const std::string& word) {
      const auto family = vocabulary.family(word);
      return has_word(looks_.identity.words, word) ||
             std::any_of(family.begin(), family.end(), [&](const std::string& other) {
               return has_word(looks_.identity.words, other);
             });
    });
    return said ? yes("its label says so") : unknown("\"" + text + "\" cannot be judged");
  }

  // A thing is of a style when it is of a sort of material that the style has; or in its colours, and of one of its
  // materials or shining as its things do.
  AttributeVerdict of_style(const StyleMeaning& style) const {
    if (has_word(looks_.identity.words, style.name)) return yes("its label says so");
    if (looks_.colors.empty()) return unknown("its colour is not known");
    const auto made_of = [&](bool special) -> const std::string* {
      const auto found = std::find_if(style.materials.begin(), style.materials.end(), [&](const std::string& material) {
        const AttributeMeaning* meaning = table_.find(material);
        if (!meaning || meaning->family.empty() == special) return false;
        return special ? is_called(*meaning) && shows(*meaning, material_share) : phrase(material).held;
      });
      return found == style.materials.end() ? nullptr : &*found;
    };
    if (const auto* material = made_of(true)) return yes("of " + *material);
    const auto is_of_it = [&](const std::string& name) {
      return std::find(style.colors.begin(), style.colors.end(), name) != style.colors.end();
    };
    for (const auto& color : looks_.colors)
      if (color.share >= shown_share && !is_of_it(color.name))
        return no(color.name + " is no colour of that style, nor of one of its materials");
    if (const auto* material = made_of(false)) return yes("of " + *material + " in a colour of that style");
    const AttributeMeaning* sheen = table_.find(style.sheen);
    if (sheen && sheen->roughness && sheen->roughness->contains(looks_.roughness))
      return yes(style.sheen + ", in a colour of that style");
    return no("of no material of that style");
  }

  bool shows(const AttributeMeaning& meaning, double share) const {
    for (std::size_t i = 0; i < looks_.colors.size(); ++i) {
      const ShownColor& color = looks_.colors[i];
      const bool enough = color.share >= (of_part_ ? part_share : share) || i == 0;
      const bool named = std::find(meaning.colors.begin(), meaning.colors.end(), color.name) !=
                         meaning.colors.end();
      const bool light = !meaning.lightness || meaning.lightness->contains(lightness(color.mean));
      if (enough && named && light) return true;
    }
    return false;
  }

  AttributeVerdict material(const std::string& text, const AttributeMeaning& meaning) const {
    const bool is_clear =
        std::any_of(meaning.materials.begin(), meaning.materials.end(),
                    [&](const std::string& name) { return has_word(looks_.clear, name); });
    if (is_clear) return yes("one sees through it");
    const bool agrees = looks_.colors.empty() || shows(meaning, material_share);
    const auto& materials = meaning.materials;
    const bool is_named = std::any_of(materials.begin(), materials.end(), [&](const std::string& name) {
      return is_surface(name, meaning.roughness);
    });
    if (is_of_member(meaning)) return yes("of a sort of " + text);
    if (!agrees && is_named && is_painted()) return yes("a surface is called so, in the colour that it is called");
    if (!agrees) return no(shown_text(looks_));
    if (std::any_of(materials.begin(), materials.end(),
                    [&](const std::string& name) { return has_word(looks_.identity.words, name); }))
      return yes("its label says so, and it is of its colour");
    if (is_named) return yes("a surface is called so, and of its colour");
    if (!looks_.colors.empty() && first_of(meaning.kinds_of_its_color))
      return yes("of its colour, as such things are");
    if (!meaning.family.empty())
      if (const AttributeMeaning* family = table_.find(meaning.family);
          family && material(meaning.family, *family).held)
        return yes("of " + meaning.family + " and of its colour");
    return no("nothing says " + text);
  }

  // Its label or a surface names the material.
  bool is_called(const AttributeMeaning& meaning) const {
    return std::any_of(meaning.materials.begin(), meaning.materials.end(), [&](const std::string& name) {
      return is_surface(name, meaning.roughness) || has_word(looks_.identity.words, name);
    });
  }

  // A surface is called by a sort of the material, and shows its colour: gold is metal, though yellow.
  bool is_of_member(const AttributeMeaning& material) const {
    return std::any_of(looks_.surfaces.begin(), looks_.surfaces.end(), [&](const auto& surface) {
      const AttributeMeaning* member = table_.find(surface.first);
      const AttributeMeaning* family = member && !member->family.empty() ? table_.find(member->family) : nullptr;
      return family && family->materials == material.materials && shows(*member, material_share);
    });
  }

  // A colour by which a surface is called, and that shows.
  bool is_painted() const {
    return std::any_of(looks_.surfaces.begin(), looks_.surfaces.end(), [&](const auto& surface) {
      const AttributeMeaning* meaning = table_.find(surface.first);
      return meaning && meaning->materials.empty() && !meaning->colors.empty() && shows(*meaning, shown_share);
    });
  }

  // A name alone is not enough where the stuff is rough or smooth by nature.
  bool is_surface(const std::string& name, const std::optional<Interval>& roughness) const {
    auto found = looks_.surfaces.find(name);
    if (found == looks_.surfaces.end()) found = looks_.surfaces.find(singular(name));
    return found != looks_.surfaces.end() && (!roughness || roughness->contains(found->second));
  }

  // A pattern: painted on a surface that is called so.
  AttributeVerdict drawing(const std::string& text, const AttributeMeaning& meaning) const {
    for (const auto& name : meaning.drawings) {
      if (has_word(looks_.identity.words, name)) return yes("its label says " + name);
      if (has_word(looks_.drawings, name)) return yes("its " + name + " surface shows");
      if (has_part(looks_, name)) return yes("it has a " + name);
    }
    return no("no surface is " + text);
  }

  AttributeVerdict measured(const AttributeMeaning& meaning) const {
    if (!meaning.mounts.empty() &&
        std::find(meaning.mounts.begin(), meaning.mounts.end(), looks_.mount) == meaning.mounts.end())
      return no("it is put up otherwise");
    if (meaning.roughness && !meaning.roughness->contains(looks_.roughness))
      return no("its surface is of roughness " + format_number(looks_.roughness, 2));
    if (!meaning.outlines.empty() &&
        std::find(meaning.outlines.begin(), meaning.outlines.end(), name(looks_.outline)) ==
            meaning.outlines.end())
      return no("its outline is " + std::string(name(looks_.outline)));
    if (!meaning.sizes.empty() &&
        std::none_of(meaning.sizes.begin(), meaning.sizes.end(),
                     [&](const auto& ranges) { return is_sized(ranges); }))
      return looks_.is_kind_known ? no("it measures " + size_text(looks_.size) + " m")
                                  : unknown("nobody knows how large such things are");
    const auto colors = std::count_if(looks_.colors.begin(), looks_.colors.end(),
                                      [](const auto& color) { return color.share >= counted_share; });
    if (colors < meaning.least_colors.value_or(0) || colors > meaning.most_colors.value_or(most_counted))
      return no(std::to_string(colors) + " colours");
    if (!meaning.colors.empty()) {
      if (looks_.colors.empty()) return unknown("its colour is not known");
      if (!shows(meaning, shown_share)) return no(shown_text(looks_));
    }
    return yes("as measured");
  }

  bool is_sized(const std::map<SizeMeasure, Interval>& ranges) const {
    return std::all_of(ranges.begin(), ranges.end(), [&](const auto& entry) {
      return entry.second.contains(value_of(entry.first));
    });
  }

  double value_of(SizeMeasure measure) const {
    const Vec3& have = looks_.size;
    const Vec3 share = have.cwiseQuotient(looks_.usual.cwiseMax(1e-6));
    const double longer = std::max(have.x(), have.y()), shorter = std::min(have.x(), have.y());
    switch (measure) {
      case SizeMeasure::width: return have.x();
      case SizeMeasure::depth: return have.y();
      case SizeMeasure::height: return have.z();
      case SizeMeasure::longest: return have.maxCoeff();
      case SizeMeasure::usual_width: return share.x();
      case SizeMeasure::usual_depth: return share.y();
      case SizeMeasure::usual_height: return share.z();
      case SizeMeasure::usual_volume: return share.prod();
      case SizeMeasure::slimness: return have.z() / std::max(1e-6, longer);
      case SizeMeasure::elongation: return longer / std::max(1e-6, shorter);
      case SizeMeasure::steadiness: return looks_.steadiness;
    }
    return 0.0;
  }

  const KnownLooks& looks_;
  bool of_part_;
  const AttributeWords& table_;
};

std::vector<std::string> telling_phrases(std::string_view attribute) {
  const auto& table = AttributeWords::built_in();
  auto phrases = table.phrases(words(attribute));
  std::erase_if(phrases, [&](const std::string& phrase) {
    return table.says_nothing(phrase) || Vocabulary::built_in().is_filler(phrase);
  });
  return phrases;
}

// "reads OPEN LATE": held against what is written on it.
std::optional<AttributeVerdict> letters_verdict(const KnownLooks& looks,
                                                std::string_view attribute) {
  auto asked = words(attribute);
  const auto verb = std::find_if(asked.begin(), asked.end(), shape::says_letters);
  if (verb == asked.end()) return std::nullopt;
  asked.erase(asked.begin(), verb + 1);
  const auto known = looks.making.ways.find("letters");
  if (asked.empty() || known == looks.making.ways.end()) return std::nullopt;
  const auto there = words(known->second);
  const bool is_there = std::all_of(asked.begin(), asked.end(), [&](const std::string& word) {
    return std::find(there.begin(), there.end(), word) != there.end();
  });
  const std::string said = "it says \"" + std::string(trim(known->second)) + "\"";
  return is_there ? yes(said) : no(there.empty() ? "nothing is written on it" : said);
}

}  // namespace

AttributeVerdict judge_attribute(const KnownLooks& looks, std::string_view attribute) {
  if (const auto stated = read_stated_size(attribute))
    return has_size(*stated, looks.size) ? yes("as measured") : no("it measures " + size_text(looks.size) + " m");
  if (const auto letters = letters_verdict(looks, attribute)) return *letters;
  auto phrases = telling_phrases(attribute);
  if (phrases.empty()) return unknown("\"" + std::string(attribute) + "\" says nothing");
  const bool of_part = phrases.size() > 1 && has_part(looks, phrases.back());  // "red curtain"
  if (of_part) phrases.pop_back();
  const Judge judge(looks, of_part);
  AttributeVerdict result;
  for (const auto& phrase : phrases) {
    result = judge.phrase(phrase);
    if (!result.held) return result;
  }
  return result;
}

}  // namespace roomgen
