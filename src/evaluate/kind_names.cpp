#include "roomgen/evaluate/kind_names.h"

#include <algorithm>

#include "roomgen/base/json.h"
#include "roomgen/base/resource.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/library/vocabulary.h"

namespace roomgen {

namespace {

constexpr int name_rank = 5, synonym_rank = 4;

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

// "jar of flowers": a jar that was made for these words.
bool was_chosen_for(const Identity& identity, const std::vector<std::string>& pieces) {
  const std::string head = words(identity.kind).back();
  if (pieces.size() < 2 || std::find(pieces.begin(), pieces.end(), head) == pieces.end())
    return false;
  return std::all_of(pieces.begin(), pieces.end(), [&](const std::string& word) {
    return word == "of" || word == head || identity.asked.count(word) > 0;
  });
}

Json parsed(std::string_view path) {
  auto json = parse_json(resource(path).value_or("{}"), std::string(path));
  return json ? *std::move(json) : Json::object();
}

}  // namespace

const KindNames& KindNames::built_in() {
  static const KindNames names;
  return names;
}

KindNames::KindNames() {
  for (const auto path : resources("data/shapes/kinds/")) {
    const Json file = parsed(path);
    if (!file.contains("kinds")) continue;
    for (const auto& [name, kind] : file["kinds"].items()) {
      shape_kinds_of_[key(name)].insert(key(name));
      if (!kind.is_object() || !kind.contains("names")) continue;
      for (const auto& other : kind["names"])
        if (other.is_string()) shape_kinds_of_[key(other.get<std::string>())].insert(key(name));
    }
  }
  for (const auto& [name, category] : KindTable::built_in().all()) {
    categories_of_[key(name)] = name;
    for (const auto& other : category.synonyms) categories_of_.try_emplace(key(other), name);
  }
  const Json labels = parsed("data/furniture-labels.json");
  if (labels.contains("labels"))
    for (const auto& [library, assets] : labels["labels"].items())
      for (const auto& [id, label] : assets.items())
        if (label.is_string()) labels_[library + "/" + id] = label.get<std::string>();
}

Identity KindNames::identify(const Object& object) const {
  Identity identity;
  const AssetRef& asset = object.asset;
  if (asset.is_box()) {
    identity.kind = key(object.category);
    identity.basis = "category of a plain box";
  } else if (asset.procedural) {
    const std::string kind = text_parameter(*asset.procedural, "kind");
    identity.kind = key(kind.empty() ? asset.procedural->recipe : kind);
    identity.basis = "recipe kind " + identity.kind;
  } else if (const auto label = labels_.find(asset.library + "/" + asset.id);
             label != labels_.end()) {
    const auto parts = split(label->second, '|');
    identity.kind = key(parts.front());
    if (parts.size() > 1)
      for (auto& word : words(parts[1])) identity.words.insert(singular(word));
    identity.basis = "label of " + asset.library + "/" + asset.id;
  } else {
    std::string name = asset.id;
    std::replace(name.begin(), name.end(), '_', ' ');
    identity.kind = key(Vocabulary::built_in().understand_name(name).kind);
    identity.basis = "name of " + asset.library + "/" + asset.id;
  }
  for (auto& word : words(identity.kind)) identity.words.insert(std::move(word));
  for (const auto& word : words(object.description)) identity.asked.insert(singular(word));
  return identity;
}

bool KindNames::same(const std::string& kind, const std::string& category) const {
  const auto& vocabulary = Vocabulary::built_in();
  const StockKind* have = vocabulary.find(kind);
  const StockKind* want = vocabulary.find(category);
  if (have && have == want) return true;
  const auto shapes = shape_kinds_of_.find(category);
  if (shapes != shape_kinds_of_.end() && shapes->second.count(kind)) return true;
  const auto mine = categories_of_.find(kind), theirs = categories_of_.find(category);
  return mine != categories_of_.end() && theirs != categories_of_.end() &&
         mine->second == theirs->second;
}

bool KindNames::descends(const std::string& kind, const std::string& category) const {
  const auto& vocabulary = Vocabulary::built_in();
  const StockKind* have = vocabulary.find(kind);
  const StockKind* want = vocabulary.find(category);
  if (have && want && vocabulary.is_a(have->name, want->name)) return true;
  const auto mine = categories_of_.find(kind), theirs = categories_of_.find(category);
  return mine != categories_of_.end() && theirs != categories_of_.end() &&
         KindTable::built_in().is_a(mine->second, theirs->second);
}

bool KindNames::is_known(const std::string& category) const {
  return Vocabulary::built_in().find(category) || shape_kinds_of_.count(category) ||
         categories_of_.count(category);
}

int KindNames::rank(const Identity& identity, std::string_view name) const {
  const std::string category = key(name);
  const std::string& kind = identity.kind;
  if (kind.empty() || category.empty()) return 0;
  if (kind == category) return name_rank;
  if (same(kind, category)) return synonym_rank;
  if (descends(kind, category)) return 3;
  // "wooden desk": the words before the kind may only say how it is, or stand in the label.
  const auto pieces = words(category);
  const auto& vocabulary = Vocabulary::built_in();
  // A table lamp is no floor lamp by being a lamp, but a mere lamp may be one.
  const bool compound = is_known(category);
  for (std::size_t first = 1; first < pieces.size(); ++first) {
    const bool only_manner =
        std::all_of(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(first),
                    [&](const std::string& word) {
                      return vocabulary.is_modifier(word) || identity.words.count(word) ||
                             identity.asked.count(word);
                    });
    if (!only_manner) break;
    const std::string head =
        join({pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end()}, " ");
    if (kind == head || (!compound && (same(kind, head) || descends(kind, head)))) return 2;
  }
  if (was_chosen_for(identity, pieces)) return 2;
  return ends_with_kind(kind, category) ? 1 : 0;
}

std::map<std::string, std::vector<std::size_t>> KindNames::match(
    const std::vector<Object>& objects, const std::vector<std::string>& categories) const {
  std::map<std::string, std::vector<std::size_t>> matched;
  for (const auto& category : categories) matched[category];
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Identity identity = identify(objects[i]);
    const std::string placed_as = key(objects[i].category);
    const auto was_asked_as = [&](const std::string& category) {
      const auto pieces = words(key(category));
      return std::all_of(pieces.begin(), pieces.end(), [&](const std::string& word) {
        return identity.asked.count(word) > 0;
      });
    };
    int best = 0;
    const std::string* chosen = nullptr;
    for (const auto& category : categories) {
      int value = rank(identity, category);
      if (value == 0) continue;
      const bool asked = was_asked_as(category);
      if (asked && value == synonym_rank) value = name_rank;
      const int wanted = 4 * value + (asked ? 2 : 0) + (key(category) == placed_as ? 1 : 0);
      if (wanted <= best) continue;
      best = wanted;
      chosen = &category;
    }
    if (chosen) matched[*chosen].push_back(i);
  }
  return matched;
}

}  // namespace roomgen
