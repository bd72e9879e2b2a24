#include "mark_names.h"

#include <algorithm>
#include <set>

#include "roomgen/base/text.h"

namespace roomgen::detail {

namespace {

constexpr int most_spelled_out = 3;  // things of one kind

int number_of(const std::string& id) {
  return std::atoi(id.c_str() + id.rfind('-') + 1);
}

// The words' first letters; where those are taken, more of the last word.
std::string initials(const std::string& kind, const std::set<std::string>& taken) {
  std::string letters;
  std::size_t last = 0;
  for (std::size_t i = 0; i < kind.size(); ++i)
    if (std::isalpha(static_cast<unsigned char>(kind[i])) && (i == 0 || kind[i - 1] == ' '))
      letters += kind[last = i];
  while (taken.contains(letters) && ++last < kind.size()) letters += kind[last];
  return letters;
}

}  // namespace

MarkNames::MarkNames(const std::vector<std::string>& ids) {
  for (const auto& id : ids) ++counts_[kind_of(id)];
  std::set<std::string> taken = {""};
  for (const auto& [kind, count] : counts_) {
    const std::string letters = initials(kind, taken);
    if (count > most_spelled_out && taken.insert(letters).second) brief_[kind] = letters;
  }
}

void MarkNames::spell_out_rarest() {
  const auto rarest = std::min_element(brief_.begin(), brief_.end(), [&](const auto& a, const auto& b) {
    return counts_.at(a.first) < counts_.at(b.first);
  });
  if (rarest != brief_.end()) brief_.erase(rarest);
}

std::string MarkNames::of(const std::string& id) const {
  const auto found = brief_.find(kind_of(id));
  return found == brief_.end() ? id : found->second + id.substr(id.rfind('-') + 1);
}

std::string MarkNames::of(const std::vector<std::string>& ids) const {
  if (ids.size() == 1) return of(ids.front());
  std::vector<int> numbers;
  for (const auto& id : ids) numbers.push_back(number_of(id));
  std::sort(numbers.begin(), numbers.end());
  std::vector<std::string> runs;
  for (std::size_t i = 0, end = 0; i < numbers.size(); i = end) {
    for (end = i + 1; end < numbers.size() && numbers[end] == numbers[end - 1] + 1;) ++end;
    runs.push_back(std::to_string(numbers[i]));
    if (end > i + 1) runs.back() += ".." + std::to_string(numbers[end - 1]);
  }
  return brief_.at(kind_of(ids.front())) + join(runs, ",");
}

std::vector<std::string> MarkNames::legend() const {
  std::vector<std::string> lines;
  for (const auto& [kind, letters] : brief_) lines.push_back(letters + " = " + kind);
  return lines;
}

}  // namespace roomgen::detail
