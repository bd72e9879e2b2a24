#pragma once

#include <map>
#include <set>

#include "prompt_reading.h"

namespace roomgen::brief {

/// Reads what there is for each of several: "a lamp on each desk", "a plant in every corner", "one
/// chair per desk". As many are planned as there are owners, once for each thing, and the brief
/// keeps what was shared out.
class ShareReader {
 public:
  explicit ShareReader(PromptReading& reading) : reading_(reading) {}

  /// "a lamp on each nightstand", "desks, each with two drawers": as many for each of the owners as
  /// were said of one. `at`: the token of what says so.
  void give_each(std::size_t owner, const Indices& things, std::uint32_t at);
  /// "a curtain between every two beds", "a candle on every other table": of how many of the owners
  /// something is said, where it is of some.
  std::optional<int> number_of_some(std::size_t owner, const language::NounPhrase& said, bool between) const;
  void give_some(int number, const Indices& things, const language::NounPhrase& owner);
  /// "a plant in each corner", "a bench under every window"
  void give_each_place(const PlacePhrase& place, const Indices& things, std::uint32_t at);
  /// "every window has a bench below it", "each corner has a plant": whether that is what an
  /// attachment says. What is said of where those things are to "it", is said of that place.
  bool give_what_each_place_has(const language::Attachment& attachment);
  /// Which part of the room has a thing so; null if none has.
  const PlacePhrase* place_having(std::size_t thing) const;
  /// "eight chairs on either side" are sixteen, but "two lamps on either side" are two; "two chairs
  /// on each side" of a table are four.
  void give_each_side(const language::Attachment& attachment, const Indices& things);
  /// "a stool for each potter's wheel", "one chair per desk": nothing is said of where they are, so
  /// by those that they are for. Other attachments are left alone.
  void read_for_each(const language::Attachment& attachment);

 private:
  bool is_for_each(const language::Attachment& attachment) const;
  bool says_for_each(const language::Attachment& attachment) const;
  bool is_for_each_person(const language::Attachment& attachment) const;
  /// One for each of so many at least, where a plural was said without a number.
  void have_for_each(std::size_t thing, int number);
  void give_each_person(const language::Attachment& attachment);
  bool is_tied(std::size_t thing, std::size_t owner) const;
  bool has_parts(std::size_t thing) const { return reading_.talk.with_parts(thing).size() > 1; }
  int number_of(std::size_t owner) const;
  void share(SharedOut shared, std::uint32_t at);
  std::optional<std::uint32_t> each_around(std::uint32_t token) const;
  void give_what_carries(std::size_t owner, std::size_t thing, std::uint32_t at);

  int doors_said() const;

  PromptReading& reading_;
  std::map<std::size_t, PlacePhrase> place_of_;  ///< by mention
  std::set<std::size_t> given_;  ///< mentions that each of others has
};

}  // namespace roomgen::brief
