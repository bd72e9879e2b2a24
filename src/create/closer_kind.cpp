#include <algorithm>

#include "roomgen/base/text.h"
#include "rule_steps.h"

namespace roomgen::create {

namespace {

bool is_any(const std::string& word, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// "for the wall", "wall-mounted", "fixed to the ceiling"; what leans against a wall stands on the floor.
std::string place_said(const std::string& prompt) {
  const auto pieces = words(prompt);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!is_any(pieces[i], {"wall", "ceiling", "corner"})) continue;
    if (i + 1 < pieces.size() && is_any(pieces[i + 1], {"mounted", "hung", "hanging"})) return pieces[i];
    if (i > 1 && is_any(pieces[i - 1], {"the", "a"}) && is_any(pieces[i - 2], {"for", "on", "to", "in", "from"}))
      return pieces[i];
  }
  return "";
}

const ShapeKind* first_of(const std::vector<std::string>& names, const ShapeKinds& kinds) {
  for (const auto& name : names)
    if (const ShapeKind* kind = kinds.find(name)) return kind;
  return nullptr;
}

}  // namespace

const ShapeKind* closer_kind(const Description& description, const ShapeKinds& kinds) {
  if (description.approximate || description.kind.empty() || !description.relation.empty()) return nullptr;
  const std::string& noun = description.noun;
  std::vector<std::string> names;
  if (const std::string place = place_said(description.prompt); !place.empty())
    names = {place + " " + noun, noun + " " + place, place + " " + description.kind};
  for (const auto& part : description.parts)
    if (part.label == "pole" && part.course == Course::arc) names.push_back("arc " + noun);
  for (const auto& part : description.parts)
    if (!part.label.empty() && part.count.value_or(1) > 0)
      for (const char* joint : {" of ", " with "})
        for (const char* ending : {"s", ""}) names.push_back(noun + joint + part.label + ending);
  return first_of(names, kinds);
}

}  // namespace roomgen::create
