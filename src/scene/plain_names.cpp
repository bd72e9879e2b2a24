#include "plain_names.h"

#include <algorithm>

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

// With a number behind it a name stays below Blender's 63 bytes.
constexpr std::size_t longest_plain = 52;

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

std::string_view without_edges(std::string_view name) {
  const auto first = name.find_first_not_of(" .");
  if (first == std::string_view::npos) return {};
  return name.substr(first, name.find_last_not_of(" .") - first + 1);
}

}  // namespace

std::string plain_name(std::string_view text) {
  std::string name;
  bool is_run = false;  // of what has no place in a name
  for (const char c : text) {
    const bool is_plain = is_letter_or_digit(c) || c == ' ' || c == '-' || c == '_' || c == '.';
    if (is_plain || !is_run) name += is_plain ? c : '_';
    is_run = !is_plain;
  }
  name = std::string(without_edges(without_edges(name).substr(0, longest_plain)));
  return std::any_of(name.begin(), name.end(), is_letter_or_digit) ? name : "";
}

std::string threejs_name(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c == ' ' || (c >= '\t' && c <= '\r')) result += '_';
    else if (std::string_view("[].:/").find(c) == std::string_view::npos) result += c;
  }
  return result;
}

std::string PlainNames::take(std::string_view text, std::string_view otherwise) {
  std::string stem = plain_name(text);
  if (stem.empty()) stem = plain_name(otherwise);
  if (stem.empty()) stem = "thing";
  std::string name = stem;
  const auto is_new = [&] { return taken_.insert(lower(threejs_name(name))).second; };
  if (is_new()) return name;
  int& number = last_number_.emplace(stem, 1).first->second;
  do name = stem + " " + std::to_string(++number);
  while (!is_new());
  return name;
}

std::vector<std::string> node_names(const Scene& scene, PlainNames& names) {
  std::vector<std::string> result;
  for (const auto& object : scene.objects) result.push_back(names.take(object.id, object.category));
  return result;
}

}  // namespace roomgen
