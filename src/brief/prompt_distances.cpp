#include <algorithm>
#include <limits>

#include "prompt_passes.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::Determiner;
using language::Measure;
using language::none;
using language::NounPhrase;
using language::Run;

/// A length between things, with the words that say so.
struct SaidGap {
  Gap gap;
  Run tokens;
  bool is_apart = false;  ///< "2 m apart"
};

class DistanceReader {
 public:
  explicit DistanceReader(PromptReading& reading) : reading_(reading) {}

  void run() {
    for (std::uint32_t i = 0; i < reading_.text.plain.size(); ++i)
      // Not "nothing within 1 m of them".
      if (const auto said = gap_at(i); said && !reading_.is_denied(said->tokens.begin)) {
        const bool is_read =
            read_apart(*said) || read_around(*said) || read_from(*said) || read_beside(*said);
        if (is_read) i = said->tokens.end - 1;
      }
  }

 private:
  // "about 1 m", "at least 1.5 m", "within 1 m"
  std::optional<SaidGap> gap_at(std::uint32_t i) const {
    const auto measure = language::bounded_measure_at(reading_.parse.tokens, i);
    if (!measure || measure->kind != Measure::Kind::length || !measure->has_unit) return std::nullopt;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Gap gap{measure->values[0], measure->count > 1 ? measure->values[1] : measure->values[0]};
    std::uint32_t begin = i;
    const bool is_within = i > 0 && reading_.is_word(i - 1, "within");
    if (i > 0 && (is_within || reading_.is_word(i - 1, "about") || reading_.is_word(i - 1, "exactly"))) --begin;
    if (is_within || measure->limit == Measure::Limit::most) gap.least = 0.0;
    if (measure->limit == Measure::Limit::least) gap.most = infinite;
    const auto end = i + static_cast<std::uint32_t>(measure->length);
    const bool is_apart = reading_.is_word(end - 1, "apart") || reading_.is_word(end, "apart");
    return SaidGap{gap, {begin, reading_.is_word(end, "apart") ? end + 1 : end}, is_apart};
  }

  // "two beds 60 cm apart": the one from the other.
  bool read_apart(const SaidGap& said) {
    if (!said.is_apart) return false;
    const Indices before = reading_.named_before(said.tokens.begin);
    if (before.empty()) return false;
    const auto parts = reading_.talk.with_parts(before.back());
    std::size_t one = before.back(), other = one;
    if (parts.size() == 2)
      one = parts.front(), other = parts.back();
    else if (parts.size() == 1 && reading_.talk.mention(one).quantity == 2)
      other = reading_.talk.part(one, 1);
    if (one == other) return false;
    demand({other}, said.tokens, said.gap, one, "");
    return true;
  }

  // "at least 1 m clear all around it", "90 cm free on all sides of the island": to all else that
  // stands on the floor, but who sits there.
  bool read_around(const SaidGap& said) {
    static const WordSet clear = {"clear", "free",  "clearance",   "space",
                                  "room",  "empty", "unobstructed"};
    static const WordSet around = {"around", "round", "sides"};
    static const WordSet between = {"of",   "all",  "on",    "every", "each",
                                    "side", "both", "floor", "its",   "four"};
    std::uint32_t at = said.tokens.end;
    bool is_clear = false, is_around = false;
    for (; at < reading_.text.plain.size() && at < said.tokens.end + 8; ++at) {
      const std::string& word = reading_.word(at);
      if (!clear.count(word) && !around.count(word) && !between.count(word)) break;
      is_clear = is_clear || clear.count(word),
      is_around = is_around || around.count(word) || word == "side";
    }
    if (!is_clear || !is_around) return false;
    const NounPhrase* target = phrase_at(at);
    const Indices before = reading_.named_before(said.tokens.begin);
    std::optional<std::size_t> thing;
    if (target && !target->is_pronoun)
      thing = reading_.mentions[static_cast<std::size_t>(target - reading_.parse.phrases.data())];
    else if (!before.empty())
      thing = before.back();
    if (!thing) return false;
    keep_clear(*thing, {said.tokens.begin, target ? target->head + 1 : at}, said.gap);
    return true;
  }
  void keep_clear(std::size_t thing, const Run& words, const Gap& said) {
    Demand clear{RelationKind::gap, Demand::none, each_wall, false};
    clear.gap = {said.least, std::numeric_limits<double>::infinity()};
    tell(words);
    reading_.talk.add(thing, clear);
    clear.part.clear();
    for (std::size_t other = 0; other < reading_.talk.count(); ++other) {
      const Mention& mention = reading_.talk.mention(other);
      const bool is_in_way = mention.mount == Mount::floor &&
                             !reading_.text.table.get(mention.category).traits.flat &&
                             !reading_.text.table.is_any_of(mention.category, {"chair", "stool"});
      clear.mention = other;
      if (other != thing && is_in_way && mention.part_of != thing) reading_.talk.add(thing, clear);
    }
  }

  // "0.5 m from the desk", "1.5 m away from every wall", "within 1 m of the door"
  bool read_from(const SaidGap& said) {
    std::uint32_t at = said.tokens.end;
    if (reading_.is_word(at, "away") || reading_.is_word(at, "back") || reading_.is_word(at, "clear")) ++at;
    const bool is_of = reading_.is_word(at, "of") && reading_.is_word(said.tokens.begin, "within");
    if (!(reading_.is_word(at, "from") || reading_.is_word(at, "off") || is_of)) return false;
    const NounPhrase* target = phrase_at(at + 1);
    const Indices before = reading_.named_before(said.tokens.begin);
    if (!target || before.empty()) return false;
    return keep_from({before.back()}, {said.tokens.begin, target->head + 1}, said.gap, *target);
  }

  // "2 m in front of the screen": beside what is said of its place.
  bool read_beside(const SaidGap& said) {
    for (std::size_t i = 0; i < reading_.parse.attachments.size(); ++i) {
      const Attachment& one = reading_.parse.attachments[i];
      const auto& place = reading_.placements[i];
      if (one.tokens.begin != said.tokens.end || !place || place->placement->inverse || place->target == none) continue;
      if (!is_level(place->placement->relations.front())) return false;
      return keep_from(reading_.subjects_of(one), said.tokens, said.gap, reading_.phrase(place->target));
    }
    return false;
  }
  static bool is_level(RelationKind kind) {
    return kind == RelationKind::in_front_of || kind == RelationKind::behind || kind == RelationKind::left_of ||
           kind == RelationKind::right_of || kind == RelationKind::side_of || kind == RelationKind::next_to || kind == RelationKind::near;
  }

  bool keep_from(const Indices& subjects, const Run& words, const Gap& gap, const NounPhrase& target) {
    const auto thing = reading_.mentions[static_cast<std::size_t>(&target - reading_.parse.phrases.data())];
    const std::string part = thing ? "" : part_named(target, gap);
    if (subjects.empty() || (!thing && part.empty()) || (thing && is_among(subjects, *thing))) return false;
    if (part == "window-0") reading_.brief.windows = std::max(1, reading_.brief.windows.value_or(1));
    demand(subjects, words, gap, thing.value_or(Demand::none), part);
    return true;
  }
  // The part of the room that a phrase means; empty if none.
  std::string part_named(const NounPhrase& target, const Gap& gap) const {
    const auto place = reading_.place_named(target);
    if (!place) return "";
    if (place->place == Place::window) return "window-0";
    if (place->place == Place::door) return "door-0";
    if (place->place != Place::wall) return "";
    const std::string wall = wall_named(*place);
    if (!wall.empty()) return wall;
    const bool are_all = target.is_plural || target.determiner == Determiner::each || target.determiner == Determiner::any;
    return are_all || gap.least < gap.most ? each_wall : "wall";
  }
  void demand(const Indices& subjects, const Run& words, const Gap& gap, std::size_t thing, const std::string& part) {
    tell(words);
    Demand demand{RelationKind::gap, thing, part, false};
    demand.gap = gap;
    for (const std::size_t subject : subjects) reading_.talk.add(subject, demand);
  }
  // The words tell no other place.
  void tell(const Run& words) {
    reading_.talk.told_by(hear(reading_.brief, words, Heard::As::relation));
    for (std::size_t i = 0; i < reading_.parse.attachments.size(); ++i)
      if (words.begin <= reading_.parse.attachments[i].tokens.begin && reading_.parse.attachments[i].tokens.begin < words.end)
        reading_.placements[i].reset();
  }

  const NounPhrase* phrase_at(std::uint32_t token) const {
    const auto found = std::find_if(reading_.parse.phrases.begin(), reading_.parse.phrases.end(),
                                    [&](const NounPhrase& one) { return one.tokens.begin == token; });
    return found == reading_.parse.phrases.end() ? nullptr : &*found;
  }

  PromptReading& reading_;
};

}  // namespace

void read_distances(PromptReading& reading) { DistanceReader(reading).run(); }

}  // namespace roomgen::brief
