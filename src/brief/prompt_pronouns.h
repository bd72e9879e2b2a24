#pragma once

#include <cstdint>
#include <optional>

#include "prompt_reading.h"

namespace roomgen::brief {

/// Finds what words that stand for something mean: "it", "each of them", "both", "the other".
class PronounReader {
 public:
  explicit PronounReader(PromptReading& reading) : reading_(reading) {}

  /// Enters what a pronoun means into the reading: one mention, and of "them" and "both" the others too.
  void read(std::int32_t phrase);
  /// What the clauses before were about.
  std::optional<std::size_t> topic_before(std::int32_t phrase) const;
  /// What a pronoun means, or the owner of "its shelf".
  std::optional<std::size_t> stands_for(std::int32_t phrase) const;

 private:
  std::optional<std::size_t> same_each_before(std::int32_t phrase) const;
  std::optional<std::size_t> named_behind(std::int32_t id) const;
  bool means_nothing(const language::NounPhrase& said) const;
  bool is_one_of_several(const language::NounPhrase& said) const;
  bool means_all(const language::NounPhrase& said) const;
  Indices several_before(std::int32_t phrase) const;
  Indices members_named(std::int32_t phrase, std::int32_t before, const Indices& subjects) const;
  Indices pair_before(std::int32_t phrase, const Indices& subjects) const;
  Indices subjects_at(std::int32_t phrase) const;
  bool is_several(std::size_t mention, std::int32_t pronoun) const;
  std::optional<std::size_t> same_as_before(std::int32_t phrase, const Indices& subjects) const;
  std::optional<std::size_t> what_is_faced(const language::Attachment& attachment, const Indices& subjects) const;
  bool is_of_them(std::int32_t phrase) const;
  Indices what_stands_at(std::int32_t phrase) const;
  std::optional<std::size_t> carrier_before(const language::Attachment& attachment) const;
  std::optional<std::size_t> small_neighbour(const language::Attachment& attachment, const Indices& subjects) const;
  std::optional<std::size_t> what_hangs_over(const language::Attachment& attachment) const;
  bool is_told_on_wall(std::int32_t phrase) const;
  std::optional<std::size_t> last_in_sentence(std::int32_t phrase) const;
  std::optional<std::size_t> owner_of(std::int32_t phrase) const;
  std::optional<std::size_t> what_was_placed(const language::Attachment& with) const;
  std::optional<std::size_t> subject_before(const language::Attachment& with) const;

  PromptReading& reading_;
};

}  // namespace roomgen::brief
