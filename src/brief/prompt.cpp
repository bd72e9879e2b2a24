#include "prompt.h"

#include <algorithm>
#include <map>

#include "discourse.h"
#include "finishes.h"
#include "hearing.h"
#include "measures.h"
#include "occupant_phrase.h"
#include "opening_phrase.h"
#include "placement.h"
#include "room_type.h"
#include "roomgen/base/text.h"
#include "settle.h"
#include "shape_words.h"

namespace roomgen::design {

namespace {

using language::Attachment;
using language::Determiner;
using language::none;
using language::NounPhrase;
using language::Run;
using Indices = std::vector<std::size_t>;

/// What the words of a prompt that are no things were taken for, by token.
enum class Taken : std::uint8_t { no, yes, room };

/// Reads things and their places from a parse.
class PromptReader {
 public:
  PromptReader(const PromptText& text, std::vector<Token> left, std::vector<Taken> taken,
               const Lexicon& lexicon, const RoomKinds& kinds, Brief& brief)
      : text_(text),
        parse_(text.parse),
        kinds_(kinds),
        left_(std::move(left)),
        taken_(std::move(taken)),
        words_(lexicon.words),
        brief_(brief),
        lexicon_(lexicon),
        talk_(lexicon, brief),
        hearing_(text, brief),
        mention_of_(parse_.phrases.size()) {
    for (std::size_t i = 0; i < parse_.phrases.size(); ++i)
      things_.push_back(read_thing_phrase(text_, i));
    for (const auto& attachment : parse_.attachments)
      placements_.push_back(placement_of(text_, attachment));
  }

  void run() {
    read_openings();
    for (std::size_t i = 0; i < parse_.phrases.size(); ++i) read_phrase(i);
    // What the prompt names itself comes before what people need.
    for (const auto id : of_occupants_) read_occupants(id);
    for (const auto& attachment : parse_.attachments) {
      look_back_from(attachment.tokens.begin);
      read_attachment(attachment);
    }
    read_adverbs();
    read_bare();
    read_activities();
    read_styles();
    brief_.understood = !brief_.heard.empty();
    hearing_.plain_verbs(mention_of_);
  }

 private:
  const NounPhrase& phrase(std::int32_t i) const {
    return parse_.phrases[static_cast<std::size_t>(i)];
  }
  const ThingPhrase& thing_at(std::int32_t i) const { return things_[static_cast<std::size_t>(i)]; }
  const std::optional<SaidPlacement>& placement_at(const Attachment& attachment) const {
    return placements_[static_cast<std::size_t>(&attachment - parse_.attachments.data())];
  }
  std::optional<std::size_t> mention_of(std::int32_t i) const {
    return i == none ? std::nullopt : mention_of_[static_cast<std::size_t>(i)];
  }
  const std::string& word(std::size_t token) const { return text_.plain[token].text; }
  bool is_word(std::size_t token, std::string_view word) const {
    return token < text_.plain.size() && text_.plain[token].is_word(word);
  }
  bool is_taken(const NounPhrase& phrase) const { return taken_[phrase.head] != Taken::no; }
  bool is_room(const NounPhrase& phrase) const {
    return taken_[phrase.head] == Taken::room || words_.generic_rooms.count(word(phrase.head));
  }
  int sentence_of(std::size_t token) const {
    int number = 0;
    for (const Run& sentence : parse_.sentences) {
      if (token < sentence.end) return number;
      ++number;
    }
    return number;
  }

  // What was said up to a token: "it" means nothing that comes behind.
  void look_back_from(std::size_t token) {
    std::size_t made = 0;
    for (std::size_t i = 0; i < parse_.phrases.size() && parse_.phrases[i].head < token; ++i)
      if (mention_of_[i]) made = std::max(made, *mention_of_[i] + 1);
    talk_.look_back_from(made);
  }

  // --- Noun phrases -----------------------------------------------------------------------------

  void read_phrase(std::size_t number) {
    const NounPhrase& said = parse_.phrases[number];
    if (is_taken(said)) {
      if (heard_as_person(said.head)) of_occupants_.push_back(static_cast<std::int32_t>(number));
      return;
    }
    if (words_.generic_rooms.count(word(said.head)))
      hear(brief_, {said.head, said.head + 1}, Heard::As::room);
    const auto id = static_cast<std::int32_t>(number);
    if (said.is_pronoun) {
      mention_of_[number] = stands_for(id);
      return;
    }
    const ThingPhrase& thing = things_[number];
    if (said.is_denied) return exclude(id, thing);
    if (thing.kind.length == 0 && names_occupants(said)) {
      of_occupants_.push_back(id);
      return;
    }
    if (const auto carrier = top(number, thing)) {
      mention_of_[number] = carrier;
      hearing_.stand_in(id, *carrier);
      return;
    }
    if (const auto owner = owner_of_part(id, thing)) return hearing_.part(id, *owner);
    if (!names_thing(id, thing)) return;
    if (!thing.article && !thing.definite) read_listed_without_commas(said, thing);
    mention_of_[number] = refer(id, thing);
    if (mention_of_[number]) hearing_.thing(thing, *mention_of_[number]);
    skip_to_ = std::max(skip_to_, thing.end);
  }

  // --- People, and what they do -----------------------------------------------------------------

  // "my twin boys", "a reading corner": whoever or whatever it is, its things stand for the phrase.
  void read_occupants(std::int32_t id) {
    const auto& occupants = Occupants::built_in();
    if (!occupants) return;
    const NounPhrase& said = phrase(id);
    for (auto i = said.tokens.begin; i <= said.head; ++i) {
      auto found = occupant_at(text_, *occupants, i);
      if (!found || found->tokens.begin < said.tokens.begin) continue;
      i = found->tokens.end - 1;
      if (found->persons == 0 && said.count > 1)
        found->persons = static_cast<int>(std::min(said.count, 20.0));
      if (is_for_thing(id)) {
        hear(brief_, found->tokens, Heard::As::person);
        continue;
      }
      const auto lead = bring_things(*found, *occupants, lexicon_, brief_);
      if (lead && found->occupant->is_activity) locate_activity(id, *found, *lead);
    }
  }
  bool names_occupants(const NounPhrase& said) const {
    const auto& occupants = Occupants::built_in();
    if (!occupants) return false;
    for (auto i = said.tokens.begin; i <= said.head; ++i)
      if (occupant_at(text_, *occupants, i)) return true;
    return false;
  }
  // "for two children": how many there are was read with the room.
  bool heard_as_person(std::uint32_t token) const {
    return std::any_of(brief_.heard.begin(), brief_.heard.end(), [&](const HeardWords& words) {
      return words.as == Heard::As::person && words.tokens.begin <= token &&
             token < words.tokens.end;
    });
  }
  // "a chair for guests" is a chair.
  bool is_for_thing(std::int32_t id) const {
    return std::any_of(parse_.attachments.begin(), parse_.attachments.end(),
                       [&](const Attachment& one) {
                         return one.to == id && one.relation == "for" && mention_of(one.from);
                       });
  }
  // "a reading corner by the window": where the activity is, its first thing is.
  void locate_activity(std::int32_t id, const OccupantPhrase& found, std::size_t lead) {
    const NounPhrase& said = phrase(id);
    mention_of_[static_cast<std::size_t>(id)] = lead;
    if (found.tokens.end > said.head) return;
    const std::size_t place = hear(brief_, {said.head, said.head + 1}, Heard::As::activity);
    brief_.mentions[lead].heard.push_back(place);
    const auto part = words_.room_parts.find(word(said.head));
    if (part == words_.room_parts.end() || part->second != "corner") return;
    talk_.told_by(hear(brief_, {said.head, said.head + 1}, Heard::As::relation));
    talk_.demand({lead}, {RelationKind::corner, Demand::none, "", false});
  }

  // "where we knit", "to read": what is done is said by verbs too.
  void read_activities() {
    const auto& occupants = Occupants::built_in();
    if (!occupants) return;
    std::vector<bool> used = heard_tokens();
    for (std::uint32_t i = 0; i < used.size(); ++i) {
      if (used[i] || taken_[i] == Taken::yes || is_denied(i)) continue;
      const auto found = occupant_at(text_, *occupants, i);
      if (!found || used[found->tokens.end - 1]) continue;
      bring_things(*found, *occupants, lexicon_, brief_);
      i = found->tokens.end - 1;
    }
  }
  std::vector<bool> heard_tokens() const {
    std::vector<bool> used(text_.plain.size(), false);
    for (const auto& words : brief_.heard)
      std::fill(used.begin() + words.tokens.begin,
                used.begin() + std::min<std::ptrdiff_t>(words.tokens.end, std::ssize(used)), true);
    return used;
  }

  // "bed desk wardrobe": things of their own, though they stand like "oak" before the last.
  void read_listed_without_commas(const NounPhrase& said, const ThingPhrase& last) {
    for (std::uint32_t i = said.tokens.begin; i + last.kind.length <= said.head;) {
      const KindMention kind = mention_at(text_.table, text_.plain, i);
      if (kind.length > 0 && kind.category->mount == Mount::floor &&
          !words_.materials.count(kind.name)) {
        ThingPhrase thing;
        thing.kind = kind;
        thing.name_tokens = {i, i + static_cast<std::uint32_t>(kind.length)};
        if (const auto mention = talk_.refer(thing, sentence_of(i)))
          hearing_.thing(thing, *mention);
      }
      i += std::max<std::uint32_t>(1, static_cast<std::uint32_t>(kind.length));
    }
  }

  // "a stack of books": what comes behind is part of the name.
  bool names_thing(std::int32_t id, const ThingPhrase& thing) const {
    const NounPhrase& said = phrase(id);
    if (said.tokens.begin < skip_to_) return false;
    if (thing.kind.length == 0) return is_new_thing(id, thing);
    if (thing.kind.length == 1 && (is_bare_material(thing) || is_light(said, thing))) return false;
    return !is_of_owner(id, thing) && !is_inside(id) && !tells_what_it_is_of(id, thing);
  }
  // "glass" alone, without an article, is what something is made of.
  bool is_bare_material(const ThingPhrase& thing) const {
    return !thing.article && !thing.definite && !thing.kind.plural &&
           words_.materials.count(thing.kind.name) > 0;
  }
  // "soft light filters through": no lamp.
  bool is_light(const NounPhrase& said, const ThingPhrase& thing) const {
    return word(said.head) == "light" && !thing.article && !thing.definite;
  }

  // A noun that nobody knows is a thing where things are introduced.
  bool is_new_thing(std::int32_t id, const ThingPhrase& thing) const {
    const NounPhrase& said = phrase(id);
    const bool introduced = thing.article || said.list != none;
    if (!introduced || (thing.definite && !thing.article) || !may_be_thing(text_, thing.noun) ||
        text_.words.room_parts.count(thing.noun) || is_of_owner(id, thing) || is_inside(id))
      return false;
    for (const Attachment& attachment : parse_.attachments)
      if (attachment.to == id && !introduces(attachment)) return false;
    return true;
  }
  bool introduces(const Attachment& attachment) const {
    static const WordSet relations = {"with",    "have", "contain", "include",
                                      "feature", "hold", "display", "support",
                                      "carry",   "by",   "need",    "want"};
    if (relations.count(attachment.relation)) return true;
    const auto said = placement_at(attachment);
    return said && said->placement->inverse;
  }

  // What is inside something, of what it is made: no thing beside it.
  bool is_inside(std::int32_t id) const {
    const NounPhrase& said = phrase(id);
    if (said.determiner != Determiner::absent || said.count > 0) return false;
    for (const Attachment& attachment : parse_.attachments)
      if (attachment.to == id && attachment.relation == "of" && names_owner(attachment.from))
        return true;
    return false;
  }
  // "a collection of books" are books, "a jar of honey" is a jar.
  bool names_owner(std::int32_t id) const { return thing_at(id).kind.length > 0; }
  // "walls of brick", "in leather"
  bool tells_what_it_is_of(std::int32_t id, const ThingPhrase& thing) const {
    if (!words_.materials.count(word(phrase(id).head)) || thing.article || thing.definite)
      return false;
    return std::any_of(parse_.attachments.begin(), parse_.attachments.end(),
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
      return words_.built_in.count(modifier) > 0;
    });
  }
  std::optional<std::size_t> owner_of_part(std::int32_t id, const ThingPhrase& thing) const {
    for (const Attachment& attachment : parse_.attachments) {
      if (attachment.to != id || !owns(attachment)) continue;
      const auto owner = mention_of(attachment.from);
      if (!owner) continue;
      if (is_built_in(thing)) return owner;
      if (words_.parts.count(word(phrase(id).head)) && !is_listed_with_thing(attachment))
        return owner;
      if (thing.kind.length > 0 && thing.kind.category->mount == Mount::wall &&
          talk_.mention(*owner).mount == Mount::surface)
        return owner;
    }
    return std::nullopt;
  }
  // "with a cabinet and a shelf": a shelf beside other things is one.
  bool is_listed_with_thing(const Attachment& attachment) const {
    return std::any_of(
        parse_.attachments.begin(), parse_.attachments.end(), [&](const Attachment& other) {
          return other.from == attachment.from && other.tokens == attachment.tokens &&
                 other.to < attachment.to && mention_of(other.to);
        });
  }
  bool owns(const Attachment& attachment) const {
    static const WordSet relations = {"with", "have", "feature", "include"};
    return relations.count(attachment.relation) > 0;
  }

  std::optional<std::size_t> refer(std::int32_t id, const ThingPhrase& thing) {
    // "on a nightstand" means one of those that are there.
    if (thing.count == 1 && !thing.another && is_target(id))
      if (const auto known = talk_.known(thing)) return known;
    return talk_.refer(thing, sentence_of(phrase(id).head));
  }
  bool is_target(std::int32_t id) const {
    for (const Attachment& attachment : parse_.attachments) {
      if (attachment.to != id) continue;
      const auto said = placement_at(attachment);
      if (said && !said->placement->inverse) return true;
    }
    return false;
  }

  // "the countertop", "its surface": of the table or cabinet that was spoken of.
  std::optional<std::size_t> top(std::size_t number, const ThingPhrase& thing) const {
    const NounPhrase& said = parse_.phrases[number];
    if (!thing.definite) return std::nullopt;
    KindMention owner;
    for (std::size_t i = said.tokens.begin; i < said.head && owner.length == 0; ++i)
      owner = mention_at(text_.table, text_.plain, i);
    const bool is_top = words_.tops.count(word(said.head)) > 0;
    const auto known_owner = talk_.last_of(owner);
    if (!is_top && !(known_owner && words_.portions.count(word(said.head)))) return std::nullopt;
    return known_owner ? known_owner : talk_.last_carrier(word(said.head));
  }

  void exclude(std::int32_t id, const ThingPhrase& thing) {
    const std::string& noun = word(phrase(id).head);
    if (noun == "window" || noun == "windows") {
      brief_.windows = 0;
      hearing_.absence(id, "window");
    }
    const bool is_known = thing.kind.length > 0;
    if (!is_known && !may_be_thing(text_, thing.noun)) return;
    const std::string category = is_known ? talk_.category_name(thing.kind) : thing.noun;
    // "avoid glass tables" forbids no tables.
    if (is_known && !thing.modifiers.empty()) {
      const std::string looks = join(thing.modifiers, " ");
      hearing_.absence(id, looks + " " + category);
      brief_.excluded_looks.push_back({category, looks});
      return;
    }
    hearing_.absence(id, category);
    if (std::find(brief_.excluded.begin(), brief_.excluded.end(), category) ==
        brief_.excluded.end())
      brief_.excluded.push_back(category);
  }

  // --- What words stand for ---------------------------------------------------------------------

  std::optional<std::size_t> stands_for(std::int32_t id) const {
    const NounPhrase& said = phrase(id);
    const std::string& noun = word(said.head);
    const bool is_reciprocal = said.tokens.size() > 1 && said.determiner != Determiner::definite;
    if (noun == "i" || noun == "we" || noun == "you" || is_reciprocal) return std::nullopt;
    const bool is_one_of_several = noun == "one" || noun == "other" || noun == "others" ||
                                   said.determiner == Determiner::each || said.count > 0;
    if (is_one_of_several)
      if (const auto several = talk_.last_of_several()) return several;
    for (const Attachment& attachment : parse_.attachments)
      if (attachment.to == id) return talk_.antecedent(subjects_of(attachment));
    return topic_before(id);
  }
  // What the clauses before were about.
  std::optional<std::size_t> topic_before(std::int32_t id) const {
    for (std::size_t i = parse_.verbs.size(); i-- > 0;) {
      const auto subject = parse_.verbs[i].subject;
      if (subject != none && subject < id && mention_of(subject)) return mention_of(subject);
    }
    for (std::int32_t i = id; i-- > 0;)
      if (mention_of(i)) return mention_of(i);
    return std::nullopt;
  }
  // "one holds …, the other …": which of several is meant.
  int nth_of(std::int32_t id) const {
    if (id == none || !phrase(id).is_pronoun) return -1;
    const std::string& noun = word(phrase(id).head);
    if (noun == "one") return 0;
    return noun == "other" ? 1 : -1;
  }

  // --- Places -----------------------------------------------------------------------------------

  Indices subjects_of(const Attachment& attachment) const {
    const Attachment& said = of_thing(attachment);
    if (said.from == none) return {};
    if (said.is_of_list) return mentions_of_list(said.from);
    const auto mention = mention_of(said.from);
    return mention ? Indices{*mention} : Indices{};
  }
  // "in the corner next to the door": what is said of a place is said of what is there.
  const Attachment& of_thing(const Attachment& attachment) const {
    const Attachment* said = &attachment;
    for (int steps = 0; steps < 4 && said->from != none && !mention_of(said->from); ++steps) {
      const auto to_place = std::find_if(
          parse_.attachments.begin(), parse_.attachments.end(), [&](const Attachment& one) {
            return one.to == said->from && one.relation != "of" && !owns(one);
          });
      if (to_place == parse_.attachments.end()) break;
      said = &*to_place;
    }
    return *said;
  }
  Indices mentions_of_list(std::int32_t phrase) const {
    Indices subjects;
    for (const auto one : parse_.with_list(static_cast<std::uint32_t>(phrase)))
      if (const auto mention = mention_of_[one];
          mention && std::find(subjects.begin(), subjects.end(), *mention) == subjects.end())
        subjects.push_back(*mention);
    return subjects;
  }

  void read_attachment(const Attachment& attachment) {
    if (attachment.is_denied || attachment.from == none) return;
    const auto said = placement_at(attachment);
    const bool is_place = said && said->target != none && !mention_of(said->target);
    talk_.told_by(said || owns(attachment)
                      ? hearing_.relation(attachment, is_place ? said->target : none)
                      : HeardWords::none);
    if (!said) {
      if (owns(attachment)) read_owned(attachment);
      return;
    }
    if (said->placement->inverse) return read_inverse(attachment, *said);
    const Indices subjects = subjects_of(attachment);
    if (subjects.empty()) return;
    if (said->placement->mutual) return relate_mutually(subjects, *said->placement);
    if (said->target == none) return relate_to_implied(subjects, *said->placement);
    read_target(attachment, *said, subjects);
  }

  void read_target(const Attachment& attachment, const SaidPlacement& said,
                   const Indices& subjects) {
    const NounPhrase& target = phrase(said.target);
    if (const auto thing = mention_of(said.target)) {
      if (said.placement->relations.front() != RelationKind::aligned)
        give_each_one(subjects, *thing, target);
      return say(subjects, said, *thing);
    }
    if (is_room(target)) {
      if (said.placement->centered) talk_.locate(subjects, *said.placement, PlacePhrase{});
      return;
    }
    auto place = read_place(text_.plain, target.tokens.begin, words_);
    if (!place) return;
    if (place->place == Place::middle)
      return locate_in_middle(attachment, subjects, *said.placement, *place);
    talk_.locate(subjects, *said.placement, *place);
  }

  // "the middle of the table" is on the table, and so is "at its center".
  void locate_in_middle(const Attachment& attachment, const Indices& subjects,
                        const Placement& placement, const PlacePhrase& place) {
    const NounPhrase& middle = phrase(attachment.to);
    for (const Attachment& of : parse_.attachments)
      if (of.from == attachment.to && of.relation == "of")
        if (const auto thing = mention_of(of.to))
          return talk_.demand(subjects, {RelationKind::on, *thing, "", false});
    if (middle.determiner == Determiner::possessive) {
      if (const auto thing = talk_.antecedent(subjects))
        talk_.demand(subjects, {RelationKind::on, *thing, "", false});
      return;
    }
    talk_.locate(subjects, placement, place);
  }

  void say(const Indices& subjects, const SaidPlacement& said, std::size_t target) {
    if (said.placement->hanging) talk_.hang_from_ceiling(subjects);
    const bool lies_on_part =
        said.is_portion && std::all_of(subjects.begin(), subjects.end(), [&](std::size_t i) {
          return talk_.mention(i).mount == Mount::surface;
        });
    if (lies_on_part) return talk_.demand(subjects, {RelationKind::on, target, "", false});
    for (auto kind : said.placement->relations)
      talk_.demand(subjects, {kind, target, "", said.placement->flank});
  }

  // "a lamp on each nightstand": as many as there are nightstands.
  void give_each_one(const Indices& subjects, std::size_t target, const NounPhrase& said) {
    if (said.determiner != Determiner::each) return;
    for (const std::size_t subject : subjects)
      if (subject != target && talk_.mention(subject).quantity == 1)
        talk_.multiply(subject, talk_.mention(target).quantity);
  }

  // "flanked by two lamps", "holds a vase": the subject is the target.
  void read_inverse(const Attachment& attachment, const SaidPlacement& said) {
    const auto owner = mention_of(attachment.from), thing = mention_of(attachment.to);
    if (!owner || !thing || *owner == *thing) return;
    for (auto kind : said.placement->relations)
      talk_.add(*thing, {kind, *owner, "", said.placement->flank, is_among_several(attachment),
                         nth_of(attachment.from)});
  }
  // "flanked by a dishwasher and a pantry": each takes a side.
  bool is_among_several(const Attachment& attachment) const {
    return std::count_if(
               parse_.attachments.begin(), parse_.attachments.end(), [&](const Attachment& other) {
                 return other.from == attachment.from && other.tokens == attachment.tokens;
               }) > 1;
  }

  void read_owned(const Attachment& attachment) {
    const auto thing = mention_of(attachment.to);
    if (!thing) return;
    for (const std::size_t owner : subjects_of(attachment)) {
      if (owner == *thing) continue;
      // "two nightstands, each with a lamp"
      if (attachment.tokens.begin > 0 && is_word(attachment.tokens.begin - 1, "each"))
        talk_.multiply(*thing, talk_.mention(owner).quantity);
      talk_.own(owner, *thing);
      owner_of_[*thing] = owner;
    }
  }

  // "to its left", "overhead": of what was spoken of before.
  void relate_to_implied(const Indices& subjects, const Placement& placement) {
    const RelationKind first = placement.relations.front();
    auto target = talk_.antecedent(first, subjects);
    // "a board with a knife on top", "a bed with a nightstand on one side"
    if (const auto owner = owner_of_.find(subjects.front()); owner != owner_of_.end())
      target = owner->second;
    if (target) say(subjects, {&placement, none, false}, *target);
  }

  // "nearby", "on top", "side by side": words that no phrase has.
  void read_adverbs() {
    std::vector<bool> used(parse_.tokens.size(), false);
    const auto use = [&](const Run& run) {
      std::fill(used.begin() + run.begin, used.begin() + run.end, true);
    };
    for (const auto& one : parse_.attachments) use(one.tokens);
    for (const auto& one : parse_.phrases) use({one.tokens.begin, one.head + 1});
    for (std::size_t i = 0; i < text_.plain.size(); ++i) {
      if (used[i]) continue;
      look_back_from(i);
      const auto match = longest(words_.placements, text_.plain, i);
      if (!match || (!match.value->pronoun && !match.value->adverb && !match.value->mutual))
        continue;
      const Indices subjects = subjects_at(i);
      const auto first = static_cast<std::uint32_t>(i);
      talk_.told_by(hearing_.adverb({first, first + static_cast<std::uint32_t>(match.length)}));
      if (!subjects.empty() && match.value->mutual)
        relate_listed(i, *match.value);
      else if (!subjects.empty())
        relate_to_implied(subjects, *match.value);
      i += match.length - 1;
    }
  }
  // Of what an adverb is said: the subject of the verb before it, what was named last in its
  // sentence, or what it is said before ("Above hangs a lantern").
  Indices subjects_at(std::size_t token) const {
    for (const auto& verb : parse_.verbs)
      if (verb.tokens.end == token && verb.subject != none)
        if (const auto subjects = mentions_of_list(verb.subject); !subjects.empty())
          return subjects;
    std::optional<std::size_t> before, after;
    for (std::size_t i = 0; i < parse_.phrases.size(); ++i) {
      const std::size_t head = parse_.phrases[i].head;
      if (!mention_of_[i] || sentence_of(head) != sentence_of(token)) continue;
      if (head < token)
        before = mention_of_[i];
      else if (!after)
        after = mention_of_[i];
    }
    if (!before) before = after;
    return before ? Indices{*before} : Indices{};
  }
  // "a desk and a shelf side by side"
  void relate_listed(std::size_t token, const Placement& placement) {
    Indices things;
    for (std::size_t i = 0; i < parse_.phrases.size(); ++i)
      if (parse_.phrases[i].head < token && mention_of_[i] &&
          sentence_of(parse_.phrases[i].head) == sentence_of(token))
        things.push_back(*mention_of_[i]);
    relate_mutually(things, placement);
  }
  // The last two of a list.
  void relate_mutually(const Indices& things, const Placement& placement) {
    if (things.size() < 2) return;
    for (auto kind : placement.relations)
      talk_.add(things.back(), {kind, things[things.size() - 2], "", false});
  }

  // --- Openings, and what is not to be ----------------------------------------------------------

  void read_openings() {
    const auto& kinds = OpeningKinds::built_in();
    if (!kinds) return;
    for (std::size_t i = 0; i < parse_.phrases.size(); ++i) {
      const NounPhrase& said = parse_.phrases[i];
      if (is_taken(said) || said.is_denied || !names_opening(said, *kinds) ||
          is_place_of_thing(static_cast<std::int32_t>(i)))
        continue;
      read_opening_phrase(static_cast<std::int32_t>(i), *kinds);
    }
  }
  bool names_opening(const NounPhrase& said, const OpeningKinds& kinds) const {
    for (std::size_t i = said.tokens.begin; i <= said.head; ++i)
      if (const auto length = opening_name_at(text_.plain, i, kinds);
          length > 0 && i + length > said.head)
        return true;
    return false;
  }
  // "under the window": where a thing is.
  bool is_place_of_thing(std::int32_t id) const {
    for (const Attachment& attachment : parse_.attachments) {
      if (attachment.to != id || attachment.from == none || owns(attachment)) continue;
      const auto kind = thing_at(attachment.from).kind.length;
      if (kind > 0 && placement_at(attachment)) return true;
    }
    return false;
  }
  void read_opening_phrase(std::int32_t id, const OpeningKinds& kinds) {
    const NounPhrase& said = phrase(id);
    std::uint32_t sentence = 0;
    for (const Run& run : parse_.sentences)
      if (run.begin <= said.head) sentence = run.begin;
    const auto opening = read_opening(left_, left_index(said.tokens.begin), left_index(sentence),
                                      words_, text_.table, kinds);
    if (!opening) return;
    if (is_part_of_thing(id, *opening)) return;
    const auto end = opening->end < left_.size() ? left_[opening->end].source.begin : taken_.size();
    std::fill(taken_.begin() + said.tokens.begin, taken_.begin() + static_cast<std::ptrdiff_t>(end),
              Taken::yes);
    ask_for(*opening, brief_);
    hear(brief_, {said.tokens.begin, static_cast<std::uint32_t>(end)}, Heard::As::thing,
         opening->wish.kind);
  }
  // The first of the tokens that are left, from a token of the prompt on.
  std::size_t left_index(std::uint32_t token) const {
    std::size_t i = 0;
    while (i < left_.size() && left_[i].source.end <= token) ++i;
    return i;
  }
  // "a wardrobe with sliding doors"
  bool is_part_of_thing(std::int32_t id, const OpeningPhrase& opening) const {
    if (opening.wish.type == OpeningType::window || opening.wish.has_place()) return false;
    for (const Attachment& attachment : parse_.attachments)
      if (attachment.to == id && attachment.from != none && owns(attachment) &&
          thing_at(attachment.from).kind.length > 0)
        return true;
    return false;
  }

  // "nothing else", "no other …", "with only …"
  void read_bare() {
    static const WordSet holders = {"with", "containing", "contains", "has"};
    const auto is_any = [&](std::size_t token, const WordSet& words) {
      return token < text_.plain.size() && words.count(word(token)) > 0;
    };
    for (std::size_t i = 0; i < text_.plain.size(); ++i)
      if ((is_word(i, "nothing") && is_any(i + 1, {"else", "more"})) ||
          (is_word(i, "no") && is_any(i + 1, {"other", "more", "additional"})) ||
          (i > 0 && words_.only.count(word(i)) && holders.count(word(i - 1))))
        brief_.bare = true;
  }

  // "Rustic but bright.", "a cosy one": words of style that are said of no thing are the room's.
  void read_styles() {
    const std::vector<bool> used = heard_tokens();
    for (std::uint32_t i = 0; i < used.size(); ++i) {
      if (used[i] || taken_[i] == Taken::yes || !names_look(word(i)) || is_denied(i)) continue;
      hear(brief_, {i, i + 1}, Heard::As::style);
      if (std::find(brief_.styles.begin(), brief_.styles.end(), word(i)) == brief_.styles.end())
        brief_.styles.push_back(word(i));
    }
  }
  // "Little" and "open" are words of style only where they are said of a room.
  bool names_look(const std::string& word) const {
    const Style* style = kinds_.style(word);
    return style && (!style->adjective.empty() || !style->more.empty());
  }
  // "not too modern", "nothing rustic"
  bool is_denied(std::size_t token) const {
    for (std::size_t n = 1; n <= 2 && n <= token; ++n)
      if (words_.negations.count(word(token - n)) || is_word(token - n, "nothing")) return true;
    return false;
  }

  const PromptText& text_;
  const language::Parse& parse_;
  const RoomKinds& kinds_;
  const std::vector<Token> left_;  ///< what the other readers did not take, lengths in one piece
  std::vector<Taken> taken_;
  const Vocabulary& words_;
  Brief& brief_;
  const Lexicon lexicon_;
  Discourse talk_;
  Hearing hearing_;
  std::vector<ThingPhrase> things_;                       ///< what the noun phrases would name
  std::vector<std::optional<SaidPlacement>> placements_;  ///< by attachment
  std::vector<std::optional<std::size_t>> mention_of_;    ///< by noun phrase
  std::map<std::size_t, std::size_t> owner_of_;           ///< "a tray with cups": mentions
  std::vector<std::int32_t> of_occupants_;                ///< noun phrases
  std::size_t skip_to_ = 0;                               ///< the token behind the last name
};

// What the readers of measures, people, shapes, rooms and finishes took out of the tokens.
std::vector<Taken> taken_from(std::size_t count, const std::vector<Token>& left) {
  std::vector<Taken> taken(count, Taken::yes);
  for (const Token& token : left)
    for (auto i = token.source.begin; i < token.source.end; ++i)
      taken[i] = token.kind == Token::Kind::room ? Taken::room : Taken::no;
  return taken;
}

}  // namespace

Brief read_prompt(std::string_view prompt, const RoomKinds& kinds, const KindTable& table) {
  Brief brief;
  const auto& words = built_in_vocabulary();
  if (!words) return brief;
  const auto parse =
      language::parse(language::tokenize(prompt, max_tokens),
                      [&](std::string_view name) { return table.spelled(name) != nullptr; });
  if (parse.tokens.size() >= max_tokens)
    brief.notes.push_back("only the first " + std::to_string(max_tokens) +
                          " words of the prompt were read");
  brief.tokens = parse.tokens;
  auto tokens = meaningful_tokens(parse.tokens);
  read_measures(tokens, parse.tokens, *words, table, brief);
  read_people(tokens, *words, table, brief);
  read_floor_shape(tokens, *words, table, kinds, brief);
  read_room_type(tokens, *words, table, kinds, brief);
  read_finishes(tokens, *words, table, finish_words(), brief);
  auto taken = taken_from(parse.tokens.size(), tokens);
  auto plain = plain_tokens(parse.tokens);
  for (std::size_t i = 0; i < plain.size(); ++i)
    if (taken[i] == Taken::room) plain[i].kind = Token::Kind::room;
  const PromptText text{parse, plain, *words, table};
  PromptReader(text, std::move(tokens), std::move(taken), {*words, table, kinds.get(brief.type)},
               kinds, brief)
      .run();
  settle(brief, table);
  if (brief.type.empty()) {
    brief.type = guess_room_type(brief, kinds, table);
    if (!brief.type.empty()) {
      brief.type_known = true;
      brief.notes.push_back("the prompt names no kind of room; taken for a " + brief.type);
    }
  }
  return brief;
}

}  // namespace roomgen::design
