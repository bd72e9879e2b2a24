#pragma once

#include <cstdint>
#include <optional>

#include "prompt_reading.h"

namespace roomgen::brief {

/// Tells whether a noun phrase names a thing of the room, or something that is said of others: stuff, a person, a tone, a
/// part, what somebody does. Reads only.
class ThingOrNot {
 public:
  explicit ThingOrNot(const PromptReading& reading) : reading_(reading) {}

  bool names_thing(std::int32_t phrase, const ThingPhrase& thing) const;
  /// "a desk with drawers", "with an integrated sink": what has it as a part.
  std::optional<std::size_t> owner_of_part(std::int32_t phrase, const ThingPhrase& thing) const;
  /// "bangs a hammer": neither a verb of how things stand or look, nor one in the passive.
  bool does_something(const language::VerbPhrase& verb) const;

 private:
  bool gives_reason(const language::NounPhrase& said) const;
  bool is_who_it_is_for(std::int32_t id) const;
  bool is_formation(std::int32_t id) const;
  bool is_number(std::int32_t id) const;
  bool is_talked_about(std::int32_t id) const;
  bool is_handled(std::int32_t id) const;
  bool names_tone(const language::NounPhrase& said, const ThingPhrase& thing) const;
  bool is_bare_material(const ThingPhrase& thing) const;
  bool is_light(const language::NounPhrase& said, const ThingPhrase& thing) const;
  bool is_new_thing(std::int32_t id, const ThingPhrase& thing) const;
  bool begins_with_place(std::int32_t id) const;
  bool may_stand_there(std::int32_t id, const std::string& noun) const;
  static bool names_artefact(const std::string& noun);
  bool introduces(const language::Attachment& attachment) const;
  bool is_inside(std::int32_t id) const;
  bool names_owner(std::int32_t id) const;
  bool tells_what_it_is_of(std::int32_t id, const ThingPhrase& thing) const;
  bool is_of_owner(std::int32_t id, const ThingPhrase& thing) const;
  bool is_built_in(const ThingPhrase& thing) const;
  bool is_listed_with_thing(const language::Attachment& attachment) const;

  const PromptReading& reading_;
};

}  // namespace roomgen::brief
