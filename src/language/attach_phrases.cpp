// Noun phrases: what each is of what has been read before it.
#include "attacher.h"

namespace roomgen::language {

// ", each with a lamp", "six desks each with a lamp": the members of what was said before; ", all facing the
// board", ", both against the wall": all of them.
bool Attacher::is_floating(std::int32_t id) {
  if (!at(id).is_pronoun || last_ == none) return false;
  if (at(id).determiner == Determiner::all || at(id).determiner == Determiner::both)
    return is_joined_ && !preposition_ && (ahead() == Tag::participle || leads_to_place(at_));
  return at(id).determiner == Determiner::each &&
         (is_joined_ || (before_ == Tag::noun && at(last_).is_plural && ahead() == Tag::preposition));
}

// Whether a preposition that says where something is follows a chunk.
bool Attacher::leads_to_place(std::size_t i) const {
  return i + 1 < chunks_.size() && chunks_[i + 1].tag == Tag::preposition && !is_with(chunks_[i + 1].piece->base) &&
         chunks_[i + 1].piece->base != "of";
}

// Of several that the clause is about, else of several to which what was said last belongs: "a bakery with
// three tables by the window, each with two chairs".
std::int32_t Attacher::each_of() {
  if (main_ != none && at(main_).is_plural) return main_;
  std::int32_t several = last_;
  for (auto one = parse_.attachments.rbegin(); one != parse_.attachments.rend(); ++one)
    if (!at(several).is_plural && one->to == several && one->from != none) several = one->from;
  if (at(several).is_plural) return several;
  return main_ != none ? main_ : last_;
}

// "A rack stands by the door, a safe inside the wardrobe": something new with a place of its own is
// no member of a list that what is known began. "The tub is under the window, the toilet beside it": nor is
// whatever has one a member of the places before it.
bool Attacher::is_clause_without_verb(std::int32_t id) {
  const auto is_new = [](const NounPhrase& one) {
    return one.determiner == Determiner::indefinite || one.determiner == Determiner::another ||
           (one.determiner == Determiner::absent && one.count > 0);
  };
  const auto first = at(open_.back().first).determiner;
  const bool is_known = first == Determiner::definite || first == Determiner::possessive ||
                        first == Determiner::each;
  const bool has_place = leads_to_place(at_);
  if (has_verb() && relative_ == none && is_behind_place() && (has_place || ahead() == Tag::participle)) return true;
  return has_verb() && relative_ == none && is_known && is_new(at(id)) && has_place;
}

// Behind a place and a comma, where no other list is open.
bool Attacher::is_behind_place() const {
  return open_.size() == 1 && open_.back().by == Opened::place && has_comma_ && before_ != Tag::conjunction &&
         parse_.attachments[static_cast<std::size_t>(open_.back().attachment)].relation != "between";
}

// "plates sit on the table, each plate beside a cup": what was spoken of, one by one.
bool Attacher::takes_up_each(std::int32_t id) {
  return at(id).determiner == Determiner::each && !at(id).is_pronoun && has_comma_ &&
         before_ != Tag::conjunction;
}

// "avoid glass tables, a living room with a sofa": what has something is wanted.
bool Attacher::is_described() const {
  return ahead() == Tag::preposition && is_with(chunks_[at_ + 1].piece->base);
}

// "Between the sofa and the window stands ..."
bool Attacher::is_second_of_between() const {
  return before_ == Tag::conjunction && main_ == none && !has_verb() && fronted_.size() == 1 && pending_ == none &&
         fronted_.back().relation == "between" && fronted_.back().to == last_;
}

void Attacher::phrase(std::uint32_t number) {
  const auto id = static_cast<std::int32_t>(number);
  each_ = none;
  if (is_floating(id)) {
    each_ = each_of();
    is_of_all_ = at(id).determiner != Determiner::each && !at(each_).is_plural;
    is_joined_ = has_comma_ = false;
    return;
  }
  if (denies_list_ && has_comma_ && is_described()) end_clause();
  if (denies_list_ || is_denied_) at(id).is_denied = true;
  if (preposition_) {
    under_preposition(id);
  } else if (is_second_of_between()) {
    fronted_.push_back(fronted_.back());
    fronted_.back().to = id;
    is_joined_ = false;
  } else if (pending_ != none) {
    under_verb(id);
  } else if (is_joined_ && !open_.empty() && (is_clause_without_verb(id) || takes_up_each(id))) {
    end_clause();
    begin_main(id);
  } else if (is_joined_ && !open_.empty() && is_share(id) && (before_ == Tag::comma || is_parting_)) {
    is_joined_ = has_comma_ = false;
    is_parting_ = true;
    share_ = id;
  } else if (is_joined_ && !open_.empty()) {
    further_member(id);
  } else {
    begin_main(id);
  }
  is_denied_ = false;
  last_ = id;
}

void Attacher::begin_main(std::int32_t id) {
  const bool is_said_of = verb_ != none && verb_at(verb_).base == "be" &&
                          verb_at(verb_).subject != none && verb_at(verb_).subject != id;
  if (is_said_of) {
    // "The room is a kitchen": said of the subject.
    verb_at(verb_).object = id;
    open(Opened::object, id, none);
    return;
  }
  if (verb_ != none && verb_at(verb_).subject == none) verb_at(verb_).subject = id;
  main_ = id;
  open(Opened::subject, id, none);
  flush_fronted(id);
}

}  // namespace roomgen::language
