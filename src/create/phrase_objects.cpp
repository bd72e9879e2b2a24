#include "phrase_objects.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "phrase_place.h"
#include "phrase_text.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

constexpr std::size_t most_parts = 24;

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

// Does a noun behind this word belong to the thing before it?
bool leads_to_part(const std::string& word) {
  static const WordSet owners = {"with",    "and", "plus", "having", "has",    "have",
                                 "without", "of",  "on",   "over",   "between"};
  return owners.count(word) > 0;
}

}  // namespace

PartWish* PhraseObjects::last_part() {
  if (empty() || part_ >= objects_.front().parts.size()) return nullptr;
  return &objects_.front().parts[part_];
}

void PhraseObjects::flush(const PhraseContext& context) {
  if (!unknown_.empty()) add_unknown_noun(context);
  if (pending_.any && !empty()) {
    Description& object = objects_.back();
    if (part_ < object.parts.size()) apply(pending_, object.parts[part_]);
    else apply(pending_, object);
  }
  if (!empty() || !pending_.any) pending_ = {};
  pending_.article = false;
}

void PhraseObjects::add(Description object, int usual_count) {
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

void PhraseObjects::add_unknown() {
  Description object;
  object.noun = join(unknown_, " ");
  object.approximate = true;
  if (const ShapeKind* kind = kinds_.nearest(object.noun); kind && ends_alike(object.noun, *kind))
    object.kind = kind->name;
  add(std::move(object), 1);
}

void PhraseObjects::add_early_part() {
  if (!empty() || early_.empty()) return;
  unknown_ = {early_.front().label};
  add_unknown();
  unknown_.clear();
  part_ = 0;
}

// A noun phrase of which no word is known: the thing itself, or a part of it.
void PhraseObjects::add_unknown_noun(const PhraseContext& context) {
  if (empty()) {
    add_unknown();
  } else if (pending_.article && objects_.front().parts.size() < most_parts &&
             leads_to_part(context.boundary) && !says_nothing(unknown_.back())) {
    PartWish part;
    part.label = singular(unknown_.back());
    if (context.negated) part.count = 0;
    apply(pending_, part);
    if (context.place) place_after(*context.place, part);
    objects_.front().parts.push_back(std::move(part));
    part_ = objects_.front().parts.size() - 1;
    pending_ = {};
  } else {
    pending_.count.reset();  // "three crests long"
  }
  unknown_.clear();
}

void PhraseObjects::add_part(const std::string& label, const std::string& last_word,
                             PhraseContext& context) {
  // "legs that are boards", "the seat is a wave": the same part again.
  const bool again = context.boundary == "is" || context.boundary == "are";
  if (PartWish* last = last_part(); again && last) {
    apply(pending_, *last);
    pending_ = {};
    context.boundary.clear();
    return;
  }
  // "a two-drawer nightstand": the thing is still to come.
  std::vector<PartWish>& parts = empty() ? early_ : objects_.front().parts;
  unknown_.clear();
  auto known = std::find_if(parts.begin(), parts.end(),
                            [&](const PartWish& part) { return part.label == label; });
  if (known == parts.end()) {
    if (parts.size() >= most_parts) return;
    parts.push_back({});
    known = parts.end() - 1;
    known->label = label;
  }
  if (known->count && !empty() &&
      ((pending_.count && *pending_.count != *known->count) ||
       (context.negated != (*known->count == 0))))
    objects_.front().contradicted = true;
  apply(pending_, *known);
  if (context.negated) known->count = 0;
  known->one = known->one || (context.indefinite && singular(last_word) == last_word);
  if (context.place) place_after(*context.place, *known);
  part_ = empty() ? none : static_cast<std::size_t>(known - parts.begin());
  pending_ = {};
  context.indefinite = false;
}

void PhraseObjects::measure(const Measure& measure) {
  if (PartWish* part = last_part()) return apply(measure, *part);
  if (measure.thick) return;
  measured_ = measured_.value_or(Vec3::Constant(std::nan("")));
  const Vec3 said = sides(measure);
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isnan(said[axis])) (*measured_)[axis] = said[axis];
  if (!empty()) take_measures(objects_.back());
}

// Sides that were said earlier stay.
void PhraseObjects::take_measures(Description& object) {
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

void PhraseObjects::relate(const std::string& relation) {
  if (size() > 1) objects_.back().relation = relation;
  else if (PartWish* part = last_part()) part->place = place_of(relation);
}

// The nearest kind is not near when it has few of the parts: then these make the thing.
void PhraseObjects::doubt_kind(Description& object) const {
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

std::vector<Description> PhraseObjects::finish(const PhraseContext& context) {
  flush(context);
  if (empty()) add_unknown();  // only parts were named, or nothing
  if (measured_) take_measures(objects_.front());
  doubt_kind(objects_.front());
  return std::move(objects_);
}

}  // namespace roomgen::create
