#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "prompt_owned.h"
#include "prompt_reading.h"

namespace roomgen::brief {

/// "left of" or "right of" alone.
bool is_beside(const Placement& placement);

/// Says of things that they stand in relation to another, also where the other is not named: "to its left", "overhead",
/// "on either side". Keeps which side of what was told last, since the other side comes next.
class PlaceTeller {
 public:
  PlaceTeller(PromptReading& reading, const OwnedReader& owned);

  /// The words that are read next begin at a token.
  void come_to(std::uint32_t token) { place_at_ = token; }
  /// Of a target that is named.
  void say(const Indices& subjects, const SaidPlacement& said, std::size_t target);
  /// Of what was spoken of before.
  void say_of_implied(const Indices& subjects, const Placement& placement);
  /// What that is, for a relation of things; none if nothing was named that may be meant.
  std::optional<std::size_t> implied(RelationKind kind, const Indices& subjects) const;
  /// Whether something was told to be on another.
  bool stands_on(std::size_t mention, std::size_t target) const;

 private:
  Indices with_kin(const Indices& subjects) const;
  bool is_at_table(const SaidPlacement& said, std::size_t target) const;
  void say_at_table(const Indices& subjects, const SaidPlacement& said, std::size_t target);
  const Placement& at_long_sides(const Placement& placement, const Indices& subjects, std::size_t target) const;
  bool hangs_over(std::size_t target, const Indices& subjects) const;
  bool is_seen_from_door() const;
  std::optional<std::size_t> told_by_it(const Indices& subjects) const;
  std::optional<std::size_t> other_side_of(const Placement& placement, const Indices& subjects) const;

  PromptReading& reading_;
  const OwnedReader& owned_;
  const std::vector<language::Run> views_;                         ///< "as you come in"
  std::uint32_t place_at_ = 0;                                     ///< token
  std::optional<std::pair<RelationKind, std::size_t>> last_side_;  ///< left or right of which mention
};

}  // namespace roomgen::brief
