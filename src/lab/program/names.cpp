#include "names.h"

#include <algorithm>

#include "limits.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

constexpr std::size_t most_listed = 20;

// What begins a word with another meaning, or would part a JSON pointer.
bool is_fit(char c) { return static_cast<unsigned char>(c) >= ' ' && std::string_view("/~$@\"\\\x7f").find(c) == std::string_view::npos; }

}  // namespace

bool is_program_name(std::string_view text) {
  if (text.empty() || text.size() > program_limits::name_bytes || text.front() == '-') return false;
  return trim(text) == text && std::all_of(text.begin(), text.end(), is_fit);
}

bool is_given_set(std::string_view text) {
  return std::find(given_sets.begin(), given_sets.end(), text) != given_sets.end();
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  const std::string close = closest_name(word, known);
  if (!close.empty()) return "; did you mean \"" + close + "\"?";
  if (known.empty() || known.size() > most_listed) return "";
  return "; known are " + join(known, ", ");
}

}  // namespace roomgen::lab
