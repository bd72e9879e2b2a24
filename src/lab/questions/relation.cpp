#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "site.h"

namespace roomgen::lab::detail {

namespace {

constexpr double nearer_by_metres = 0.3, nearer_by_times = 1.25;

using Things = std::vector<const Reference*>;

Things placeless(const QuestionSite& site) {
  Things all = site.references.all();
  std::erase_if(all, [](const Reference* one) { return !says_no_place(*one); });
  return all;
}

const Reference* reference_of(const Things& things, const QuestionSite& site, const std::string& id) {
  const auto found = std::find_if(things.begin(), things.end(),
                                  [&](const Reference* one) { return site.object(one->object).id == id; });
  return found == things.end() ? nullptr : *found;
}

std::vector<std::string> texts_of(const Things& things) {
  std::vector<std::string> texts;
  for (const Reference* one : things) texts.push_back(one->text);
  return texts;
}

bool carries(const QuestionSite& site, const Reference& reference) {
  const std::string& id = site.object(reference.object).id;
  return std::any_of(site.scene.objects.begin(), site.scene.objects.end(),
                     [&](const Object& other) { return other.on == id; });
}

SpatialQuestion question_of(const QuestionSite& site, Random& random, const std::string& form, const Reference* a,
                     const Reference* right, Things wrong) {
  random.shuffle(wrong);
  wrong.resize(std::min(wrong.size(), most_wrong));
  Things things = wrong;
  things.push_back(right);
  const QuestionDraft draft{form, {{"a", a}}, {}, things, {}, {{"right", site.object(right->object).id}}};
  return choice_question(site, random, draft, right->text, texts_of(wrong));
}

double gap_between(const QuestionSite& site, const Reference* a, const Reference* b) {
  return gap(footprint(site.object(a->object)), footprint(site.object(b->object)));
}

bool stands_by_itself(const QuestionSite& site, const Reference* one) {
  const Object& object = site.object(one->object);
  return object.mount == Mount::floor && !object.traits.flat;
}

}  // namespace

// All choices stand on something, so that none is unlikely by its kind.
std::vector<SpatialQuestion> carried_questions(const QuestionSite& site, Random& random) {
  const Things all = placeless(site);
  std::vector<SpatialQuestion> questions;
  for (const Reference* carrier : all) {
    const std::string& id = site.object(carrier->object).id;
    Things on, elsewhere;
    for (const Reference* one : all)
      if (!site.object(one->object).on.empty()) (site.object(one->object).on == id ? on : elsewhere).push_back(one);
    if (on.empty() || elsewhere.empty() || questions.size() >= site.most) continue;
    questions.push_back(question_of(site, random, "carried", carrier, random.pick(on), elsewhere));
  }
  return questions;
}

// All choices carry something.
std::vector<SpatialQuestion> carrier_questions(const QuestionSite& site, Random& random) {
  Things all = placeless(site), carriers = all;
  std::erase_if(carriers, [&](const Reference* one) { return !carries(site, *one); });
  random.shuffle(all);
  std::vector<SpatialQuestion> questions;
  for (const Reference* one : all) {
    const std::string& on = site.object(one->object).on;
    const Reference* right = on.empty() ? nullptr : reference_of(carriers, site, on);
    if (!right || questions.size() >= site.most) continue;
    Things wrong = carriers;
    std::erase_if(wrong, [&](const Reference* other) { return other == right || other == one; });
    if (!wrong.empty()) questions.push_back(question_of(site, random, "carrier", one, right, wrong));
  }
  return questions;
}

std::vector<SpatialQuestion> nearest_questions(const QuestionSite& site, Random& random) {
  Things all = placeless(site);
  std::erase_if(all, [&](const Reference* one) { return !stands_by_itself(site, one); });
  std::vector<SpatialQuestion> questions;
  std::set<std::size_t> asked;
  for (std::size_t tries = tries_for_one * site.most; tries > 0 && questions.size() < site.most; --tries) {
    if (all.size() < 3) break;
    random.shuffle(all);
    const Reference* a = all.front();
    Things choices(all.begin() + 1, all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), most_wrong + 2)));
    std::erase_if(choices, [&](const Reference* one) { return !site.same_room(one->object, a->object); });
    if (choices.size() < 2 || asked.count(a->object)) continue;
    std::sort(choices.begin(), choices.end(), [&](const Reference* b, const Reference* c) {
      return gap_between(site, a, b) < gap_between(site, a, c);
    });
    const double nearest = gap_between(site, a, choices[0]), next = gap_between(site, a, choices[1]);
    if (next < std::max(nearest + nearer_by_metres, nearer_by_times * nearest)) continue;
    asked.insert(a->object);
    questions.push_back(question_of(site, random, "nearest", a, choices[0], Things(choices.begin() + 1, choices.end())));
  }
  return questions;
}

// Of dwellings whose rooms are all of another kind.
std::vector<SpatialQuestion> in_room_questions(const QuestionSite& site, Random& random) {
  std::set<std::string> types;
  for (const auto& room : site.scene.rooms) types.insert(room.type);
  std::vector<SpatialQuestion> questions;
  if (types.size() < 2 || types.size() != site.scene.rooms.size()) return questions;
  Things all = placeless(site);
  random.shuffle(all);
  for (const Reference* one : all) {
    if (questions.size() >= site.most) break;
    const std::string right = "the " + room_of(site.scene, site.object(one->object)).type;
    std::vector<std::string> wrong;
    for (const auto& type : types)
      if ("the " + type != right) wrong.push_back("the " + type);
    random.shuffle(wrong);
    wrong.resize(std::min(wrong.size(), most_wrong));
    questions.push_back(choice_question(site, random, {"in room", {{"a", one}}, {}, {}, {}}, right, wrong));
  }
  return questions;
}

}  // namespace roomgen::lab::detail
