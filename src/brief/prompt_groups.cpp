#include <algorithm>
#include <map>

#include "prompt_passes.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::none;
using language::NounPhrase;

/// What is told of an area, in the order of the text.
struct Group {
  Indices members;
  std::size_t heard = HeardWords::none;  ///< the words that join the last of them
  bool in_corner = false;
};

class GroupReader {
 public:
  explicit GroupReader(PromptReading& reading) : reading_(reading) {}

  void run() {
    std::map<std::string, Group> groups;  // by the name of the area
    for (const Attachment& attachment : reading_.parse.attachments) collect(attachment, groups);
    for (auto& [name, group] : groups) stand_together(group);
  }

 private:
  void collect(const Attachment& attachment, std::map<std::string, Group>& groups) {
    if (attachment.is_denied || attachment.from == none || attachment.to == none) return;
    const bool has_them = reading_.owns(attachment) && is_area(attachment.from);
    const bool are_in_it = attachment.relation == "in" && is_area(attachment.to);
    if (!has_them && !are_in_it) return;
    const Indices things = has_them ? reading_.all_of(attachment.to) : reading_.subjects_of(attachment);
    if (things.empty()) return;
    const std::int32_t area = has_them ? attachment.from : attachment.to;
    Group& group = groups[name_of(area)];
    for (const std::size_t thing : things)
      if (!is_among(group.members, thing)) group.members.push_back(thing);
    if (const auto lead = reading_.mention_of(area); lead && !is_among(group.members, *lead)) group.members.push_back(*lead);
    group.heard = reading_.hearing.relation(attachment, area);
    group.in_corner = reading_.is_word(reading_.phrase(area).head, "corner");
  }

  // "the reading corner", but not the room itself, nor its corner or one of its things.
  bool is_area(std::int32_t id) const {
    const NounPhrase& phrase = reading_.phrase(id);
    const KindMention& kind = reading_.thing(id).kind;
    const bool is_thing = reading_.mention_of(id) && kind.length > 0 && !kind.is_inferred();  // "a charging station"
    if (is_thing || reading_.taken[phrase.head] == Taken::room || phrase.is_pronoun) return false;
    return reading_.words.areas.count(reading_.word(phrase.head)) > 0 && phrase.head > 0 && is_named(phrase);
  }
  // "the reading corner": of "the left corner" the place is meant.
  bool is_named(const NounPhrase& phrase) const {
    const bool is_corner = reading_.is_word(phrase.head, "corner");
    return !is_corner || std::any_of(reading_.parse.modifiers.begin() + phrase.modifiers.begin,
                                     reading_.parse.modifiers.begin() + phrase.modifiers.end, [&](const auto& modifier) {
                                       const std::string& word = reading_.word(modifier.tokens.begin);
                                       return !reading_.words.walls.count(word) && word != "own";
                                     });
  }
  std::string name_of(std::int32_t id) const {
    const NounPhrase& phrase = reading_.phrase(id);
    std::string name;
    for (auto i = phrase.tokens.begin; i <= phrase.head; ++i)
      if (!reading_.words.definite.count(reading_.word(i)) && !reading_.words.numbers.count(reading_.word(i)))
        name += reading_.word(i) + " ";
    return name;
  }

  void stand_together(const Group& group) {
    const auto anchor = anchor_of(group.members);
    if (!anchor) return;
    reading_.talk.told_by(group.heard);
    keep_in_corner(*anchor, group);
    for (const std::size_t member : group.members)
      if (member != *anchor && stands_free(member)) draw_near(member, *anchor);
    draw_together(*anchor);
    reading_.talk.told_by(HeardWords::none);
  }

  bool is_floor_thing(std::size_t mention) const {
    const Mention& one = reading_.talk.mention(mention);
    return one.mount == Mount::floor && one.part_of == Demand::none && !one.formation;
  }
  bool stands_free(std::size_t mention) const {
    return is_floor_thing(mention) && reading_.talk.mention(mention).demands.empty();
  }
  // The largest thing on the floor.
  std::optional<std::size_t> anchor_of(const Indices& members) const {
    std::optional<std::size_t> best;
    double largest = 0.0;
    for (const std::size_t member : members) {
      const Mention& one = reading_.talk.mention(member);
      const double area = one.size.head<2>().prod();
      const bool is_flat = reading_.text.table.get(one.category).traits.flat;
      if (is_floor_thing(member) && !is_flat && area > largest) best = member, largest = area;
    }
    return best;
  }
  void draw_near(std::size_t member, std::size_t anchor) {
    Demand near{RelationKind::near, anchor, "", false};
    if (reading_.talk.mention(anchor).quantity > 1) near.nth = 0;
    reading_.talk.add(member, near);
  }
  // "a reading corner with two armchairs": the second one is near the first.
  void draw_together(std::size_t anchor) {
    constexpr int most = 4;
    const Mention& mention = reading_.talk.mention(anchor);
    const bool is_free = std::all_of(mention.demands.begin(), mention.demands.end(),
                                     [](const Demand& demand) { return demand.kind == RelationKind::corner; });
    if (mention.quantity < 2 || mention.quantity > most || !is_free) return;
    const std::size_t others = reading_.talk.part(anchor, mention.quantity - 1);
    if (others == anchor) return;
    reading_.brief.mentions[others].demands.clear();  // one of them stands in the corner
    reading_.talk.add(others, {RelationKind::near, anchor, "", false});
  }
  // "a cosy corner"
  void keep_in_corner(std::size_t anchor, const Group& group) {
    if (!group.in_corner || !stands_free(anchor) || reading_.talk.mention(anchor).quantity > 1) return;
    Demand corner{RelationKind::corner, Demand::none, "", false};
    corner.is_means = true;
    reading_.talk.add(anchor, corner);
  }

  PromptReading& reading_;
};

}  // namespace

void read_groups(PromptReading& reading) { GroupReader(reading).run(); }

}  // namespace roomgen::brief
