#include "target_names.h"

#include <algorithm>

#include "roomgen/base/text.h"
#include "scene/room_part.h"

namespace roomgen::design {

namespace {

constexpr std::size_t longest_target_name = 80;  ///< bytes

bool is_number(const std::string& word) {
  return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
}

bool is_article(const std::string& word) {
  return word == "the" || word == "a" || word == "an" || word == "its" || word == "existing";
}

struct Name {
  std::string base, number;
};

// "coffee table" and "0"
Name name_of(std::vector<std::string> words) {
  Name name;
  if (!words.empty() && is_number(words.back())) {
    name.number = words.back();
    words.pop_back();
  }
  name.base = join(words, " ");
  return name;
}

std::string in_quotes(std::string_view name) {
  return "\"" + std::string(name) + "\"";
}

}  // namespace

TargetNames::TargetNames(const Scene& scene, const Object& object, const KindTable& categories)
    : categories_(categories), self_(words(object.id)) {
  for (const auto& other : scene.objects)
    if (other.id != object.id) add(other.id, true);
  for (const auto& opening : scene.room.openings) add(opening.id, false);
  for (std::size_t k = 0; k < scene.room.polygon.size(); ++k)
    add("wall-" + std::to_string(k), false);
  add("corner", false);
  for (const auto& region : region_names()) {
    add(region, false);
    entries_.back().region = true;
  }
}

void TargetNames::add(const std::string& id, bool thing) {
  auto name = name_of(words(id));
  entries_.push_back({id, std::move(name.base), std::move(name.number), thing});
}

bool TargetNames::is_self(const std::vector<std::string>& words) const {
  return words == self_;
}

std::string TargetNames::spelt(const std::vector<std::string>& words) const {
  const Name name = name_of(words);
  for (const auto& entry : entries_)
    if (entry.base == name.base && entry.number == name.number) return entry.id;
  return "";
}

TargetNames::Entries TargetNames::of_base(const std::string& base,
                                          const std::string& number) const {
  std::vector<const Entry*> found;
  for (const auto& entry : entries_)
    if ((number.empty() || entry.number == number) &&
        (entry.base == base || entry.base == singular(base)))
      found.push_back(&entry);
  return found;
}

// A couch may be a sofa, and so may a corner sofa.
TargetNames::Entries TargetNames::of_kind(const std::string& base,
                                          const std::string& number) const {
  std::vector<const Entry*> found;
  const Kind* kind = categories_.find(base);
  for (const auto& entry : entries_)
    if (kind && entry.thing && (number.empty() || entry.number == number) &&
        categories_.is_a(entry.base, kind->name))
      found.push_back(&entry);
  return found;
}

// Only among names of the same number: "chair-3" is no misspelling of "chair-2".
TargetNames::Entries TargetNames::misspelt(const std::string& base,
                                           const std::string& number) const {
  if (base.size() < 3) return {};
  std::vector<std::string> known;
  for (const auto& entry : entries_)
    if (!entry.region && (entry.number == number || number.empty())) known.push_back(entry.base);
  return of_base(closest_name(base, known), number);
}

NamedTarget TargetNames::find(std::string_view text) const {
  if (text.size() > longest_target_name) return {"", "a target's name was too long"};
  auto pieces = words(text);
  while (!pieces.empty() && is_article(pieces.front())) pieces.erase(pieces.begin());
  if (pieces.empty()) return {"", "a target's name was empty"};
  if (is_self(pieces)) return {"", in_quotes(text) + " is the object itself"};
  if (const std::string id = spelt(pieces); !id.empty())
    return {id, id == text ? "" : in_quotes(text) + " was read as " + in_quotes(id)};
  const Name name = name_of(pieces);
  auto meant = of_base(name.base, name.number);
  if (meant.empty()) meant = misspelt(name.base, name.number);
  if (meant.empty()) meant = of_kind(name.base, name.number);
  if (meant.size() > 1) return {"", in_quotes(text) + " may mean several objects; use their ids"};
  if (!meant.empty())
    return {meant.front()->id, in_quotes(text) + " was read as " + in_quotes(meant.front()->id)};
  return {"", in_quotes(text) + " is not in the room; name only what is placed already"};
}

}  // namespace roomgen::design
