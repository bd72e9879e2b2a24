#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "site.h"

namespace roomgen::lab::detail {

namespace {

constexpr std::size_t most_ordinal = 8;
constexpr const char* ordinals[most_ordinal] = {"first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth"};

// Frames by whether they show the object, where the camera looks at something that can be named without it.
struct Sightings {
  std::vector<std::pair<std::size_t, const Reference*>> with, without;
};

Sightings sightings(const QuestionSite& site, const Reference& object) {
  Sightings result;
  for (const std::size_t frame : stops_of(site)) {
    const std::size_t target = target_of(site, frame);
    const auto& looked_at = site.references.of(target);
    const bool named = looked_at && !looked_at->by_time && looked_at->other != site.object(object.object).id &&
                       object.other != site.frames[frame].frame.target;
    if (target == object.object || !named) continue;
    if (site.frames[frame].objects[object.object].pixels == 0) result.without.emplace_back(frame, &*looked_at);
    if (site.share(frame, object.object) >= question_forms().limits.clear) result.with.emplace_back(frame, &*looked_at);
  }
  return result;
}

}  // namespace

// The colours that may be chosen are drawn first, then which of them is asked for, then a thing of it: no colour is
// likelier than another.
std::vector<SpatialQuestion> color_questions(const QuestionSite& site, Random& random) {
  std::map<std::string, std::vector<const Reference*>> by_color;
  for (const Reference* one : site.references.all())
    if (one->way != "color" && !site.references.color(one->object).empty())
      by_color[site.references.color(one->object)].push_back(one);
  std::vector<std::string> colors;
  for (const auto& [color, things] : by_color) colors.push_back(color);
  std::vector<SpatialQuestion> questions;
  std::set<std::size_t> asked;
  for (std::size_t k = 0; k < 4 * site.most && colors.size() >= 2 && questions.size() < site.most; ++k) {
    random.shuffle(colors);
    const std::vector<std::string> offered(colors.begin(), colors.begin() + static_cast<std::ptrdiff_t>(std::min(colors.size(), most_wrong + 1)));
    const Reference* one = random.pick(by_color[offered[0]]);
    if (!asked.insert(one->object).second) continue;
    questions.push_back(choice_question(site, random, {"color", {{"a", one}}, {}, {}, {}}, offered[0],
                                        {offered.begin() + 1, offered.end()}));
  }
  return questions;
}

// The kind is drawn before the stop: what there are several of is no likelier.
std::vector<SpatialQuestion> kind_questions(const QuestionSite& site, Random& random) {
  auto all = stops_of(site);
  all.resize(std::min(all.size(), most_ordinal));
  std::map<std::string, std::vector<std::size_t>> places;  // counted from 0
  for (std::size_t nth = 0; nth < all.size(); ++nth) {
    const Object& target = site.object(target_of(site, all[nth]));
    if (!target.stand_in) places[target.category].push_back(nth);
  }
  std::vector<std::string> kinds;
  for (const auto& [kind, list] : places) kinds.push_back(kind);
  auto asked = kinds;
  random.shuffle(asked);
  asked.resize(std::min(asked.size(), site.most));
  std::vector<SpatialQuestion> questions;
  for (const auto& right : asked) {
    std::vector<std::string> wrong;
    for (const auto& kind : kinds)
      if (!site.kinds.is_a(kind, right) && !site.kinds.is_a(right, kind)) wrong.push_back(kind);
    if (wrong.empty()) continue;
    random.shuffle(wrong);
    wrong.resize(std::min(wrong.size(), most_wrong));
    const std::size_t nth = random.pick(places[right]);
    const TourFrame& stop = site.frames[all[nth]].frame;
    const QuestionDraft draft{"kind", {}, {{"nth", ordinals[nth]}}, {}, {all[nth]},
                              {{"nth", nth + 1}, {"frame", stop.number}, {"right", stop.target}}};
    SpatialQuestion question = choice_question(site, random, draft, right, wrong);
    question.objects = {stop.target};
    questions.push_back(std::move(question));
  }
  return questions;
}

// Whether it is in sight is drawn first: things that are large are asked about no oftener where they are.
std::vector<SpatialQuestion> in_sight_questions(const QuestionSite& site, Random& random) {
  auto things = site.references.all();
  random.shuffle(things);
  const auto& words = question_forms().words;
  std::vector<SpatialQuestion> questions;
  for (const Reference* one : things) {
    if (questions.size() >= site.most) break;
    const Sightings found = sightings(site, *one);
    if (found.with.empty() || found.without.empty()) continue;
    const bool yes = random.chance(0.5);
    const auto& [frame, target] = random.pick(yes ? found.with : found.without);
    const QuestionDraft draft{"in sight", {{"a", target}, {"b", one}}, {}, {}, {frame}, {{"frame", site.frames[frame].frame.number}}};
    questions.push_back(choice_question(site, random, draft, words.at(yes ? "yes" : "no"), {words.at(yes ? "no" : "yes")}));
  }
  return questions;
}

}  // namespace roomgen::lab::detail
