#include "journal_line.h"

#include "base/sha256.h"

namespace roomgen {

namespace {

constexpr std::string_view before_sum = R"({"sum":")", before_body = R"(","entry":)", after_body = "}";
constexpr std::size_t sum_digits = 16;

std::string sum_of(std::string_view body) { return sha256_hex(body).substr(0, sum_digits); }

}  // namespace

std::string journal_line(std::string_view body) {
  std::string line(before_sum);
  line += sum_of(body);
  line += before_body;
  line += body;
  line += after_body;
  return line += '\n';
}

std::optional<std::string_view> journal_body(std::string_view line) {
  constexpr std::size_t head = before_sum.size() + sum_digits + before_body.size();
  if (line.size() <= head + after_body.size() || !line.starts_with(before_sum) || !line.ends_with(after_body))
    return std::nullopt;
  if (line.substr(before_sum.size() + sum_digits, before_body.size()) != before_body) return std::nullopt;
  const auto body = line.substr(head, line.size() - head - after_body.size());
  if (line.substr(before_sum.size(), sum_digits) != sum_of(body)) return std::nullopt;
  return body;
}

JournalLines split_journal(std::string_view bytes) {
  JournalLines found;
  std::vector<JournalLine> all;
  std::size_t whole = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto end = bytes.find('\n', at);
    if (end == std::string_view::npos) break;
    const auto body = journal_body(bytes.substr(at, end - at));
    all.push_back({all.size() + 1, at, body.value_or(std::string_view())});
    at = end + 1;
    if (!body) continue;
    whole = all.size();
    found.whole_bytes = at;
  }
  all.resize(whole);
  found.lines = std::move(all);
  return found;
}

}  // namespace roomgen
