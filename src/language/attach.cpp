#include <set>
#include <string_view>
#include <utility>

#include "attacher.h"
#include "chunks.h"

namespace roomgen::language {

void Attacher::run() {
  for (at_ = 0; at_ < chunks_.size(); ++at_) {
    read(chunks_[at_]);
    if (chunks_[at_].tag != Tag::adverb) before_ = chunks_[at_].tag;
  }
}

void Attacher::read(const Chunk& chunk) {
  switch (chunk.tag) {
    case Tag::stop:
      return end_sentence();
    case Tag::comma:
    case Tag::conjunction:
      return join(chunk);
    case Tag::subordinator:
      return view_length(at_ + 1) > 0 ? void() : end_clause();
    case Tag::negation:
      is_denied_ = true;
      return;
    case Tag::relative:
      return relative();
    case Tag::there:
      return existential();
    case Tag::preposition:
      return preposition(*chunk.piece);
    case Tag::be:
    case Tag::auxiliary:
      return auxiliary(chunk);
    case Tag::verb:
      return verb(*chunk.piece);
    case Tag::participle:
      return participle(*chunk.piece);
    case Tag::adjective:
      return complement(chunk);
    case Tag::noun:
      if (const std::size_t length = view_length(at_); length > 0) return skip_view(length);
      return phrase(chunk.phrase);
    default:
      return;
  }
}

// "On the left as you come in there is a rack", "as you enter the room": from where it is seen, in the midst of a clause;
// how many chunks it has, or 0.
std::size_t Attacher::view_length(std::size_t first) const {
  static const std::set<std::string_view> ways = {"enter", "come", "walk", "step"};
  const auto tag = [&](std::size_t i) { return i < chunks_.size() ? chunks_[i].tag : Tag::stop; };
  if (tag(first) != Tag::noun || tag(first + 1) != Tag::verb || !ways.contains(chunks_[first + 1].piece->base) ||
      !parse_.phrases[chunks_[first].phrase].is_pronoun)
    return 0;
  std::size_t end = first + 2;
  while (tag(end) == Tag::preposition || tag(end) == Tag::adverb) ++end;
  const bool names_room = tag(end) == Tag::noun && parse_.phrases[chunks_[end].phrase].determiner == Determiner::definite;
  return (names_room ? end + 1 : end) - first;
}

void Attacher::skip_view(std::size_t length) {
  at_ += length - 1;
  if (preposition_ && preposition_->relation == "as") preposition_.reset();
  relative_ = none;
}

// "a rack that holds coats"; "stools, one of which is metal", "tables, of which four are round"; "a desk on which a
// lamp stands": the place of what comes.
void Attacher::relative() {
  const auto preposition = std::exchange(preposition_, std::nullopt);
  const bool is_of = preposition && preposition->relation == "of";
  if (preposition && !is_of && preposition->from != none) {
    Attachment place = *preposition;
    // "stands at the wall, above which hangs a mirror": above what the clause is about; but of what it introduces last
    // itself, "faces a sideboard, on which ...".
    const bool introduces = at(place.from).determiner == Determiner::indefinite || at(place.from).count > 0;
    const bool is_of_clause = !introduces && at_ >= 2 && chunks_[at_ - 2].tag == Tag::comma && verb_ != none && verb_at(verb_).subject != none;
    place.to = is_of_clause ? verb_at(verb_).subject : place.from;
    place.from = none;
    end_clause();
    fronted_.push_back(place);
    return;
  }
  relative_ = is_of && ahead() == Tag::noun ? none : last_;
  verb_ = participle_ = none;
}

void Attacher::end_clause() {
  open_.clear();
  fronted_.clear();
  verb_ = relative_ = participle_ = auxiliary_ = outer_verb_ = none;
  last_ = main_ = pending_ = each_ = share_ = none;
  is_joined_ = is_denied_ = denies_list_ = is_auxiliary_denied_ = is_parting_ = false;
}

// A comma or a conjunction: what comes may be a further member of a list, or another clause.
void Attacher::join(const Chunk& chunk) {
  pending_ = none;
  participle_ = share_ = none;
  // "a coffee table between, toys in a basket": nothing comes that it is between.
  if (before_ == Tag::preposition && (chunk.tag == Tag::comma || ahead() == Tag::noun)) preposition_.reset();
  if (chunk.tag == Tag::comma) has_comma_ = true;
  is_joined_ = true;
  // "At the foot of the bed, a rack ...": what was told beforehand is told.
  if (chunk.tag == Tag::comma && !fronted_.empty() && main_ == none && !has_verb()) open_.clear();
  const bool is_within_subject = relative_ != none && outer_verb_ == none;
  if (has_verb() && !is_within_subject && begins_clause(at_ + 1)) {
    end_clause();
  } else if (relative_ != none && chunk.tag == Tag::comma) {
    leave_relative();
  }
  conjunction_ = chunk.tag == Tag::conjunction ? chunk.piece->base : "";
  if (conjunction_ == "nor") is_denied_ = true;
}

// "..., the other faces the door": a noun phrase with a verb of its own, prepositions between
// them.
bool Attacher::begins_clause(std::size_t i) const {
  while (i < chunks_.size() &&
         (chunks_[i].tag == Tag::conjunction || chunks_[i].tag == Tag::adverb))
    ++i;
  if (i < chunks_.size() && (chunks_[i].tag == Tag::there || is_verb(chunks_[i], VerbForm::base)))
    return true;
  for (std::size_t n = 0; n < 8 && i < chunks_.size(); ++n, ++i) {
    const Tag tag = chunks_[i].tag;
    if (tag == Tag::verb || tag == Tag::be || tag == Tag::auxiliary) return n > 0;
    // "a vase and a mug sit ..."
    if (tag == Tag::conjunction && n > 0 && i + 1 < chunks_.size() &&
        chunks_[i + 1].tag == Tag::noun)
      continue;
    if (tag != Tag::noun && tag != Tag::preposition && tag != Tag::adverb && tag != Tag::negation)
      return false;
  }
  return false;
}

bool Attacher::is_verb(const Chunk& chunk, VerbForm form) const {
  return chunk.tag == Tag::verb && chunk.piece->form == form && is_imperative_;
}

void Attacher::leave_relative() {
  relative_ = none;
  verb_ = outer_verb_;
}

// Lists grow while others are open: their members become runs in the end.
void Attacher::finish() {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    parse_.lists[i].members.begin = static_cast<std::uint32_t>(parse_.members.size());
    parse_.members.insert(parse_.members.end(), members_[i].begin(), members_[i].end());
    parse_.lists[i].members.end = static_cast<std::uint32_t>(parse_.members.size());
  }
  for (const auto attachment : fronted_of_)
    parse_.attachments[static_cast<std::size_t>(attachment)].is_of_list = true;
}

void attach(const std::vector<Chunk>& chunks, Parse& parse) {
  Attacher attacher(chunks, parse);
  attacher.run();
  attacher.finish();
}

}  // namespace roomgen::language
