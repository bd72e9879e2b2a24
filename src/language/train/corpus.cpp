#include "corpus.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tag_model.h"

namespace roomgen::language {

namespace {

struct TaggedWord {
  std::size_t end = 0;  ///< in the text
  char tag = 0;         ///< 0: a mark
};

std::vector<TaggedWord> read_words(const std::string& line, std::string& text) {
  std::vector<TaggedWord> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) {
    TaggedWord tagged;
    if (const auto slash = word.rfind('/'); slash != std::string::npos && slash > 0) {
      if (slash + 2 != word.size() || word_tag_letters.find(word.back()) == std::string_view::npos)
        throw std::runtime_error("no tag: " + word);
      tagged.tag = word.back();
      word.resize(slash);
    }
    text += (text.empty() ? "" : " ") + word;
    tagged.end = text.size();
    words.push_back(tagged);
  }
  return words;
}

TaggedSentence read_sentence(const std::string& line) {
  TaggedSentence sentence;
  const auto words = read_words(line, sentence.text);
  sentence.tokens = tokenize(sentence.text);
  sentence.units = units(sentence.tokens);
  sentence.facts = facts_of(sentence.tokens, sentence.units);
  std::size_t word = 0;
  for (const Unit& unit : sentence.units) {
    const std::size_t end = sentence.tokens[unit.tokens.end - 1].span.end;
    while (word + 1 < words.size() && words[word].end < end) ++word;
    const auto given = given_tag(unit);
    if (!given && words[word].tag == 0)
      throw std::runtime_error("a word without a tag: " + sentence.text);
    sentence.tags.push_back(given ? *given
                                  : static_cast<WordTag>(word_tag_letters.find(words[word].tag)));
  }
  return sentence;
}

}  // namespace

std::vector<TaggedSentence> read_corpus(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error("cannot read " + path);
  std::vector<TaggedSentence> result;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.empty() || line.starts_with('#')) continue;
    try {
      result.push_back(read_sentence(line));
    } catch (const std::exception& problem) {
      throw std::runtime_error(path + ":" + std::to_string(number) + ": " + problem.what());
    }
  }
  return result;
}

}  // namespace roomgen::language
