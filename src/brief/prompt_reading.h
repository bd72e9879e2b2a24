#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brief.h"
#include "discourse.h"
#include "hearing.h"
#include "placement.h"
#include "room_kinds.h"
#include "thing_phrase.h"

namespace roomgen::brief {

/// What the words of a prompt that are no things were taken for, by token.
enum class Taken : std::uint8_t { no, yes, room };

/// What the tokens that the readers of measures, people, shapes, rooms and finishes left say of all
/// `count`.
std::vector<Taken> taken_from(std::size_t count, const std::vector<Token>& left);

/// A prompt while it is read: its parse, what each part of it would mean, and what it was taken for
/// so far. The readers of openings, things, people and places work on it, each on its own words.
struct PromptReading {
  PromptReading(const PromptText& said, std::vector<Token> untaken, std::vector<Taken> already,
                const Lexicon& names, const RoomKinds& rooms, Brief& result);

  const language::NounPhrase& phrase(std::int32_t i) const {
    return parse.phrases[static_cast<std::size_t>(i)];
  }
  const ThingPhrase& thing(std::int32_t phrase) const {
    return things[static_cast<std::size_t>(phrase)];
  }
  const std::optional<SaidPlacement>& placement(const language::Attachment& attachment) const {
    return placements[static_cast<std::size_t>(&attachment - parse.attachments.data())];
  }
  std::optional<std::size_t> mention_of(std::int32_t phrase) const {
    return phrase == language::none ? std::nullopt : mentions[static_cast<std::size_t>(phrase)];
  }
  const std::string& word(std::size_t token) const { return text.plain[token].text; }
  bool is_word(std::size_t token, std::string_view word) const {
    return token < text.plain.size() && text.plain[token].is_word(word);
  }
  bool is_taken(const language::NounPhrase& phrase) const {
    return taken[phrase.head] != Taken::no;
  }
  bool is_room(const language::NounPhrase& phrase) const {
    return taken[phrase.head] == Taken::room || words.generic_rooms.count(word(phrase.head));
  }
  /// "my uncle", "two cats"
  bool is_somebody(const language::NounPhrase& phrase) const;
  /// "the corner", "the northern half": the part of the room that a phrase names.
  std::optional<PlacePhrase> place_named(const language::NounPhrase& phrase) const {
    return read_place(text.plain, phrase.tokens.begin, words);
  }
  int sentence_of(std::size_t token) const;
  /// "On the desk:", "Chairs:": what comes behind is announced.
  bool announces(const language::Run& sentence) const;
  /// "not too modern", "nothing rustic"
  bool is_denied(std::size_t token) const;
  /// By token: whether it was heard as something.
  std::vector<bool> heard_tokens() const;
  /// The same, without words that say where something is and say it of nothing: "in winter".
  std::vector<bool> tokens_with_sense() const;

  /// What was said up to a token: "it" means nothing that comes behind.
  void look_back_from(std::size_t token);
  /// "with", "has": what follows is the first one's.
  bool owns(const language::Attachment& attachment) const;
  /// What a noun phrase means, with the parts of which more is said elsewhere.
  Indices all_of(std::int32_t phrase) const;
  /// The mentions of which a place is said.
  Indices subjects_of(const language::Attachment& attachment) const;
  Indices mentions_of_list(std::int32_t phrase) const;
  /// The mentions of the noun phrases before a token in its sentence, in the order of the text.
  Indices named_before(std::size_t token) const;
  /// "a stool" of "a stool and a trolley next to each": what a phrase of a list is joined to right before it.
  std::optional<std::size_t> joined_before(std::int32_t phrase) const;
  bool means_some(std::int32_t phrase) const { return is_share[static_cast<std::size_t>(phrase)]; }
  /// "a vase on it", "a bench below it": is that where the thing of a phrase is?
  bool is_told_at_pronoun(std::int32_t phrase) const;

  const PromptText& text;
  const language::Parse& parse;
  const RoomKinds& kinds;
  const std::vector<Token> left;  ///< what the readers before did not take, lengths in one piece
  std::vector<Taken> taken;
  const Vocabulary& words;
  Brief& brief;
  const Lexicon lexicon;
  Discourse talk;
  Hearing hearing;
  std::vector<ThingPhrase> things;                       ///< what the noun phrases would name
  std::vector<std::optional<SaidPlacement>> placements;  ///< by attachment
  std::vector<std::optional<std::size_t>> mentions;      ///< by noun phrase
  std::vector<std::vector<std::size_t>> also;  ///< by noun phrase: further mentions, of "them" and "both"
  std::vector<bool> is_share;  ///< by noun phrase: means some of several things, no more

 private:
  bool is_part_of_thing(const language::Attachment& with) const;
  const language::Attachment& of_thing(const language::Attachment& attachment) const;
};

}  // namespace roomgen::brief
