#include "references.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "language/number.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

using design::KindMention;
using Which = NamedThing::Which;

constexpr std::size_t most_adjectives = 5;
constexpr double clearly_apart = 0.15;   // metres by which one is farther to a side than the others
constexpr double clearly_larger = 1.03;  // factor

bool is_new(const std::string& word) { return word == "a" || word == "an" || word == "another"; }

// "all six of the", "the two", "another", "two more": up to the adjectives.
std::size_t read_determiners(const EditText& text, std::size_t at, NamedThing& thing) {
  thing.bare = true;
  at += longest_in(text.edits.properties, text.tokens, at);
  for (bool more = true; more && at < text.tokens.size();) {
    more = false;
    const auto& token = text.tokens[at];
    if (const auto length = longest_in(text.edits.all, text.tokens, at)) {
      thing.which = Which::all;
      if (token.is_word("both")) thing.count = 2;
      at += length, more = true;
    } else if (token.kind == EditText::Token::Kind::word && is_new(token.text)) {
      thing.which = Which::indefinite;
      thing.further = thing.further || token.is_word("another");
      thing.count = 1;
      at += 1, more = true;
    } else if (text.words.definite.count(token.text) && token.kind == EditText::Token::Kind::word) {
      if (thing.which != Which::all) thing.which = Which::definite;
      at += 1, more = true;
    } else if (token.kind == EditText::Token::Kind::word && text.words.vague.count(token.text)) {
      thing.which = Which::indefinite;
      const auto few = text.words.numbers.find(token.text);
      thing.count = few == text.words.numbers.end() ? 0 : few->second;
      at += 1, more = true;
    } else if (const auto number = language::number_at(text.raw, at);
               number && number->value >= 1 && number->value <= 50 && number->value == std::floor(number->value)) {
      thing.count = static_cast<int>(number->value);
      if (thing.bare) thing.which = Which::indefinite;
      at += number->length, more = true;
      // "one of the armchairs"
      thing.any = text.is_word(at, "of") && at + 1 < text.tokens.size() && text.words.definite.count(text.tokens[at + 1].text);
      if (thing.any) ++at;
    }
    if (more) thing.bare = false;
  }
  return at;
}

bool may_be_adjective(const EditText& text, std::size_t at) {
  const auto& token = text.tokens[at];
  return token.kind == EditText::Token::Kind::word && !text.words.stops.count(token.text) &&
         !text.edits.verbs.count(token.text) && !text.words.numbers.count(token.text) &&
         !text.words.definite.count(token.text) && !text.words.room_parts.count(token.text);
}

std::optional<std::size_t> read_adjective(const EditText& text, std::size_t at, NamedThing& thing) {
  if (const auto side = design::longest(text.edits.sides, text.tokens, at, 2)) {
    thing.side = *side.value;
    return at + side.length;
  }
  if (text.edits.sizes.count(text.tokens[at].text)) {
    thing.size = text.edits.sizes.at(text.tokens[at].text);
    thing.looks.push_back(text.tokens[at].text);
    // "the smaller of the two tables"
    if (text.is_word(at + 1, "of")) {
      NamedThing others;
      const auto next = read_determiners(text, at + 2, others);
      if (next > at + 2) return next;
    }
    return at + 1;
  }
  if (text.edits.more.count(text.tokens[at].text)) {
    thing.further = true;
    return at + 1;
  }
  if (!may_be_adjective(text, at)) return std::nullopt;
  thing.looks.push_back(text.tokens[at].text);
  return at + 1;
}

// The name of a kind that ends its phrase: of "glass table" the glass is an adjective.
KindMention head_at(const EditText& text, std::size_t at) {
  KindMention mention = design::mention_at(text.kinds, text.tokens, at);
  if (mention.length == 0) return mention;
  const std::size_t next = at + mention.length;
  if (!mention.plural && next < text.tokens.size() && !text.words.stops.count(text.tokens[next].text) &&
      !text.edits.verbs.count(text.tokens[next].text) && design::mention_at(text.kinds, text.tokens, next).length > 0)
    return {};
  return mention;
}

std::optional<NamedThing> pronoun_at(const EditText& text, std::size_t at) {
  NamedThing thing;
  thing.begin = at;
  if (const auto length = longest_in(text.edits.pronouns, text.tokens, at)) {
    thing.which = Which::pronoun;
    thing.plural = text.is_word(at, "them") || text.is_word(at, "these") || text.is_word(at, "those");
    thing.end = at + length;
    return thing;
  }
  if (const auto length = longest_in(text.edits.everything, text.tokens, at)) {
    thing.which = Which::everything;
    thing.plural = true;
    thing.end = at + length;
    return thing;
  }
  return std::nullopt;
}

std::string joined_ids(const std::vector<std::string>& ids) { return join(ids, ", "); }

std::vector<Object> all_objects(const EditText& text) {
  std::vector<Object> all = text.scene.objects;
  all.insert(all.end(), text.coming.begin(), text.coming.end());
  return all;
}

// Of several, those at the far end in a direction.
Result<std::vector<std::string>> farthest(const EditText& text, std::vector<std::string> ids, std::size_t count,
                                          const std::string& words, const std::function<double(const Object&)>& measure,
                                          const std::function<bool(double, double)>& clearly) {
  std::stable_sort(ids.begin(), ids.end(), [&](const std::string& a, const std::string& b) {
    return measure(*text.object(a)) > measure(*text.object(b));
  });
  if (count >= ids.size()) return ids;
  if (!clearly(measure(*text.object(ids[count - 1])), measure(*text.object(ids[count]))))
    return not_understood("\"" + words + "\" may be " + joined_ids(ids) + ", which are much alike in that; say which one by its id");
  ids.resize(count);
  return ids;
}

Result<std::vector<std::string>> narrowed(const EditText& text, const NamedThing& thing, std::vector<std::string> ids) {
  const std::string words = text.words_from(thing.begin, thing.end);
  const std::size_t count = thing.count > 0 ? static_cast<std::size_t>(thing.count) : 1;
  if (thing.side && ids.size() > 1)
    return farthest(text, std::move(ids), count, words,
                    [&](const Object& object) { return Vec2(object.position.head<2>()).dot(*thing.side); },
                    [](double first, double second) { return first - second >= clearly_apart; });
  if (thing.size != 0.0 && ids.size() > 1)
    return farthest(text, std::move(ids), count, words,
                    [&](const Object& object) {
                      const double axis = std::abs(thing.size);
                      const double size = axis == 3 ? object.size.z() : axis == 2 ? object.size.x() : object.size.prod();
                      return thing.size > 0 ? size : 1.0 / size;
                    },
                    [](double first, double second) { return first >= clearly_larger * second; });
  return ids;
}

// Words of looks that some of them are described by tell these from the others.
std::vector<std::string> described(const EditText& text, const NamedThing& thing, std::vector<std::string> ids) {
  for (const auto& look : thing.looks) {
    std::vector<std::string> such;
    for (const auto& id : ids) {
      const Object& object = *text.object(id);
      auto known = words(object.description + " " + object.category);
      for (const auto& [stuff, finish] : object.asset.finish)
        for (auto& word : words(finish)) known.push_back(word);
      if (std::find(known.begin(), known.end(), look) != known.end()) such.push_back(id);
    }
    if (!such.empty()) ids = std::move(such);
    else if (thing.size == 0.0 && ids.size() > 1) return {};
  }
  return ids;
}

Result<std::vector<std::string>> meant_by_pronoun(const EditText& text, const NamedThing& thing) {
  const std::string words = text.words_from(thing.begin, thing.end);
  const auto& known = !text.latest.empty() ? text.latest : !text.recall.added.empty() ? text.recall.added : text.recall.touched;
  if (known.empty()) return not_understood("nothing was spoken of before that \"" + words + "\" could mean");
  if (thing.plural || known.size() == 1) return known;
  return not_understood("\"" + words + "\" may be " + joined_ids(known) + "; say which one");
}

// Has the number of what fits anything to say?
Result<std::vector<std::string>> by_number(const EditText& text, const NamedThing& thing, std::vector<std::string> ids) {
  const std::string words = text.words_from(thing.begin, thing.end);
  const auto wanted = static_cast<std::size_t>(thing.count);
  using Ids = std::vector<std::string>;
  if (!thing.any && (thing.which == Which::all || (thing.plural && thing.which == Which::definite))) {
    if (thing.count == 0 || wanted == ids.size()) return ids;
    return not_understood("\"" + words + "\": there are " + std::to_string(ids.size()) + ": " + joined_ids(ids));
  }
  if (thing.any && wanted <= ids.size()) return Ids(ids.end() - static_cast<std::ptrdiff_t>(wanted), ids.end());
  if (ids.size() == 1) return ids;
  std::vector<std::string> spoken_of;
  for (const auto& id : ids)
    if (std::count(text.mentioned.begin(), text.mentioned.end(), id)) spoken_of.push_back(id);
  if (spoken_of.size() == 1 && thing.which == Which::definite) return spoken_of;
  return not_understood("\"" + words + "\" may be " + joined_ids(ids) + "; say which one, by its id or its place");
}

// "chair-2" comes as two tokens.
void read_number_of_id(const EditText& text, NamedThing& thing) {
  if (thing.end >= text.raw.size()) return;
  const auto& token = text.raw[thing.end];
  if (token.kind != language::Token::Kind::number || token.joint != language::Token::Joint::hyphen) return;
  thing.number = static_cast<int>(token.value);
  ++thing.end;
}

std::optional<NamedThing> noun_phrase_at(const EditText& text, std::size_t at) {
  NamedThing thing;
  thing.begin = at;
  at = read_determiners(text, at, thing);
  for (std::size_t n = 0; n <= most_adjectives && at < text.tokens.size(); ++n) {
    thing.kind = head_at(text, at);
    if (thing.kind.length > 0) {
      thing.plural = thing.kind.plural || thing.count > 1;
      thing.end = at + thing.kind.length;
      read_number_of_id(text, thing);
      if (thing.further && thing.which == Which::definite && !thing.bare) thing.further = false;
      return thing;
    }
    const auto next = read_adjective(text, at, thing);
    if (!next) return std::nullopt;
    at = *next;
  }
  return std::nullopt;
}

}  // namespace

std::string NamedThing::description() const {
  std::vector<std::string> all = looks;
  all.push_back(kind.name);
  return join(all, " ");
}

std::optional<NamedThing> named_thing_at(const EditText& text, std::size_t at) {
  if (at >= text.tokens.size()) return std::nullopt;
  auto named = noun_phrase_at(text, at);
  // "that chair", "all six chairs" are no pronouns.
  const auto pronoun = pronoun_at(text, at);
  return named || !pronoun ? named : pronoun;
}

// "the lamp" may be any lamp, whichever kind people mean first by the word.
std::vector<std::string> fitting(const EditText& text, const NamedThing& thing) {
  std::vector<std::string> exact, general, by_word;
  for (const auto& object : all_objects(text)) {
    if (thing.which == Which::everything) {
      exact.push_back(object.id);
      continue;
    }
    if (!thing.kind.category || (thing.number && !object.id.ends_with("-" + std::to_string(*thing.number)))) continue;
    const auto all = words(object.category);
    const auto said = words(thing.kind.name);
    const bool ends_so = said.size() <= all.size() && std::equal(said.rbegin(), said.rend(), all.rbegin());
    const bool has_words = std::all_of(said.begin(), said.end(), [&](const std::string& word) {
      return std::find(all.begin(), all.end(), word) != all.end();
    });
    if (object.category == thing.kind.name) exact.push_back(object.id);
    else if (ends_so || text.kinds.is_a(object.category, thing.kind.category->name)) general.push_back(object.id);
    else if (has_words) by_word.push_back(object.id);
  }
  if (!exact.empty()) return exact;
  return general.empty() ? by_word : general;
}

Result<std::vector<std::string>> meant(const EditText& text, const NamedThing& thing,
                                       const std::vector<std::string>* among) {
  if (thing.which == Which::pronoun) return meant_by_pronoun(text, thing);
  auto ids = fitting(text, thing);
  if (among)
    std::erase_if(ids, [&](const std::string& id) { return std::find(among->begin(), among->end(), id) == among->end(); });
  const std::string words = text.words_from(thing.begin, thing.end);
  if (ids.empty()) return not_understood("there is no \"" + words + "\" in the room");
  ids = described(text, thing, std::move(ids));
  if (ids.empty()) return not_understood("nothing in the room is known to be \"" + words + "\"");
  auto few = narrowed(text, thing, std::move(ids));
  if (!few) return few;
  if (thing.which == Which::everything) return few;
  return by_number(text, thing, *std::move(few));
}

}  // namespace roomgen
