#include "noun_kind.h"

#include <algorithm>
#include <vector>

#include "language/inflection.h"
#include "language/lexicon.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

using language::lexicon;
using language::PartOfSpeech;
using language::Sense;
using language::WordClass;
using Synsets = std::vector<std::uint32_t>;

constexpr int most_steps = 16;  // no way up in WordNet is longer

// Of a compound that the lexicon lacks the last words: "gas cylinder" is a cylinder.
std::string lemma_of(std::string_view noun) {
  const auto pieces = words(noun);
  for (std::size_t first = 0; first < pieces.size(); ++first) {
    const std::string ending = join({pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end()}, " ");
    for (const auto& form : language::singulars(ending))
      if (lexicon().has(form, PartOfSpeech::noun)) return form;
    if (lexicon().has(ending, PartOfSpeech::noun)) return ending;
  }
  return "";
}

bool is_thing(const Sense& sense) {
  for (const auto thing : {WordClass::artefact, WordClass::appliance, WordClass::furniture, WordClass::food, WordClass::plant})
    if (sense.is(thing)) return true;
  return false;
}

// "Orange" is rather a fruit, "mahogany" wood and "lilac" a colour.
bool is_living_plant(std::string_view lemma) {
  return lexicon().is(lemma, WordClass::plant) && !lexicon().may_be(lemma, WordClass::material) &&
         !lexicon().may_be(lemma, WordClass::color);
}

// Senses in which the noun may be a thing: the commonest first, but vehicles last, since a tank in a room is
// rather a vessel.
std::vector<Sense> thing_senses(std::string_view lemma) {
  auto senses = lexicon().common_senses(lemma, PartOfSpeech::noun);
  const bool may_grow = is_living_plant(lemma);
  std::erase_if(senses, [&](const Sense& sense) {
    return !is_thing(sense) || (sense.is(WordClass::plant) && !may_grow);
  });
  std::stable_partition(senses.begin(), senses.end(),
                        [](const Sense& sense) { return !sense.is(WordClass::vehicle); });
  return senses;
}

// A name that stands for several things names its kind where it is of the same classes as the kind's own
// name: "drawers" are a dresser, but no dresser is underwear.
bool is_sense_of(const Kind& kind, std::string_view name, std::uint32_t synset) {
  const auto senses = lexicon().common_senses(name, PartOfSpeech::noun);
  const auto sense = std::find_if(senses.begin(), senses.end(),
                                  [&](const Sense& one) { return one.synset == synset; });
  if (sense == senses.end()) return false;
  const auto own = thing_senses(lemma_of(kind.name));
  return std::any_of(own.begin(), own.end(),
                     [&](const Sense& one) { return one.classes == sense->classes; });
}

NounKind called_by(const KindTable& table, std::uint32_t synset, int steps) {
  NounKind found;
  for (const auto word : lexicon().members(synset)) {
    const Kind* kind = table.named(word);
    if (!kind || kind->hyponyms == 0 || steps > kind->hyponyms || !is_sense_of(*kind, word, synset)) continue;
    const bool is_it = steps == 0 && !table.only_resembles(word);
    const NounKind candidate{&table.planned(*kind), is_it ? NounBasis::synonym : NounBasis::hyponym,
                             std::string(word)};
    if (kind->name == word) return candidate;
    if (!found.kind) found = candidate;
  }
  return found;
}

Synsets one_step_up(const Synsets& level) {
  Synsets above;
  for (const auto synset : level)
    for (const auto general : lexicon().more_general(synset))
      if (std::find(above.begin(), above.end(), general) == above.end()) above.push_back(general);
  return above;
}

// The nearest that `meaning(synset, steps)` finds, upwards from a sense.
template <typename Meaning>
NounKind climb(std::uint32_t synset, const Meaning& meaning) {
  Synsets level{synset};
  for (int steps = 0; steps <= most_steps && !level.empty(); ++steps, level = one_step_up(level))
    for (const auto one : level)
      if (NounKind found = meaning(one, steps); found.kind) return found;
  return {};
}

// Who or what is usually no thing is none where it might be one: a bat, a jack.
bool is_usually_alive(std::string_view lemma) {
  return lexicon().is(lemma, WordClass::person) || lexicon().is(lemma, WordClass::animal);
}

NounKind related(const KindTable& table, std::uint32_t synset) {
  return climb(synset, [&](std::uint32_t above, int steps) { return called_by(table, above, steps); });
}

NounKind stand_in_of(const KindTable& table, std::uint32_t synset) {
  return climb(synset, [&](std::uint32_t above, int) {
    return NounKind{table.stand_in(above), NounBasis::stand_in, ""};
  });
}

}  // namespace

NounKind inferred_kind(const KindTable& table, std::string_view noun) {
  if (const Kind* kind = table.named(noun)) return {&table.planned(*kind), NounBasis::name, std::string(noun)};
  const std::string lemma = lemma_of(noun);
  if (lemma.empty() || is_usually_alive(lemma)) return {};
  for (const auto& sense : thing_senses(lemma)) {
    if (auto found = related(table, sense.synset); found.kind) return found;
    if (auto found = stand_in_of(table, sense.synset); found.kind) return found;
  }
  return {};
}

const Kind* stand_in_for(const KindTable& table, std::string_view noun) {
  const std::string lemma = lemma_of(noun);
  if (lemma.empty() || is_usually_alive(lemma)) return nullptr;
  for (const auto& sense : thing_senses(lemma))
    if (const auto found = stand_in_of(table, sense.synset); found.kind) return found.kind;
  return nullptr;
}

bool is_physical(std::string_view noun) {
  const std::string lemma = lemma_of(noun);
  return lemma.empty() || !thing_senses(lemma).empty();
}

}  // namespace roomgen
