#include "scene_nouns.h"

#include <algorithm>

#include "language/inflection.h"
#include "language/lexicon.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

using language::lexicon;
using language::PartOfSpeech;

constexpr int most_general = 3;          // steps up: an armchair is a chair is a seat
constexpr int most_special = 2;          // steps down
constexpr std::size_t least_piece = 4;   // letters of "fire" for "fireplace"

// Of a name that WordNet lacks the last word: "bar stool" is a stool.
std::string lemma_of(const std::string& name) {
  if (lexicon().has(name, PartOfSpeech::noun)) return name;
  const auto pieces = words(name);
  return pieces.empty() ? name : pieces.back();
}

// Whatever sense of the noun it is: what is there is known.
bool is_kind_of(const std::string& lemma, const std::string& noun) {
  std::vector<std::uint32_t> level;
  for (const auto& sense : lexicon().common_senses(lemma, PartOfSpeech::noun)) level.push_back(sense.synset);
  const auto senses = lexicon().senses(noun, PartOfSpeech::noun);
  const auto is_sense = [&](std::uint32_t synset) {
    return std::any_of(senses.begin(), senses.end(),
                       [&](const language::Sense& sense) { return sense.synset == synset; });
  };
  for (int step = 0; step <= most_general; ++step) {
    if (std::any_of(level.begin(), level.end(), is_sense)) return true;
    std::vector<std::uint32_t> above;
    for (const auto synset : level)
      for (const auto general : lexicon().more_general(synset)) above.push_back(general);
    level = std::move(above);
  }
  return false;
}

bool is_related(const std::string& noun, const std::string& name) {
  const std::string lemma = lemma_of(name);
  return lexicon().are_synonyms(noun, lemma) || is_kind_of(lemma, noun) ||
         lexicon().steps_up(noun, lemma, most_special).has_value();
}

// "the fire", where there is a fireplace and "fire" is no thing of its own.
bool is_beginning_of(const EditText& text, const std::string& noun, const std::string& category) {
  if (noun.size() < least_piece || text.kinds.named(noun) || lexicon().is(noun, language::WordClass::artefact))
    return false;
  const auto pieces = words(category);
  return std::any_of(pieces.begin(), pieces.end(), [&](const std::string& piece) {
    return piece.size() > noun.size() + 2 && piece.starts_with(noun);
  });
}

bool may_be_called(const EditText& text, const std::string& noun, const std::string& category) {
  if (is_beginning_of(text, noun, category)) return true;
  if (!lexicon().has(noun, PartOfSpeech::noun)) return false;
  if (is_related(noun, category)) return true;
  const Kind* kind = text.kinds.by_name(category);
  return kind && std::any_of(kind->names.begin(), kind->names.end(), [&](const std::string& name) {
    return name == noun || lexicon().are_synonyms(noun, name);
  });
}

}  // namespace

std::vector<std::string> things_by_meaning(const EditText& text, const std::string& noun) {
  std::vector<std::string> ids;
  for (const auto& object : text.scene.objects)
    if (may_be_called(text, noun, object.category)) ids.push_back(object.id);
  return ids;
}

}  // namespace roomgen
