// Lists: which of those that are open a noun phrase continues.
#include "attacher.h"
#include "lexicon.h"
#include "small_words.h"

namespace roomgen::language {

void Attacher::open(Opened by, std::int32_t id, std::int32_t attachment) {
  open_.push_back({by, id, id, attachment});
  is_joined_ = has_comma_ = ended_by_conjunction_ = false;
}

void Attacher::further_member(std::int32_t id) {
  ended_by_conjunction_ = before_ == Tag::conjunction;
  while (open_.size() > 1 && !takes(open_.back(), id)) open_.pop_back();
  OpenList& list = open_.back();
  // "no rug, desk or plant"
  const bool is_list_of_bare = is_bare(list.last) || at(list.last).determiner == Determiner::no || at(list.last).determiner == Determiner::any;
  const bool has_place = before_ == Tag::comma && ahead() == Tag::preposition;  // "no rugs, low bookcase under the window"
  if (at(list.last).is_denied && is_list_of_bare && is_bare(id) && !has_place) at(id).is_denied = true;
  link(list, id);
  if (list.attachment != none) {
    Attachment attachment = parse_.attachments[static_cast<std::size_t>(list.attachment)];
    attachment.to = id;
    if (attachment.is_denied && !attachment.is_verb) at(id).is_denied = true;
    list.attachment = add(attachment);
  }
  is_joined_ = has_comma_ = false;
}

// "without rug, desk or plant"; of "a bed without headboard, a lamp, a desk" only the headboard is not there.
bool Attacher::is_past_denied(const OpenList& list, std::int32_t id) {
  if (list.attachment == none || !has_comma_) return false;
  const Attachment& by = parse_.attachments[static_cast<std::size_t>(list.attachment)];
  if (!by.is_denied || by.is_verb) return false;
  // "stools without backs, and a pair of armchairs"
  if (ended_by_conjunction_) return conjunction_ == "and" && is_bare(list.last) && !is_bare(id);
  for (auto i = at(id).tokens.end; i < parse_.tokens.size() && parse_.tokens[i].kind != Token::Kind::stop; ++i)
    if (parse_.tokens[i].is("or") || parse_.tokens[i].is("nor")) return false;
  return true;
}

// Whether the noun phrase is another member of the list, rather than of one around it.
bool Attacher::takes(const OpenList& list, std::int32_t id) {
  if (is_all_there_is(id) && at(list.last).is_denied) return false;
  if (is_past_denied(list, id)) return false;
  if (list.by != Opened::subject && list.by != Opened::object && is_share(id)) return false;
  if ((list.by == Opened::object || list.by == Opened::clause) && brings_something_new(list, id)) return false;
  // "two chairs facing a sofa, a lamp and ...": the sofa ends the clause.
  if (list.by == Opened::clause) return !has_comma_;
  // "..., a table holding a mug, and a lamp": the last of the outer list.
  if (list.by == Opened::with && has_comma_ && ended_by_conjunction_ && list.first == list.last &&
      is_within_list())
    return false;
  // "holds a vase filled with flowers and a bowl"
  if (list.by == Opened::with && is_bare(list.last) && !is_bare(id) && open_.size() > 1 &&
      resembles(open_[open_.size() - 2], id))
    return false;
  if (list.by == Opened::with && is_past_each(list, id)) return false;
  if (list.by == Opened::subject || list.by == Opened::object || list.by == Opened::with)
    return true;
  const std::string& relation =
      parse_.attachments[static_cast<std::size_t>(list.attachment)].relation;
  // "a shower instead of a tub, a toilet"
  if ((relation == "instead of" || relation == "rather than") && has_comma_) return false;
  if (relation == "between" && list.first == list.last && !means_several(list.first)) return true;
  // "a sink at one end and four stools"
  if (names_part(list.last) != names_part(id)) return false;
  // "in a semicircle and a cello resting against the chair"
  if (ahead() == Tag::participle && at(id).determiner == Determiner::indefinite) return false;
  if (ahead() == Tag::preposition || has_comma_)
    return list.by == Opened::of && open_.size() == 2 && is_bare(id) && is_adjectival(list);
  return at(id).determiner == at(list.last).determiner &&
         (at(id).count > 0) == (at(list.last).count > 0) &&
         !resembles(open_[open_.size() - 2], id);
}

// "desks, each with a chair, plus a lectern"; "16 desks each with a chair, 4 plants": what is added to all, and
// what is counted as they are, is none of what each of them has.
bool Attacher::is_past_each(const OpenList& list, std::int32_t id) {
  if (!has_comma_ || open_.size() < 2) return false;
  const Attachment& with = parse_.attachments[static_cast<std::size_t>(list.attachment)];
  if (with.tokens.begin == 0 || !parse_.tokens[with.tokens.begin - 1].is("each")) return false;
  if (small_words().additions.contains(conjunction_) || has_one_member(list, id)) return true;
  const bool is_apart = with.tokens.begin > 1 && parse_.tokens[with.tokens.begin - 2].kind == Token::Kind::comma;
  const auto is_counted = [&](std::int32_t one) { return at(one).determiner == Determiner::absent && at(one).count > 0; };
  return !is_apart && is_counted(with.from) && is_counted(id) && !is_counted(list.last);
}

// "desks, each with its own lamp, and a sofa", "chairs, each with its own footstool, sideboard covered in photos": a list of
// two has no comma before "and", and what is none's own stands behind no comma of a list that nothing ends.
bool Attacher::has_one_member(const OpenList& list, std::int32_t id) {
  if (list.first != list.last) return false;
  if (ended_by_conjunction_) return true;
  std::size_t i = at_;
  while (i < chunks_.size() && chunks_[i].tag != Tag::stop && chunks_[i].tag != Tag::conjunction) ++i;
  const bool goes_on = i < chunks_.size() && chunks_[i].tag == Tag::conjunction && is_bare(id);
  return at(list.last).determiner == Determiner::possessive && at(id).determiner != Determiner::possessive && !goes_on;
}

// "a sofa facing the TV and a bookshelf": behind what is known a thing is introduced beside the sofa; but what holds the
// one may hold the other.
bool Attacher::brings_something_new(const OpenList& list, std::int32_t id) {
  if (list.attachment == none || at(list.last).determiner != Determiner::definite ||
      at(id).determiner != Determiner::indefinite)
    return false;
  const Attachment& attachment = parse_.attachments[static_cast<std::size_t>(list.attachment)];
  return attachment.is_verb && !small_words().verbs_of_having.contains(attachment.relation);
}

// Whether a list around the innermost one has several members by now.
bool Attacher::is_within_list() const {
  for (std::size_t i = 0; i + 1 < open_.size(); ++i)
    if (open_[i].first != open_[i].last) return true;
  return false;
}

bool Attacher::is_bare(std::int32_t id) {
  return at(id).determiner == Determiner::absent && at(id).count == 0.0 && !at(id).is_vague;
}

// "them" too
bool Attacher::means_several(std::int32_t id) {
  return at(id).is_plural || (at(id).is_pronoun && (parse_.tokens[at(id).head].is("them") || at(id).determiner == Determiner::both));
}

// "full of boxes"
bool Attacher::is_adjectival(const OpenList& list) {
  const Attachment& attachment = parse_.attachments[static_cast<std::size_t>(list.attachment)];
  return at(attachment.from).head + 1 < attachment.tokens.begin;
}

bool Attacher::resembles(const OpenList& list, std::int32_t id) {
  return list.by != Opened::subject && at(list.last).determiner == at(id).determiner &&
         (at(id).count > 0) == (at(list.last).count > 0);
}

// "without a desk or a chair, only a bed": the bed is wanted.
bool Attacher::is_all_there_is(std::int32_t id) {
  const std::uint32_t first = at(id).tokens.begin;
  const auto says = [&](std::uint32_t token) {
    return parse_.tokens[token].is("only") || parse_.tokens[token].is("just");
  };
  return says(first) || (first > 0 && says(first - 1));
}

// "two facing the door": some of several, of which something of their own is said.
bool Attacher::is_share(std::int32_t id) {
  const bool is_told = ahead() == Tag::participle || leads_to_place(at_) || is_told_of_them();
  const std::string& noun = parse_.tokens[at(id).head].text;
  const bool is_rest = is_parting_ && (noun == "other" || noun == "others" || noun == "rest");
  return at(id).is_pronoun && (at(id).count > 0 || at(id).determiner == Determiner::another || is_rest) && is_told;
}

// "two of them round", "one of which is metal"
bool Attacher::is_told_of_them() const {
  if (ahead() != Tag::preposition || chunks_[at_ + 1].piece->base != "of") return false;
  const Tag what = ahead(2), behind = ahead(3);
  if (what == Tag::relative) return behind == Tag::be || behind == Tag::verb;
  return what == Tag::noun && parse_.phrases[chunks_[at_ + 2].phrase].is_pronoun;
}

// "end", "side": where something is, rather than a thing.
bool Attacher::names_part(std::int32_t id) {
  constexpr double some = 0.3;
  const std::string noun = parse_.head_of(at(id));
  const auto& english = lexicon();
  return english.share(noun, WordClass::artefact) < some &&
         english.share(noun, WordClass::place) + english.share(noun, WordClass::body_part) >= some;
}

void Attacher::link(OpenList& list, std::int32_t id) {
  // "a pot and a pan on the stove, a toaster and a kettle on the counter"
  if (list.is_placed) {
    list.first = list.last = id;
    list.is_placed = list.has_own_place = false;
    return;
  }
  NounPhrase& first = at(list.first);
  if (first.list == none) {
    first.list = static_cast<std::int32_t>(parse_.lists.size());
    parse_.lists.push_back({});
    members_.push_back({static_cast<std::uint32_t>(list.first)});
  }
  members_[static_cast<std::size_t>(first.list)].push_back(static_cast<std::uint32_t>(id));
  at(id).list = first.list;
  list.last = id;
}

}  // namespace roomgen::language
