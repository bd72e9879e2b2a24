#include "prompt_things.h"

#include <algorithm>

#include "language/inflection.h"
#include "language/lexicon.h"
#include "prompt_ellipsis.h"
#include "prompt_limits.h"
#include "prompt_pronouns.h"
#include "roomgen/base/text.h"
#include "scene/finish_words.h"

namespace roomgen::design {

namespace {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;

class ThingReader {
 public:
  explicit ThingReader(PromptReading& reading) : reading_(reading), pronouns_(reading) {}

  /// Gives back the noun phrases that are people or what they do.
  std::vector<std::int32_t> run() {
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) read_phrase(i);
    return std::move(occupants_);
  }

 private:
  void read_phrase(std::size_t number) {
    const NounPhrase& said = reading_.parse.phrases[number];
    if (reading_.is_taken(said)) {
      if (heard_as_person(said.head)) occupants_.push_back(static_cast<std::int32_t>(number));
      return;
    }
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
    if (thing.kind.length == 0 && reading_.is_somebody(said))
      hear(reading_.brief, {said.tokens.begin, said.head + 1}, Heard::As::person);
    const bool is_denied = said.is_denied || is_of_nobody(id);
    if (is_denied && exclude_look(id, thing)) return;
    if (is_denied && !is_denied_place(id)) return exclude(id, thing);
    if (const auto picture = names_occupants(said) ? what_shows(id) : std::nullopt) return reading_.hearing.part(id, *picture);
    if ((thing.kind.length == 0 || thing.kind.is_inferred()) && names_occupants(said)) {
      occupants_.push_back(id);
      return;
    }
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
    if (const auto owner = owner_of_part(id, thing)) return reading_.hearing.part(id, *owner);
    if (!names_thing(id, thing)) return;
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
      read_rows(id, *reading_.mentions[number]);
      one_for_each_person(id, *reading_.mentions[number]);
      reading_.hearing.thing(thing, *reading_.mentions[number]);
    }
    skip_to_ = std::max(skip_to_, thing.end);
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
      return verb.subject == id && does_something(verb) && verb.base != "have" && verb.base != "be";
    });
  }
  // "bangs a hammer": neither a verb of how things stand or look, nor one in the passive.
  bool does_something(const language::VerbPhrase& verb) const {
    const std::string& word = reading_.word(verb.tokens.end - 1);
    return verb.object != none && verb.kind == language::VerbPhrase::Kind::finite && !verb.is_passive &&
           !reading_.words.verbs.count(word) && !reading_.words.stops.count(word) && !reading_.words.placements.count(word);
  }
  // "three rows of five seats"
  void read_rows(std::int32_t id, std::size_t mention) {
    for (const Attachment& attachment : reading_.parse.attachments) {
      if (attachment.to != id || attachment.relation != "of" || attachment.from == none) continue;
      const NounPhrase& rows = reading_.phrase(attachment.from);
      if (counts_new(id, rows, mention)) {
        reading_.talk.set_count(mention, static_cast<int>(rows.count));
        reading_.hearing.number(attachment.from, mention);
      }
      if (!reading_.words.groups.count(reading_.word(rows.head))) continue;
      reading_.mentions[static_cast<std::size_t>(attachment.from)] = mention;
      if (rows.count > 1 && reading_.phrase(id).count > 0)
        reading_.talk.multiply(mention, static_cast<int>(rows.count));
      reading_.hearing.number(attachment.from, mention);
    }
  }
  // "three toddlers nap in their own cots", "four flatmates: each has a bin": as many as there are of them.
  void one_for_each_person(std::int32_t id, std::size_t mention) {
    const NounPhrase& said = reading_.phrase(id);
    const bool is_own = said.determiner == Determiner::possessive && said.is_plural && said.head > said.tokens.begin &&
                        reading_.is_word(said.tokens.begin + 1, "own");
    if (!is_own && !is_had_by_each(id)) return;
    for (std::int32_t i = id; i-- > 0;) {
      const NounPhrase& before = reading_.phrase(i);
      if (before.count < 2 || before.is_pronoun || reading_.mention_of(i) || !reading_.is_somebody(before)) continue;
      if (before.count > most_of_them) return;
      reading_.talk.set_count(mention, static_cast<int>(before.count));
      return reading_.hearing.number({said.tokens.begin, said.tokens.begin + (is_own ? 2u : 1u)}, mention);
    }
  }
  static constexpr double most_of_them = 40;
  bool is_had_by_each(std::int32_t id) const {
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
      return one.to == id && one.from != none && reading_.owns(one) && reading_.phrase(one.from).is_pronoun &&
             reading_.phrase(one.from).determiner == Determiner::each && !reading_.mention_of(one.from);
    });
  }
  // "3 of those recliners", which nothing was said of before
  bool counts_new(std::int32_t id, const NounPhrase& number, std::size_t mention) const {
    return number.is_pronoun && number.count >= 1 && !reading_.talk.mention(mention).counted &&
           mention + 1 == reading_.talk.count() && reading_.phrase(id).is_plural;
  }
  // An umbrella bucket is one thing, a bed desk two.
  bool is_furniture(const Kind& kind) const {
    return kind.mount == Mount::floor && reading_.text.table.is_any_of(kind.name, {"seat", "table", "storage", "bed"});
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
  // "a stack of books": what comes behind is part of the name.
  bool names_thing(std::int32_t id, const ThingPhrase& thing) const {
    const NounPhrase& said = reading_.phrase(id);
    if (said.tokens.begin < skip_to_ || gives_reason(said) || names_tone(said, thing) || is_talked_about(id) || is_formation(id) || is_handled(id) || is_of_occupant(said) || is_who_it_is_for(id)) return false;
    if (thing.kind.length == 0)
      return is_new_thing(id, thing) || (thing.definite && reading_.talk.known(thing));
    if (thing.kind.length == 1 && (is_bare_material(thing) || is_light(said, thing))) return false;
    return !is_of_owner(id, thing) && !is_inside(id) && !tells_what_it_is_of(id, thing);
  }
  // "because I have run out of shelves": up to the mark before.
  bool gives_reason(const NounPhrase& said) const {
    for (std::uint32_t i = said.tokens.begin; i-- > 0;) {
      const auto kind = reading_.text.plain[i].kind;
      if (reading_.is_word(i, "because")) return true;
      if (kind == Token::Kind::comma || kind == Token::Kind::stop) return false;
    }
    return false;
  }
  // "who uses a wheelchair": the words name the person.
  bool is_of_occupant(const NounPhrase& said) const {
    for (std::uint32_t i = said.tokens.begin > 3 ? said.tokens.begin - 3 : 0; i < said.tokens.begin; ++i)
      if (const auto& found = reading_.occupants[i]; found && found->tokens.end > said.head) return true;
    return false;
  }
  // "a podcast studio for four speakers"
  bool is_who_it_is_for(std::int32_t id) const {
    if (!language::lexicon().may_be(reading_.parse.head_of(reading_.phrase(id)), language::WordClass::person)) return false;
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
      return one.to == id && one.relation == "for" && one.from != none && reading_.is_room(reading_.phrase(one.from));
    });
  }
  // "nobody needs desks"
  bool is_of_nobody(std::int32_t id) const {
    return std::any_of(reading_.parse.verbs.begin(), reading_.parse.verbs.end(), [&](const language::VerbPhrase& verb) {
      return verb.object == id && verb.subject != none && reading_.is_word(reading_.phrase(verb.subject).head, "nobody");
    });
  }
  // "in two columns of four"
  bool is_formation(std::int32_t id) const {
    const std::string& noun = reading_.word(reading_.phrase(id).head);
    const bool is_row = reading_.words.rows.count(noun) > 0;
    if (!is_row && !reading_.words.groups.count(noun)) return false;
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
      if (one.from == id && one.relation == "of") return is_row || is_number(one.to);
      return one.to == id && one.relation == "in" && is_row;
    });
  }
  // "blocks of four"
  bool is_number(std::int32_t id) const {
    return id != none && reading_.phrase(id).is_pronoun && reading_.phrase(id).count > 0;
  }
  // "relatives who argue about football", "light strips like a racing grid", "if I see a desk"
  bool is_talked_about(std::int32_t id) const {
    for (auto i = reading_.phrase(id).tokens.begin; i-- > 0 && reading_.text.plain[i].kind == Token::Kind::word;)
      if (reading_.is_word(i, "if")) return true;
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
                       [&](const Attachment& one) {
                         return one.to == id && (one.relation == "about" || one.relation == "like");
                       });
  }
  // "kids drop scooters", "an intern distributes pizza": told of what people do, no thing of the room.
  bool is_handled(std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    if (said.determiner != Determiner::absent || said.count > 0 || said.is_pronoun) return false;
    return std::any_of(reading_.parse.verbs.begin(), reading_.parse.verbs.end(), [&](const auto& verb) {
      return verb.object == id && verb.subject != none && does_something(verb) && !reading_.words.asking.count(verb.base) &&
             !reading_.phrase(verb.subject).is_pronoun && !reading_.mention_of(verb.subject) &&
             reading_.is_somebody(reading_.phrase(verb.subject));
    });
  }
  // "bottle green", "oatmeal", without an article: what something looks like.
  bool names_tone(const NounPhrase& said, const ThingPhrase& thing) const {
    if (thing.article || thing.definite || thing.kind.plural || said.is_plural) return false;
    for (auto i = said.tokens.begin; i <= said.head; ++i)
      if (!finish_words().describes(reading_.word(i))) return false;
    return true;
  }
  // "glass" alone, without an article, is what something is made of, and "the glass" of which nothing was said before
  // is a pane.
  bool is_bare_material(const ThingPhrase& thing) const {
    return !thing.article && !(thing.definite && reading_.talk.known(thing)) && !thing.kind.plural &&
           reading_.words.materials.count(thing.kind.name) > 0;
  }
  // "soft light filters through": no lamp.
  bool is_light(const NounPhrase& said, const ThingPhrase& thing) const {
    return reading_.word(said.head) == "light" && !thing.article && !thing.definite;
  }
  // A noun that nobody knows is a thing where things are introduced.
  bool is_new_thing(std::int32_t id, const ThingPhrase& thing) const {
    const NounPhrase& said = reading_.phrase(id);
    const bool introduced = thing.article || (said.list != none && !may_be_stuff(thing.noun));
    const bool names_thing = may_be_thing(reading_.text, thing.noun) && is_physical(thing.noun);
    if (!introduced || (thing.definite && !thing.article) || !(names_thing || may_stand_there(id, thing.noun)) ||
        reading_.text.words.room_parts.count(thing.noun) || is_of_owner(id, thing) || is_inside(id))
      return false;
    for (const Attachment& attachment : reading_.parse.attachments)
      if (attachment.to == id && !introduces(attachment)) return false;
    return true;
  }
  // "a branch in a vase", "a shelf holding a dollhouse miniature": whatever its noun means else, it is a thing where
  // it is put to one.
  bool may_stand_there(std::int32_t id, const std::string& noun) const {
    const Vocabulary& words = reading_.words;
    if (noun.size() < 3 || words.no_things.count(noun) || words.parts.count(noun) || words.portions.count(noun) ||
        words.room_words.count(noun) || words.groups.count(noun) || words.shares.count(noun) ||
        words.walls.count(noun) || words.stops.count(noun) || words.placements.count(noun))
      return false;
    using language::WordClass;
    const auto& english = language::lexicon();
    for (const auto other : {WordClass::person, WordClass::animal, WordClass::activity, WordClass::time, WordClass::feeling,
                             WordClass::event, WordClass::room, WordClass::building, WordClass::body_part})
      if (english.is(noun, other) && !english.may_be(noun, WordClass::artefact)) return false;
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(), [&](const Attachment& one) {
      const auto& said = reading_.placement(one);
      if (!said || one.to == none) return false;
      if (one.to == id) return said->placement->inverse && reading_.mention_of(one.from);
      return one.from == id && !said->placement->inverse && said->target != none &&
             (reading_.thing(said->target).kind.length > 0 || reading_.phrase(said->target).is_pronoun);
    });
  }
  static bool names_artefact(const std::string& noun) {
    using language::WordClass;
    const auto& lexicon = language::lexicon();
    const std::string word = language::singular(noun);
    return lexicon.is(word, WordClass::artefact) && !lexicon.is(word, WordClass::building) &&
           !lexicon.is(word, WordClass::room) && !lexicon.is(word, WordClass::place);
  }
  bool introduces(const Attachment& attachment) const {
    static const WordSet relations = {"with",    "have", "contain", "include",
                                      "feature", "hold", "display", "support",
                                      "carry",   "by",   "need",    "want"};
    if (relations.count(attachment.relation)) return true;
    const auto said = reading_.placement(attachment);
    if (!said) return false;
    // "on an altar", but not "at an angle"
    return said->placement->inverse ||
           names_artefact(reading_.word(reading_.phrase(attachment.to).head));
  }
  // What is inside something, of what it is made: no thing beside it.
  bool is_inside(std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    if (said.determiner != Determiner::absent || said.count > 0) return false;
    for (const Attachment& attachment : reading_.parse.attachments)
      if (attachment.to == id && attachment.relation == "of" && names_owner(attachment.from))
        return true;
    return false;
  }
  // "a collection of books" are books, "a jar of honey" is a jar.
  bool names_owner(std::int32_t id) const { return reading_.thing(id).kind.length > 0; }
  // "walls of brick", "in leather"
  bool tells_what_it_is_of(std::int32_t id, const ThingPhrase& thing) const {
    if (!reading_.words.materials.count(reading_.word(reading_.phrase(id).head)) || thing.article ||
        thing.definite)
      return false;
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
                       [&](const Attachment& one) {
                         return one.to == id && (one.relation == "of" || one.relation == "in");
                       });
  }
  // "a desk with drawers", "with an integrated sink", "a photo frame with a print": no other thing.
  bool is_of_owner(std::int32_t id, const ThingPhrase& thing) const {
    return is_built_in(thing) || owner_of_part(id, thing).has_value();
  }
  bool is_built_in(const ThingPhrase& thing) const {
    return std::any_of(thing.modifiers.begin(), thing.modifiers.end(), [&](const auto& modifier) {
      return reading_.words.built_in.count(modifier) > 0;
    });
  }
  std::optional<std::size_t> owner_of_part(std::int32_t id, const ThingPhrase& thing) const {
    for (const Attachment& attachment : reading_.parse.attachments) {
      if (attachment.to != id || !reading_.owns(attachment)) continue;
      const auto owner = reading_.mention_of(attachment.from);
      if (!owner) continue;
      if (is_built_in(thing)) return owner;
      if (reading_.words.parts.count(reading_.word(reading_.phrase(id).head)) &&
          !is_listed_with_thing(attachment))
        return owner;
      if (thing.kind.length > 0 && thing.kind.category->mount == Mount::wall &&
          reading_.talk.mention(*owner).mount == Mount::surface)
        return owner;
    }
    return std::nullopt;
  }
  // "with a cabinet and a shelf": a shelf beside other things is one.
  bool is_listed_with_thing(const Attachment& attachment) const {
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
                       [&](const Attachment& other) {
                         return other.from == attachment.from &&
                                other.tokens == attachment.tokens && other.to < attachment.to &&
                                reading_.mention_of(other.to);
                       });
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
    if (is_target(id)) return pronouns_.stands_for(id);
    const bool has_place = std::any_of(
        reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
        [&](const Attachment& one) { return one.from == id && reading_.placement(one); });
    return has_place ? pronouns_.topic_before(id) : std::nullopt;
  }

  // "not next to the sofa": the sofa is there.
  bool is_denied_place(std::int32_t id) const {
    return reading_.phrase(id).determiner == Determiner::definite &&
           std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
                       [&](const Attachment& one) { return one.to == id && one.is_denied && reading_.placement(one); });
  }
  // "no pink", "no red things": no thing shall look so.
  bool exclude_look(std::int32_t id, const ThingPhrase& thing) {
    static const WordSet of_nothing = {"colour", "colours", "color", "colors", "whatsoever"};
    const NounPhrase& said = reading_.phrase(id);
    const std::string& noun = reading_.word(said.head);
    if (thing.kind.length > 0 && !thing.kind.is_inferred()) return false;
    std::vector<std::string> looks;
    for (auto i = said.tokens.begin; i <= said.head; ++i)
      if (finish_words().describes(reading_.word(i))) looks.push_back(reading_.word(i));
    if (looks.empty() || !(finish_words().describes(noun) || of_nothing.count(noun) || reading_.words.anything.count(noun)))
      return false;
    const std::string look = join(looks, " ");
    reading_.hearing.absence(id, look);
    reading_.brief.excluded_looks.push_back({"", look});
    return true;
  }
  void exclude(std::int32_t id, const ThingPhrase& thing) {
    if (denies_others(reading_, reading_.phrase(id))) return;
    const std::string& noun = reading_.word(reading_.phrase(id).head);
    if (noun == "window" || noun == "windows") {
      reading_.brief.windows = 0;
      reading_.hearing.absence(id, "window");
    }
    const bool is_named = thing.kind.length > 0, is_known = is_named && !thing.kind.is_stand_in();
    if (!is_named && !may_be_thing(reading_.text, thing.noun)) return;
    const std::string& unknown = is_named ? thing.kind.name : thing.noun;
    const std::string category = is_known ? thing.kind.category->name : unknown;
    // "avoid glass tables" forbids no tables.
    if (is_known && !thing.modifiers.empty()) {
      const std::string looks = join(thing.modifiers, " ");
      reading_.hearing.absence(id, looks + " " + category);
      reading_.brief.excluded_looks.push_back({category, looks});
      return;
    }
    reading_.hearing.absence(id, category);
    if (std::find(reading_.brief.excluded.begin(), reading_.brief.excluded.end(), category) ==
        reading_.brief.excluded.end())
      reading_.brief.excluded.push_back(category);
  }
  // "for two children": how many there are was read with the room.
  bool heard_as_person(std::uint32_t token) const {
    return std::any_of(reading_.brief.heard.begin(), reading_.brief.heard.end(),
                       [&](const HeardWords& words) {
                         return words.as == Heard::As::person && words.tokens.begin <= token &&
                                token < words.tokens.end;
                       });
  }
  bool names_occupants(const NounPhrase& said) const {
    const auto begin = reading_.occupants.begin();
    return std::any_of(begin + said.tokens.begin, begin + said.head + 1,
                       [](const auto& found) { return found.has_value(); });
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
  PronounReader pronouns_;
  std::vector<std::int32_t> occupants_;
  std::size_t skip_to_ = 0;  ///< the token behind the last name
};

}  // namespace

std::vector<std::int32_t> read_things(PromptReading& reading) {
  return ThingReader(reading).run();
}

}  // namespace roomgen::design
