#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "site.h"

namespace roomgen::lab::detail {

namespace {

constexpr int answer_decimals = 3;

// Each thing's best frame and what is given besides, without repetition.
std::vector<std::size_t> evidence(const QuestionSite& site, const QuestionDraft& draft, const std::set<std::size_t>& things) {
  std::set<std::size_t> frames(draft.frames.begin(), draft.frames.end());
  for (const std::size_t k : things) frames.insert(site.seen[k].best);
  std::vector<std::size_t> numbers;
  for (const std::size_t frame : frames) numbers.push_back(site.frames[frame].frame.number);
  return numbers;
}

SpatialQuestion begun(const QuestionSite& site, Random& random, const QuestionDraft& draft) {
  const QuestionForm& form = question_forms().forms.at(draft.form);
  Fillings fillings = draft.words;
  std::set<std::size_t> things;
  std::set<std::string> ids;
  SpatialQuestion question;
  question.arguments = draft.arguments;
  const auto add = [&](const Reference& reference) {
    things.insert(reference.object);
    ids.insert(site.object(reference.object).id);
    if (!reference.other.empty()) ids.insert(reference.other);
  };
  for (const auto& [place, reference] : draft.places) {
    fillings[place] = reference->text;
    question.arguments[place] = site.object(reference->object).id;
    add(*reference);
  }
  for (const Reference* reference : draft.things) add(*reference);
  question.task = form.task;
  question.form = draft.form;
  question.unit = form.unit;
  question.text = filled(random.pick(form.texts), fillings);
  question.frames = evidence(site, draft, things);
  question.objects.assign(ids.begin(), ids.end());
  return question;
}

}  // namespace

double QuestionSite::share(std::size_t frame, std::size_t k) const {
  const FrameRecord& record = frames[frame];
  return static_cast<double>(record.objects[k].pixels) / (static_cast<double>(record.width) * record.height);
}

std::vector<std::size_t> stops_of(const QuestionSite& site) {
  std::vector<std::size_t> stops;
  for (std::size_t frame = 0; frame < site.frames.size(); ++frame)
    if (!site.frames[frame].frame.target.empty()) stops.push_back(frame);
  return stops;
}

std::size_t target_of(const QuestionSite& site, std::size_t frame) {
  return static_cast<std::size_t>(find_object(site.scene, site.frames[frame].frame.target) - site.scene.objects.data());
}

bool says_no_place(const Reference& reference) {
  return !reference.by_time && reference.way != "on" && reference.way != "nearest";
}

SpatialQuestion number_question(const QuestionSite& site, Random& random, const QuestionDraft& draft, double answer) {
  SpatialQuestion question = begun(site, random, draft);
  const QuestionForm& form = question_forms().forms.at(draft.form);
  question.number = rounded(answer, answer_decimals);
  question.tolerance = rounded(std::max(form.tolerance * std::abs(answer), form.least_tolerance), answer_decimals);
  return question;
}

SpatialQuestion choice_question(const QuestionSite& site, Random& random, const QuestionDraft& draft, const std::string& right,
                         std::vector<std::string> wrong) {
  SpatialQuestion question = begun(site, random, draft);
  question.choices = std::move(wrong);
  question.choices.push_back(right);
  random.shuffle(question.choices);
  question.right = static_cast<std::size_t>(std::find(question.choices.begin(), question.choices.end(), right) -
                                            question.choices.begin());
  return question;
}

}  // namespace roomgen::lab::detail
