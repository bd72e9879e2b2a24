#include "role_features.h"

#include <algorithm>

#include "brief/opening_phrase.h"
#include "clause_parts.h"
#include "clause.h"
#include "language/feature_hash.h"
#include "language/inflection.h"
#include "language/lexicon.h"
#include "language/tag_model.h"
#include "spoken_clause.h"

namespace roomgen {

namespace {

using language::FeatureHash;
using Token = design::Token;

// ---- What single words are ---------------------------------------------------------------------

void set_tags(const EditText& text, std::vector<WordSigns>& signs) {
  const auto units = language::units(text.raw);
  const auto tags = language::tag_words(units, language::facts_of(text.raw, units), language::tag_model());
  for (std::size_t u = 0; u < units.size(); ++u)
    for (auto i = units[u].tokens.begin; i < units[u].tokens.end; ++i)
      signs[i].tag = language::word_tag_letters[static_cast<std::size_t>(tags[u])];
}

std::string base_of(const WordSigns& sign) {
  if (const auto verb = language::verb(sign.word); verb && sign.tag.find_first_of("VGEX") != std::string::npos)
    return verb->base;
  return sign.tag == "N" ? language::singular(sign.word) : sign.word;
}

// "relocate" is to move, "rug" a furnishing.
std::vector<std::string> general_terms(const WordSigns& sign) {
  constexpr std::size_t most = 4;
  std::vector<std::string> terms;
  const bool is_verb = sign.tag.find_first_of("VGE") != std::string::npos;
  if (is_verb)
    for (const auto term : language::lexicon().hypernyms(sign.base, language::PartOfSpeech::verb))
      if (terms.size() < most) terms.emplace_back(term);
  const auto senses = language::lexicon().senses(sign.base, language::PartOfSpeech::noun);
  if (sign.tag != "N" || senses.empty()) return terms;
  for (std::size_t k = 0; k < language::word_class_names.size(); ++k)
    if (senses.front().is(static_cast<language::WordClass>(k)))
      terms.emplace_back(language::word_class_names[k]);
  return terms;
}

// ---- What phrases mean to edits ----------------------------------------------------------------

void put_sign(std::vector<WordSigns>& signs, std::size_t begin, std::size_t length, char first, char other) {
  for (std::size_t i = begin; i < std::min(begin + length, signs.size()); ++i)
    signs[i].kinds += i == begin ? first : other;
}

struct PhraseSign {
  char first, other;
  std::vector<const design::WordSet*> sets;
};

void put_phrases(const EditText& text, std::vector<WordSigns>& signs) {
  const auto& edits = text.edits;
  const PhraseSign all[] = {
      {'C', 'c', {&edits.closers, &edits.welcome, &edits.courtesies}},
      {'X', 'x', {&edits.openers, &edits.hedges, &edits.emphasis, &edits.explanations}},
      {'F', 'f', {&edits.faces, &edits.facing_away}},
      {'W', 'w', {&edits.where_they_are, &edits.stays, &edits.existing}},
      {'B', 'b', {&edits.back, &edits.vice_versa, &edits.goes_away, &edits.unneeded}},
      {'S', 's', {&edits.substitutes, &edits.something, &edits.shapes}},
      {'Q', 'q', {&edits.questions, &edits.modals, &edits.auxiliaries, &edits.wishes}},
      {'E', 'e', {&edits.except, &edits.besides, &edits.only_these}},
      {'M', 'm', {&edits.more, &edits.all, &edits.others, &edits.everything}},
      {'O', 'o', {&edits.pronouns}},
      {'N', 'n', {&edits.away, &edits.closer, &edits.nearest, &edits.farthest, &edits.apart, &edits.side_by_side}},
  };
  for (const auto& sign : all)
    for (std::size_t i = 0; i < signs.size(); ++i)
      for (const auto* set : sign.sets)
        if (const auto length = longest_in(*set, text.tokens, i)) {
          put_sign(signs, i, length, sign.first, sign.other);
          break;
        }
}

template <typename Map>
void put_keys(const EditText& text, std::vector<WordSigns>& signs, const Map& map, char first, char other) {
  for (std::size_t i = 0; i < signs.size();) {
    const auto length = design::longest(map, text.tokens, i).length;
    put_sign(signs, i, length, first, other);
    i += std::max<std::size_t>(1, length);
  }
}

void put_maps(const EditText& text, std::vector<WordSigns>& signs) {
  const auto& edits = text.edits;
  put_keys(text, signs, text.words.placements, 'P', 'p');
  put_keys(text, signs, edits.places, 'P', 'p');
  put_keys(text, signs, edits.directions, 'D', 'd');
  put_keys(text, signs, edits.side_tails, 'D', 'd');
  put_keys(text, signs, edits.growth, 'G', 'g');
  put_keys(text, signs, edits.measured, 'G', 'g');
  put_keys(text, signs, edits.sizes, 'G', 'g');
  put_keys(text, signs, edits.amounts, 'A', 'a');
  put_keys(text, signs, edits.shares, 'A', 'a');
  put_keys(text, signs, edits.multiples, 'A', 'a');
  put_keys(text, signs, edits.turns, 'T', 't');
  put_keys(text, signs, edits.turn_directions, 'T', 't');
  put_keys(text, signs, edits.room_parts, 'R', 'r');
}

void put_things(const EditText& text, std::vector<WordSigns>& signs) {
  for (std::size_t i = 0; i < signs.size();) {
    const auto thing = named_thing_at(text, i);
    if (!thing || !thing->kind.category) {
      ++i;
      continue;
    }
    const bool is_there = !fitting(text, *thing).empty();
    put_sign(signs, i, thing->end - i, is_there ? 'K' : 'U', is_there ? 'k' : 'u');
    i = std::max(i + 1, thing->end);
  }
}

void put_words(const EditText& text, std::vector<WordSigns>& signs) {
  const auto& kinds = OpeningKinds::built_in();
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (text.tokens[i].kind == Token::Kind::number) signs[i].kinds += '0';
    if (describes_looks(signs[i].word)) signs[i].kinds += 'L';
    if (kinds)
      if (const auto length = design::opening_name_at(text.tokens, i, *kinds)) put_sign(signs, i, length, 'I', 'i');
    const auto verb = verb_at(text, i);
    if (!verb) continue;
    put_sign(signs, i, verb->length, 'V', 'v');
    signs[i].classes.push_back("v:" + verb->meaning);
  }
}

}  // namespace

std::vector<WordSigns> signs_of(const EditText& text) {
  std::vector<WordSigns> signs(text.tokens.size());
  set_tags(text, signs);
  for (std::size_t i = 0; i < signs.size(); ++i) {
    const bool is_number = text.tokens[i].kind == Token::Kind::number;
    signs[i].word = is_number ? "0" : text.tokens[i].kind == Token::Kind::stop ? "." : text.tokens[i].text;
    if (text.is_comma(i)) signs[i].word = ",";
    signs[i].base = base_of(signs[i]);
    signs[i].classes = general_terms(signs[i]);
  }
  put_things(text, signs);
  put_words(text, signs);
  put_maps(text, signs);
  put_phrases(text, signs);
  return signs;
}

void RoleContext::add(EditRole role, bool ends_sentence) {
  if (role != last) before = last, last = role;
  if (role == EditRole::next || ends_sentence) has_order = has_thing = has_target = false;
  has_order |= role == EditRole::order;
  has_thing |= role == EditRole::thing;
  has_target |= role == EditRole::target;
}

// ---- Features ----------------------------------------------------------------------------------

namespace {

const WordSigns edge{"|", "|", "|", "|", {}};

const WordSigns& sign_at(const std::vector<WordSigns>& signs, std::size_t at, int off) {
  const auto i = static_cast<std::ptrdiff_t>(at) + off;
  return i < 0 || i >= static_cast<std::ptrdiff_t>(signs.size()) ? edge : signs[static_cast<std::size_t>(i)];
}

/// Puts features together; each kind of them has a number of its own.
class FeatureList {
 public:
  explicit FeatureList(std::size_t first) : which_(first) {}
  void put(std::initializer_list<std::string_view> parts) { features_.push_back(FeatureHash(which_++, parts).value()); }
  /// Several of one kind.
  void put_all(const std::vector<std::string>& words) {
    for (const auto& word : words) features_.push_back(FeatureHash(which_, {word}).value());
    ++which_;
  }
  Features taken() { return std::move(features_); }

 private:
  std::size_t which_;
  Features features_;
};

std::vector<std::string> letters_of(const std::string& kinds) {
  std::vector<std::string> all;
  for (const char letter : kinds) all.emplace_back(1, letter);
  return all;
}

constexpr std::size_t first_of_words = 0, first_of_contexts = 50, first_of_deeds = 80,
                      first_of_places = 110;

}  // namespace

Features word_features(const std::vector<WordSigns>& signs, std::size_t at) {
  const auto& s0 = signs[at];
  const auto &p1 = sign_at(signs, at, -1), &p2 = sign_at(signs, at, -2), &p3 = sign_at(signs, at, -3);
  const auto &n1 = sign_at(signs, at, 1), &n2 = sign_at(signs, at, 2), &n3 = sign_at(signs, at, 3);
  FeatureList list(first_of_words);
  list.put({});
  list.put({s0.word});
  list.put({s0.base, s0.tag});
  list.put({p1.word, s0.word});
  list.put({s0.word, n1.word});
  list.put({p1.word});
  list.put({n1.word});
  list.put({p2.word, p1.word});
  list.put({n1.word, n2.word});
  list.put({p1.word, s0.word, n1.word});
  list.put({s0.tag});
  list.put({p1.tag, s0.tag});
  list.put({s0.tag, n1.tag});
  list.put({p1.tag, s0.tag, n1.tag});
  list.put({s0.tag, n1.tag, n2.tag});
  list.put({p2.tag, p1.tag, s0.tag});
  list.put({s0.kinds});
  list.put({p1.kinds, s0.kinds});
  list.put({s0.kinds, n1.kinds});
  list.put({p1.kinds, s0.kinds, n1.kinds});
  list.put({s0.kinds, n1.kinds, n2.kinds});
  list.put({s0.kinds, s0.tag});
  list.put({s0.word, n1.kinds});
  list.put({s0.word, p1.kinds});
  list.put({s0.word, n1.tag});
  list.put({s0.tag, n1.kinds, n2.kinds, n3.kinds});
  list.put({p2.kinds, p1.kinds});
  list.put({p3.kinds, p2.kinds, p1.kinds});
  list.put({p1.base, s0.kinds});
  list.put({n1.kinds});
  list.put({p1.kinds});
  list.put_all(s0.classes);
  list.put_all(p1.classes);
  list.put_all(n1.classes);
  list.put_all(letters_of(s0.kinds));
  list.put_all(letters_of(n1.kinds));
  return list.taken();
}

Features context_features(const std::vector<WordSigns>& signs, std::size_t at, const RoleContext& context) {
  const auto &s0 = signs[at], &p1 = sign_at(signs, at, -1), &n1 = sign_at(signs, at, 1);
  const std::string last(edit_role_names[static_cast<std::size_t>(context.last)]);
  const std::string before(edit_role_names[static_cast<std::size_t>(context.before)]);
  const std::string flags{context.has_order ? '1' : '0', context.has_thing ? '1' : '0', context.has_target ? '1' : '0'};
  const bool is_behind_mark = p1.word == "." || p1.word == "," || p1.word == "|";
  FeatureList list(first_of_contexts);
  list.put({last});
  list.put({last, before});
  list.put({last, flags});
  list.put({flags, s0.kinds});
  list.put({flags, s0.tag, n1.tag});
  list.put({flags, s0.word});
  list.put({last, s0.word});
  list.put({last, s0.tag});
  list.put({last, s0.kinds});
  list.put({last, p1.word});
  list.put({last, p1.tag, s0.tag});
  list.put({last, p1.kinds, s0.kinds});
  list.put({last, s0.tag, n1.tag});
  list.put({last, s0.kinds, n1.kinds});
  list.put({last, before, s0.tag});
  list.put({last, flags, s0.tag, is_behind_mark ? "m" : ""});
  list.put({last, is_behind_mark ? "m" : "", s0.kinds});
  return list.taken();
}

namespace {

std::string letter_of(EditRole role) { return std::string(edit_role_names[static_cast<std::size_t>(role)].substr(0, 2)); }

// "a", "the", "it", "two more": with what the first thing begins.
std::string manner_of(const EditText& text, const SpokenOrder& order) {
  for (const auto& part : order.parts) {
    if (part.role != EditRole::thing) continue;
    const auto thing = named_thing_at(text, part.begin);
    if (!thing) return "?";
    std::string manner(1, static_cast<char>('0' + static_cast<int>(thing->which)));
    if (thing->bare) manner += 'b';
    if (thing->further) manner += 'f';
    if (thing->any) manner += 'a';
    if (thing->kind.category) manner += fitting(text, *thing).empty() ? 'n' : 'y';
    return manner;
  }
  return "-";
}

std::vector<std::string> words_with(const std::vector<WordSigns>& signs, const SpokenOrder& order, EditRole role,
                                    const std::string& prefix) {
  std::vector<std::string> words;
  for (const auto& part : order.parts)
    for (std::size_t i = part.begin; part.role == role && i < part.end; ++i) words.push_back(prefix + signs[i].base);
  return words;
}

std::vector<std::string> crossed(const std::vector<std::string>& words, const std::string& with) {
  std::vector<std::string> all;
  for (const auto& word : words) all.push_back(word + "/" + with);
  return all;
}

std::vector<std::string> pairs_of(const std::vector<std::string>& words) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) all.push_back(words[i] + " " + words[i + 1]);
  return all;
}

}  // namespace

Features deed_features(const EditText& text, const std::vector<WordSigns>& signs, const SpokenOrder& order,
                       std::string_view previous) {
  std::string shape, roles;
  std::vector<std::string> classes, kinds, looks;
  for (const auto& part : order.parts) {
    shape += letter_of(part.role);
    if (roles.find(letter_of(part.role)) == std::string::npos) roles += letter_of(part.role);
    for (std::size_t i = part.begin; i < part.end; ++i) {
      if (part.role == EditRole::order) classes.insert(classes.end(), signs[i].classes.begin(), signs[i].classes.end());
      for (const char kind : signs[i].kinds)
        if (std::isupper(static_cast<unsigned char>(kind)) || kind == '0') kinds.push_back(letter_of(part.role) + kind);
      if (part.role == EditRole::look)
        for (const auto& term : signs[i].classes) looks.push_back(term);
    }
  }
  std::sort(roles.begin(), roles.end());
  const std::string manner = manner_of(text, order);
  const auto orders = words_with(signs, order, EditRole::order, "");
  FeatureList list(first_of_deeds);
  list.put({});
  list.put({shape});
  list.put({roles});
  list.put({manner});
  list.put({manner, roles});
  list.put_all(orders);
  list.put_all(pairs_of(orders));
  list.put_all(crossed(orders, manner));
  list.put_all(crossed(orders, roles));
  list.put_all(classes);
  list.put_all(crossed(classes, manner));
  list.put_all(crossed(classes, roles));
  list.put_all(kinds);
  list.put_all(looks);
  list.put_all(words_with(signs, order, EditRole::look, ""));
  list.put_all(words_with(signs, order, EditRole::amount, ""));
  list.put_all(words_with(signs, order, EditRole::place, ""));
  list.put_all(crossed(words_with(signs, order, EditRole::thing, ""), order.has(EditRole::look) ? "l" : ""));
  list.put({order.has(EditRole::order) ? "" : previous});
  list.put({previous});
  return list.taken();
}

Features place_features(const EditText&, const std::vector<WordSigns>& signs, const SpokenOrder& order, EditDeed deed) {
  const std::string what(deed_names[static_cast<std::size_t>(deed)]);
  const auto places = words_with(signs, order, EditRole::place, "");
  const auto orders = words_with(signs, order, EditRole::order, "");
  std::string all;
  for (const auto& word : places) all += word + " ";
  std::vector<std::string> targets;
  for (const auto& part : order.parts)
    for (std::size_t i = part.begin; part.role == EditRole::target && i < part.end; ++i)
      targets.insert(targets.end(), signs[i].classes.begin(), signs[i].classes.end());
  FeatureList list(first_of_places);
  list.put({});
  list.put({all});
  list.put({what});
  list.put_all(places);
  list.put_all(pairs_of(places));
  list.put_all(crossed(places, what));
  list.put_all(orders);
  list.put_all(words_with(signs, order, EditRole::target, ""));
  list.put_all(crossed(targets, all));
  list.put({order.has(EditRole::target) ? "t" : "", order.has(EditRole::amount) ? "a" : "", all});
  return list.taken();
}

}  // namespace roomgen
