#include "attributes.h"

#include <algorithm>

#include "library/attribute_words.h"
#include "library/vocabulary.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double shown_share = 0.3;     // of a colour that a thing has in a viewer's eyes
constexpr double material_share = 0.2;  // of a colour that fits the material
constexpr double counted_share = 0.08;  // of each colour of something colourful
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

class Judge {
 public:
  explicit Judge(const KnownLooks& looks) : looks_(looks), table_(AttributeWords::built_in()) {}

  AttributeVerdict phrase(const std::string& text) const {
    const AttributeMeaning* meaning = table_.find(text);
    if (!meaning) return unlisted(text);
    if (const auto* kind = first_of(meaning->kinds)) return yes("as any " + *kind);
    for (const auto& word : meaning->said)
      if (has_word(looks_.identity.words, word)) return yes("its label says " + word);
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

  // Only the label can tell; another word of the same family is as good.
  AttributeVerdict unlisted(const std::string& text) const {
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

  bool shows(const AttributeMeaning& meaning, double share) const {
    for (std::size_t i = 0; i < looks_.colors.size(); ++i) {
      const ShownColor& color = looks_.colors[i];
      const bool enough = color.share >= share || i == 0;
      const bool named = std::find(meaning.colors.begin(), meaning.colors.end(), color.name) !=
                         meaning.colors.end();
      const bool light = !meaning.lightness || meaning.lightness->contains(lightness(color.mean));
      if (enough && named && light) return true;
    }
    return false;
  }

  AttributeVerdict material(const std::string& text, const AttributeMeaning& meaning) const {
    const auto names_it = [&](const std::set<std::string>& said) {
      return std::any_of(meaning.materials.begin(), meaning.materials.end(),
                         [&](const std::string& name) { return has_word(said, name); });
    };
    if (names_it(looks_.identity.words)) return yes("its label says so");
    const bool agrees = shows(meaning, material_share);
    if (agrees && names_it(looks_.surfaces)) return yes("a surface is called so, and of its colour");
    if (agrees && first_of(meaning.kinds_of_its_color)) return yes("of its colour, as such things are");
    if (!meaning.family.empty() && agrees)
      if (const AttributeMeaning* family = table_.find(meaning.family);
          family && material(meaning.family, *family).held)
        return yes("of " + meaning.family + " and of its colour");
    if (!names_it(looks_.told)) return no("nothing says " + text);
    return agrees || is_painted() ? yes("made so, and of its colour")
                                  : no("made so, but " + shown_text(looks_));
  }

  // A colour that the maker was told beside the material, and that shows.
  bool is_painted() const {
    return std::any_of(looks_.told.begin(), looks_.told.end(), [&](const std::string& word) {
      const AttributeMeaning* meaning = table_.find(word);
      return meaning && meaning->materials.empty() && !meaning->colors.empty() &&
             shows(*meaning, shown_share);
    });
  }

  AttributeVerdict measured(const AttributeMeaning& meaning) const {
    if (meaning.mount && looks_.mount != *meaning.mount) return no("it is put up otherwise");
    if (meaning.roughness && !meaning.roughness->contains(looks_.roughness))
      return no("its surface is of roughness " + format_number(looks_.roughness, 2));
    if (!meaning.outlines.empty() &&
        std::find(meaning.outlines.begin(), meaning.outlines.end(), name(looks_.outline)) ==
            meaning.outlines.end())
      return no("its outline is " + std::string(name(looks_.outline)));
    if (!meaning.sizes.empty() &&
        std::none_of(meaning.sizes.begin(), meaning.sizes.end(),
                     [&](const auto& ranges) { return is_sized(ranges); }))
      return no("it measures " + size_text(looks_.size) + " m");
    if (meaning.least_colors) {
      const auto there = std::count_if(looks_.colors.begin(), looks_.colors.end(),
                                       [](const auto& color) { return color.share >= counted_share; });
      if (there < *meaning.least_colors) return no(std::to_string(there) + " colours");
    }
    if (!meaning.colors.empty()) {
      if (looks_.colors.empty()) return unknown("its colour is not known");
      if (!shows(meaning, shown_share)) return no(shown_text(looks_));
    }
    return yes("as measured");
  }

  bool is_sized(const std::map<SizeMeasure, Range>& ranges) const {
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
    }
    return 0.0;
  }

  const KnownLooks& looks_;
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

}  // namespace

AttributeVerdict judge_attribute(const KnownLooks& looks, std::string_view attribute) {
  const Judge judge(looks);
  const auto phrases = telling_phrases(attribute);
  if (phrases.empty()) return unknown("\"" + std::string(attribute) + "\" says nothing");
  AttributeVerdict result;
  for (const auto& phrase : phrases) {
    result = judge.phrase(phrase);
    if (!result.held) return result;
  }
  return result;
}

}  // namespace roomgen
