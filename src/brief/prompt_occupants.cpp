#include "prompt_occupants.h"

#include <algorithm>

#include "language/lexicon.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::NounPhrase;

class OccupantReader {
 public:
  explicit OccupantReader(PromptReading& reading) : reading_(reading) {}

  // "my twin boys", "a reading corner": whoever or whatever it is, its things stand for the phrase.
  void read_occupants(std::int32_t id) {
    const NounPhrase& said = reading_.phrase(id);
    for (auto i = said.tokens.begin; i <= said.head; ++i) {
      auto found = reading_.occupants[i];
      if (!found || found->tokens.begin < said.tokens.begin) continue;
      i = found->tokens.end - 1;
      if (found->persons == 0 && said.count > 1 && !tells_age(reading_, said))
        found->persons = static_cast<int>(std::min(said.count, 1.0 * most_people));
      if (is_for_thing(id)) {
        hear(reading_.brief, found->tokens, Heard::As::person);
        continue;
      }
      const auto lead = bring(*found);
      if (lead && found->occupant->is_activity) locate_activity(id, *found, *lead);
    }
  }
  // "where we knit", "to read": what is done is said by verbs too.
  void read_activities() {
    std::vector<bool> used = reading_.heard_tokens();
    for (std::uint32_t i = 0; i < used.size(); ++i) {
      if (used[i] || reading_.taken[i] == Taken::yes || reading_.is_denied(i)) continue;
      const auto& found = reading_.occupants[i];
      if (!found || used[found->tokens.end - 1]) continue;
      if (has_what_it_needs(*found))
        hear(reading_.brief, found->tokens, Heard::As::activity);
      else
        bring(*found);
      i = found->tokens.end - 1;
    }
  }

 private:
  std::optional<std::size_t> bring(const OccupantPhrase& phrase) {
    count_people(phrase);
    return bring_things(phrase, *Occupants::built_in(), reading_.lexicon, reading_.brief);
  }
  // "eight backpackers" are eight people, "three cats" are none.
  void count_people(const OccupantPhrase& phrase) {
    const auto& english = language::lexicon();
    const std::string& name = phrase.occupant->name;
    const bool are_people = english.is(name, language::WordClass::person) || english.is(name, language::WordClass::group);
    if (phrase.persons > 1 && are_people && reading_.brief.people == 0) reading_.brief.people = phrase.persons;
  }
  // "sleeps on two chairs", "plays chess": what it is done on, or with, was said.
  bool has_what_it_needs(const OccupantPhrase& found) const {
    if (!found.occupant->is_activity) return false;
    for (const auto& verb : reading_.parse.verbs) {
      if (verb.tokens.begin > found.tokens.begin || found.tokens.begin >= verb.tokens.end) continue;
      if (found.occupant->is_of_nothing && verb.object != language::none) return true;
      const auto index = static_cast<std::int32_t>(&verb - reading_.parse.verbs.data());
      for (const Attachment& one : reading_.parse.attachments)
        if (one.verb == index && one.relation == "on" && reading_.mention_of(one.to)) return true;
    }
    return false;
  }
  // "a chair for guests" is a chair.
  bool is_for_thing(std::int32_t id) const {
    return std::any_of(reading_.parse.attachments.begin(), reading_.parse.attachments.end(),
                       [&](const Attachment& one) {
                         return one.to == id && one.relation == "for" &&
                                reading_.mention_of(one.from);
                       });
  }
  // "a reading corner by the window": where the activity is, its first thing is.
  void locate_activity(std::int32_t id, const OccupantPhrase& found, std::size_t lead) {
    const NounPhrase& said = reading_.phrase(id);
    reading_.mentions[static_cast<std::size_t>(id)] = lead;
    if (found.tokens.end > said.head) return;
    const std::size_t place = hear(reading_.brief, {said.head, said.head + 1}, Heard::As::activity);
    reading_.brief.mentions[lead].heard.push_back(place);
    const auto part = reading_.words.room_parts.find(reading_.word(said.head));
    if (part == reading_.words.room_parts.end() || part->second != "corner") return;
    // "six armchairs and a reading corner": one of them is there.
    const Mention& first = reading_.talk.mention(lead);
    if (first.counted && first.quantity > 1) lead = reading_.talk.part(lead, 1);
    reading_.mentions[static_cast<std::size_t>(id)] = lead;
    reading_.talk.told_by(hear(reading_.brief, {said.head, said.head + 1}, Heard::As::relation));
    reading_.talk.demand({lead}, {RelationKind::corner, Demand::none, "", false});
  }

  PromptReading& reading_;
};

}  // namespace

bool tells_age(const PromptReading& reading, const NounPhrase& said) {
  static const WordSet spans = {"yr", "yrs", "yo", "year", "years", "month", "months", "week", "weeks"};
  for (auto i = said.tokens.begin; i < said.head; ++i)
    if (spans.count(reading.word(i))) return true;
  return false;
}

void read_occupants(PromptReading& reading, std::int32_t phrase) {
  OccupantReader(reading).read_occupants(phrase);
}

void read_activities(PromptReading& reading) {
  OccupantReader(reading).read_activities();
}

}  // namespace roomgen::brief
