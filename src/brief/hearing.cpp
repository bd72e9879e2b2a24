#include "hearing.h"

#include <algorithm>

namespace roomgen::brief {

using language::none;
using language::Run;

std::size_t Hearing::note(std::size_t mention, const Run& tokens, Heard::As as, std::string word) {
  const std::size_t index = hear(brief_, tokens, as, std::move(word));
  brief_.mentions[mention].heard.push_back(index);
  return index;
}

void Hearing::thing(const ThingPhrase& thing, std::size_t mention) {
  note(mention, thing.name_tokens, Heard::As::thing);
  for (const auto token : thing.count_tokens)
    note(mention, {token, token + 1}, Heard::As::count);
  const auto& looks = brief_.mentions[mention].looks;
  for (std::size_t i = 0; i < thing.modifiers.size(); ++i)
    if (std::find(looks.begin(), looks.end(), thing.modifiers[i]) != looks.end())
      note(mention, thing.modifier_tokens[i], Heard::As::attribute, thing.modifiers[i]);
  if (!thing.contents.empty()) note(mention, thing.contents_tokens, Heard::As::thing);
  for (const auto& tokens : thing.measure_tokens)
    note(mention, tokens, Heard::As::attribute, said_length);
}

void Hearing::part(std::int32_t number, std::size_t owner) {
  const Run run{phrase(number).tokens.begin, phrase(number).head + 1};
  std::string words;
  for (auto i = run.begin; i < run.end; ++i)
    if (text_.plain[i].kind == Token::Kind::word || text_.plain[i].kind == Token::Kind::number)
      words += (words.empty() ? "" : " ") + text_.plain[i].text;
  auto& parts = brief_.mentions[owner].parts;
  if (std::find(parts.begin(), parts.end(), words) == parts.end()) parts.push_back(words);
  note(owner, run, Heard::As::attribute, words);
}

void Hearing::absence(std::int32_t number, const std::string& category) {
  Run run = phrase(number).tokens;
  // "avoid rugs": the word that denies it is part of it.
  for (const auto& verb : text_.parse.verbs)
    if (verb.object == number && verb.tokens.end <= run.begin)
      hear(brief_, verb.tokens, Heard::As::absence, category);
  hear(brief_, run, Heard::As::absence, category);
}

void Hearing::number(std::int32_t number, std::size_t mention) {
  this->number({phrase(number).tokens.begin, phrase(number).head + 1}, mention);
}

void Hearing::number(const Run& tokens, std::size_t mention) {
  note(mention, tokens, Heard::As::count);
}

void Hearing::length(const Run& tokens, std::size_t mention) {
  note(mention, tokens, Heard::As::attribute, said_length);
}

void Hearing::look(const Run& tokens, std::size_t mention, const std::string& word) {
  note(mention, tokens, Heard::As::attribute, word);
}

void Hearing::stand_in(std::int32_t number, std::size_t mention) {
  note(mention, {phrase(number).tokens.begin, phrase(number).head + 1}, Heard::As::thing);
}

std::size_t Hearing::relation(const language::Attachment& attachment, std::int32_t place) {
  Run tokens = attachment.tokens;
  if (attachment.verb != none) {
    const auto& verb = text_.parse.verbs[static_cast<std::size_t>(attachment.verb)];
    const bool is_joined = verb.tokens.end == tokens.begin;
    // "six paintings leaning on the wall": where they are is planned, how they are there is not.
    if (is_joined && text_.words.manners.count(text_.plain[verb.tokens.end - 1].text))
      hear(brief_, {verb.tokens.end - 1, verb.tokens.end}, Heard::As::not_understood);
    else if (is_joined)
      tokens.begin = verb.tokens.begin;
  }
  if (place != none) {
    const auto& target = phrase(place);
    tokens.begin = std::min(tokens.begin, target.tokens.begin);
    tokens.end = std::max(tokens.end, target.tokens.end);
  }
  return hear(brief_, tokens, Heard::As::relation);
}

void Hearing::plain_verbs(const std::vector<std::optional<std::size_t>>& mention_of) {
  const auto mention = [&](std::int32_t number) {
    return number == none ? std::nullopt : mention_of[static_cast<std::size_t>(number)];
  };
  for (const auto& verb : text_.parse.verbs) {
    const std::string& word = text_.plain[verb.tokens.end - 1].text;
    const bool puts = verb.kind == language::VerbPhrase::Kind::imperative && mention(verb.object);
    if (verb.is_denied || !(puts || text_.words.verbs.count(word) || text_.words.stops.count(word) ||
                            text_.words.asking.count(verb.base)))
      continue;
    auto one = mention(verb.object);
    if (!one) one = mention(verb.subject);
    if (one)
      note(*one, verb.tokens, Heard::As::thing);
    else
      hear(brief_, verb.tokens, Heard::As::room);
  }
}

}  // namespace roomgen::brief
