#include "prompt_owned.h"

#include <algorithm>

#include "language/inflection.h"
#include "mention_shape.h"
#include "place_readers.h"

namespace roomgen::brief {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;

// Whether words that say where the thing of a phrase is, and name a target, pass a test.
template <typename Test>
bool OwnedReader::is_told(std::int32_t id, Test test) const {
  return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
    const auto& said = reading_.placement(one);
    return one.from == id && said && said->target != none && test(one, *said);
  });
}

std::optional<std::size_t> OwnedReader::owner_of(std::size_t mention) const {
  const auto found = owner_of_.find(mention);
  return found == owner_of_.end() ? std::nullopt : std::optional(found->second);
}

// The last several that a phrase comes behind, in its sentence.
std::optional<std::size_t> OwnedReader::several_before(std::size_t phrase) const {
  const int sentence = reading_.sentence_of(reading_.parse.phrases[phrase].head);
  for (std::size_t k = phrase; k-- > 0 && reading_.sentence_of(reading_.parse.phrases[k].head) == sentence;)
    if (const auto one = reading_.mentions[k]; one && reading_.talk.mention(*one).quantity > 1) return one;
  return std::nullopt;
}

// "two bistro tables by the window, a pair of chairs each": of the last several before it.
void OwnedReader::read_those_behind_each() {
  for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
    const auto thing = reading_.mentions[i];
    const NounPhrase& phrase = reading_.parse.phrases[i];
    if (!thing || !is_each_behind(phrase) || owner_of_.count(*thing) || !reading_.talk.mention(*thing).demands.empty()) continue;
    const auto owner = several_before(i);
    if (!owner || *owner == *thing) continue;
    reading_.talk.told_by(hear(reading_.brief, {phrase.head + 1, phrase.head + 2}, Heard::As::count));
    shares_.give_each(*owner, {*thing}, phrase.head + 1);
    reading_.talk.own(*owner, *thing, true);
  }
}

// "each with", "every desk has", "each of them holding"
bool OwnedReader::says_each(const Attachment& attachment) const {
  const auto begin = attachment.tokens.begin;
  const NounPhrase& from = reading_.phrase(attachment.from);
  // "each with", "each loaded with"
  const bool is_participle = begin > 1 && reading_.word(begin - 1).ends_with("ed") && language::verb(reading_.word(begin - 1));
  return (begin > 0 && reading_.is_word(begin - 1, "each")) || (is_participle && reading_.is_word(begin - 2, "each")) ||
         (from.determiner == Determiner::each && !is_reciprocal(from));
}

// "three desks with a chair each"
bool OwnedReader::is_each_behind(const NounPhrase& thing) const {
  return reading_.is_word(thing.head + 1, "each") && !reading_.is_word(thing.head + 2, "of") &&
         !reading_.is_word(thing.head + 2, "with");
}

// "each other"
bool OwnedReader::is_reciprocal(const NounPhrase& phrase) const {
  return phrase.is_pronoun && reading_.is_word(phrase.head, "other") && phrase.determiner == Determiner::each;
}

void OwnedReader::read(const Attachment& attachment) {
  const auto thing = reading_.mention_of(attachment.to);
  if (!thing) return;
  for (const std::size_t owner : reading_.subjects_of(attachment)) {
    if (owner == *thing || reading_.talk.mention(owner).part_of != Demand::none) continue;
    if (says_each(attachment) && is_past_each(attachment)) continue;
    // "two armchairs with a table between them and a lamp on it": it is none of the two.
    if (!says_each(attachment) && reading_.talk.mention(owner).quantity > 1 && is_told_at_one(attachment.to)) continue;
    if (!says_each(attachment) && !is_told_somewhere(attachment.to) && follows_told_place(attachment)) continue;
    if (!named_before(attachment).empty() && is_told_at_another(attachment.to, owner)) continue;
    if (!says_each(attachment) &&
        (goes_on_about_room(attachment) || goes_on_beside(attachment, owner)))
      continue;
    if (says_each(attachment) || is_each_behind(reading_.phrase(attachment.to)))
      shares_.give_each(owner, reading_.all_of(attachment.to), attachment.tokens.begin);
    for (const std::size_t one : reading_.all_of(attachment.to))
      if (!is_alone_with(attachment) || !hang_over(owner, one))
        reading_.talk.own(owner, one, says_each(attachment), which_of(reading_, attachment.from));
    owner_of_[*thing] = owner;
  }
}

// "a vanity with a mirror", and nothing else is said of the mirror
bool OwnedReader::is_alone_with(const Attachment& attachment) const {
  return attachment.relation == "with" && reading_.phrase(attachment.to).list == none && !is_told_somewhere(attachment.to);
}

bool OwnedReader::hang_over(std::size_t owner, std::size_t thing) {
  const Mention &what = reading_.talk.mention(thing), &below = reading_.talk.mention(owner);
  const bool may_hang = what.mount == Mount::wall && what.demands.empty() && below.mount == Mount::floor && needs_wall(below, reading_.text.table);
  if (may_hang) reading_.talk.add(thing, {RelationKind::above, owner, "", false});
  return may_hang;
}

// "each with a chair, a lego table in the middle": what has its own place in the room is no more of the list.
bool OwnedReader::is_told_in_room(std::int32_t id) const {
  return is_told(id, [&](const Attachment&, const SaidPlacement& said) {
    if (said.placement->inverse || reading_.mention_of(said.target)) return false;
    const NounPhrase& target = reading_.phrase(said.target);
    return reading_.place_named(target) && target.determiner != Determiner::possessive;
  });
}

// ", a printer between the clusters": neither is what stands between things, behind a comma.
bool OwnedReader::is_told_between(std::int32_t id) const {
  const auto begin = reading_.phrase(id).tokens.begin;
  return begin > 0 && reading_.text.plain[begin - 1].kind == Token::Kind::comma && is_told(id, [&](const Attachment&, const SaidPlacement& said) {
    return said.placement->relations.front() == RelationKind::between && !reading_.phrase(said.target).is_pronoun;
  });
}

bool OwnedReader::is_past_each(const Attachment& attachment) const {
  const auto is_elsewhere = [&](std::int32_t id) { return is_told_in_room(id) || is_told_between(id); };
  const auto before = named_before(attachment);
  return is_elsewhere(attachment.to) || std::any_of(before.begin(), before.end(), [&](const Attachment* one) { return is_elsewhere(one->to); });
}

// Those of its list that were named before it.
std::vector<const Attachment*> OwnedReader::named_before(const Attachment& attachment) const {
  std::vector<const Attachment*> before;
  for (const Attachment& other : reading_.parse.attachments)
    if (other.from == attachment.from && other.tokens.begin == attachment.tokens.begin && other.to < attachment.to)
      before.push_back(&other);
  return before;
}

// "a sideboard with a vase on it, two paintings and a chandelier": who tells of one of a list that it is on it, tells
// nothing of those behind it.
bool OwnedReader::follows_told_place(const Attachment& attachment) const {
  const auto before = named_before(attachment);
  return std::any_of(before.begin(), before.end(),
                     [&](const Attachment* other) { return reading_.is_told_at_pronoun(other->to); });
}

// "a bed with a lamp, a rack near the door, an armchair": from what has its own place in the room on, behind a comma, the
// list is no more of what the first has.
bool OwnedReader::goes_on_about_room(const Attachment& attachment) const {
  const auto is_told_behind_comma = [&](std::int32_t id) {
    const auto begin = reading_.phrase(id).tokens.begin;
    return begin > 0 && reading_.text.plain[begin - 1].kind == Token::Kind::comma && is_told_in_room(id);
  };
  const auto before = named_before(attachment);
  return !before.empty() && (is_told_behind_comma(attachment.to) ||
                             std::any_of(before.begin(), before.end(), [&](const Attachment* other) {
                               return is_told_behind_comma(other->to);
                             }));
}

// "a desk with a chair and a screen on the wall", "a cart with bottles, an armchair and a lamp":
// from what stands elsewhere in the room on.
bool OwnedReader::goes_on_beside(const Attachment& attachment, std::size_t owner) const {
  const auto before = named_before(attachment);
  if (!before.empty() && is_told_in_room(attachment.to)) return true;
  return std::any_of(before.begin(), before.end(), [&](const Attachment* other) {
    const auto thing = reading_.mention_of(other->to);
    if (!thing || reading_.talk.is_small(*thing) ||
        reading_.talk.mention(*thing).mount != Mount::floor)
      return false;
    const auto& demands = reading_.talk.mention(*thing).demands;
    return std::none_of(demands.begin(), demands.end(),
                        [&](const Demand& demand) { return demand.mention == owner; });
  });
}

// "on it", "beside it"
bool OwnedReader::is_told_at_one(std::int32_t id) const {
  return is_told(id, [&](const Attachment&, const SaidPlacement& said) {
    return reading_.is_word(reading_.phrase(said.target).head, "it");
  });
}

// "a nightstand with a lamp and a bench at the foot of the bed": the bench is the bed's.
bool OwnedReader::is_told_at_another(std::int32_t id, std::size_t owner) const {
  return is_told(id, [&](const Attachment& one, const SaidPlacement& said) {
    if (one.is_of_list || said.placement->inverse) return false;
    const auto target = reading_.mention_of(said.target);
    return target && *target != owner && !reading_.phrase(said.target).is_pronoun;
  });
}

// "behind it", "on top": whether words at a thing say where it is.
bool OwnedReader::is_told_somewhere(std::int32_t id) const {
  const auto end = reading_.phrase(id).tokens.end;
  const auto adverb = longest(reading_.words.placements, reading_.text.plain, end);
  return (adverb && (adverb.value->pronoun || adverb.value->adverb)) ||
         std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
           return one.from == id && reading_.placement(one);
         });
}

}  // namespace roomgen::brief
