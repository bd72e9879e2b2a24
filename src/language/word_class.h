#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace roomgen::language {

enum class PartOfSpeech : std::uint8_t { noun, verb, adjective, adverb };

/// What a word may stand for. Classes overlap: a garment is an artefact, a person is living. Which
/// synsets are at the top of each class stands in data/language/word-classes.txt.
enum class WordClass : std::uint8_t {
  activity,
  animal,
  appliance,
  art,
  artefact,
  attribute,
  body_part,
  building,
  color,
  container,
  covering,
  event,
  feeling,
  fixture,
  food,
  furnishing,
  furniture,
  garment,
  group,
  instrument,
  material,
  message,
  person,
  place,
  plant,
  quantity,
  room,
  shape,
  substance,
  time,
  toy,
  vehicle
};

inline constexpr std::array<std::string_view, 32> word_class_names = {
    "activity",  "animal",     "appliance", "art",      "artefact", "attribute",  "body part",
    "building",  "color",      "container", "covering", "event",    "feeling",    "fixture",
    "food",      "furnishing", "furniture", "garment",  "group",    "instrument", "material",
    "message",   "person",     "place",     "plant",    "quantity", "room",       "shape",
    "substance", "time",       "toy",       "vehicle"};

constexpr std::string_view name_of(WordClass word_class) {
  return word_class_names[static_cast<std::size_t>(word_class)];
}

}  // namespace roomgen::language
