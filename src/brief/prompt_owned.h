#pragma once

#include <map>
#include <optional>
#include <vector>

#include "prompt_reading.h"
#include "prompt_shares.h"

namespace roomgen::brief {

/// Reads what things have: "a desk with a lamp and a chair", "tables, each with two vases". Who has what is remembered,
/// for the words of place that come behind: "a tray with cups on the left".
class OwnedReader {
 public:
  OwnedReader(PromptReading& reading, ShareReader& shares) : reading_(reading), shares_(shares) {}

  /// "with", "has": what comes behind is the first one's, up to what is told to be elsewhere.
  void read(const language::Attachment& attachment);
  /// "two bistro tables by the window, a pair of chairs each": of the last several before it.
  void read_those_behind_each();

  /// "a vanity with a mirror": what hangs on walls is above what stands at one; whether it is.
  bool hang_over(std::size_t owner, std::size_t thing);

  std::optional<std::size_t> owner_of(std::size_t mention) const;
  /// "each with", "every desk has", "each of them holding"
  bool says_each(const language::Attachment& attachment) const;
  /// "each loaded with boxes, a jack by the door, an extinguisher": is it no more of what each has?
  bool is_past_each(const language::Attachment& attachment) const;
  /// "a bed with a lamp, a rack near the door, an armchair": is it behind what has its own place in the room?
  bool goes_on_about_room(const language::Attachment& attachment) const;
  /// "behind it", "on top": whether words at the thing of a phrase say where it is.
  bool is_told_somewhere(std::int32_t phrase) const;

 private:
  bool is_each_behind(const language::NounPhrase& thing) const;
  bool is_reciprocal(const language::NounPhrase& phrase) const;
  template <typename Test>
  bool is_told(std::int32_t phrase, Test test) const;
  bool is_told_in_room(std::int32_t phrase) const;
  bool is_alone_with(const language::Attachment& attachment) const;
  bool is_told_between(std::int32_t phrase) const;
  bool goes_on_beside(const language::Attachment& attachment, std::size_t owner) const;
  bool is_told_at_one(std::int32_t phrase) const;
  bool is_told_at_another(std::int32_t phrase, std::size_t owner) const;
  std::vector<const language::Attachment*> named_before(const language::Attachment& attachment) const;
  bool follows_told_place(const language::Attachment& attachment) const;
  std::optional<std::size_t> several_before(std::size_t phrase) const;

  PromptReading& reading_;
  ShareReader& shares_;
  std::map<std::size_t, std::size_t> owner_of_;  ///< "a tray with cups": mentions
};

}  // namespace roomgen::brief
