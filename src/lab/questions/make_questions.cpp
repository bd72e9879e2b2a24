#include <algorithm>
#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"
#include "site.h"

namespace roomgen::lab {

namespace {

using namespace detail;

struct NamedMaker {
  const char* form;
  FormMaker make;
};

constexpr NamedMaker makers[] = {
    {"height", height_questions},     {"length", length_questions},   {"distance", distance_questions},
    {"gap", gap_questions},           {"area", area_questions},       {"room area", room_area_questions},
    {"count", count_questions},       {"side", side_questions},       {"behind", behind_questions},
    {"order", order_questions},       {"first", first_questions},     {"between", between_questions},
    {"carried", carried_questions},   {"carrier", carrier_questions}, {"nearest", nearest_questions},
    {"in room", in_room_questions},   {"color", color_questions},     {"kind", kind_questions},
    {"in sight", in_sight_questions}};

Error bad_questions(const std::string& what) { return {Error::Kind::invalid_input, "questions: " + what}; }

Status check_tasks(const QuestionOptions& options) {
  const auto tasks = question_tasks();
  for (const auto& task : options.tasks)
    if (std::count(tasks.begin(), tasks.end(), task) == 0)
      return bad_questions("no task is called " + task + "; there are " + join(tasks, ", "));
  if (options.per_form < 1 || options.per_form > 1000) return bad_questions("there must be 1 to 1000 of a form");
  return {};
}

Status check_frames(const Scene& scene, const std::vector<FrameRecord>& frames) {
  if (frames.empty()) return bad_questions("there are no frames; draw them with `roomgen frames`");
  for (const auto& frame : frames) {
    bool same = frame.objects.size() == scene.objects.size();
    for (std::size_t k = 0; same && k < frame.objects.size(); ++k) same = frame.objects[k].id == scene.objects[k].id;
    if (!same || (!frame.frame.target.empty() && !find_object(scene, frame.frame.target)))
      return bad_questions("frame " + std::to_string(frame.frame.number) + " shows another scene; draw the frames again");
  }
  return {};
}

// Floor under what stands on it, as a share of all floor.
double occupancy(const Scene& scene) {
  double covered = 0.0, all = 0.0;
  for (const auto& room : rooms_of(scene)) all += std::abs(signed_area(room.polygon.points));
  for (const auto& object : scene.objects)
    if (object.mount == Mount::floor && !object.traits.flat) covered += object.size.x() * object.size.y();
  return covered / all;
}

Json complexity_of(const Scene& scene, const Json& given) {
  Json json = {{"objects", scene.objects.size()}, {"occupancy", rounded(occupancy(scene), 3)}};
  if (given.is_object()) json.update(given);
  return json;
}

// Scenes of one seed draw apart: else the first question of a form had its answer at one place in all of them.
std::string fingerprint(const Scene& scene, const std::vector<FrameRecord>& frames) {
  std::string text = std::to_string(frames.size());
  for (const auto& object : scene.objects)
    text += " " + object.id + " " + format_number(object.position.x()) + " " + format_number(object.position.y());
  return text;
}

std::string id_of(const QuestionOptions& options, const SpatialQuestion& question, std::size_t number) {
  std::string form = question.form;
  std::replace(form.begin(), form.end(), ' ', '-');
  return (options.prefix.empty() ? "" : options.prefix + "-") + form + "-" + std::to_string(number);
}

}  // namespace

Result<std::vector<SpatialQuestion>> make_questions(const Scene& scene, const ModelTable& models, const KindTable& kinds,
                                             const std::vector<FrameRecord>& frames, const QuestionOptions& options) {
  if (auto status = check_tasks(options); !status) return status.error();
  if (auto status = check_frames(scene, frames); !status) return status.error();
  const auto seen = appearances(scene, frames, question_forms().limits);
  const References references(scene, models, kinds, seen);
  const QuestionSite site{scene, kinds, frames, seen, references, static_cast<std::size_t>(options.per_form)};
  const Json complexity = complexity_of(scene, options.complexity);
  const std::string drawn_for = fingerprint(scene, frames);
  std::vector<SpatialQuestion> questions;
  for (const auto& [form, make] : makers) {
    const std::string& task = question_forms().forms.at(form).task;
    if (!options.tasks.empty() && std::count(options.tasks.begin(), options.tasks.end(), task) == 0) continue;
    Random random = Random(options.seed).fork(drawn_for).fork(form);
    std::size_t number = 0;
    for (auto& question : make(site, random)) {
      question.id = id_of(options, question, ++number);
      question.complexity = complexity;
      questions.push_back(std::move(question));
    }
  }
  Random order = Random(options.seed).fork(drawn_for).fork("order");
  order.shuffle(questions);
  return questions;
}

}  // namespace roomgen::lab
