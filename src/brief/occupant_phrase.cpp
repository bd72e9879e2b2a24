#include "occupant_phrase.h"

#include <algorithm>

#include "language/inflection.h"
#include "mention_shape.h"

namespace roomgen::brief {

namespace {

// As written, and with its last word as a noun in the singular or a verb in its base form.
std::vector<std::string> forms_of(const std::string& before, const std::string& last) {
  std::vector<std::string> forms{before + last};
  for (const auto& noun : language::singulars(last)) forms.push_back(before + noun);
  if (const auto verb = language::verb(last)) forms.push_back(before + verb->base);
  return forms;
}

int number_at(const PromptText& text, std::uint32_t i) {
  const Token& token = text.plain[i];
  if (token.kind == Token::Kind::number) return static_cast<int>(std::clamp(token.value, 0.0, 1.0 * most_people));
  const auto number = text.words.numbers.find(token.text);
  const bool exact = number != text.words.numbers.end() && !text.words.vague.count(token.text);
  return exact && token.text != "a" && token.text != "an" ? std::min(number->second, most_people) : 0;
}

// "a family of five", but not "a mother of two boys"
int number_of_members(const PromptText& text, std::uint32_t token) {
  if (token + 1 >= text.plain.size() || !text.plain[token].is_word("of")) return 0;
  const bool is_all = std::any_of(text.parse.phrases.begin(), text.parse.phrases.end(),
                                  [&](const auto& phrase) { return phrase.head == token + 1 && phrase.is_pronoun; });
  return is_all ? number_at(text, token + 1) : 0;
}

/// Adds what one occupant means to a brief.
class Bringer {
 public:
  Bringer(const OccupantPhrase& phrase, const Occupants& occupants, const Lexicon& lexicon,
          Brief& brief)
      : phrase_(phrase), occupants_(occupants), lexicon_(lexicon), brief_(brief) {}

  std::optional<std::size_t> run() {
    heard_ = hear(brief_, phrase_.tokens,
                  phrase_.occupant->is_activity ? Heard::As::activity : Heard::As::person);
    for (const auto& thing : phrase_.occupant->things) bring(thing);
    for (const auto& thing : phrase_.occupant->things) relate(thing);
    return first_;
  }

 private:
  // What such a room has of that kind anyway; empty if nothing.
  std::string brought_by_room(const std::string& kind) const { return among(lexicon_.kind.core, kind); }
  std::string among(const std::vector<Piece>& pieces, const std::string& kind) const {
    for (const Piece& piece : pieces)
      for (const auto& [own, weight] : piece.any)
        if (lexicon_.table.is_a(own, kind) || lexicon_.table.is_a(kind, own)) return own;
    return "";
  }
  // A room that says what its people have (a lecture hall a seat for each) has nothing else on its floor for each of them,
  // but of what it has several anyway.
  bool has_other_places(const Occupant::Thing& thing, const Kind& kind) const {
    const auto& core = lexicon_.kind.core;
    if (!thing.each || kind.mount != Mount::floor || phrase_.persons < 2) return false;
    const bool has_places = std::any_of(core.begin(), core.end(), [](const Piece& piece) { return piece.for_people > 0; });
    const bool is_there = std::any_of(core.begin(), core.end(), [&](const Piece& piece) {
      const bool is_several = piece.for_people > 0 || piece.high > 1;
      return is_several && (!among({piece}, kind.name).empty() || !among(piece.then, kind.name).empty());
    });
    return has_places && !is_there;
  }
  // A pupil's chair is a student chair in a classroom.
  std::string meant_in_room(const std::string& kind) const {
    const auto meant = lexicon_.kind.means.find(kind);
    return meant == lexicon_.kind.means.end() ? kind : meant->second;
  }

  // Who is told to have a desk needs no other: of an executive desk or a bistro table the last word
  // says what would do as well.
  std::optional<std::size_t> named(const std::string& kind) const {
    const std::string noun = kind.substr(kind.rfind(' ') + 1);
    const std::string& general = lexicon_.table.by_name(noun) ? noun : kind;
    for (std::size_t i = 0; i < brief_.mentions.size(); ++i)
      if (!is_of_others(brief_.mentions[i]) && (lexicon_.table.is_a(brief_.mentions[i].category, kind) ||
                                                lexicon_.table.is_a(brief_.mentions[i].category, general)))
        return i;
    return std::nullopt;
  }

  bool belongs(const std::string& kind) const {
    return phrase_.occupant->is_activity || occupants_.belongs(kind, brief_.type);
  }
  // The teacher's desk is no pupil's.
  bool is_of_others(const Mention& mention) const {
    return !mention.owner.empty() && occupants_.find(mention.owner) != phrase_.occupant;
  }

  int number_of(const Occupant::Thing& thing) const {
    if (!thing.each) return std::max(1, thing.count);
    if (phrase_.persons > 0) return phrase_.persons;
    if (thing.count > 0) return thing.count;
    if (phrase_.occupant->is_activity) return std::clamp(brief_.people, 1, most_people);
    return std::max(1, phrase_.occupant->count);
  }

  // Seats for as many, or for whoever comes, were told of.
  bool are_seated(const Occupant::Thing& thing) const {
    const bool is_seat = lexicon_.table.is_any_of(thing.kind, {"chair", "stool", "armchair"});
    if (!is_seat || !(thing.each || number_of(thing) > 1)) return false;
    int seats = 0;
    for (const Mention& mention : brief_.mentions)
      if (!is_of_others(mention) && lexicon_.table.is_any_of(mention.category, {"seat"})) seats += mention.quantity;
    return seats >= std::max(2, number_of(thing));
  }
  // "Nothing else", "no more than a lamp on the desk": people bring nothing there.
  bool is_barred(const Occupant::Thing& thing) const {
    if (brief_.bare && !phrase_.occupant->is_activity) return true;
    const auto carrier = brought_.find(thing.to);
    return std::any_of(brief_.limits.begin(), brief_.limits.end(), [&](const Limit& limit) {
      if (!limit.category.empty()) return lexicon_.table.is_a(thing.kind, limit.category);
      return limit.on != no_mention && carrier != brought_.end() && carrier->second == limit.on;
    });
  }

  void bring(const Occupant::Thing& thing) {
    std::optional<std::size_t> mention = named(thing.kind);
    if (!mention) {
      // What stands to a thing that stays away stays away with it.
      const bool belongs = this->belongs(thing.kind) && (thing.to.empty() || this->belongs(thing.to) || named(thing.to));
      // Of what each of several has, such a room has as many as there are people.
      const std::string own = thing.always ? "" : brought_by_room(thing.kind);
      const bool is_counted = thing.each && phrase_.persons > 1;
      const Kind* kind = lexicon_.table.by_name(own.empty() || !is_counted ? meant_in_room(thing.kind) : own);
      if (!kind || !belongs || (!own.empty() && !is_counted) || has_other_places(thing, *kind) || is_barred(thing) || are_seated(thing)) return;
      mention = add(*kind, number_of(thing));
    }
    brief_.mentions[*mention].heard.push_back(heard_);
    brought_[thing.kind] = *mention;
    if (!first_) first_ = mention;
  }

  std::size_t add(const Kind& kind, int count) {
    const auto source = phrase_.occupant->is_activity ? Requirement::Source::activity : Requirement::Source::person;
    brief_.mentions.push_back(
        unnamed_mention(kind.name, count, source, phrase_.occupant->name, lexicon_.words, lexicon_.table));
    return brief_.mentions.size() - 1;
  }

  // What the prompt says of a thing's place itself counts.
  void relate(const Occupant::Thing& thing) {
    const auto own = brought_.find(thing.kind), target = brought_.find(thing.to);
    if (!thing.relation || own == brought_.end()) return;
    Mention& mention = brief_.mentions[own->second];
    if (mention.source == Requirement::Source::prompt) return;
    Demand demand{*thing.relation, Demand::none, "", false};
    if (!thing.to.empty()) {
      if (target == brought_.end() || target->second == own->second) return;
      demand.mention = target->second;
    }
    mention.demands.push_back(demand);
    const bool beside = *thing.relation == RelationKind::near ||
                        *thing.relation == RelationKind::next_to;
    if (beside && mention.mount == Mount::floor && needs_wall(mention, lexicon_.table))
      mention.demands.push_back({RelationKind::edge, Demand::none, "", false});
  }

  const OccupantPhrase& phrase_;
  const Occupants& occupants_;
  const Lexicon& lexicon_;
  Brief& brief_;
  std::size_t heard_ = HeardWords::none;
  std::optional<std::size_t> first_;
  std::map<std::string, std::size_t> brought_;  ///< mentions, by the kinds of the occupant's things
};

}  // namespace

std::optional<OccupantPhrase> occupant_at(const PromptText& text, const Occupants& occupants,
                                          std::uint32_t token) {
  std::optional<OccupantPhrase> best;
  std::string before;
  for (std::uint32_t n = 0; n < longest_occupant_name && token + n < text.plain.size(); ++n) {
    const Token& last = text.plain[token + n];
    if (last.kind != Token::Kind::word) break;
    for (const auto& form : forms_of(before, last.text))
      if (const Occupant* occupant = occupants.find(form)) {
        best = {occupant, {token, token + n + 1}, 0};
        break;
      }
    before += last.text + " ";
  }
  if (!best) return std::nullopt;
  best->persons = token > 0 ? number_at(text, token - 1) : 0;
  if (best->persons > 0) --best->tokens.begin;
  if (const int members = number_of_members(text, best->tokens.end)) best->persons = members, best->tokens.end += 2;
  return best;
}

std::optional<std::size_t> bring_things(const OccupantPhrase& phrase, const Occupants& occupants,
                                        const Lexicon& lexicon, Brief& brief) {
  return Bringer(phrase, occupants, lexicon, brief).run();
}

}  // namespace roomgen::brief
