#include "heard_measures.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include "complexity.h"

namespace roomgen::compose {

namespace {

bool says_anything(const std::string& text) {
  return std::ranges::any_of(text, [](unsigned char c) { return std::isalnum(c) != 0 || c == '%' || c >= 0x80; });
}

/// Cuts an entry that nobody understood at the ends of spans.
class Cutter {
 public:
  Cutter(const Heard& entry, std::string_view prompt) : entry_(entry), prompt_(prompt), at_(entry.begin) {}

  void cut(const language::Span& span) {
    const std::size_t begin = std::max<std::size_t>(span.begin, at_), end = std::min<std::size_t>(span.end, entry_.end);
    if (begin >= end) return;
    add(begin, Heard::As::not_understood);
    add(end, Heard::As::count);
  }

  std::vector<Heard> take() {
    add(entry_.end, Heard::As::not_understood);
    return std::move(pieces_);
  }

 private:
  void add(std::size_t end, Heard::As as) {
    const auto is_space = [&](std::size_t i) { return std::isspace(static_cast<unsigned char>(prompt_[i])) != 0; };
    std::size_t begin = std::exchange(at_, end);
    while (begin < end && is_space(begin)) ++begin;
    while (begin < end && is_space(end - 1)) --end;
    std::string text(prompt_.substr(begin, end - begin));
    if (says_anything(text)) pieces_.push_back({begin, end, std::move(text), as, {}});
  }

  const Heard& entry_;
  std::string_view prompt_;
  std::size_t at_;  ///< bytes before it are in pieces
  std::vector<Heard> pieces_;
};

}  // namespace

std::vector<Heard> with_measures_heard(std::vector<Heard> heard, std::string_view prompt) {
  const auto spans = complexity_spans(prompt);
  std::vector<Heard> result;
  for (auto& entry : heard) {
    if (entry.as != Heard::As::not_understood || entry.end > prompt.size()) {
      result.push_back(std::move(entry));
      continue;
    }
    Cutter cutter(entry, prompt);
    for (const auto& span : spans) cutter.cut(span);
    std::ranges::move(cutter.take(), std::back_inserter(result));
  }
  return result;
}

}  // namespace roomgen::compose
