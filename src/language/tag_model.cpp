#include "tag_model.h"

#include <algorithm>

#include "lexicon.h"
#include "small_words.h"

extern "C" {
extern const unsigned char roomgen_tagger[];
extern const std::uint64_t roomgen_tagger_size;
}

namespace roomgen::language {

std::array<int, word_tag_count> TagModel::scores(const TagFeatures& features) const {
  std::array<int, word_tag_count> sums{};
  for (const std::uint32_t feature : features) weights_.add_to(sums, feature);
  return sums;
}

WordTag TagModel::best(const TagFeatures& features, const UnitFacts& facts,
                       const TagContext& context) const {
  const auto sums = scores(features);
  std::size_t best = word_tag_count;
  for (std::size_t tag = 0; tag < word_tag_count; ++tag)
    if (may_have(facts, context, static_cast<WordTag>(tag)) &&
        (best == word_tag_count || sums[tag] > sums[best]))
      best = tag;
  return static_cast<WordTag>(best);
}

namespace {

// Of words that no list of small words knows: the tags of closed classes are left to the model, for
// words of several parts ("next to") and for what the lists forgot, but for those of a single word.
bool may_have_by_form(const UnitFacts& facts, WordTag tag) {
  const Candidates& may_be = facts.may_be;
  const bool is_unknown =
      !may_be.is_noun && !may_be.verb && !may_be.is_adjective && !may_be.is_adverb;
  const auto has_form = [&](std::initializer_list<VerbForm> forms) {
    return may_be.verb && std::find(forms.begin(), forms.end(), may_be.verb->form) != forms.end();
  };
  switch (tag) {
    case WordTag::adjective:
      return is_unknown || may_be.is_adjective || may_be.is_participle() ||
             lexicon().may_be(facts.word, WordClass::color);
    case WordTag::verb:
      return may_be.verb && !has_form({VerbForm::gerund});
    case WordTag::gerund:
      return has_form({VerbForm::gerund});
    case WordTag::participle:
      return may_be.verb && !has_form({VerbForm::gerund, VerbForm::third_person});
    case WordTag::auxiliary:
      return may_be.verb && may_be.verb->base == "have";
    case WordTag::infinitive:
    case WordTag::there:
    case WordTag::conjunction:
      return false;
    default:
      return true;
  }
}

bool may_have_in_closed_class(const std::string& word, WordTag tag) {
  const auto& words = small_words();
  if (words.determiners.count(word))
    return tag == WordTag::determiner || tag == WordTag::pronoun ||
           (tag == WordTag::relative && words.relatives.count(word)) || tag == WordTag::quantity ||
           (tag == WordTag::adverb && words.adverbs.count(word));
  switch (tag) {
    case WordTag::noun:
      // "to its right"
      return words.adverbs.count(word) && lexicon().has(word, PartOfSpeech::noun);
    case WordTag::owner:
    case WordTag::gerund:
    case WordTag::participle:
    case WordTag::unit:
    case WordTag::determiner:
      return false;
    case WordTag::auxiliary:
      return words.be.count(word) || words.auxiliaries.count(word);
    case WordTag::infinitive:
      return word == "to";
    case WordTag::there:
      return word == "there";
    default:
      return true;
  }
}

}  // namespace

bool may_have(const UnitFacts& facts, const TagContext& context, WordTag tag) {
  if (facts.ends_compound) return tag == WordTag::noun;
  // Behind "a" or "the" the noun phrase goes on, behind "of" one begins.
  if (context.awaits_noun() && (tag == WordTag::verb || tag == WordTag::auxiliary)) return false;
  // "a television stand": the base form does not agree with one thing.
  const auto& verb = facts.may_be.verb;
  if (tag == WordTag::verb && verb && verb->form == VerbForm::base && context.is_singular())
    return false;
  // "three mic stands": one thing is not three.
  if (tag == WordTag::verb && context.is_short_of_plural()) return false;
  if (facts.ends_name && tag == WordTag::verb) return false;
  // "two windows and blinds": a second verb needs a first.
  if (tag == WordTag::verb && verb && verb->form == VerbForm::third_person &&
      context.last() == 'C' && context.verbs() == '0')
    return false;
  // "a writing desk"
  if (facts.begins_compound && tag == WordTag::gerund) return false;
  if (facts.is_hyphened)
    return tag == WordTag::noun || tag == WordTag::adjective || tag == WordTag::adverb ||
           tag == WordTag::verb || tag == WordTag::participle || tag == WordTag::gerund;
  return facts.may_be.is_small ? may_have_in_closed_class(facts.word, tag)
                               : may_have_by_form(facts, tag);
}

std::optional<WordTag> given_tag(const Unit& unit) {
  switch (unit.kind) {
    case Unit::Kind::number:
    case Unit::Kind::measure:
      return WordTag::quantity;
    case Unit::Kind::comma:
    case Unit::Kind::stop:
      return WordTag::other;
    default:
      return std::nullopt;
  }
}

const TagModel& tag_model() {
  static const TagModel built_in(std::string_view(reinterpret_cast<const char*>(roomgen_tagger),
                                                  static_cast<std::size_t>(roomgen_tagger_size)));
  return built_in;
}

std::vector<WordTag> tag_words(const std::vector<Unit>& units, const std::vector<UnitFacts>& facts,
                               const TagModel& model) {
  std::vector<WordTag> tags;
  TagContext context;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const auto given = given_tag(units[i]);
    tags.push_back(given ? *given : model.best(tag_features(facts, i, context), facts[i], context));
    context.add(units[i], facts[i], tags.back());
  }
  return tags;
}

}  // namespace roomgen::language
