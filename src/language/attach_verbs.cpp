// Verbs: whose they are, and what they are done to.
#include <set>
#include <string_view>
#include <utility>

#include "attacher.h"
#include "small_words.h"

namespace roomgen::language {

void Attacher::existential() {
  if (has_existential_) end_clause();
  VerbPhrase& verb = add_verb(VerbPhrase::Kind::existential, chunks_[at_].piece->tokens, "be");
  verb_ = static_cast<std::int32_t>(&verb - parse_.verbs.data());
  has_existential_ = true;
  main_ = none;
}

VerbPhrase& Attacher::add_verb(VerbPhrase::Kind kind, const Run& tokens, const std::string& base) {
  VerbPhrase verb;
  verb.kind = kind;
  verb.tokens = tokens;
  verb.base = base;
  verb.is_denied = is_denied_ || is_auxiliary_denied_;
  is_denied_ = is_auxiliary_denied_ = false;
  parse_.verbs.push_back(verb);
  return parse_.verbs.back();
}

void Attacher::auxiliary(const Chunk& chunk) {
  is_auxiliary_denied_ = is_auxiliary_denied_ || chunk.piece->is_denied;
  if (verb_ != none && verb_at(verb_).kind == VerbPhrase::Kind::existential && main_ == none) {
    verb_at(verb_).is_denied = verb_at(verb_).is_denied || chunk.piece->is_denied;
    return;
  }
  if (chunk.tag == Tag::auxiliary) {
    auxiliary_ = 1;
    return;
  }
  begin_finite(chunk.piece->tokens, "be");
}

// A finite verb: of the relative clause that is open, or of the clause.
void Attacher::begin_finite(const Run& tokens, const std::string& base) {
  const bool is_relative = relative_ != none && (verb_ == none || verb_ == outer_verb_);
  if (relative_ != none && !is_relative) leave_relative();
  const auto kind = is_relative ? VerbPhrase::Kind::relative : VerbPhrase::Kind::finite;
  VerbPhrase& verb = add_verb(kind, tokens, base);
  // "a shop with seven tables, four are square"
  const bool is_of_share = last_ != none && before_ == Tag::noun && at(last_).is_pronoun && at(last_).count > 0;
  verb.subject = is_relative ? relative_ : is_of_share ? last_ : main_;
  if (is_relative) outer_verb_ = verb_;
  verb_ = static_cast<std::int32_t>(&verb - parse_.verbs.data());
  participle_ = none;
  if (!is_relative) close_lists();
  // "it faces the window" is said of what the pronoun stands for.
  if (verb.subject == none && last_ != none && fronted_.empty()) verb_at(verb_).subject = last_;
}

void Attacher::close_lists() {
  open_.clear();
  is_joined_ = has_comma_ = false;
}

void Attacher::verb(const Piece& piece) {
  // "is placed", "are standing", "should face": the verb that the auxiliary began.
  if (verb_ != none && verb_at(verb_).base == "be" && before_is_be() &&
      verb_at(verb_).kind != VerbPhrase::Kind::existential) {
    VerbPhrase& open = verb_at(verb_);
    open.base = piece.base;
    open.tokens.end = piece.tokens.end;
    open.is_passive = piece.form == VerbForm::past;
    open.is_denied = open.is_denied || is_denied_;
    is_denied_ = false;
    pending_ = open.is_passive ? none : verb_;
    auxiliary_ = none;
    return;
  }
  const bool is_imperative =
      piece.form == VerbForm::base && auxiliary_command() && main_ == none && relative_ == none;
  if (is_imperative) {
    if (has_verb()) end_clause();
    VerbPhrase& verb = add_verb(VerbPhrase::Kind::imperative, piece.tokens, piece.base);
    verb.is_denied =
        verb.is_denied || piece.is_denied || small_words().verbs_of_denial.count(piece.base) > 0;
    denies_list_ = verb.is_denied;
    verb_ = static_cast<std::int32_t>(&verb - parse_.verbs.data());
    is_imperative_ = true;
    auxiliary_ = none;
  } else {
    // "he hates televisions"
    static const std::set<std::string_view> dislikes = {"hate", "dislike", "detest", "loathe"};
    is_auxiliary_denied_ = is_auxiliary_denied_ || piece.is_denied || dislikes.count(piece.base) > 0;
    begin_finite(piece.tokens, piece.base);
    denies_list_ = verb_at(verb_).is_denied;
    auxiliary_ = none;
  }
  pending_ = verb_;
}

// "don't put": the auxiliary is no sign of a subject.
bool Attacher::auxiliary_command() const { return last_ == none || is_imperative_ || !fronted_.empty(); }

// Behind its noun: "facing the window", "made of oak", "each surrounded by".
void Attacher::participle(const Piece& piece) {
  if (last_ == none) return fronted_participle(piece);
  VerbPhrase& verb = add_verb(VerbPhrase::Kind::participle, piece.tokens, piece.base);
  // "beside the sofa holding a mug": what is known already is not described.
  const bool is_known = at(last_).determiner == Determiner::definite || parse_.tokens[at(last_).head].is("them") ||
                        parse_.tokens[at(last_).head].is("it");
  is_told_of_all_ = each_ != none && is_of_all_;
  if (each_ != none)
    verb.subject = std::exchange(each_, none);
  else
    verb.subject = before_ == Tag::comma || is_known ? what_is_told_of() : last_;
  verb.is_passive = piece.form == VerbForm::past;
  participle_ = static_cast<std::int32_t>(&verb - parse_.verbs.data());
  pending_ = verb.is_passive ? none : participle_;
}

// "Facing the bed, a desk ...": said of what comes.
void Attacher::fronted_participle(const Piece& piece) {
  VerbPhrase& verb = add_verb(VerbPhrase::Kind::participle, piece.tokens, piece.base);
  verb.is_passive = piece.form == VerbForm::past;
  if (!verb.is_passive) pending_ = static_cast<std::int32_t>(&verb - parse_.verbs.data());
}

// ", topped with a lamp": of the subject of the clause, or of what has been placed by now.
std::int32_t Attacher::what_is_told_of() {
  if (verb_ != none && verb_at(verb_).kind == VerbPhrase::Kind::finite &&
      verb_at(verb_).subject != none && verb_at(verb_).object == none)
    return verb_at(verb_).subject;
  std::int32_t told = last_;
  for (auto i = parse_.attachments.size(); i-- > 0;) {
    const Attachment& one = parse_.attachments[i];
    if (one.to != told) continue;
    if (is_with(one.relation) || one.is_verb) break;
    told = one.from;
  }
  return told == none ? last_ : told;
}

void Attacher::complement(const Chunk& chunk) {
  if (verb_ == none || verb_at(verb_).subject == none) return;
  VerbPhrase& verb = verb_at(verb_);
  if (verb.complement.empty()) verb.complement.begin = chunk.complement.begin;
  verb.complement.end = chunk.complement.end;
  if (is_denied_ || verb.is_denied)
    for (auto i = chunk.complement.begin; i < chunk.complement.end; ++i)
      parse_.modifiers[i].is_denied = true;
  is_denied_ = false;
}

void Attacher::under_verb(std::int32_t id) {
  VerbPhrase& verb = verb_at(pending_);
  const std::int32_t subject = verb.subject;
  // "On the left stands a cabinet"
  if (subject == none && verb.kind == VerbPhrase::Kind::finite) {
    verb.subject = id;
    pending_ = none;
    return begin_main(id);
  }
  verb.object = id;
  std::int32_t attachment = none;
  if (subject == none && verb.kind == VerbPhrase::Kind::participle) {
    fronted_.push_back(between(verb, pending_, none, id));
    pending_ = none;
    return;
  }
  if (subject != none) {
    Attachment said = between(verb, pending_, subject, id);
    if (pending_ == participle_ && is_told_of_all_) said.is_of_list = true;
    attachment = add(said);
  }
  const bool is_main = verb.kind == VerbPhrase::Kind::imperative;
  if (is_main) main_ = id;
  pending_ = none;
  const bool has = small_words().verbs_of_having.count(verb.base) > 0;
  const bool is_clause = !has && verb.kind == VerbPhrase::Kind::participle;
  open(is_main ? Opened::object : is_clause ? Opened::clause : Opened::with, id, attachment);
  if (is_main) flush_fronted(id);
}

Attachment Attacher::between(const VerbPhrase& verb, std::int32_t number, std::int32_t from,
                   std::int32_t to) const {
  Attachment attachment;
  attachment.from = from;
  attachment.is_of_list = verb.kind == VerbPhrase::Kind::finite;
  attachment.to = to;
  attachment.verb = number;
  attachment.tokens = verb.tokens;
  attachment.relation = verb.base;
  attachment.is_verb = true;
  attachment.is_denied = verb.is_denied;
  return attachment;
}

}  // namespace roomgen::language
