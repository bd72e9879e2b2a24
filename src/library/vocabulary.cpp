#include "roomgen/library/vocabulary.h"

#include <algorithm>
#include <array>

#include "roomgen/base/json.h"
#include "roomgen/base/resource.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr int max_ancestors = 8;
constexpr std::size_t max_phrase_words = 24;
constexpr double other_child_fit = 0.75;  // a deck chair for who asks for a chair

std::vector<std::string> singular_words(std::string_view text) {
  auto pieces = words(text);
  if (pieces.size() > max_phrase_words) pieces.resize(max_phrase_words);
  for (auto& piece : pieces) piece = singular(piece);
  return pieces;
}

std::string ending(const std::vector<std::string>& pieces, std::size_t first) {
  return join({pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end()}, " ");
}

// Words formed like adjectives say how a thing is even if no list has them: padded, rustic.
bool looks_like_adjective(std::string_view word) {
  static constexpr std::array<std::string_view, 11> endings = {
      "ed", "ish", "ful", "less", "ous", "ive", "ic", "al", "ern", "ian", "able"};
  return word.size() > 4 && word != "table" &&
         std::any_of(endings.begin(), endings.end(),
                     [&](std::string_view e) { return word.ends_with(e); });
}

bool is_number(std::string_view word) {
  return !word.empty() && std::isdigit(static_cast<unsigned char>(word.front()));
}

// "lamp with a shade", "table for six": what follows says how, not what.
std::string_view before_preposition(std::string_view phrase) {
  static constexpr std::array<std::string_view, 12> stops = {
      " with ",    " for ",  " in ", " on ", " from ", " made ",
      " without ", " that ", ",",    "(",    ";",      " by "};
  std::size_t cut = phrase.size();
  for (const auto stop : stops) cut = std::min(cut, phrase.find(stop));
  return phrase.substr(0, cut);
}

// "round table": a table, of which something is said.
bool only_describes(std::string_view name) {
  return name.starts_with("round ") || name.starts_with("oval ") || name.starts_with("small ");
}

std::vector<std::string> read_texts(const JsonReader& json) {
  std::vector<std::string> texts;
  for (const auto& element : json.elements_or_none(2000)) texts.push_back(element.text());
  return texts;
}

Mount read_mount(const JsonReader& json) {
  const auto mount = parse_mount(json.text());
  if (!mount) json.report("is none of floor, wall, ceiling, surface");
  return mount.value_or(Mount::floor);
}

StockKind read_kind(const std::string& name, const JsonReader& json) {
  json.allow_only({"is", "names", "usual", "substitutes", "mount", "also", "supports"});
  StockKind kind;
  kind.name = name;
  kind.parent = json["is"].text_or("");
  kind.names = read_texts(json["names"]);
  kind.usual = json["usual"].boolean_or(false);
  kind.supports = json["supports"].boolean_or(false);
  if (json["substitutes"].exists())
    for (const auto& [other, fit] : json["substitutes"].members())
      kind.substitutes[other] = fit.number(0.01, 0.99);
  if (json["mount"].exists()) kind.mount = read_mount(json["mount"]);
  for (const auto& element : json["also"].elements_or_none(4))
    kind.also.push_back(read_mount(element));
  return kind;
}

// What an entry does not say, its nearest ancestor says.
void inherit(std::map<std::string, StockKind, std::less<>>& kinds, StockKind& kind) {
  auto ancestor = kinds.find(kind.parent);
  for (int i = 0; ancestor != kinds.end() && i < max_ancestors; ++i) {
    if (!kind.mount) {
      kind.mount = ancestor->second.mount;
      if (kind.also.empty()) kind.also = ancestor->second.also;
    }
    kind.supports = kind.supports || ancestor->second.supports;
    ancestor = kinds.find(ancestor->second.parent);
  }
}

}  // namespace

Result<Vocabulary> Vocabulary::parse(std::string_view text, const std::string& source) {
  auto json = parse_json(text, source);
  if (!json) return json.error();
  JsonReader::Problems problems(source);
  const JsonReader root(*json, problems);
  root.allow_only({"about", "kinds", "families", "modifiers", "fillers"});
  Vocabulary vocabulary;
  for (const auto& [name, entry] : root["kinds"].members())
    vocabulary.kinds_[name] = read_kind(name, entry);
  for (const auto& [name, entry] : root["kinds"].members()) {
    StockKind& kind = vocabulary.kinds_[name];
    if (!kind.parent.empty() && !vocabulary.kinds_.count(kind.parent))
      entry["is"].report("\"" + kind.parent + "\" is no kind");
    for (const auto& [other, fit] : kind.substitutes)
      if (!vocabulary.kinds_.count(other)) entry.report("substitute \"" + other + "\" is no kind");
    inherit(vocabulary.kinds_, kind);
  }
  for (const auto& family : root["families"].elements_or_none(500)) {
    auto members = read_texts(family);
    for (const auto& word : members)
      vocabulary.family_of_.try_emplace(word, vocabulary.families_.size());
    vocabulary.families_.push_back(std::move(members));
  }
  for (auto& word : read_texts(root["modifiers"])) vocabulary.modifiers_[word] = true;
  for (auto& word : read_texts(root["fillers"])) vocabulary.fillers_[word] = true;
  if (problems.first()) return *problems.first();

  const auto key = [](const std::string& name) { return join(singular_words(name), " "); };
  for (const auto& [name, kind] : vocabulary.kinds_) vocabulary.names_[key(name)] = name;
  for (const auto& [name, kind] : vocabulary.kinds_)
    for (const auto& other : kind.names) vocabulary.names_.try_emplace(key(other), name);
  return vocabulary;
}

void Vocabulary::add(const KindTable& categories) {
  const auto key = [](const std::string& name) { return join(singular_words(name), " "); };
  std::vector<const Kind*> added;
  for (const auto& [name, category] : categories.all()) {
    if (only_describes(name) || names_.count(key(name))) continue;
    StockKind& kind = kinds_[name];
    kind.name = name;
    kind.mount = category.mount;
    names_[key(name)] = name;
    added.push_back(&category);
  }
  for (const Kind* category : added) {
    StockKind& kind = kinds_[category->name];
    if (const StockKind* parent = find(category->parent)) kind.parent = parent->name;
    inherit(kinds_, kind);
  }
  for (const auto& [name, category] : categories.all())
    if (const auto phrase = understand(name); phrase.known)
      for (const auto& other : category.synonyms) names_.try_emplace(key(other), phrase.kind);
}

const Vocabulary& Vocabulary::built_in() {
  static const Vocabulary vocabulary = [] {
    auto parsed = parse(resource("data/vocabulary.json").value_or("{}"), "data/vocabulary.json");
    // A test parses the file; a build whose data is broken has an empty vocabulary.
    if (!parsed) return Vocabulary{};
    parsed->add(KindTable::built_in());
    return *std::move(parsed);
  }();
  return vocabulary;
}

const StockKind* Vocabulary::by_name(std::string_view name) const {
  const auto found = kinds_.find(name);
  return found == kinds_.end() ? nullptr : &found->second;
}

const StockKind* Vocabulary::find(std::string_view name) const {
  const auto found = names_.find(join(singular_words(name), " "));
  return found == names_.end() ? nullptr : by_name(found->second);
}

KindPhrase Vocabulary::understand(std::string_view phrase) const {
  if (const StockKind* whole = find(phrase))
    return {whole->name, join(singular_words(phrase), " "), true};
  std::vector<std::string> pieces;
  for (auto& piece : singular_words(before_preposition(phrase)))
    if (!is_filler(piece)) pieces.push_back(std::move(piece));

  // English puts the kind last: try the longest ending first.
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    const auto found = names_.find(ending(pieces, first));
    if (found == names_.end()) continue;
    const bool only_modifiers =
        std::all_of(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(first),
                    [&](const std::string& word) { return is_modifier(word); });
    if (only_modifiers) return {found->second, found->first, true};
    break;
  }
  std::vector<std::string> rest;
  for (const auto& piece : pieces)
    if (&piece == &pieces.back() || !family_of_.count(piece)) rest.push_back(piece);
  return {join(rest, " "), join(rest, " "), false};
}

KindPhrase Vocabulary::understand_name(std::string_view name) const {
  KindPhrase phrase = understand(name);
  if (phrase.known) return phrase;
  const auto pieces = singular_words(before_preposition(name));
  for (std::size_t first = 0; first < pieces.size(); ++first)
    if (const auto found = names_.find(ending(pieces, first)); found != names_.end())
      return {found->second, found->first, true};
  return phrase;
}

std::vector<std::string> Vocabulary::mentioned(std::string_view text) const {
  constexpr std::size_t longest_name = 4;
  const auto pieces = singular_words(text);
  std::vector<std::string> result;
  for (std::size_t first = 0; first < pieces.size();) {
    std::size_t taken = std::min(longest_name, pieces.size() - first);
    for (; taken > 0; --taken) {
      const auto begin = pieces.begin() + static_cast<std::ptrdiff_t>(first);
      const auto found =
          names_.find(join({begin, begin + static_cast<std::ptrdiff_t>(taken)}, " "));
      if (found == names_.end()) continue;
      result.push_back(found->second);
      break;
    }
    first += std::max<std::size_t>(taken, 1);
  }
  return result;
}

bool Vocabulary::is_a(std::string_view name, std::string_view ancestor) const {
  const StockKind* kind = by_name(name);
  for (int i = 0; kind && i < max_ancestors; ++i) {
    if (kind->name == ancestor) return true;
    kind = by_name(kind->parent);
  }
  return name == ancestor;
}

double Vocabulary::fit(std::string_view have, std::string_view want) const {
  if (have == want) return have.empty() ? 0.0 : 1.0;
  const StockKind* wanted = by_name(want);
  const StockKind* owned = by_name(have);
  if (!wanted || !owned) return 0.0;  // what the vocabulary lacks fits itself only
  if (is_a(have, want)) return owned->usual ? 1.0 : other_child_fit;
  double best = 0.0;
  for (const auto& [other, fit] : wanted->substitutes)
    if (is_a(have, other)) best = std::max(best, fit);
  return best;
}

std::vector<std::string> Vocabulary::family(std::string_view word) const {
  std::vector<std::string> result{std::string(word)};
  const auto found = family_of_.find(word);
  if (found == family_of_.end()) return result;
  for (const auto& other : families_[found->second])
    if (other != word) result.push_back(other);
  return result;
}

std::string Vocabulary::family_name(std::string_view word) const {
  const auto found = family_of_.find(word);
  return found == family_of_.end() ? std::string() : families_[found->second].front();
}

bool Vocabulary::is_modifier(std::string_view word) const {
  return modifiers_.count(word) || family_of_.count(word) || is_filler(word) || is_number(word) ||
         looks_like_adjective(word);
}

bool Vocabulary::is_filler(std::string_view word) const {
  return fillers_.count(word) > 0;
}

}  // namespace roomgen
