#include "parse.h"

#include "chunks.h"
#include "inflection.h"

namespace roomgen::language {

Span Parse::span_of(const Run& run) const {
  if (run.empty()) return {};
  return {tokens[run.begin].span.begin, tokens[run.end - 1].span.end};
}

std::string Parse::head_of(const NounPhrase& phrase) const {
  const std::string& word = tokens[phrase.head].text;
  return phrase.is_plural ? singular(word) : word;
}

std::string Parse::text_of(const Modifier& modifier) const {
  std::string text;
  for (auto i = modifier.tokens.begin; i < modifier.tokens.end; ++i) {
    if (!text.empty()) text += tokens[i].joint == Token::Joint::hyphen ? "-" : " ";
    text += tokens[i].text;
  }
  return text;
}

std::vector<std::uint32_t> Parse::with_list(std::uint32_t phrase) const {
  const std::int32_t list = phrases[phrase].list;
  if (list == none) return {phrase};
  const Run& run = lists[static_cast<std::size_t>(list)].members;
  return {members.begin() + run.begin, members.begin() + run.end};
}

namespace {

void find_sentences(Parse& parse) {
  Run sentence;
  for (std::uint32_t i = 0; i < parse.tokens.size(); ++i) {
    sentence.end = i + 1;
    if (parse.tokens[i].kind != Token::Kind::stop && i + 1 < parse.tokens.size()) continue;
    parse.sentences.push_back(sentence);
    sentence.begin = i + 1;
  }
}

}  // namespace

Parse parse(std::vector<Token> tokens, const IsName& is_name) {
  Parse result;
  result.tokens = std::move(tokens);
  find_sentences(result);
  const auto pieces = tag(result.tokens, is_name);
  attach(chunk(pieces, result), result);
  return result;
}

Parse parse(std::string_view text, const IsName& is_name) {
  return parse(tokenize(text), is_name);
}

}  // namespace roomgen::language
