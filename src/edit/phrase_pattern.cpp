#include "phrase_pattern.h"

#include <algorithm>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

// Between brackets the ways to go on; else the words themselves.
std::vector<std::string> choices_of(std::string_view piece) {
  return split(piece, '|');
}

std::string joined_words(const std::string& first, const std::string& second) {
  return first.empty() ? second : second.empty() ? first : first + " " + second;
}

std::vector<std::string> each_with_each(const std::vector<std::string>& before,
                                        const std::vector<std::string>& choices) {
  std::vector<std::string> all;
  for (const auto& start : before)
    for (const auto& choice : choices) all.push_back(joined_words(start, choice));
  return all;
}

}  // namespace

std::vector<std::string> phrases_of(std::string_view pattern) {
  std::vector<std::string> phrases = {""};
  while (!pattern.empty()) {
    const bool is_choice = pattern.front() == '(';
    if (is_choice) pattern.remove_prefix(1);
    const std::size_t end = std::min(pattern.find(is_choice ? ')' : '('), pattern.size());
    phrases = each_with_each(phrases, is_choice ? choices_of(pattern.substr(0, end))
                                                : std::vector{std::string(trim(pattern.substr(0, end)))});
    pattern.remove_prefix(std::min(end + (is_choice ? 1 : 0), pattern.size()));
  }
  return phrases;
}

}  // namespace roomgen
