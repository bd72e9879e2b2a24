#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "language/inflection.h"
#include "site.h"

namespace roomgen::lab::detail {

namespace {

constexpr double least_ahead = 0.7, least_aside = 0.5;                // metres
const double sure_side_low = radians(30.0), sure_side_high = radians(150.0);
const double surely_behind = radians(120.0);

Vec2 place(const QuestionSite& site, const Reference& reference) {
  return site.object(reference.object).position.head<2>();
}

double angle_between(const Vec2& from, const Vec2& to) {
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

// Of a kind, those that the video shows; nothing if somebody might count otherwise.
std::optional<std::vector<std::size_t>> counted(const QuestionSite& site, const std::string& kind) {
  if (!site.references.is_settled(kind)) return std::nullopt;
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < site.scene.objects.size(); ++k) {
    if (!site.kinds.is_a(site.object(k).category, kind) && site.object(k).category != kind) continue;
    if (site.seen[k].clear)
      list.push_back(k);
    else if (site.seen[k].is_faint())
      return std::nullopt;
  }
  return list;
}

// Of somebody at the middle of a who looks at b, in radians to the left; nothing if it is nearly ahead or behind, or on
// another side for who stands at a corner of a.
std::optional<double> side_of(const Object& a, const Vec2& b, const Vec2& c) {
  const Footprint at = footprint(a);
  if ((b - at.center()).norm() < least_ahead || (c - at.center()).norm() < least_aside) return std::nullopt;
  const double angle = angle_between(b - at.center(), c - at.center());
  const bool sure = std::abs(angle) >= sure_side_low && std::abs(angle) <= sure_side_high;
  const auto corners = at.outline();
  const bool same = std::all_of(corners.begin(), corners.end(), [&](const Vec2& corner) {
    const double seen = angle_between(b - corner, c - corner);
    return (seen > 0) == (angle > 0);
  });
  return sure && same ? std::optional(angle) : std::nullopt;
}

// Around the camera of a frame.
struct Surroundings {
  std::vector<const Reference*> behind, ahead;
};

Surroundings surroundings(const QuestionSite& site, std::size_t frame, const std::string& target) {
  Surroundings around;
  const CameraPose& pose = site.frames[frame].frame.pose;
  const Vec2 eye = pose.eye.head<2>(), looks = front_direction(pose.yaw);
  for (const Reference* reference : site.references.all()) {
    const Object& object = site.object(reference->object);
    if (object.id == target || reference->other == target || !contains(room_of(site.scene, object).polygon, eye)) continue;
    const Vec2 way = object.position.head<2>() - eye;
    const double angle = std::abs(angle_between(looks, way));
    const auto pixels = site.frames[frame].objects[reference->object].pixels;
    if (angle > surely_behind && way.norm() > least_aside && pixels == 0) around.behind.push_back(reference);
    if (site.share(frame, reference->object) >= question_forms().limits.clear) around.ahead.push_back(reference);
  }
  return around;
}

const Reference* reference_of(const QuestionSite& site, const std::string& id) {
  for (const Reference* reference : site.references.all())
    if (site.object(reference->object).id == id) return reference;
  return nullptr;
}

}  // namespace

// What there are several of first: one of a kind needs no counting.
std::vector<SpatialQuestion> count_questions(const QuestionSite& site, Random& random) {
  std::set<std::string> kinds;
  for (const auto& object : site.scene.objects) kinds.insert(object.category);
  std::vector<std::string> several, single;
  for (const auto& kind : kinds)
    if (const auto list = counted(site, kind); list && !list->empty()) (list->size() > 1 ? several : single).push_back(kind);
  random.shuffle(several);
  random.shuffle(single);
  if (!single.empty()) several.push_back(single.front());
  std::vector<SpatialQuestion> questions;
  for (const auto& kind : several) {
    if (questions.size() >= site.most) break;
    QuestionDraft draft{"count", {}, {{"kinds", language::plural(kind)}}, {}, {}, {{"kind", kind}}};
    const auto list = *counted(site, kind);
    for (const std::size_t k : list) draft.frames.push_back(site.seen[k].best);
    SpatialQuestion question = number_question(site, random, draft, static_cast<double>(list.size()));
    for (const std::size_t k : list) question.objects.push_back(site.object(k).id);
    std::sort(question.objects.begin(), question.objects.end());
    questions.push_back(std::move(question));
  }
  return questions;
}

std::vector<SpatialQuestion> side_questions(const QuestionSite& site, Random& random) {
  const auto all = site.references.all();
  const auto& words = question_forms().words;
  std::vector<SpatialQuestion> questions;
  std::set<std::array<std::size_t, 3>> asked;  // b and c in one order: the other question has the other answer
  if (all.size() < 3) return questions;
  for (std::size_t tries = tries_for_one * site.most; tries > 0 && questions.size() < site.most; --tries) {
    const Reference *a = random.pick(all), *b = random.pick(all), *c = random.pick(all);
    const bool differ = a != b && b != c && a != c && a->other.empty() && b->other.empty() && c->other.empty();
    if (!differ || !site.same_room(a->object, b->object) || !site.same_room(a->object, c->object)) continue;
    if (site.object(a->object).mount != Mount::floor || site.object(a->object).traits.flat) continue;
    const auto angle = side_of(site.object(a->object), place(site, *b), place(site, *c));
    const auto [low, high] = std::minmax(b->object, c->object);
    if (!angle || !asked.insert({a->object, low, high}).second) continue;
    const std::string &left = words.at("left"), &right = words.at("right");
    const bool is_left = *angle > 0;
    questions.push_back(choice_question(site, random, {"side", {{"a", a}, {"b", b}, {"c", c}}, {}, {}, {}},
                                        is_left ? left : right, {is_left ? right : left}));
  }
  return questions;
}

std::vector<SpatialQuestion> behind_questions(const QuestionSite& site, Random& random) {
  auto stops = stops_of(site);
  random.shuffle(stops);
  std::vector<SpatialQuestion> questions;
  for (const std::size_t frame : stops) {
    if (questions.size() >= site.most) break;
    const std::string& target = site.frames[frame].frame.target;
    const Reference* looked_at = reference_of(site, target);
    auto around = surroundings(site, frame, target);
    if (!looked_at || around.behind.empty() || around.ahead.empty()) continue;
    const Reference* right = random.pick(around.behind);
    random.shuffle(around.ahead);
    around.ahead.resize(std::min(around.ahead.size(), most_wrong));
    std::vector<std::string> wrong;
    for (const Reference* one : around.ahead) wrong.push_back(one->text);
    QuestionDraft draft{"behind", {{"a", looked_at}}, {}, around.ahead, {frame}, {{"frame", site.frames[frame].frame.number}}};
    draft.things.push_back(right);
    draft.arguments["right"] = site.object(right->object).id;
    questions.push_back(choice_question(site, random, draft, right->text, wrong));
  }
  return questions;
}

}  // namespace roomgen::lab::detail
