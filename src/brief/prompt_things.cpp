#include <algorithm>

#include "language/inflection.h"
#include "language/lexicon.h"
#include "language/number.h"
#include "phrase_readers.h"
#include "prompt_passes.h"
#include "prompt_pronouns.h"
#include "roomgen/base/text.h"
#include "thing_or_not.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;

class ThingReader {
 public:
  explicit ThingReader(PromptReading& reading) : reading_(reading), words_(reading), pronouns_(reading) {}

  void run() {
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) read_phrase(i);
  }

 private:
  void read_phrase(std::size_t number) {
    const NounPhrase& said = reading_.parse.phrases[number];
    if (reading_.taken[said.head] == Taken::room) read_numbers_of_room(said);
    if (reading_.is_taken(said)) return;
    if (reading_.words.generic_rooms.count(reading_.word(said.head)))
      hear(reading_.brief, {said.head, said.head + 1}, Heard::As::room);
    const auto id = static_cast<std::int32_t>(number);
    if (const auto meant = thing_of_next_noun(reading_, id)) {
      reading_.mentions[number] = reading_.talk.refer(*meant, reading_.sentence_of(said.head));
      if (reading_.mentions[number]) reading_.hearing.thing(*meant, *reading_.mentions[number]);
      return;
    }
    if (said.is_pronoun) {
      // "the northern half"
      if (!reading_.place_named(said)) pronouns_.read(id);
      return;
    }
    ThingPhrase& thing = reading_.things[number];
    if (thing.kind.length == 0) name_by_what_it_holds(id, thing);
    if (acts_as_person(id)) {
      hear(reading_.brief, {said.tokens.begin, said.head + 1}, Heard::As::person);
      return;
    }
    const bool is_somebody = thing.kind.length == 0 && reading_.is_somebody(said);
    if (const auto picture = is_somebody ? what_shows(id) : std::nullopt)
      return reading_.hearing.part(id, *picture);
    if (is_somebody) hear_people(said);
    if (read_exclusion(reading_, id, thing)) return;
    if (const auto carrier = top(number, thing)) {
      reading_.mentions[number] = carrier;
      reading_.hearing.stand_in(id, *carrier);
      return;
    }
    if (const auto whole = whole_of(id)) {
      reading_.mentions[number] = whole;
      reading_.hearing.stand_in(id, *whole);
      return;
    }
    if (const auto owner = words_.owner_of_part(id, thing)) return reading_.hearing.part(id, *owner);
    if (said.tokens.begin < skip_to_ || !words_.names_thing(id, thing)) return;
    if (const auto first = first_of_alternatives(id)) return take_first(id, *first);
    if (!thing.article && !thing.definite) read_listed_without_commas(said, thing);
    const std::size_t before = reading_.talk.count();
    reading_.mentions[number] = refer(id, thing);
    if (const auto owner = person_owning(id); reading_.mentions[number] && !owner.empty()) {
      // "twelve mats facing the teacher's mat": it is none of them.
      std::size_t& own = *reading_.mentions[number];
      if (own < before && reading_.talk.mention(own).quantity > 1) own = reading_.talk.another(own, 1);
      reading_.brief.mentions[own].owner = owner;
    }
    if (reading_.talk.count() > before) note_list(said);
    if (reading_.mentions[number]) {
      read_counts(reading_, id, *reading_.mentions[number]);
      reading_.hearing.thing(thing, *reading_.mentions[number]);
    }
    skip_to_ = std::max(skip_to_, thing.end);
  }
  // "either a workbench or a folding table": what the last thing of a list before "or" is.
  std::optional<std::size_t> first_of_alternatives(std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    if (said.list == none || said.tokens.begin == 0 || !reading_.is_word(said.tokens.begin - 1, "or") || is_target(id)) return std::nullopt;
    for (std::int32_t before = id; before-- > 0;)
      if (reading_.phrase(before).list == said.list) return reading_.mention_of(before);
    return std::nullopt;
  }
  void take_first(std::int32_t id, std::size_t first) {
    reading_.hearing.stand_in(id, first);
    reading_.brief.notes.push_back("of \"" + reading_.talk.mention(first).noun + " or " + reading_.parse.head_of(reading_.phrase(id)) +
                                   "\" the first is taken");
  }
  // "where two painters work"
  void hear_people(const NounPhrase& said) {
    hear(reading_.brief, {said.tokens.begin, said.head + 1}, Heard::As::person);
    if (reading_.brief.people > 0 || tells_age(said)) return;
    double count = said.count;
    for (auto i = said.tokens.begin; i <= said.head && count < 2.0; ++i)
      if (const auto several = reading_.words.people.find(reading_.word(i));
          several != reading_.words.people.end())
        count = several->second;
    if (count >= 2.0) reading_.brief.people = static_cast<int>(std::min(count, 1.0 * most_people));
  }
  bool tells_age(const NounPhrase& said) const {
    static const WordSet spans = {"yr",    "yrs",    "yo",   "year", "years",
                                  "month", "months", "week", "weeks"};
    return std::any_of(reading_.parse.tokens.begin() + said.tokens.begin,
                       reading_.parse.tokens.begin() + said.head,
                       [](const auto& token) { return spans.count(token.text) > 0; });
  }
  // Among which things the newest is named; of "eight desks and chairs" the chairs are joined to eight.
  void note_list(const NounPhrase& said) {
    Mention& newest = reading_.brief.mentions.back();
    newest.list = said.list;
    if (said.list == none || said.tokens.begin == 0 || !reading_.is_word(said.tokens.begin - 1, "and")) return;
    const bool is_bare = said.determiner == Determiner::absent && said.count == 0 && said.is_plural;
    for (const NounPhrase& other : reading_.parse.phrases)
      if (is_bare && other.list == said.list && other.tokens.end + 1 == said.tokens.begin && other.count > 1 && !other.is_pronoun)
        newest.joined_to = static_cast<int>(std::min(other.count, most_of_them));
  }
  // "a TV on a stand": a stand for that, where there is such a kind.
  void name_by_what_it_holds(std::int32_t id, ThingPhrase& thing) const {
    const NounPhrase& said = reading_.phrase(id);
    if (said.determiner == Determiner::definite) return;
    for (const Attachment& attachment : reading_.parse.attachments) {
      const auto& place = reading_.placement(attachment);
      if (attachment.to != id || !place || place->placement->relations.front() != RelationKind::on) continue;
      const auto held = reading_.mention_of(attachment.from);
      if (!held) continue;
      const Mention& mention = reading_.talk.mention(*held);
      for (const std::string& what : {mention.noun, mention.category})
        if (const Kind* kind = reading_.text.table.named(what + " " + reading_.parse.head_of(said))) {
          thing.kind = {kind, 1, said.is_plural, kind->name, NounBasis::name, ""};
          return;
        }
    }
  }
  // "the speaker bangs a hammer": who does something to something is no thing where the word may mean a person.
  bool acts_as_person(std::int32_t id) const {
    const std::string noun = language::singular(reading_.word(reading_.phrase(id).head));
    if (!language::lexicon().may_be(noun, language::WordClass::person)) return false;
    return std::any_of(reading_.parse.verbs.begin(), reading_.parse.verbs.end(), [&](const auto& verb) {
      return verb.subject == id && words_.does_something(verb) && verb.base != "have" && verb.base != "be";
    });
  }
  // An umbrella bucket is one thing, a bed desk two.
  bool is_furniture(const Kind& kind) const {
    return kind.mount == Mount::floor && reading_.text.table.is_any_of(kind.name, {"seat", "table", "storage", "bed"});
  }
  // "an 8-bed dormitory", "a 12-person boardroom": what the room has, or whom it is for.
  void read_numbers_of_room(const NounPhrase& said) {
    for (std::uint32_t i = said.tokens.begin; i + 1 < said.head; ++i) {
      const auto number = language::number_at(reading_.parse.tokens, i);
      if (!number || number->value < 2.0 || number->value > most_people) continue;
      const auto noun = i + static_cast<std::uint32_t>(number->length);
      const KindMention kind = mention_at(reading_.text.table, reading_.text.plain, noun);
      ThingPhrase thing;
      thing.kind = kind;
      thing.count = static_cast<int>(number->value);
      thing.counted = thing.article = true;
      thing.name_tokens = {noun, noun + static_cast<std::uint32_t>(kind.length)};
      for (auto k = i; k < noun; ++k) thing.count_tokens.push_back(k);
      if (seats_people(reading_.word(noun))) {
        reading_.brief.people = thing.count;
        hear(reading_.brief, {i, noun + 1}, Heard::As::person);
      } else if (kind.length > 0 && !kind.is_inferred() && thing.name_tokens.end <= said.head) {
        if (const auto mention = reading_.talk.refer(thing, reading_.sentence_of(i)))
          reading_.hearing.thing(thing, *mention);
      }
    }
  }
  bool seats_people(const std::string& noun) const {
    return noun == "seat" || noun == "seater" || reading_.words.people_words.count(noun) ||
           language::lexicon().is(noun, language::WordClass::person);
  }
  // "bed desk wardrobe": things of their own, though they stand like "oak" before the last.
  void read_listed_without_commas(const NounPhrase& said, const ThingPhrase& last) {
    for (std::uint32_t i = said.tokens.begin; i + last.kind.length <= said.head;) {
      const KindMention kind = mention_at(reading_.text.table, reading_.text.plain, i);
      if (kind.length > 0 && is_furniture(*kind.category) &&
          !reading_.words.materials.count(kind.name)) {
        ThingPhrase thing;
        thing.kind = kind;
        thing.name_tokens = {i, i + static_cast<std::uint32_t>(kind.length)};
        if (const auto mention = reading_.talk.refer(thing, reading_.sentence_of(i)))
          reading_.hearing.thing(thing, *mention);
      }
      i += std::max<std::uint32_t>(1, static_cast<std::uint32_t>(kind.length));
    }
  }
  std::optional<std::size_t> refer(std::int32_t id, const ThingPhrase& thing) {
    // "on a nightstand" means one of those that are there.
    if (thing.count == 1 && !thing.another && is_target(id))
      if (const auto known = reading_.talk.one_of(thing)) return known;
    ThingPhrase own = thing;
    // "one mirror per chair": of the chairs that are there
    if (!thing.article && is_shared_out(id)) own.definite = true;
    // "between sofa and console": in the manner of notes
    if (!thing.article && !thing.kind.plural && thing.modifiers.empty() && is_target(id)) own.definite = true;
    if (is_of_somebody_else(id, thing)) own.definite = false, own.article = true;
    return reading_.talk.refer(own, reading_.sentence_of(reading_.phrase(id).head));
  }
  bool is_shared_out(std::int32_t id) const {
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
                       [&](const Attachment& one) { return one.to == id && one.relation == "per"; });
  }
  // "the teacher's desk" is none of the students'.
  bool is_of_somebody_else(std::int32_t id, const ThingPhrase& thing) const {
    const auto known = thing.definite ? reading_.talk.known(thing) : std::nullopt;
    if (!known) return false;
    const auto& looks = reading_.talk.mention(*known).looks;
    const std::string owner = person_owning(id);
    return !owner.empty() && std::find(looks.begin(), looks.end(), owner) == looks.end();
  }
  // "teacher" of "the teacher's desk"; empty if no person owns what a phrase names.
  std::string person_owning(std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    for (auto i = said.modifiers.begin; i < said.modifiers.end; ++i) {
      const auto& modifier = reading_.parse.modifiers[i];
      const std::string& owner = reading_.word(modifier.tokens.begin);
      if (modifier.kind == language::Modifier::Kind::owner &&
          language::lexicon().is(language::singular(owner), language::WordClass::person))
        return owner;
    }
    return "";
  }
  bool is_target(std::int32_t id) const {
    for (const Attachment& attachment : reading_.parse.attachments) {
      if (attachment.to != id) continue;
      const auto said = reading_.placement(attachment);
      if (said && !said->placement->inverse) return true;
    }
    return false;
  }
  // "the countertop", "its surface": of the table or cabinet that was spoken of.
  std::optional<std::size_t> top(std::size_t number, const ThingPhrase& thing) const {
    const NounPhrase& said = reading_.parse.phrases[number];
    if (!thing.definite) return std::nullopt;
    KindMention owner;
    for (std::size_t i = said.tokens.begin; i < said.head && owner.length == 0; ++i)
      owner = mention_at(reading_.text.table, reading_.text.plain, i);
    const bool is_top = reading_.words.tops.count(reading_.word(said.head)) > 0;
    const auto known_owner = reading_.talk.last_of(owner);
    if (!is_top && !(known_owner && reading_.words.portions.count(reading_.word(said.head))))
      return std::nullopt;
    return known_owner ? known_owner : reading_.talk.last_carrier(reading_.word(said.head));
  }
  // "a bed, its head against the wall": what is said of the place of a part is said of the whole.
  std::optional<std::size_t> whole_of(std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    const std::string& noun = reading_.word(said.head);
    if (said.determiner != Determiner::possessive ||
        !(reading_.words.portions.count(noun) || reading_.words.parts.count(noun)))
      return std::nullopt;
    // "a desk with its back to the window"
    for (const Attachment& with : reading_.parse.attachments)
      if (with.to == id && with.relation == "with" && reading_.mention_of(with.from)) return reading_.mention_of(with.from);
    if (is_target(id)) return pronouns_.stands_for(id);
    const bool has_place = std::any_of(
        reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
        [&](const Attachment& one) { return one.from == id && reading_.placement(one); });
    return has_place ? pronouns_.topic_before(id) : std::nullopt;
  }

  // "posters of bands", "a statue of a dog": who is shown does not live here.
  std::optional<std::size_t> what_shows(std::int32_t id) const {
    for (const Attachment& attachment : reading_.parse.attachments)
      if (attachment.to == id && attachment.relation == "of" && attachment.from != none &&
          reading_.thing(attachment.from).kind.length > 0)
        if (const auto thing = reading_.mention_of(attachment.from)) return thing;
    return std::nullopt;
  }

  PromptReading& reading_;
  const ThingOrNot words_;
  PronounReader pronouns_;
  std::size_t skip_to_ = 0;  ///< the token behind the last name
};

}  // namespace

void read_things(PromptReading& reading) {
  ThingReader(reading).run();
}

}  // namespace roomgen::brief
