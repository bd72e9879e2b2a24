#include "completion.h"

#include <algorithm>

#include "roomgen/base/text.h"

namespace roomgen::repl {

namespace {

std::vector<std::string> starting_with(std::string_view start, const std::vector<std::string>& phrases) {
  std::vector<std::string> found;
  for (const auto& phrase : phrases)
    if (phrase.starts_with(start)) found.push_back(phrase);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// Of sorted phrases: what the first and the last share.
std::size_t common_length(const std::vector<std::string>& sorted) {
  const std::string &first = sorted.front(), &last = sorted.back();
  const auto end = std::mismatch(first.begin(), first.end(), last.begin(), last.end()).first;
  return static_cast<std::size_t>(end - first.begin());
}

Completion completion_of(std::size_t written, std::vector<std::string> choices) {
  Completion result;
  if (choices.empty()) return result;
  result.insert = choices.front().substr(written, common_length(choices) - written);
  if (choices.size() == 1) result.insert += ' ';
  result.choices = std::move(choices);
  return result;
}

bool begins_word(std::string_view text, std::size_t at) { return at == 0 || text[at - 1] == ' '; }

}  // namespace

Completion complete(std::string_view written, const std::vector<std::string>& commands,
                    const std::vector<std::string>& phrases) {
  const std::string text = lower(written);
  // The most words that begin a phrase: "floor l" rather than "l".
  for (std::size_t at = 0; at <= text.size(); ++at) {
    if (!begins_word(text, at)) continue;
    const std::string_view end = std::string_view(text).substr(at);
    auto choices = starting_with(end, phrases);
    if (at == 0) {
      const auto begun = starting_with(end, commands);
      choices.insert(choices.end(), begun.begin(), begun.end());
      std::sort(choices.begin(), choices.end());
    }
    if (!choices.empty()) return completion_of(end.size(), std::move(choices));
  }
  return {};
}

}  // namespace roomgen::repl
