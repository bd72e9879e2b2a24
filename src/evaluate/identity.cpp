#include "identity.h"

#include <algorithm>
#include <tuple>

#include "library/seen_assets.h"
#include "roomgen/base/text.h"
#include "scene/written_asset.h"

namespace roomgen {

namespace {

constexpr int name_rank = 5, synonym_rank = 4, descendant_rank = 3;
constexpr int most_ancestors = 8;

// "Coffee_Tables" is "coffee table".
std::string key(std::string_view name) {
  auto pieces = words(name);
  for (auto& piece : pieces) piece = singular(piece);
  return join(pieces, " ");
}

// What a compound with these is not, whatever it ends with: a toy car is no car.
bool makes_an_image(const std::string& word) {
  static const std::set<std::string> makers = {"toy",  "model", "play", "doll", "dollhouse",
                                               "plush", "dog",  "cat",  "pet",  "miniature"};
  return makers.count(word) > 0;
}

bool ends_with_words(const std::string& text, const std::string& ending) {
  return text.size() > ending.size() + 1 && text.ends_with(ending) &&
         text[text.size() - ending.size() - 1] == ' ';
}

// A "console table" is some table.
bool ends_with_kind(const std::string& kind, const std::string& category) {
  return ends_with_words(kind, category) && !makes_an_image(words(kind).front());
}

// "jar of flowers" is a jar.
bool is_kind_of_something(const Identity& identity, const std::vector<std::string>& pieces) {
  const auto of = std::find(pieces.begin(), pieces.end(), "of");
  return of != pieces.begin() && of != pieces.end() && *std::prev(of) == words(identity.kind).back();
}

// One kind for plans, or for libraries, or what is built for the name.
bool same_kind(const Kind& have, const Kind& want, const KindTable& kinds) {
  return have.stocked_as == want.stocked_as || want.built_as == have.name ||
         &kinds.planned(have) == &kinds.planned(want);
}

bool descends(const Kind& have, const Kind& want, const Vocabulary& vocabulary) {
  const KindTable& kinds = vocabulary.kinds();
  return vocabulary.is_a(have.stocked_as, want.stocked_as) ||
         is_of(kinds.planned(have), kinds.planned(want).name);
}

// Of two names; 0 unless both name kinds of one line. A guitar is no harp, however much one stands for it.
int kinship_rank(const std::string& kind, const std::string& category, const Vocabulary& vocabulary) {
  const Kind* have = vocabulary.kinds().named(kind);
  const Kind* want = vocabulary.kinds().named(category);
  if (!have || !want || vocabulary.kinds().only_resembles(category)) return 0;
  if (same_kind(*have, *want, vocabulary.kinds())) return synonym_rank;
  return descends(*have, *want, vocabulary) ? descendant_rank : 0;
}

bool is_in_label(const std::vector<std::string>& name, const Identity& identity) {
  return std::all_of(name.begin(), name.end(), [&](const std::string& word) { return identity.words.count(word) > 0; });
}

}  // namespace

Identity identify(const Object& object, const Vocabulary& vocabulary) {
  Identity identity;
  if (object.stand_in) {
    identity.basis = "a plain stand-in, which is no thing's model";
    return identity;
  }
  const AssetRef& asset = object.asset;
  if (asset.is_box()) {
    identity.kind = key(object.category);
    identity.basis = "category of a plain box";
  } else if (asset.procedural) {
    std::string kind = text_parameter(*asset.procedural, "kind");
    if (kind.empty()) kind = text_parameter(*asset.procedural, "name");  // of a program
    identity.kind = key(kind.empty() ? asset.procedural->recipe : kind);
    identity.basis = "recipe kind " + identity.kind;
    // Who drew it says what it was drawn as.
    if (is_written(asset))
      for (auto& word : words(object.description)) identity.words.insert(singular(std::move(word)));
  } else if (const auto* seen = seen_asset(asset)) {
    identity.kind = key(seen->kind);
    for (auto& word : seen->told()) identity.words.insert(singular(std::move(word)));
    identity.basis = "label of " + asset.library + "/" + asset.id;
  } else {
    std::string name = asset.id;
    std::replace(name.begin(), name.end(), '_', ' ');
    identity.kind = key(vocabulary.understand_name(name).kind);
    identity.basis = "name of " + asset.library + "/" + asset.id;
  }
  for (auto& word : words(identity.kind)) identity.words.insert(std::move(word));
  return identity;
}

int identity_rank(const Identity& identity, std::string_view name, const Vocabulary& vocabulary) {
  const std::string category = key(name);
  const std::string& kind = identity.kind;
  if (kind.empty() || category.empty()) return 0;
  if (kind == category) return name_rank;
  if (const int kin = kinship_rank(kind, category, vocabulary); kin > 0) return kin;
  const auto pieces = words(category);
  if (vocabulary.kinds().only_resembles(category) && is_in_label(pieces, identity)) return synonym_rank;
  // "wooden desk": the words before a kind may only say how it is, or stand in the label; those of a name
  // that nobody knows ("sushi plate") tell nothing.
  // A table lamp is no floor lamp by being a lamp, but a mere lamp may be one.
  const bool compound = vocabulary.kinds().named(category) != nullptr;
  for (std::size_t first = 1; first < pieces.size(); ++first) {
    const bool only_manner =
        std::all_of(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(first),
                    [&](const std::string& word) {
                      return !compound || vocabulary.is_modifier(word) || identity.words.count(word);
                    });
    if (!only_manner) break;
    const std::string head =
        join({pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end()}, " ");
    if (kind == head || (!compound && kinship_rank(kind, head, vocabulary) > 0)) return 2;
  }
  if (is_kind_of_something(identity, pieces)) return 2;
  return ends_with_kind(kind, category) ? 1 : 0;
}

bool is_special_sort(const Identity& identity, std::string_view sort, const Vocabulary& vocabulary) {
  const KindTable& table = vocabulary.kinds();
  const std::string first = key(sort) + " ";
  const auto says = [&](const Kind& kind, const std::string& name) {
    const std::string called = key(name);
    return called.starts_with(first) && table.named(called.substr(first.size())) != &kind;
  };
  const Kind* kind = table.named(identity.kind);
  for (int i = 0; kind && i < most_ancestors; ++i) {
    if (says(*kind, kind->name) || std::any_of(kind->names.begin(), kind->names.end(),
                                               [&](const std::string& name) { return says(*kind, name); }))
      return true;
    kind = kind->parent.empty() ? nullptr : table.by_name(kind->parent);
  }
  return false;
}

std::map<std::string, std::vector<std::size_t>> identified_as(
    const std::vector<Object>& objects, const std::vector<std::string>& categories,
    const Vocabulary& vocabulary) {
  std::map<std::string, std::vector<std::size_t>> matched;
  for (const auto& category : categories) matched[category];
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Identity identity = identify(objects[i], vocabulary);
    const std::string placed_as = key(objects[i].category);
    // Of names that fit equally well the one of which fewer are found.
    std::tuple<int, bool, long> best{0, false, 0};
    const std::string* chosen = nullptr;
    for (const auto& category : categories) {
      const int value = identity_rank(identity, category, vocabulary);
      const std::tuple<int, bool, long> fit{value, key(category) == placed_as,
                                            -static_cast<long>(matched[category].size())};
      if (value == 0 || fit <= best) continue;
      best = fit;
      chosen = &category;
    }
    if (chosen) matched[*chosen].push_back(i);
  }
  return matched;
}

}  // namespace roomgen
