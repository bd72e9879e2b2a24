#include "tag_features.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>

#include "feature_hash.h"
#include "inflection.h"
#include "lexicon.h"

namespace roomgen::language {

namespace {

std::string form_of(const Candidates& may_be) {
  if (!may_be.verb) return "";
  switch (may_be.verb->form) {
    case VerbForm::base:
      return "b";
    case VerbForm::third_person:
      return "s";
    case VerbForm::gerund:
      return "g";
    default:
      return "p";
  }
}

// Which of three uses is the commonest, and whether by far.
std::string mostly(const Candidates& may_be) {
  const double uses[] = {may_be.noun_uses, may_be.verb ? may_be.verb_uses : 0.0,
                         may_be.adjective_uses};
  std::string text;
  for (int i = 0; i < 3; ++i)
    for (int k = i + 1; k < 3; ++k) {
      const double lead = std::log2((uses[i] + 0.5) / (uses[k] + 0.5));
      text += static_cast<char>('m' + std::lround(std::clamp(lead, -3.0, 3.0) / 1.5));
    }
  return text;
}

std::string key_of_word(const Token& token, const Candidates& may_be) {
  if (may_be.is_small) return "=" + token.text;
  std::string key = form_of(may_be);
  if (may_be.is_noun) key += may_be.is_plural ? 'N' : 'n';
  if (may_be.is_adjective) key += 'a';
  if (may_be.is_adverb) key += 'r';
  return key;
}

UnitFacts facts_of(const std::vector<Token>& tokens, const Unit& unit) {
  UnitFacts facts;
  const Token& last = tokens[unit.tokens.end - 1];
  facts.word = last.text;
  facts.is_hyphened = unit.tokens.size() > 1;
  switch (unit.kind) {
    case Unit::Kind::number:
      facts.is_plural_number = unit.value > 1.0;
      facts.key = facts.is_plural_number ? "#" : "1";
      break;
    case Unit::Kind::measure:
      facts.key = "#m";
      break;
    case Unit::Kind::comma:
      facts.key = ",";
      break;
    case Unit::Kind::stop:
      facts.key = ".";
      break;
    case Unit::Kind::word:
      facts.may_be = candidates(last);
      facts.key = key_of_word(last, facts.may_be) + (facts.is_hyphened ? "-" : "");
  }
  if (!last.clitic.empty()) facts.key += "'" + last.clitic;
  facts.rate = facts.key + ":" + mostly(facts.may_be);
  return facts;
}

bool is_known_pair(const std::vector<UnitFacts>& facts, std::size_t first) {
  if (first + 1 >= facts.size() || !facts[first].may_be.is_content ||
      !facts[first + 1].may_be.is_content)
    return false;
  return lexicon().has(facts[first].word + " " + singular(facts[first + 1].word),
                       PartOfSpeech::noun);
}

// A mark, or nothing more.
bool ends_phrase(const std::vector<Unit>& units, std::size_t at) {
  return at >= units.size() || units[at].kind == Unit::Kind::comma ||
         units[at].kind == Unit::Kind::stop;
}

}  // namespace

std::vector<UnitFacts> facts_of(const std::vector<Token>& tokens, const std::vector<Unit>& units,
                                const IsName& is_name) {
  std::vector<UnitFacts> result;
  result.reserve(units.size());
  for (const Unit& unit : units) {
    result.push_back(facts_of(tokens, unit));
    UnitFacts& last = result.back();
    last.ends_compound =
        result.size() > 1 && last.may_be.is_small &&
        lexicon().has(result[result.size() - 2].word + " " + last.word, PartOfSpeech::noun);
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    const bool begins_name = is_name && i + 1 < result.size() && result[i + 1].may_be.is_noun &&
                             is_name(result[i].word + " " + singular(result[i + 1].word));
    result[i].begins_compound = is_known_pair(result, i) || begins_name;
    if (begins_name) result[i + 1].ends_name = ends_phrase(units, i + 2);
  }
  return result;
}

void TagContext::end_phrase() {
  number_ = Number::unsaid;
  nouns_ = '0';
}

void TagContext::add(const Unit& unit, const UnitFacts& facts, WordTag tag) {
  before_last_ = last_;
  last_ = word_tag_letters[static_cast<std::size_t>(tag)];
  static const std::set<std::string_view> openers = {"a",  "an", "the", "of", "with",
                                                     "in", "on", "at",  "by", "for"};
  awaits_noun_ =
      (tag == WordTag::determiner || tag == WordTag::preposition) && openers.count(facts.word) > 0;
  if (unit.kind == Unit::Kind::stop || unit.kind == Unit::Kind::comma) {
    last_ = unit.kind == Unit::Kind::stop ? '.' : ',';
    end_phrase();
    if (unit.kind == Unit::Kind::stop)
      verbs_ = '0';
    else if (verbs_ == '1')
      verbs_ = '2';
    return;
  }
  switch (tag) {
    case WordTag::determiner:
      end_phrase();
      opener_ = before_last_;
      number_ = facts.word == "a" || facts.word == "an" || facts.word == "each" ||
                        facts.word == "every" || facts.word == "another"
                    ? Number::one
                    : Number::definite;
      return;
    case WordTag::quantity:
      number_ = facts.key == "1" ? Number::one : Number::several;
      return;
    case WordTag::noun:
      nouns_ = facts.may_be.is_plural ? '2' : '1';
      return;
    case WordTag::unit:
    case WordTag::adjective:
    case WordTag::adverb:
    case WordTag::owner:
      return;
    case WordTag::verb:
    case WordTag::auxiliary:
      verbs_ = '1';
      return end_phrase();
    case WordTag::relative:
    case WordTag::there:
      verbs_ = '0';
      return end_phrase();
    case WordTag::conjunction:
      if (verbs_ == '1') verbs_ = '2';
      return end_phrase();
    case WordTag::pronoun:
      end_phrase();
      nouns_ = '1';
      return;
    default:
      return end_phrase();
  }
}

TagFeatures tag_features(const std::vector<UnitFacts>& facts, std::size_t at,
                         const TagContext& context) {
  static const UnitFacts edge{"", "|", "|", {}, false, false, false, false, false};
  const auto around = [&](std::size_t i) -> const UnitFacts& {
    return i < facts.size() ? facts[i] : edge;
  };
  const UnitFacts& here = facts[at];
  const UnitFacts &next = around(at + 1), &after = around(at + 2);
  const UnitFacts &before = at > 0 ? facts[at - 1] : edge, &earlier = at > 1 ? facts[at - 2] : edge;
  const std::string_view text = here.word;
  const char last = context.last(), before_last = context.before_last();
  const char phrase[] = {context.number(), context.nouns(), '\0'};
  const std::string clause{context.verbs(), context.number(), context.nouns()};
  const char pairs[] = {at > 0 && is_known_pair(facts, at - 1) ? 'y' : 'n',
                        is_known_pair(facts, at) ? 'y' : 'n', '\0'};
  TagFeatures result;
  std::size_t n = 0;
  const auto put = [&](std::initializer_list<std::string_view> parts) {
    result[n] = FeatureHash(n, parts).value();
    ++n;
  };
  const std::string_view t1(&last, 1), t2(&before_last, 1);
  put({});
  put({text});
  put({text, t1});
  put({text, phrase});
  put({text.substr(text.size() - std::min<std::size_t>(3, text.size())), here.key});
  put({text.substr(text.size() - std::min<std::size_t>(2, text.size())), phrase});
  put({here.key});
  put({here.rate});
  put({here.key, t1});
  put({here.rate, t1});
  put({here.key, t1, t2});
  put({here.key, next.key});
  put({here.key, t1, next.key});
  put({here.key, before.word});
  put({here.key, next.word});
  put({here.key, next.key, after.key});
  put({here.key, phrase});
  put({here.key, phrase, next.key});
  put({here.rate, phrase, next.key.substr(0, 3)});
  put({here.key, clause});
  put({here.key, clause, next.key});
  put({here.rate, clause});
  put({here.key, pairs, phrase});
  put({here.key, t1, next.key, after.key});
  put({text, next.key});
  put({here.key, before.key, earlier.key, next.key});
  return result;
}

}  // namespace roomgen::language
