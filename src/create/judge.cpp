#include "maker_questions.h"
#include "roomgen/create/maker.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "brief/reply_measure.h"
#include "chat/loose_json.h"
#include "chat/interview.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

using Keys = std::vector<std::string>;

constexpr int least_points = 1, most_points = 5;
constexpr std::size_t most_reason = 300;  // bytes

// 4, "4", "4/5".
std::optional<double> points_in(const Json& value) {
  const Json first = value.is_string() ? Json(split(value.get<std::string>(), '/').front()) : value;
  const auto measure = brief::single_measure(first);
  return measure ? std::optional(measure->value) : std::nullopt;
}

Result<Score> read_score(const Json& json, const Keys& names) {
  const auto wrong = [&](const std::string& what) {
    return Error{Error::Kind::invalid_input, "/" + names.front() + ": " + what};
  };
  const Json* given = member(json, names);
  if (!given) return wrong("missing; expected points and a reason");
  const Json* points = given->is_object() ? member(*given, {"points", "score", "rating"}) : given;
  const auto value = points ? points_in(*points) : std::nullopt;
  if (!value || *value < least_points || *value > most_points)
    return wrong("expected points from 1 to 5");
  Score score;
  score.points = static_cast<int>(std::lround(*value));
  const Json* reason = given->is_object()
                           ? member(*given, {"reason", "explanation", "justification"})
                           : member(json, {names.front() + " reason"});
  if (reason && reason->is_string())
    score.reason = shortened(std::string(trim(reason->get_ref<const std::string&>())), most_reason);
  return score;
}

Result<Reading<Scores>> read_scores(const std::string& text) {
  auto loose =
      find_json(text, {{"structure", "realism", "alignment"},
                               {"structural coherence", "visual realism", "prompt alignment"}});
  if (!loose) return loose.error();
  const auto structure = read_score(loose->json, {"structure", "structural coherence"});
  if (!structure) return structure.error();
  const auto realism = read_score(loose->json, {"realism", "visual realism"});
  if (!realism) return realism.error();
  const auto alignment = read_score(loose->json, {"alignment", "prompt alignment"});
  if (!alignment) return alignment.error();
  return Reading<Scores>{{*structure, *realism, *alignment}, std::move(loose->repairs)};
}

}  // namespace

Result<Scores> judge(ChatModel& model, const Prompts& prompts, const std::string& prompt,
                     const std::vector<std::string>& views, const JudgeOptions& options) {
  if (views.empty()) return Error{Error::Kind::invalid_input, "there is no picture to judge"};
  Question question{"create-judge-system", "create-judge-user"};
  question.user_slots = {{"prompt", prompt}, {"views", std::to_string(views.size())}};
  question.schema = scores_schema();
  question.schema_name = "scores";
  question.max_tokens = options.tokens;
  question.images = views;
  question.cancel = options.cancel;
  return Interview(model, prompts, options.answers).ask(question, read_scores);
}

}  // namespace roomgen::create
