#include "attach.h"

#include "attacher.h"

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
      return end_clause();
    case Tag::negation:
      is_denied_ = true;
      return;
    case Tag::relative:
      relative_ = last_;
      verb_ = participle_ = none;
      return;
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
      return phrase(chunk.phrase);
    default:
      return;
  }
}

void Attacher::end_clause() {
  open_.clear();
  fronted_.clear();
  verb_ = relative_ = participle_ = auxiliary_ = outer_verb_ = none;
  last_ = main_ = pending_ = each_ = none;
  is_joined_ = is_denied_ = denies_list_ = is_auxiliary_denied_ = is_parting_ = false;
}

// A comma or a conjunction: what comes may be a further member of a list, or another clause.
void Attacher::join(const Chunk& chunk) {
  pending_ = none;
  participle_ = none;
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
