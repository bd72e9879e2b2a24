#include "roomgen/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace roomgen {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

char lower_char(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Bytes above 127 are parts of UTF-8 letters.
bool is_word_char(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) > 127;
}

// The bytes of the UTF-8 character that the text begins with; 0 if there is none.
std::size_t utf8_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t size = byte(0) < 0x80   ? 1
                           : byte(0) < 0xC2 ? 0
                           : byte(0) < 0xE0 ? 2
                           : byte(0) < 0xF0 ? 3
                           : byte(0) < 0xF5 ? 4
                                            : 0;
  if (size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  return size;
}

// Control characters (C0 but line ends, DEL, C1) and those that turn the direction of writing (Unicode
// Standard Annex 9: U+202A to U+202E, U+2066 to U+2069).
bool steers_terminal(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return (byte(0) < 32 && character != "\n" && character != "\t") || byte(0) == 127;
  if (character.size() == 2) return byte(0) == 0xC2 && byte(1) < 0xA0;
  if (character.size() != 3 || byte(0) != 0xE2) return false;
  return (byte(1) == 0x80 && byte(2) >= 0xAA && byte(2) <= 0xAE) ||
         (byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9);
}

}  // namespace

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), lower_char);
  return result;
}

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> pieces;
  while (true) {
    const auto end = text.find(separator);
    pieces.emplace_back(trim(text.substr(0, end)));
    if (end == std::string_view::npos) return pieces;
    text.remove_prefix(end + 1);
  }
}

std::string join(const std::vector<std::string>& pieces, std::string_view separator) {
  std::string result;
  for (const auto& piece : pieces) {
    if (&piece != &pieces.front()) result += separator;
    result += piece;
  }
  return result;
}

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> result;
  std::string word;
  for (char c : text) {
    c = lower_char(c);
    if (is_word_char(c)) {
      word += c;
    } else if (!word.empty()) {
      result.push_back(std::move(word));
      word.clear();
    }
  }
  if (!word.empty()) result.push_back(std::move(word));
  return result;
}

std::string format_number(double value, int decimals) {
  if (!std::isfinite(value) || std::abs(value) > 1e12) return "?";
  const double scale = std::pow(10.0, decimals);
  auto digits = static_cast<std::int64_t>(std::llround(std::abs(value) * scale));
  const bool negative = value < 0 && digits != 0;
  std::string fraction;
  for (int i = 0; i < decimals; ++i, digits /= 10) {
    const char digit = static_cast<char>('0' + digits % 10);
    if (digit != '0' || !fraction.empty()) fraction.insert(fraction.begin(), digit);
  }
  std::string result = (negative ? "-" : "") + std::to_string(digits);
  return fraction.empty() ? result : result + "." + fraction;
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t size = utf8_size(text);
    const auto character = text.substr(0, std::max<std::size_t>(size, 1));
    result += size > 0 && !steers_terminal(character) ? character : "?";
    text.remove_prefix(character.size());
  }
  return result;
}

std::string shortened(std::string text, std::size_t limit) {
  if (text.size() <= limit) return text;
  while (limit > 0 && (static_cast<unsigned char>(text[limit]) & 0xC0) == 0x80) --limit;
  return text.substr(0, limit);  // and not the memory of all of it
}

std::string singular(std::string word) {
  const auto ends = [&](std::string_view ending) {
    return word.size() > ending.size() + 1 && word.ends_with(ending);
  };
  if (word.ends_with("shelves")) return word.substr(0, word.size() - 3) + "f";
  if (ends("ches") || ends("shes") || ends("sses") || ends("xes"))
    return word.substr(0, word.size() - 2);
  if (ends("ies") && word != "movies") return word.substr(0, word.size() - 3) + "y";
  if (ends("s") && !ends("ss") && !ends("us") && !ends("is") && word != "canvas")
    return word.substr(0, word.size() - 1);
  return word;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Three rows of the table: this one and the two before it, for swapped neighbours.
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({row[j - 1] + 1, last[j] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

std::string closest_name(std::string_view name, const std::vector<std::string>& names) {
  constexpr std::size_t longest_name = 60;  // what is longer is no slip of the pen, and would take long to compare
  std::string best;
  if (name.size() > longest_name) return best;
  std::size_t best_distance = std::max<std::size_t>(1, name.size() / 4) + 1;
  for (const auto& candidate : names) {
    const std::size_t longer = std::max(name.size(), candidate.size()) - std::min(name.size(), candidate.size());
    if (longer >= best_distance) continue;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace roomgen
