#include "prompt_pronouns.h"

#include <algorithm>

namespace roomgen::brief {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;

void PronounReader::read(std::int32_t id) {
  const NounPhrase& said = reading_.phrase(id);
  if (means_nothing(said)) return;
  const auto number = static_cast<std::size_t>(id);
  if (const auto whole = named_behind(id)) {
    reading_.mentions[number] = whole;
    return;
  }
  if (means_all(said))
    if (const Indices all = several_before(id); !all.empty()) {
      reading_.mentions[number] = all.front();
      reading_.also[number] = {all.begin() + 1, all.end()};
      return;
    }
  reading_.mentions[number] = stands_for(id);
}

// "some of the seats": what was spoken of before.
std::optional<std::size_t> PronounReader::named_behind(std::int32_t id) const {
  if (reading_.phrase(id).count > 0) return std::nullopt;
  for (const Attachment& of : reading_.parse.attachments) {
    if (of.from != id || of.relation != "of" || of.to == none || reading_.phrase(of.to).is_pronoun) continue;
    if (reading_.thing(of.to).definite && reading_.thing(of.to).kind.length > 0) return reading_.talk.known(reading_.thing(of.to));
  }
  return std::nullopt;
}

// "I", "everyone", "each other"
bool PronounReader::means_nothing(const NounPhrase& said) const {
  static const WordSet people = {"i", "we", "you", "he", "she", "me", "us", "him", "everyone", "everybody", "someone", "somebody", "anyone", "nobody"};
  const std::string& noun = reading_.word(said.head);
  return people.count(noun) || (noun == "other" && said.determiner == Determiner::each) ||
         (noun == "another" && said.tokens.size() > 1);
}

bool PronounReader::is_one_of_several(const NounPhrase& said) const {
  const std::string& noun = reading_.word(said.head);
  return noun == "one" || noun == "other" || noun == "others" || said.determiner == Determiner::each || said.count > 0;
}

// "them", "both"
bool PronounReader::means_all(const NounPhrase& said) const {
  static const WordSet plurals = {"them", "they", "these", "those", "both"};
  return plurals.count(reading_.word(said.head)) > 0;
}

Indices PronounReader::subjects_at(std::int32_t id) const {
  for (const Attachment& attachment : reading_.parse.attachments)
    if (attachment.to == id) return reading_.subjects_of(attachment);
  return {};
}

// What "them" means: "a sofa and a chair", "two beds", or of two things the one and where it is.
Indices PronounReader::several_before(std::int32_t id) const {
  const Indices subjects = subjects_at(id);
  const auto is_here = [&](std::size_t token) {
    return reading_.sentence_of(token) == reading_.sentence_of(reading_.phrase(id).head);
  };
  const Indices pair = pair_before(id, subjects);
  for (std::int32_t i = id; i-- > 0;) {
    if (!pair.empty() && !is_here(reading_.phrase(i).head)) return pair;
    const Indices members = members_named(i, id, subjects);
    if (!members.empty()) return members;
  }
  return pair;
}

// The members of the list that a phrase is in, or the several things that it names.
Indices PronounReader::members_named(std::int32_t phrase, std::int32_t before, const Indices& subjects) const {
  if (reading_.phrase(phrase).is_pronoun) return {};
  Indices members;
  for (const auto one : reading_.parse.with_list(static_cast<std::uint32_t>(phrase))) {
    const auto mention = static_cast<std::int32_t>(one) < before ? reading_.mention_of(static_cast<std::int32_t>(one)) : std::nullopt;
    if (mention && !is_among(subjects, *mention) && !is_among(members, *mention)) members.push_back(*mention);
  }
  const auto own = reading_.mention_of(phrase);
  if (!own || is_among(subjects, *own)) return {};
  if (reading_.talk.mention(*own).quantity != 1 || reading_.phrase(phrase).is_plural) return {*own};  // "wall bars"
  return members.size() > 1 ? members : Indices{};
}

// "A sofa faces a television, a rug lies between them"
Indices PronounReader::pair_before(std::int32_t id, const Indices& subjects) const {
  const auto token = reading_.phrase(id).head;
  for (auto one = reading_.parse.attachments.rbegin(); one != reading_.parse.attachments.rend(); ++one) {
    const bool is_before = one->tokens.begin < token && one->to < id && one->from < id &&
                           reading_.sentence_of(one->tokens.begin) + 1 >= reading_.sentence_of(token);
    const auto from = reading_.mention_of(one->from), to = reading_.mention_of(one->to);
    if (!is_before || !from || !to || *from == *to || !reading_.placement(*one)) continue;
    if (is_among(subjects, *from) || is_among(subjects, *to) || reading_.talk.mention(*from).quantity != 1 ||
        reading_.talk.mention(*to).quantity != 1)
      continue;
    return {*from, *to};
  }
  return {};
}

std::optional<std::size_t> PronounReader::stands_for(std::int32_t id) const {
  const NounPhrase& said = reading_.phrase(id);
  const bool is_it = reading_.is_word(said.head, "it");
  if (const auto same = same_each_before(id)) return same;
  if (is_one_of_several(said))
    if (const auto several = reading_.talk.last_of_several(what_stands_at(id), is_of_them(id))) return several;
  for (const Attachment& attachment : reading_.parse.attachments) {
    if (attachment.to != id) continue;
    if (const auto owner = owner_of(attachment.from); owner && !(is_it && is_several(*owner, id))) return owner;
    if (const auto picture = what_hangs_over(attachment)) return picture;
    const auto subjects = reading_.subjects_of(attachment);
    if (const auto neighbour = small_neighbour(attachment, subjects)) return neighbour;
    if (const auto same = is_it ? same_as_before(id, subjects) : std::nullopt) return same;
    if (const auto carrier = carrier_before(attachment); carrier && !(is_it && is_several(*carrier, id))) return carrier;
    if (const auto faced = is_it ? what_is_faced(attachment, subjects) : std::nullopt) return faced;
    return reading_.talk.antecedent(subjects, is_it);
  }
  return topic_before(id);
}

// "a cloth on every table and a vase in the centre of each": of what "every" was said in the sentence before.
std::optional<std::size_t> PronounReader::same_each_before(std::int32_t id) const {
  const NounPhrase& said = reading_.phrase(id);
  if (!reading_.is_word(said.head, "each")) return std::nullopt;
  const Indices standing = what_stands_at(id);
  for (std::int32_t i = id; i-- > 0 && reading_.sentence_of(reading_.phrase(i).head) == reading_.sentence_of(said.head);) {
    const auto mention = reading_.mention_of(i);
    if (reading_.phrase(i).determiner == Determiner::each && mention && !is_among(standing, *mention)) return mention;
  }
  return std::nullopt;
}

// "two armchairs with a table between them and a lamp on it": it is one thing; of "desks, each with a lamp on it" each is.
bool PronounReader::is_several(std::size_t mention, std::int32_t pronoun) const {
  if (reading_.talk.mention(mention).quantity < 2) return false;
  const std::uint32_t head = reading_.phrase(pronoun).head;
  for (std::uint32_t i = head; i-- > 0 && reading_.sentence_of(i) == reading_.sentence_of(head);)
    if (reading_.is_word(i, "each") || reading_.is_word(i, "every")) return false;
  return true;
}

// "A screen stands on it, a cabinet under it and two chairs in front of it": until something else is told of.
std::optional<std::size_t> PronounReader::same_as_before(std::int32_t id, const Indices& subjects) const {
  const auto sentence = reading_.sentence_of(reading_.phrase(id).head);
  for (std::int32_t i = id; i-- > 0 && reading_.sentence_of(reading_.phrase(i).head) == sentence;) {
    if (reading_.phrase(i).is_pronoun && reading_.is_word(reading_.phrase(i).head, "it")) {
      const auto same = reading_.mention_of(i);
      return same && !is_among(subjects, *same) ? same : std::nullopt;
    }
    const bool is_told_of = std::any_of(reading_.parse.verbs.begin(), reading_.parse.verbs.end(), [&](const auto& verb) {
      return verb.subject == i && verb.kind == language::VerbPhrase::Kind::finite;
    });
    if (is_told_of) return std::nullopt;
  }
  return std::nullopt;
}

// "The television hangs above a cabinet, the sofa faces it": what the clause before was about.
std::optional<std::size_t> PronounReader::what_is_faced(const Attachment& attachment, const Indices& subjects) const {
  const auto& said = reading_.placement(attachment);
  if (!said || said->placement->relations.front() != RelationKind::face_to || attachment.from == none) return std::nullopt;
  const auto topic = topic_before(attachment.from);
  return topic && !is_among(subjects, *topic) ? topic : std::nullopt;
}

// "against one of them"
bool PronounReader::is_of_them(std::int32_t id) const {
  return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
    return one.from == id && one.relation == "of" && one.to != none && reading_.phrase(one.to).is_pronoun;
  });
}

// "three tables with two chairs at each": the chairs.
Indices PronounReader::what_stands_at(std::int32_t id) const {
  Indices all;
  for (const Attachment& attachment : reading_.parse.attachments)
    if (attachment.to == id && reading_.phrase(id).determiner == Determiner::each && reading_.placement(attachment))
      std::ranges::copy(reading_.subjects_of(attachment), std::back_inserter(all));
  return all;
}

// "The desk is by the door with a lamp behind it; on it are ...": nothing stands on a lamp.
std::optional<std::size_t> PronounReader::carrier_before(const Attachment& attachment) const {
  const auto& said = reading_.placement(attachment);
  const auto topic = topic_before(attachment.to);
  if (!said || !topic || said->placement->inverse || said->placement->relations.front() != RelationKind::on)
    return std::nullopt;
  const auto& table = reading_.text.table;
  return table.is_any_of(reading_.talk.mention(*topic).category, {"table", "storage", "seat", "bed"}) ? topic : std::nullopt;
}

// "A bowl sits on the island, and a coffee maker is placed near it": what small things stand beside is small.
std::optional<std::size_t> PronounReader::small_neighbour(const Attachment& attachment, const std::vector<std::size_t>& subjects) const {
  const auto& said = reading_.placement(attachment);
  if (!said || subjects.empty() || !reading_.talk.is_small(subjects.front())) return std::nullopt;
  const RelationKind first = said->placement->relations.front();
  if (first == RelationKind::on || first == RelationKind::under || first == RelationKind::above) return std::nullopt;
  const auto other = topic_before(attachment.to);
  const bool is_beside = other && *other != subjects.front() && reading_.talk.is_small(*other);
  return is_beside ? other : std::nullopt;
}

// "On the wall a tapestry; below it an altar"
std::optional<std::size_t> PronounReader::what_hangs_over(const Attachment& attachment) const {
  const auto& said = reading_.placement(attachment);
  const auto last = last_in_sentence(attachment.to);
  const bool is_below = said && said->placement->relations.front() == RelationKind::under;
  if (!is_below || !last) return std::nullopt;
  const Mount mount = reading_.talk.mention(*last).mount;
  return mount == Mount::wall || mount == Mount::ceiling ? last : std::nullopt;
}

bool PronounReader::is_told_on_wall(std::int32_t id) const {
  return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
    const auto& said = reading_.placement(one);
    if (one.from != id || !said || said->target == none || said->placement->relations.front() != RelationKind::on) return false;
    const auto place = reading_.place_named(reading_.phrase(said->target));
    return place && place->place == Place::wall;
  });
}

// What was named last in the sentence, else what the clauses before were about.
std::optional<std::size_t> PronounReader::last_in_sentence(std::int32_t id) const {
  const auto sentence = reading_.sentence_of(reading_.phrase(id).head);
  for (std::int32_t i = id; i-- > 0 && reading_.sentence_of(reading_.phrase(i).head) == sentence;)
    if (reading_.mention_of(i) && !reading_.phrase(i).is_pronoun) {
      const Mount mount = reading_.talk.mention(*reading_.mention_of(i)).mount;
      if (mount == Mount::wall || mount == Mount::ceiling || is_told_on_wall(i)) return reading_.mention_of(i);
      break;
    }
  return topic_before(id);
}

// "a table with four chairs around it and a lamp above it": what a thing is with is "it".
std::optional<std::size_t> PronounReader::owner_of(std::int32_t id) const {
  for (const Attachment& attachment : reading_.parse.attachments)
    if (id != none && attachment.to == id && (attachment.relation == "with" || attachment.relation == "have")) {
      if (const auto subject = subject_before(attachment)) return subject;
      if (const auto owner = reading_.mention_of(attachment.from)) return owner;
      return what_was_placed(attachment);
    }
  return std::nullopt;
}

// "a room with a desk opposite the bed, with a mirror above it": what was placed is talked of, not the bed.
std::optional<std::size_t> PronounReader::what_was_placed(const Attachment& with) const {
  std::int32_t last = none;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(reading_.parse.phrases.size()); ++i)
    if (reading_.phrase(i).head < with.tokens.begin) last = i;
  for (const Attachment& one : reading_.parse.attachments)
    if (last != none && one.to == last && reading_.placement(one) && !reading_.placement(one)->placement->inverse)
      return reading_.mention_of(one.from);
  return std::nullopt;
}

// "A dresser faces the bed from the wall, with a mirror above it": it is the dresser's mirror.
std::optional<std::size_t> PronounReader::subject_before(const Attachment& with) const {
  for (const auto& verb : reading_.parse.verbs) {
    const bool is_around = verb.subject != none && verb.tokens.end <= with.tokens.begin &&
                           verb.kind == language::VerbPhrase::Kind::finite &&
                           reading_.sentence_of(verb.tokens.begin) == reading_.sentence_of(with.tokens.begin);
    const bool is_behind_object = with.from != verb.subject &&
                                  (with.from == verb.object || !reading_.mention_of(with.from));
    if (is_around && is_behind_object && reading_.mention_of(verb.subject)) return reading_.mention_of(verb.subject);
  }
  return std::nullopt;
}

// What the clauses before were about.
std::optional<std::size_t> PronounReader::topic_before(std::int32_t id) const {
  for (std::size_t i = reading_.parse.verbs.size(); i-- > 0;) {
    const auto subject = reading_.parse.verbs[i].subject;
    if (subject != none && subject < id && reading_.mention_of(subject))
      return reading_.mention_of(subject);
  }
  for (std::int32_t i = id; i-- > 0;)
    if (reading_.mention_of(i)) return reading_.mention_of(i);
  return std::nullopt;
}

}  // namespace roomgen::brief
