#include "foreign.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/resource.h"
#include "function_word.h"
#include "roomgen/base/json.h"
#include "small_words.h"

namespace roomgen::language {

namespace {

constexpr const char* foreign_path = "data/language/foreign.json";
constexpr std::ptrdiff_t fewest = 2;

struct SmallWordsOf {
  ForeignLanguage language;
  Words words;
};

std::vector<SmallWordsOf> read_languages() {
  std::vector<SmallWordsOf> languages;
  const auto json = parse_json(resource(foreign_path).value_or("{}"), foreign_path);
  if (!json) return languages;
  JsonReader::Problems problems(foreign_path);
  const JsonReader root(*json, problems);
  for (const auto& [name, entry] : root["languages"].members()) {
    SmallWordsOf one{{name, entry["refusal"].text(1000)}, {}};
    for (const auto& word : entry["words"].elements(1000)) one.words.insert(word.text(50));
    languages.push_back(std::move(one));
  }
  return languages;
}

}  // namespace

std::optional<ForeignLanguage> foreign_language(const std::vector<Token>& tokens) {
  static const auto languages = read_languages();
  const auto is_word = [](const Token& token) { return token.kind == Token::Kind::word; };
  const auto english = std::count_if(tokens.begin(), tokens.end(), [&](const Token& token) {
    return is_word(token) && is_function_word(token);
  });
  const SmallWordsOf* best = nullptr;
  std::ptrdiff_t most = std::max(english, fewest - 1);
  for (const auto& one : languages) {
    const auto there = std::count_if(tokens.begin(), tokens.end(), [&](const Token& token) {
      return is_word(token) && one.words.count(token.text) > 0;
    });
    if (there <= most) continue;
    most = there;
    best = &one;
  }
  if (!best) return std::nullopt;
  return best->language;
}

}  // namespace roomgen::language
