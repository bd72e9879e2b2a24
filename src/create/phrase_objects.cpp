#include "phrase_objects.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "language/inflection.h"
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
    return !pieces.empty() &&
           language::singular(pieces.back()) == language::singular(wanted.back());
  };
  return ends(kind.name) || std::any_of(kind.names.begin(), kind.names.end(), ends);
}

}  // namespace

PartWish* PhraseObjects::part(const Referent& referent) {
  if (!referent.is_part()) return nullptr;
  auto& parts = objects_[referent.object].parts;
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const PartWish& part) {
    return part.label == referent.label;
  });
  return found == parts.end() ? nullptr : &*found;
}

// All that was said before an object was named is said of it.
Referent PhraseObjects::add(Description object, Attributes said) {
  object.prompt = prompt_;
  object.count = said.count.value_or(object.count);
  object.parts = std::exchange(early_, {});
  object.size = std::exchange(measured_, std::nullopt);
  said.count.reset();
  create::apply(said, object);
  objects_.push_back(std::move(object));
  return {objects_.size() - 1, ""};
}

Referent PhraseObjects::add_unknown(const std::string& noun, Attributes said) {
  Description object;
  object.noun = noun;
  object.approximate = true;
  if (const ShapeKind* kind = kinds_.nearest(noun); kind && ends_alike(noun, *kind))
    object.kind = kind->name;
  return add(std::move(object), std::move(said));
}

Referent PhraseObjects::add_part(const NamedPart& named) {
  std::vector<PartWish>& parts = empty() ? early_ : objects_.front().parts;
  auto known = std::find_if(parts.begin(), parts.end(),
                            [&](const PartWish& part) { return part.label == named.label; });
  if (known == parts.end()) {
    if (parts.size() >= most_parts) return {};
    known = parts.insert(parts.end(), PartWish());
    known->label = named.label;
  }
  const bool another_count = named.said.count && named.said.count != known->count;
  if (known->count && !empty() && (another_count || named.is_denied != (*known->count == 0)))
    objects_.front().contradicted = true;
  create::apply(named.said, *known);
  if (named.is_denied) known->count = 0;
  known->one = known->one || named.is_one;
  if (empty()) return {};
  return {0, named.label};
}

void PhraseObjects::apply(const Attributes& said, const Referent& to) {
  if (PartWish* known = part(to))
    create::apply(said, *known);
  else if (to)
    create::apply(said, objects_[to.object]);
}

void PhraseObjects::measure(const language::Measure& measure, const Referent& of) {
  if (PartWish* known = part(of)) return create::apply(measure, *known);
  if (measure.side == language::Measure::Side::thickness) return;
  measured_ = measured_.value_or(Vec3::Constant(std::nan("")));
  const Vec3 said = sides(measure);
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isnan(said[axis])) (*measured_)[axis] = said[axis];
  if (of) take_measures(objects_[of.object]);
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

std::vector<Description> PhraseObjects::finish() {
  if (empty()) add_unknown("", {});
  doubt_kind(objects_.front());
  return std::move(objects_);
}

}  // namespace roomgen::create
