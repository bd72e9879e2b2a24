#include "description_words.h"

#include <utility>

#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

constexpr std::pair<Course, std::string_view> courses[] = {
    {Course::straight, "straight"}, {Course::arc, "arc"},       {Course::s_curve, "s-curve"},
    {Course::taper, "taper"},       {Course::spiral, "spiral"}, {Course::wave, "wave"}};
constexpr std::pair<Strength, std::string_view> strengths[] = {
    {Strength::gentle, "gentle"},
    {Strength::moderate, "moderate"},
    {Strength::pronounced, "pronounced"}};
constexpr std::pair<Place, std::string_view> places[] = {
    {Place::foot, "foot"},     {Place::base, "base"},     {Place::deck, "deck"},
    {Place::column, "column"}, {Place::upright, "upright"}, {Place::across, "across"},
    {Place::stack, "stack"},   {Place::helix, "helix"},   {Place::radial, "radial"},
    {Place::wheel, "wheel"},   {Place::around, "around"}, {Place::front, "front"},
    {Place::side, "side"},     {Place::back, "back"},     {Place::top, "top"},
    {Place::hang, "hang"}};

template <typename T, std::size_t N>
std::string_view name_in(const std::pair<T, std::string_view> (&table)[N], T wanted) {
  for (const auto& [value, text] : table)
    if (value == wanted) return text;
  return table[0].second;
}

template <typename T, std::size_t N>
std::optional<T> value_in(const std::pair<T, std::string_view> (&table)[N], std::string_view text) {
  for (const auto& [value, name] : table)
    if (words(name) == words(text)) return value;
  return std::nullopt;
}

template <typename T, std::size_t N>
std::vector<std::string> names_in(const std::pair<T, std::string_view> (&table)[N]) {
  std::vector<std::string> names;
  for (const auto& [value, name] : table) names.emplace_back(name);
  return names;
}

}  // namespace

std::string_view name(Course course) {
  return name_in(courses, course);
}
std::string_view name(Strength strength) {
  return name_in(strengths, strength);
}
std::optional<Course> course_named(std::string_view text) {
  return value_in(courses, text);
}
std::optional<Strength> strength_named(std::string_view text) {
  return value_in(strengths, text);
}
std::optional<Place> place_named(std::string_view text) {
  return value_in(places, text);
}
std::vector<std::string> course_names() {
  return names_in(courses);
}
std::vector<std::string> strength_names() {
  return names_in(strengths);
}

}  // namespace roomgen::create
