#include "phrase.h"

#include "part_forms.h"
#include "phrase_attributes.h"
#include "phrase_measure.h"
#include "phrase_nouns.h"
#include "phrase_objects.h"
#include "phrase_place.h"
#include "phrase_text.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

constexpr std::size_t most_objects = 8;
constexpr int usual_some = 3;  // of things named in the plural without a number

// Walks through the sentence once. Adjectives wait for their noun; what is said after a noun, up to
// a boundary, belongs to it.
class PhraseReader {
 public:
  PhraseReader(const std::string& prompt, const Words& words, const ShapeKinds& kinds)
      : words_(words),
        kinds_(kinds),
        text_(prompt, *built_in_parts(), kinds),
        nouns_(text_, words, kinds),
        objects_(prompt, kinds) {}

  std::vector<Description> run() {
    while (at_ < text_.size()) step();
    return objects_.finish(context_);
  }

 private:
  void step() {
    const std::string& word = text_[at_];
    if (word == ",") return boundary();
    if (text_.is(at_, {"for", "when", "while", "because"})) {
      boundary();
      return skip_purpose();
    }
    if (words_.negations.count(word) || (word == "not" && text_.is(at_ + 1, {"a", "any", "one"}))) {
      boundary();
      context_.negated = true;
      return;
    }
    // "the mattress is missing", "leave the armrests out"
    if (text_.is(at_, {"missing", "absent"}) || (word == "out" && leaves_out_)) {
      take_away_last();
      ++at_;
      return;
    }
    if (text_.is(at_, {"leave", "leaving"})) leaves_out_ = true;
    if (simile() || arrangement() || measure() || relation() || placement() || attribute() ||
        noun())
      return;
    // "a tall and narrow back" goes on.
    if (word == "and" && (objects_.pending().article || objects_.empty())) {
      ++at_;
      return;
    }
    if (words_.boundaries.count(word)) return boundary();
    if (!words_.fillers.count(word)) objects_.unknown().push_back(word);
    if (text_.is(at_, {"a", "an", "the"})) {
      objects_.pending().article = true;
      context_.indefinite = word != "the";
    }
    ++at_;
  }

  // --- Where phrases end ----------------------------------------------------------------------

  // What was said since the last noun belongs to it.
  void boundary() {
    context_.boundary = text_[at_];
    if (!text_.is(at_, {",", "and", "of", "made"})) objects_.add_early_part();
    // "on a cube, a ball and a cone" goes on.
    if (context_.boundary != "," && context_.boundary != "and") context_.place = nullptr;
    ++at_;
    objects_.flush(context_);
    context_.negated = false;
  }

  void take_away_last() {
    if (PartWish* part = objects_.last_part()) part->count = 0;
    leaves_out_ = false;
  }

  // "for four people", "for books": up to what says something about the thing again.
  void skip_purpose() {
    while (at_ < text_.size() && text_[at_] != "," && !words_.negations.count(text_[at_]) &&
           !text_.is(at_, {"with", "made", "that", "which", "having", "on"})) {
      specialise();
      ++at_;
    }
  }

  // "a stand for umbrellas" is an umbrella stand.
  void specialise() {
    if (objects_.size() != 1) return;
    Description& object = *objects_.head();
    for (const std::size_t length : {std::size_t{2}, std::size_t{1}}) {
      if (at_ + length > text_.size()) continue;
      std::string held = text_.joined(at_, length - 1);
      held += (length > 1 ? " " : "") + singular(text_[at_ + length - 1]);
      const ShapeKind* kind = kinds_.find(held + " " + object.noun);
      if (!kind) continue;
      object.kind = kind->name;
      object.approximate = false;
      return;
    }
  }

  // --- Places and sizes -----------------------------------------------------------------------

  // "shaped like a tree": no tree is there.
  bool simile() {
    for (const auto& phrase : words_.similes) {
      if (!text_.starts(at_, phrase)) continue;
      objects_.flush(context_);
      at_ += phrase.size();
      for (; at_ < text_.size() && !words_.boundaries.count(text_[at_]) && text_[at_] != ","; ++at_)
        if (const auto shape = words_.shapes.find(text_[at_]); shape != words_.shapes.end()) {
          objects_.pending().shape = shape->second;  // "shaped like a hexagon"
          objects_.pending().any = true;
        }
      objects_.flush(context_);
      return true;
    }
    return false;
  }

  // "a ring of twelve stones", "stack twenty rings": the word is no thing beside them.
  bool arrangement() {
    const auto found = words_.arrangements.find(text_[at_]);
    if (found == words_.arrangements.end()) return false;
    const bool of = text_.is(at_ + 1, {"of"});
    const std::size_t after = at_ + (of ? 2 : 1);
    if (!text_.count(after) && !(of && text_.part(after))) return false;
    arranged_ = Placement{};
    arranged_.after = found->second;
    context_.place = &arranged_;
    if (objects_.empty()) {
      objects_.unknown().push_back(text_[at_]);
      objects_.add_unknown();
      objects_.head()->kind.clear();
    }
    objects_.unknown().clear();
    at_ = after;
    return true;
  }

  // "on three stones", "a handle at each end", "each smaller than the one below".
  bool placement() {
    if (on_some_of_them()) return true;
    const Placement* placement = placement_at(text_, at_, words_);
    if (!placement || (objects_.empty() && !placement->opens())) return false;
    context_.boundary = text_[at_];
    objects_.flush(context_);
    context_.negated = false;
    at_ += placement->words.size();
    context_.place = placement->opens() ? placement : nullptr;
    PartWish* part = objects_.last_part();
    if (!part) return true;
    place_before(*placement, *part);
    if (placement->series.turn > 0)
      if (const double turn = read_turn(text_, at_); turn > 0) part->series.turn = turn;
    return true;
  }

  // "a door on three of them"
  bool on_some_of_them() {
    PartWish* part = objects_.last_part();
    if (!part || !text_.is(at_, {"on", "in", "at"})) return false;
    const auto count = text_.count(at_ + 1);
    const std::size_t after = at_ + 1 + count.length;
    if (!count) return false;
    if (!text_.is(after, {"them", "these"}) && !text_.starts(after, {"of", "them"})) return false;
    part->count = count.meaning * part->count.value_or(1);
    at_ = after + (text_.is(after, {"of"}) ? 2 : 1);
    return true;
  }

  bool measure() {
    const auto measure = read_measure(text_, at_);
    if (!measure) return false;
    at_ = measure->end;
    objects_.measure(*measure);
    return true;
  }

  // "cups on it", "four chairs around it", "with a lamp on top".
  bool relation() {
    for (const auto& [phrase, meaning] : words_.relations) {
      if (!text_.starts(at_, phrase)) continue;
      objects_.flush(context_);
      objects_.relate(meaning);
      at_ += phrase.size();
      return true;
    }
    return false;
  }

  // --- Adjectives and nouns -------------------------------------------------------------------

  bool attribute() {
    if (names_thing(text_, at_, words_, objects_.empty())) return false;
    if (more_of_known()) return true;
    const auto read = read_attribute(text_, at_, words_, objects_.pending());
    if (read.of_form) objects_.unknown().clear();  // "central pedestal": an adjective too
    at_ += read.length;
    return read.length > 0;
  }

  // "nine in all" is said of the first part, "and two little ones" of the last.
  bool more_of_known() {
    const auto count = text_.count(at_);
    PartWish* last = objects_.last_part();
    if (!count || !last) return false;
    std::size_t after = at_ + count.length;
    if (text_.starts(after, {"in", "all"}) || text_.starts(after, {"in", "total"})) {
      for (auto& part : objects_.head()->parts)
        if (!part.label.empty() && !part.count) {
          part.count = count.meaning;
          break;
        }
      at_ = after + 2;
      return true;
    }
    while (text_.longest(words_.scales, after) || text_.color(after)) ++after;
    if (!text_.is(after, {"ones"})) return false;
    last->count = last->count.value_or(0) + count.meaning;
    at_ = after + 1;
    return true;
  }

  bool noun() {
    if (nouns_.is_pronoun(at_)) return false;
    PhraseNoun noun = nouns_.compound(at_, objects_.head());
    if (noun.role == PhraseNoun::Role::none) {
      const std::string& boundary = context_.boundary;
      if (boundary == "that" || boundary == "which" || boundary == "of") specialise();
      noun = nouns_.simple(at_, objects_.head());
    }
    at_ += noun.length;
    if (noun.role == PhraseNoun::Role::part) objects_.add_part(noun.part, text_[at_ - 1], context_);
    if (noun.role == PhraseNoun::Role::object) add_object(*noun.kind, noun.length);
    return noun.role != PhraseNoun::Role::none;
  }

  // Of a kind that the words before here name.
  void add_object(const ShapeKind& kind, std::size_t length) {
    Description object;
    object.noun = text_.joined(at_ - length, length);
    object.kind = kind.name;
    // "a sculpture of three spheres" is what its parts are.
    if (objects_.empty() && words_.makings.count(object.noun) && text_.is(at_, {"of", "from"})) {
      object.kind.clear();
      object.approximate = true;
    }
    const bool first = objects_.empty();
    if (!first && (object.kind == objects_.head()->kind || context_.negated || !is_beside() ||
                   objects_.size() >= most_objects)) {
      objects_.pending() = {};
      return;
    }
    objects_.unknown().clear();
    // "cups on it": some of them.
    const bool some = !first && singular(text_[at_ - 1]) != text_[at_ - 1];
    objects_.add(std::move(object), some ? usual_some : 1);
  }

  // "a chair that looks like a chair", "a rack for bottles": no other thing beside the first.
  bool is_beside() const {
    static const WordSet joins = {"", "with", "and", "plus", ","};
    return joins.count(context_.boundary) || nouns_.has_relation(at_);
  }

  const Words& words_;
  const ShapeKinds& kinds_;
  PhraseText text_;
  PhraseNouns nouns_;
  PhraseObjects objects_;
  PhraseContext context_;
  std::size_t at_ = 0;
  Placement arranged_;  ///< of the last arrangement
  bool leaves_out_ = false;
};

}  // namespace

std::vector<Description> read_phrase(const std::string& prompt, const Words& words,
                                     const ShapeKinds& kinds) {
  return PhraseReader(prompt, words, kinds).run();
}

}  // namespace roomgen::create
