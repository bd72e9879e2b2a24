#include "phrase.h"

#include <algorithm>
#include <cmath>

#include "attributes.h"
#include "part_forms.h"
#include "phrase_measure.h"
#include "phrase_place.h"
#include "phrase_text.h"
#include "roomgen/base/text.h"
#include "roomgen/design/prompt_words.h"

namespace roomgen::create {

namespace {

constexpr std::size_t most_parts = 24;
constexpr std::size_t most_objects = 8;
constexpr int usual_some = 3;  // of things named in the plural without a number

// Words of place, number and purpose are no parts: "down the right side".
bool says_nothing(const std::string& word) {
  const auto& vocabulary = *design::built_in_vocabulary();
  return vocabulary.no_things.count(word) || vocabulary.people_words.count(word) ||
         vocabulary.stops.count(word);
}

// The last words say what a thing is.
bool ends_alike(const std::string& noun, const ShapeKind& kind) {
  const auto wanted = words(noun);
  if (wanted.empty()) return false;
  const auto ends = [&](const std::string& name) {
    const auto pieces = words(name);
    return !pieces.empty() && singular(pieces.back()) == singular(wanted.back());
  };
  return ends(kind.name) || std::any_of(kind.names.begin(), kind.names.end(), ends);
}

// Walks through the sentence once. Adjectives wait for their noun; what is said after a noun, up to a
// boundary, belongs to it.
class PhraseReader {
 public:
  PhraseReader(const std::string& prompt, const Words& words, const ShapeKinds& kinds)
      : prompt_(prompt), words_(words), kinds_(kinds), text_(prompt, *built_in_parts(), kinds) {}

  std::vector<Description> run() {
    while (at_ < text_.size()) step();
    flush();
    if (objects_.empty()) begin_unknown();  // only parts were named, or nothing
    if (measured_) take_measures(objects_.front());
    doubt_kind(objects_.front());
    return std::move(objects_);
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
      negated_ = true;
      return;
    }
    // "the mattress is missing", "leave the armrests out"
    if (text_.is(at_, {"missing", "absent"}) || (word == "out" && leaves_out_)) {
      take_away_last();
      ++at_;
      return;
    }
    if (text_.is(at_, {"leave", "leaving"})) leaves_out_ = true;
    if (simile() || arrangement() || measure() || relation() || placement() || attribute() || noun())
      return;
    // "a tall and narrow back" goes on.
    if (word == "and" && (pending_.article || objects_.empty())) {
      ++at_;
      return;
    }
    if (words_.boundaries.count(word)) return boundary();
    if (!words_.fillers.count(word)) unknown_.push_back(word);
    if (text_.is(at_, {"a", "an", "the"})) {
      pending_.article = true;
      indefinite_ = word != "the";
    }
    ++at_;
  }

  // What was said since the last noun belongs to it.
  void boundary() {
    last_boundary_ = text_[at_];
    if (!text_.is(at_, {",", "and", "of", "made"})) begin_with_part();
    // "on a cube, a ball and a cone" goes on.
    if (last_boundary_ != "," && last_boundary_ != "and") next_ = nullptr;
    ++at_;
    flush();
    negated_ = false;
  }

  // The nearest kind is not near when it has few of the parts: then these make the thing.
  void doubt_kind(Description& object) const {
    const ShapeKind* kind = object.approximate ? kinds_.find(object.kind) : nullptr;
    if (!kind) return;
    const auto labels = kinds_.labels(kind->recipe);
    int known = 0, asked = 0;
    for (const auto& part : object.parts) {
      if (part.label.empty() || part.count == 0) continue;
      ++asked;
      known += labels.count(part.label) > 0;
    }
    if (2 * known < asked) object.kind.clear();
  }

  // "a tower with four windows": no other thing is named, so the part is the thing.
  void begin_with_part() {
    if (!objects_.empty() || early_.empty()) return;
    unknown_ = {early_.front().label};
    begin_unknown();
    unknown_.clear();
    part_ = 0;
  }

  // "shaped like a tree": no tree is there.
  bool simile() {
    for (const auto& phrase : words_.similes) {
      if (!text_.starts(at_, phrase)) continue;
      flush();
      at_ += phrase.size();
      for (; at_ < text_.size() && !words_.boundaries.count(text_[at_]) && text_[at_] != ","; ++at_)
        if (const auto shape = words_.shapes.find(text_[at_]); shape != words_.shapes.end()) {
          pending_.shape = shape->second;  // "shaped like a hexagon"
          pending_.any = true;
        }
      flush();
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
    if (objects_.empty()) unknown_.push_back(text_[at_]);
    arranged_ = Placement{};
    arranged_.after = found->second;
    next_ = &arranged_;
    if (objects_.empty()) {
      begin_unknown();
      objects_.front().kind.clear();
    }
    unknown_.clear();
    at_ = after;
    return true;
  }

  // "on three stones", "a handle at each end", "each smaller than the one below".
  bool placement() {
    if (on_some_of_them()) return true;
    const Placement* placement = placement_at(text_, at_, words_);
    if (!placement || (objects_.empty() && !placement->opens())) return false;
    last_boundary_ = text_[at_];
    flush();
    negated_ = false;
    at_ += placement->words.size();
    next_ = placement->opens() ? placement : nullptr;
    PartWish* part = last_part();
    if (!part) return true;
    place_before(*placement, *part);
    if (placement->series.turn > 0)
      if (const double turn = read_turn(text_, at_); turn > 0) part->series.turn = turn;
    return true;
  }

  // "a door on three of them"
  bool on_some_of_them() {
    if (!text_.is(at_, {"on", "in", "at"}) || objects_.empty()) return false;
    auto& parts = objects_.front().parts;
    const auto count = text_.count(at_ + 1);
    const std::size_t after = at_ + 1 + count.length;
    if (!count || part_ >= parts.size()) return false;
    if (!text_.is(after, {"them", "these"}) && !text_.starts(after, {"of", "them"})) return false;
    parts[part_].count = count.meaning * parts[part_].count.value_or(1);
    at_ = after + (text_.is(after, {"of"}) ? 2 : 1);
    return true;
  }

  void flush() {
    if (!unknown_.empty()) unknown_noun();
    if (pending_.any && !objects_.empty()) {
      Description& object = objects_.back();
      if (part_ < object.parts.size()) apply(pending_, object.parts[part_]);
      else apply(pending_, object);
    }
    if (!objects_.empty() || !pending_.any) pending_ = {};
    pending_.article = false;
  }

  void take_away_last() {
    if (!objects_.empty() && part_ < objects_.front().parts.size())
      objects_.front().parts[part_].count = 0;
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
    Description& object = objects_.front();
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

  bool measure() {
    const auto measure = read_measure(text_, at_);
    if (!measure) return false;
    at_ = measure->end;
    if (PartWish* part = last_part()) {
      apply(*measure, *part);
    } else if (!measure->thick) {
      measured_ = measured_.value_or(Vec3::Constant(std::nan("")));
      const Vec3 said = sides(*measure);
      for (int axis = 0; axis < 3; ++axis)
        if (!std::isnan(said[axis])) (*measured_)[axis] = said[axis];
      if (!objects_.empty()) take_measures(objects_.back());
    }
    return true;
  }

  // What was named last, if that is a part of the first object.
  PartWish* last_part() {
    if (objects_.empty() || part_ >= objects_.front().parts.size()) return nullptr;
    return &objects_.front().parts[part_];
  }

  // Sides that were said earlier stay.
  void take_measures(Description& object) {
    if (!object.size) object.size = Vec3::Constant(std::nan(""));
    for (int axis = 0; axis < 3; ++axis) {
      const double said = (*measured_)[axis];
      if (std::isnan(said)) continue;
      double& side = (*object.size)[axis];
      if (!std::isnan(side) && std::abs(side - said) > 1e-6) object.contradicted = true;
      side = said;
    }
    measured_.reset();
  }

  // "cups on it", "four chairs around it", "with a lamp on top".
  bool relation() {
    for (const auto& [phrase, meaning] : words_.relations) {
      if (!text_.starts(at_, phrase)) continue;
      flush();
      if (objects_.size() > 1) objects_.back().relation = meaning;
      else if (part_ != none) objects_.front().parts[part_].place = place_of(meaning);
      at_ += phrase.size();
      return true;
    }
    return false;
  }

  // Passes over words that said something of the noun to come.
  bool said(std::size_t length) {
    pending_.any = true;
    at_ += length;
    return true;
  }

  bool attribute() {
    const std::string& word = text_[at_];
    const auto kind = text_.kind(at_);
    // The name of a kind goes before its first word's other meanings: "wine rack", "round table".
    if (kind.length > 1 && !words_.shapes.count(word) && !words_.styles.count(word)) return false;
    // "a ladder": not the way to build one.
    if (kind && objects_.empty() && words_.constructions.count(word) && ends_phrase(at_ + kind.length))
      return false;
    if (const auto count = text_.count(at_)) {
      if (more_of_known(count)) return true;
      pending_.count = count.meaning;
      pending_.article = true;
      return said(count.length);
    }
    if (const auto strength = text_.longest(words_.strengths, at_)) {
      pending_.strength = *strength.meaning;
      return said(strength.length);
    }
    if (const auto style = text_.longest(words_.styles, at_)) {
      pending_.style = *style.meaning;
      return said(style.length);
    }
    if (const std::size_t length = form()) {
      unknown_.clear();  // "central pedestal": an adjective too
      return said(length);
    }
    if (const auto material = text_.longest(words_.materials, at_)) {
      pending_.material = material.meaning->name;
      return said(material.length);
    }
    if (const auto scale = text_.longest(words_.scales, at_); scale && !text_.part(at_)) {
      pending_.scale = pending_.scale.cwiseProduct(*scale.meaning);
      return said(scale.length);
    }
    if (words_.directions.count(word)) {
      pending_.direction = word;
      return said(1);
    }
    const auto color = text_.color(at_);
    if (!color || kind) return false;
    pending_.color = color.meaning;
    return said(color.length);
  }

  bool ends_phrase(std::size_t at) const {
    return at >= text_.size() || text_[at] == "," || words_.boundaries.count(text_[at]) > 0;
  }

  // "nine in all" is said of the first part, "and two little ones" of the last.
  bool more_of_known(const PhraseText::Run<int>& count) {
    if (objects_.empty() || part_ >= objects_.front().parts.size()) return false;
    std::size_t after = at_ + count.length;
    auto& parts = objects_.front().parts;
    if (text_.starts(after, {"in", "all"}) || text_.starts(after, {"in", "total"})) {
      for (auto& part : parts)
        if (!part.label.empty() && !part.count) {
          part.count = count.meaning;
          break;
        }
      at_ = after + 2;
      return true;
    }
    while (text_.longest(words_.scales, after) || text_.color(after)) ++after;
    if (!text_.is(after, {"ones"})) return false;
    parts[part_].count = parts[part_].count.value_or(0) + count.meaning;
    at_ = after + 1;
    return true;
  }

  // One word may say several things of a form: "splayed" is a way to build legs and a lean.
  std::size_t form() {
    const auto construction = text_.longest(words_.constructions, at_);
    const auto lean = text_.longest(words_.leans, at_);
    const auto course = text_.longest(words_.courses, at_);
    const auto shape = text_.longest(words_.shapes, at_);
    if (construction) pending_.construction = *construction.meaning;
    if (lean) pending_.lean = *lean.meaning;
    if (course) pending_.course = *course.meaning;
    if (shape) pending_.shape = *shape.meaning;
    // The last that is known says how far it goes.
    for (const std::size_t length : {shape.length, course.length, lean.length})
      if (length > 0) return length;
    return construction.length;
  }

  bool noun() {
    const auto kind = text_.kind(at_);
    // "one can sit on it"
    if (kind.length == 1 && words_.fillers.count(text_[at_]) &&
        (at_ == 0 || !text_.is(at_ - 1, {"a", "an", "the"})))
      return false;
    // "a piano stool", "a merry-go-round bookshelf": the last is the thing.
    if (kind && text_.kind(at_ + kind.length)) {
      at_ += kind.length;
      return true;
    }
    // "an oven door", "a drawer unit": the thing only says what the part is like, or the part the thing.
    if (kind && !objects_.empty() && part_at(at_ + kind.length) && !has_relation(at_ + kind.length + 1)) {
      at_ += kind.length;
      const auto part = part_at(at_);
      return add_part(part.meaning, part.length);
    }
    // "a cube body", "bottle holders": nouns that say what the next one is like.
    if (is_adjunct(kind.length)) {
      ++at_;
      return true;
    }
    if (last_boundary_ == "that" || last_boundary_ == "which" || last_boundary_ == "of") specialise();
    auto part = part_at(at_);
    // "ten test tubes": of the rack of which they are parts.
    if (kind.length > 1 && !objects_.empty())
      if (const auto last = part_at(at_ + kind.length - 1); last && head_knows(last.meaning))
        return add_part(last.meaning, kind.length);
    // "a back panel" is the back.
    if (part.length == 1 && head_knows(part.meaning))
      if (const auto next = part_at(at_ + 1); next && !head_knows(next.meaning)) part.length += next.length;
    if (kind.length > part.length && part && head_knows(part.meaning) && !has_relation(at_ + kind.length))
      return add_part(part.meaning, kind.length);
    // "an open shelf": the longer name of a kind ends with what is a part here.
    if (!objects_.empty() && kind.length > part.length)
      if (const auto ending = part_at(at_ + kind.length - 1);
          ending && (head_knows(ending.meaning) || objects_.front().kind.empty()))
        part = {kind.length, ending.meaning};
    if (part && is_part(kind.length, part)) return add_part(part.meaning, part.length);
    if (!kind || names_no_object(at_ + kind.length)) return false;
    return add_object(*kind.meaning, kind.length);
  }

  bool is_adjunct(std::size_t kind_length) const {
    const std::size_t after = at_ + 1;
    if (objects_.empty() || after >= text_.size() || kind_length > 1) return false;
    const auto part = part_at(at_);
    if (part.length == 1)
      if (const auto next = part_at(after)) return head_knows(next.meaning) || !head_knows(part.meaning);
    return kind_length == 1 && !part && is_unknown_noun(after);
  }

  bool is_unknown_noun(std::size_t at) const {
    const std::string& word = text_[at];
    return word != "," && !words_.boundaries.count(word) && !words_.fillers.count(word) &&
           !says_nothing(word) && !text_.kind(at) && !part_at(at) && !text_.color(at) &&
           !text_.count(at) && singular(word) != word;
  }

  // "a football team": the last word says that it is no football.
  bool names_no_object(std::size_t at) const {
    return objects_.empty() && at < text_.size() && words_.no_objects.count(text_[at]) > 0;
  }

  // The part that the words name: one that the thing has, if they may mean several.
  PhraseText::Run<std::string> part_at(std::size_t at) const {
    // Recipes have parts of which no list knows.
    const auto known = text_.part(at);
    if (known.length < 2 && at < text_.size() && !says_nothing(text_[at]) &&
        head_knows(singular(text_[at])))
      return {1, singular(text_[at])};
    for (const auto& label : known.meaning)
      if (head_knows(label)) return {known.length, label};
    if (known) return {known.length, known.meaning.front()};
    return {};
  }

  bool head_knows(const std::string& label) const {
    return !objects_.empty() && kinds_.find(objects_.front().kind) && head_has(label);
  }

  bool is_part(std::size_t kind_length, const PhraseText::Run<std::string>& part) const {
    if (kind_length > part.length) return false;
    if (kind_length == 0) return true;
    // "seat stool": a part before the thing that it is a part of.
    const std::size_t after = at_ + part.length;
    if (objects_.empty()) return static_cast<bool>(text_.kind(after));
    return !kinds_.find(objects_.front().kind) || head_has(part.meaning) || !has_relation(after);
  }

  bool head_has(const std::string& label) const {
    const ShapeKind* head = kinds_.find(objects_.front().kind);
    return head && kinds_.labels(head->recipe).count(label) > 0;
  }

  // Does what follows the noun put it somewhere: "four chairs around it"?
  bool has_relation(std::size_t from) const {
    for (const std::size_t at : {from, from + 1})
      if (text_.is(at, {"around", "on", "next", "beside", "under", "underneath", "behind"}))
        return true;
    return from + 2 < text_.size() && text_.starts(from, {"in", "front"});
  }

  bool add_part(const std::string& label, std::size_t length) {
    at_ += length;
    // "legs that are boards", "the seat is a wave": the same part again.
    if ((last_boundary_ == "is" || last_boundary_ == "are") && !objects_.empty() &&
        part_ < objects_.front().parts.size()) {
      apply(pending_, objects_.front().parts[part_]);
      pending_ = {};
      last_boundary_.clear();
      return true;
    }
    // "a two-drawer nightstand": the thing is still to come.
    std::vector<PartWish>& parts = objects_.empty() ? early_ : objects_.front().parts;
    unknown_.clear();
    auto known = std::find_if(parts.begin(), parts.end(),
                              [&](const PartWish& part) { return part.label == label; });
    if (known == parts.end()) {
      if (parts.size() >= most_parts) return true;
      parts.push_back({});
      known = parts.end() - 1;
      known->label = label;
    }
    if (known->count && !objects_.empty() &&
        ((pending_.count && *pending_.count != *known->count) || (negated_ != (*known->count == 0))))
      objects_.front().contradicted = true;
    apply(pending_, *known);
    if (negated_) known->count = 0;
    known->one = known->one || (indefinite_ && singular(text_[at_ - 1]) == text_[at_ - 1]);
    if (next_) place_after(*next_, *known);
    part_ = objects_.empty() ? none : static_cast<std::size_t>(known - parts.begin());
    pending_ = {};
    indefinite_ = false;
    return true;
  }

  bool add_object(const ShapeKind& kind, std::size_t length) {
    Description object;
    object.noun = text_.joined(at_, length);
    object.kind = kind.name;
    // "a sculpture of three spheres" is what its parts are.
    if (objects_.empty() && words_.makings.count(object.noun) && text_.is(at_ + length, {"of", "from"})) {
      object.kind.clear();
      object.approximate = true;
    }
    at_ += length;
    // "a chair that looks like a chair", "a rack for bottles": no other thing beside the first.
    const bool beside =
        last_boundary_.empty() || last_boundary_ == "with" || last_boundary_ == "and" ||
        last_boundary_ == "plus" || last_boundary_ == "," || has_relation(at_);
    if (!objects_.empty() && (object.kind == objects_.front().kind || negated_ || !beside ||
                              objects_.size() >= most_objects)) {
      pending_ = {};
      return true;
    }
    unknown_.clear();
    // "cups on it": some of them.
    const bool some = !objects_.empty() && singular(text_[at_ - 1]) != text_[at_ - 1];
    begin(std::move(object), some ? usual_some : 1);
    return true;
  }

  // A thing of no known kind: the nearest one stands for it, if any is near.
  void begin_unknown() {
    Description object;
    object.noun = join(unknown_, " ");
    object.approximate = true;
    if (const ShapeKind* kind = kinds_.nearest(object.noun);
        kind && ends_alike(object.noun, *kind))
      object.kind = kind->name;
    begin(std::move(object), 1);
  }

  // All that was said before an object was named is said of it.
  void begin(Description object, int usual_count) {
    object.prompt = prompt_;
    object.count = std::clamp(pending_.count.value_or(usual_count), 0, PhraseText::most_count);
    object.parts = std::exchange(early_, {});
    object.size = std::exchange(measured_, std::nullopt);
    pending_.count.reset();
    apply(pending_, object);
    pending_ = {};
    objects_.push_back(std::move(object));
    part_ = none;
  }

  // A noun phrase of which no word is known: the thing itself, or a part of it.
  void unknown_noun() {
    static const WordSet owners = {"with", "and", "plus", "having", "has", "have", "without", "of", "on", "over", "between"};
    if (objects_.empty()) {
      begin_unknown();
    } else if (pending_.article && objects_.front().parts.size() < most_parts &&
               owners.count(last_boundary_) && !says_nothing(unknown_.back())) {
      PartWish part;
      part.label = singular(unknown_.back());
      if (negated_) part.count = 0;
      apply(pending_, part);
      if (next_) place_after(*next_, part);
      objects_.front().parts.push_back(std::move(part));
      part_ = objects_.front().parts.size() - 1;
      pending_ = {};
    } else {
      pending_.count.reset();  // "three crests long"
    }
    unknown_.clear();
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const std::string& prompt_;
  const Words& words_;
  const ShapeKinds& kinds_;
  PhraseText text_;
  std::size_t at_ = 0;
  std::vector<Description> objects_;
  std::vector<PartWish> early_;       ///< parts named before their object
  Attributes pending_;                ///< said, and not yet of anything
  std::vector<std::string> unknown_;  ///< words of the noun phrase that nothing is known of
  std::string last_boundary_;
  std::optional<Vec3> measured_;
  const Placement* next_ = nullptr;  ///< says where the parts to come are
  Placement arranged_;
  std::size_t part_ = none;  ///< of the first object, what was named last
  bool negated_ = false, leaves_out_ = false;
  bool indefinite_ = false;  ///< the last article was "a"
};

}  // namespace

std::vector<Description> read_phrase(const std::string& prompt, const Words& words,
                                     const ShapeKinds& kinds) {
  return PhraseReader(prompt, words, kinds).run();
}

}  // namespace roomgen::create
