#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "chunks.h"

namespace roomgen::language {

/// What opened a list, and so what further members are attached by.
enum class Opened { subject, object, with, clause, place, of };

struct OpenList {
  Opened by = Opened::subject;
  std::int32_t first = none, last = none;  ///< noun phrases
  std::int32_t attachment = none;          ///< that further members repeat
  bool has_own_place = false;              ///< a member before the last is somewhere already
  bool is_placed = false;                  ///< all members so far are somewhere: who follows begins another list
};

/// Reads chunks from left to right and keeps what is open: the clause with its verb, lists, a
/// preposition or a verb that waits for its noun phrase. What it reads of one sort stands in a file
/// of its own: attach_verbs.cpp, attach_prepositions.cpp, attach_phrases.cpp, attach_lists.cpp.
class Attacher {
 public:
  Attacher(const std::vector<Chunk>& chunks, Parse& parse) : chunks_(chunks), parse_(parse) {}

  void run();
  void finish();

 private:
  NounPhrase& at(std::int32_t phrase) { return parse_.phrases[static_cast<std::size_t>(phrase)]; }
  VerbPhrase& verb_at(std::int32_t verb) { return parse_.verbs[static_cast<std::size_t>(verb)]; }
  Tag ahead(std::size_t n = 1) const {
    return at_ + n < chunks_.size() ? chunks_[at_ + n].tag : Tag::stop;
  }

  // Clauses.
  void read(const Chunk& chunk);
  std::size_t view_length(std::size_t first) const;
  void skip_view(std::size_t length);
  void relative();
  void end_clause();
  void end_sentence() {
    end_clause();
    is_imperative_ = false;
  }
  void join(const Chunk& chunk);
  bool has_verb() const { return verb_ != none || has_existential_; }
  bool begins_clause(std::size_t i) const;
  bool is_verb(const Chunk& chunk, VerbForm form) const;
  void leave_relative();

  // Verbs.
  void existential();
  VerbPhrase& add_verb(VerbPhrase::Kind kind, const Run& tokens, const std::string& base);
  void auxiliary(const Chunk& chunk);
  void begin_finite(const Run& tokens, const std::string& base);
  void close_lists();
  void verb(const Piece& piece);
  bool before_is_be() const {
    return before_ == Tag::be || before_ == Tag::negation || before_ == Tag::auxiliary;
  }
  bool auxiliary_command() const;
  void participle(const Piece& piece);
  void fronted_participle(const Piece& piece);
  std::int32_t what_is_told_of();
  void complement(const Chunk& chunk);
  void under_verb(std::int32_t id);
  Attachment between(const VerbPhrase& verb, std::int32_t number, std::int32_t from,
                     std::int32_t to) const;

  // Prepositions.
  void preposition(const Piece& piece);
  bool is_with(const std::string& relation) const {
    return relation == "with" || relation == "without";
  }
  bool begins_with_place() const;
  void set_from(Attachment& attachment);
  bool is_of_one(const VerbPhrase& verb) const;
  bool governs_places();
  void from_nearest(Attachment& attachment);
  std::int32_t top_of(std::int32_t phrase) const;
  void under_preposition(std::int32_t id);
  void flush_fronted(std::int32_t id);
  std::int32_t add(const Attachment& attachment);

  // Noun phrases.
  bool is_floating(std::int32_t id);
  std::int32_t each_of();
  bool leads_to_place(std::size_t chunk) const;
  bool is_clause_without_verb(std::int32_t id);
  bool is_behind_place() const;
  bool takes_up_each(std::int32_t id);
  bool is_described() const;
  bool is_second_of_between() const;
  void phrase(std::uint32_t number);
  void begin_main(std::int32_t id);

  // Lists.
  void open(Opened by, std::int32_t id, std::int32_t attachment);
  void further_member(std::int32_t id);
  bool takes(const OpenList& list, std::int32_t id);
  bool brings_something_new(const OpenList& list, std::int32_t id);
  bool is_past_denied(const OpenList& list, std::int32_t id);
  bool is_past_each(const OpenList& list, std::int32_t id);
  bool has_one_member(const OpenList& list, std::int32_t id);
  bool is_within_list() const;
  bool is_bare(std::int32_t id);
  bool is_adjectival(const OpenList& list);
  bool resembles(const OpenList& list, std::int32_t id);
  bool names_part(std::int32_t id);
  bool is_share(std::int32_t id);
  bool is_told_of_them() const;
  bool means_several(std::int32_t id);
  bool is_all_there_is(std::int32_t id);
  void link(OpenList& list, std::int32_t id);

  const std::vector<Chunk>& chunks_;
  Parse& parse_;
  std::size_t at_ = 0;
  Tag before_ = Tag::stop;
  std::vector<OpenList> open_;       ///< outer ones first
  std::vector<Attachment> fronted_;  ///< "On the shelf": what they belong to comes later
  std::vector<std::int32_t> fronted_of_;
  std::vector<std::vector<std::uint32_t>> members_;
  std::optional<Attachment> preposition_;   ///< that waits for its noun phrase
  std::int32_t main_ = none, last_ = none;  ///< noun phrases
  std::int32_t relative_ = none;            ///< what the open relative clause is about
  std::int32_t verb_ = none, outer_verb_ = none, participle_ = none;
  std::int32_t pending_ = none;  ///< the verb that waits for its object
  std::int32_t each_ = none;     ///< what an "each" that stands alone and has just been read means
  std::int32_t share_ = none;    ///< of several, of which something of its own is being said
  bool is_of_all_ = false;        ///< and whether all of its list
  bool is_told_of_all_ = false;   ///< so of the open participle
  std::int32_t auxiliary_ = none;
  bool has_existential_ = false, is_imperative_ = false, is_joined_ = false, has_comma_ = false;
  bool ended_by_conjunction_ = false;
  std::string conjunction_;  ///< that was read last in the clause
  bool is_parting_ = false;  ///< "five tables, three by the wall": the shares of several are read
  bool is_denied_ = false, is_auxiliary_denied_ = false, denies_list_ = false;
};

}  // namespace roomgen::language
