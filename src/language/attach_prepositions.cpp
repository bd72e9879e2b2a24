// Prepositions: what is somewhere, and where.
#include <utility>

#include "attacher.h"
#include "small_words.h"

namespace roomgen::language {

void Attacher::preposition(const Piece& piece) {
  if (is_joined_ && begins_with_place()) end_clause();
  Attachment attachment;
  attachment.tokens = piece.tokens;
  attachment.relation = piece.base;
  attachment.is_denied = is_denied_ || small_words().denying_prepositions.count(piece.base) > 0;
  is_denied_ = false;
  set_from(attachment);
  preposition_ = attachment;
  is_joined_ = has_comma_ = false;
  pending_ = none;
}

// ", on the south side a plain one": a place and right behind it what is there make a clause of their own.
bool Attacher::begins_with_place() const {
  std::size_t i = at_ + 1;
  if (i >= chunks_.size() || chunks_[i].tag != Tag::noun) return false;
  while (i + 2 < chunks_.size() && chunks_[i + 1].tag == Tag::preposition && chunks_[i + 1].piece->base == "of" &&
         chunks_[i + 2].tag == Tag::noun)
    i += 2;
  if (i + 1 >= chunks_.size() || chunks_[i + 1].tag != Tag::noun) return false;
  const NounPhrase& what = parse_.phrases[chunks_[i + 1].phrase];
  return !what.is_pronoun || what.count > 0;
}

void Attacher::set_from(Attachment& attachment) {
  if (attachment.relation == "of" && before_ == Tag::noun) {
    attachment.from = last_;
  } else if (share_ != none) {
    attachment.from = share_;
    if (participle_ != none) attachment.verb = std::exchange(participle_, none);
  } else if (each_ != none) {
    attachment.from = std::exchange(each_, none);
    attachment.is_of_list = is_of_all_;
  } else if (participle_ != none && before_ == Tag::noun && verb_at(participle_).object == last_ && attachment.relation == "on") {
    // "facing the screen on the wall"
    attachment.from = last_;
    participle_ = none;
  } else if (participle_ != none) {
    attachment.verb = participle_;
    attachment.from = verb_at(participle_).subject;
    participle_ = none;
  } else if (governs_places()) {
    attachment.verb = verb_;
    attachment.from = verb_at(verb_).subject;
    attachment.is_of_list = !is_of_one(verb_at(verb_));
  } else if (is_joined_ && is_with(attachment.relation)) {
    attachment.from = main_ != none ? main_ : last_;
  } else if (is_joined_ && open_.empty()) {
    attachment.from = none;
  } else {
    from_nearest(attachment);
  }
}

// "stands in the corner beside the bed": all that follows the verb is said of its subject, until
// the object of the verb comes.
bool Attacher::governs_places() {
  if (verb_ == none || verb_at(verb_).subject == none) return false;
  const auto kind = verb_at(verb_).kind;
  if (kind != VerbPhrase::Kind::finite && kind != VerbPhrase::Kind::relative) return false;
  if (before_ == Tag::noun && !open_.empty() && open_.back().by == Opened::with) return false;
  // "so that nine can sit, and a projector on the ceiling": not where they sit.
  const auto& verb = verb_at(verb_);
  const bool is_new = before_ == Tag::noun && last_ != none && !open_.empty() && open_.back().last == last_ &&
                      open_.back().by == Opened::subject && at(last_).tokens.begin >= verb.tokens.end;
  if (is_new) return false;
  return verb_at(verb_).object == none;
}

// "a bench and a plant that is near the door": the plant alone.
bool Attacher::is_of_one(const VerbPhrase& verb) const {
  const std::string& word = parse_.tokens[verb.tokens.begin].text;
  const bool is_singular = word == "is" || word == "was" || (word != verb.base && word.ends_with('s'));
  return verb.kind == VerbPhrase::Kind::relative && is_singular;
}

void Attacher::from_nearest(Attachment& attachment) {
  attachment.from = top_of(last_);
  // "a statue on a plinth, facing the door": the statue.
  if (before_ == Tag::comma && !is_with(attachment.relation)) attachment.from = what_is_told_of();
  const bool is_known = last_ != none && (at(last_).is_pronoun
                                              ? at(last_).determiner != Determiner::each
                                              : at(last_).determiner == Determiner::definite);
  if (is_with(attachment.relation) && is_known)
    attachment.from = what_is_told_of();
  if (main_ != none && small_words().exceptions.count(attachment.relation))
    attachment.from = main_;
  // "a room for twelve with a screen", "a cabinet for jackets in the corner"; "under the desk, but not in front of it"
  const Attachment* last = parse_.attachments.empty() ? nullptr : &parse_.attachments.back();
  const bool goes_on = last && last->to == last_ && !last->is_verb && last->relation != "of" &&
                       (last->relation == "for" || before_ == Tag::conjunction || before_ == Tag::negation);
  if (goes_on) {
    attachment.from = last->from;
    attachment.is_of_list = last->is_of_list;
    return;
  }
  if (open_.empty() || is_with(attachment.relation)) return;
  OpenList& list = open_.back();
  const bool is_whole = list.last == attachment.from && list.first != list.last &&
                        (list.by != Opened::with || attachment.relation == "along") && !list.has_own_place &&
                        ended_by_conjunction_;
  attachment.is_of_list = is_whole;
  list.is_placed = list.is_placed || is_whole;
  if (!is_whole && list.last == attachment.from) list.has_own_place = true;
}

// Of "a vase of flowers" the vase.
std::int32_t Attacher::top_of(std::int32_t phrase) const {
  if (parse_.attachments.empty() || phrase == none) return phrase;
  const Attachment& last = parse_.attachments.back();
  return last.to == phrase && last.relation == "of" && !last.is_verb ? last.from : phrase;
}

void Attacher::under_preposition(std::int32_t id) {
  Attachment attachment = *preposition_;
  preposition_.reset();
  attachment.to = id;
  if (attachment.is_denied) at(id).is_denied = true;
  if (attachment.from == none) {
    fronted_.push_back(attachment);
    return;
  }
  const auto by = is_with(attachment.relation)  ? Opened::with
                  : attachment.relation == "of" ? Opened::of
                                                : Opened::place;
  open(by, id, add(attachment));
}

void Attacher::flush_fronted(std::int32_t id) {
  for (Attachment attachment : fronted_) {
    attachment.from = id;
    fronted_of_.push_back(add(attachment));
  }
  fronted_.clear();
}

std::int32_t Attacher::add(const Attachment& attachment) {
  parse_.attachments.push_back(attachment);
  return static_cast<std::int32_t>(parse_.attachments.size() - 1);
}

}  // namespace roomgen::language
