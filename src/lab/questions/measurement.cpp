#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "site.h"

namespace roomgen::lab::detail {

namespace {

constexpr double least_height = 0.1, least_side = 0.2, least_cover = 0.05;  // metres, square metres
constexpr double least_way = 0.5, least_space = 0.2;

using Value = std::function<std::optional<double>(const Object&)>;
using PairValue = std::function<std::optional<double>(const Object&, const Object&)>;

// What all that are alike have in common may be asked of any of them.
std::vector<SpatialQuestion> questions_of_one(const QuestionSite& site, Random& random, const std::string& form,
                                       const Value& value) {
  std::vector<Reference> candidates;
  std::vector<std::string> twins;
  for (std::size_t k = 0; k < site.scene.objects.size(); ++k) {
    const auto& own = site.references.of(k);
    const auto reference = own ? own : site.references.twin(k);
    if (!reference || !value(site.object(k))) continue;
    if (reference->any_twin && std::count(twins.begin(), twins.end(), reference->text) > 0) continue;
    if (reference->any_twin) twins.push_back(reference->text);
    candidates.push_back(*reference);
  }
  random.shuffle(candidates);
  std::vector<SpatialQuestion> questions;
  for (const auto& reference : candidates) {
    if (questions.size() >= site.most) break;
    questions.push_back(number_question(site, random, {form, {{"a", &reference}}, {}, {}, {}},
                                        *value(site.object(reference.object))));
  }
  return questions;
}

std::vector<SpatialQuestion> questions_of_two(const QuestionSite& site, Random& random, const std::string& form,
                                       const PairValue& value) {
  const auto all = site.references.all();
  std::vector<SpatialQuestion> questions;
  if (all.size() < 2) return questions;
  std::vector<std::pair<std::size_t, std::size_t>> used;
  for (std::size_t tries = tries_for_one * site.most; tries > 0 && questions.size() < site.most; --tries) {
    const Reference *a = random.pick(all), *b = random.pick(all);
    const std::pair<std::size_t, std::size_t> pair = std::minmax(a->object, b->object);
    if (a == b || !site.same_room(a->object, b->object) || std::count(used.begin(), used.end(), pair) > 0) continue;
    const auto answer = value(site.object(a->object), site.object(b->object));
    if (!answer) continue;
    used.push_back(pair);
    questions.push_back(number_question(site, random, {form, {{"a", a}, {"b", b}}, {}, {}, {}}, *answer));
  }
  return questions;
}

bool stands_on_floor(const Object& object) { return object.mount == Mount::floor && !object.traits.flat; }

}  // namespace

// Of what hangs from the ceiling nobody knows whether its cord counts.
std::vector<SpatialQuestion> height_questions(const QuestionSite& site, Random& random) {
  return questions_of_one(site, random, "height", [](const Object& object) {
    const bool fits = object.mount != Mount::ceiling && object.size.z() >= least_height;
    return fits ? std::optional(object.size.z()) : std::nullopt;
  });
}

std::vector<SpatialQuestion> length_questions(const QuestionSite& site, Random& random) {
  return questions_of_one(site, random, "length", [](const Object& object) {
    const double side = std::max(object.size.x(), object.size.y());
    return side >= least_side ? std::optional(side) : std::nullopt;
  });
}

std::vector<SpatialQuestion> distance_questions(const QuestionSite& site, Random& random) {
  return questions_of_two(site, random, "distance", [](const Object& a, const Object& b) {
    const double metres = (a.position - b.position).head<2>().norm();
    return metres >= least_way ? std::optional(metres) : std::nullopt;
  });
}

std::vector<SpatialQuestion> gap_questions(const QuestionSite& site, Random& random) {
  return questions_of_two(site, random, "gap", [](const Object& a, const Object& b) {
    if (!stands_on_floor(a) || !stands_on_floor(b)) return std::optional<double>();
    const double metres = gap(footprint(a), footprint(b));
    return metres >= least_space ? std::optional(metres) : std::nullopt;
  });
}

std::vector<SpatialQuestion> area_questions(const QuestionSite& site, Random& random) {
  return questions_of_one(site, random, "area", [](const Object& object) {
    const double area = object.size.x() * object.size.y();
    const bool fits = object.mount == Mount::floor && !object.traits.round && area >= least_cover;
    return fits ? std::optional(area) : std::nullopt;
  });
}

std::vector<SpatialQuestion> room_area_questions(const QuestionSite& site, Random& random) {
  if (!site.scene.rooms.empty()) return {};
  QuestionDraft draft{"room area", {}, {}, {}, {}};
  const std::size_t step = std::max<std::size_t>(1, site.frames.size() / 4);
  for (std::size_t frame = 0; frame < site.frames.size(); frame += step) draft.frames.push_back(frame);
  return {number_question(site, random, draft, std::abs(signed_area(site.scene.room.polygon.points)))};
}

}  // namespace roomgen::lab::detail
