#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "chat/interview.h"
#include "chat/loose_json.h"
#include "roomgen/base/text.h"
#include "roomgen/edit_reader/understand.h"
#include "scene_words.h"

namespace roomgen {

namespace {

constexpr std::size_t most_operations = 60;  // of one round
constexpr std::size_t longest_judgement = 2000;

struct Judged {
  std::string judgement;
  std::vector<Json> operations;
  std::size_t beyond = 0;  ///< of them, not taken
};

Result<Reading<Judged>> read_judged(const std::string& text) {
  const auto found = find_json(text, {{"operations"}, {"operation", "edits", "judgement"}});
  if (!found) return found.error();
  const Json* list = member(found->json, {"operations", "operation", "edits"});
  if (!list || !list->is_array()) return Error{Error::Kind::invalid_input, "it holds no list \"operations\""};
  Reading<Judged> reading{{}, found->repairs, {}};
  if (const Json* words = member(found->json, {"judgement", "judgment"}); words && words->is_string())
    reading.value.judgement = shortened(words->get<std::string>(), longest_judgement);
  for (const auto& one : *list)
    if (reading.value.operations.size() < most_operations) reading.value.operations.push_back(one);
  reading.value.beyond = list->size() - reading.value.operations.size();
  return reading;
}

std::string verdict_lines(const Scene& scene) {
  std::string lines;
  for (const auto& one : scene.requirements) lines += told(one) + "\n";
  return lines.empty() ? "nothing in particular\n" : lines;
}

std::string unplaced_lines(const Scene& scene) {
  std::vector<std::string> lines;
  for (const auto& one : scene.unplaced) lines.push_back(one.id + " (" + one.reason + ")");
  return lines.empty() ? "nothing" : join(lines, "; ");
}

std::string news_of(const std::vector<ReviewRound>& rounds) {
  if (rounds.empty()) return {};
  const auto &changes = rounds.back().changes, &refused = rounds.back().refused;
  return (changes.empty() ? "" : "Your last answer has changed: " + join(changes, "; ") + "\n") +
         (refused.empty() ? "" : "Of it could not be done: " + join(refused, "; ") + "\n");
}

Result<Question> review_question(const Reviewing& reviewing, const Scene& scene, const std::vector<ReviewRound>& rounds) {
  auto system = operation_slots(reviewing.prompts, scene);
  if (!system) return system.error();
  const SceneWords words = words_of_scene(scene);
  Question question{.system = "review-system", .user = "review-user"};
  question.system_slots = *std::move(system);
  question.user_slots = {{"prompt", scene.prompt},
                         {"requirements", verdict_lines(scene)},
                         {"unplaced", unplaced_lines(scene)},
                         {"room", words.room},
                         {"parts", words.parts},
                         {"placed", words.placed},
                         {"refused", news_of(rounds)}};
  question.schema = operations_schema("judgement");
  question.schema_name = "review";
  question.max_tokens = reviewing.tokens;
  question.cancel = reviewing.cancel;
  return question;
}

/// What an answer calls the things that it adds: their ids, by name.
using NewNames = std::map<std::string, std::string, std::less<>>;

// With ids in place of the names, also behind the comma of a relation.
Json with_ids(const Json& json, const NewNames& names) {
  if (json.is_string()) {
    const std::string text = json.get<std::string>();
    const auto comma = text.rfind(',');
    const std::size_t from = comma == std::string::npos ? 0 : text.find_first_not_of(' ', comma + 1);
    const auto named = from == std::string::npos ? names.end() : names.find(text.substr(from));
    return named == names.end() ? json : Json(text.substr(0, from) + named->second);
  }
  Json result = json;
  if (json.is_structured())
    for (auto& inner : result) inner = with_ids(inner, names);
  return result;
}

// Takes what the answer calls a new thing out of the operation.
std::string take_name(Json& operation) {
  if (!operation.is_object() || !operation.contains("as")) return {};
  const std::string name = operation["as"].is_string() ? operation["as"].get<std::string>() : "";
  operation.erase("as");
  return name;
}

// As it was asked, without what fills pages.
std::string told_operation(Json operation) {
  if (operation.is_object() && operation.contains("program")) operation["program"] = "...";
  return json_line(operation);
}

// Is any of these things taken out so that another one of its kind comes?
bool is_exchange(const Session& session, const edit::Remove& remove, const edit::Add& add) {
  return std::any_of(remove.objects.begin(), remove.objects.end(), [&](const std::string& id) {
    const Object* gone = find_object(session.scene(), id);
    return gone && session.kinds().is_a(gone->category, add.category);
  });
}

// What is carried out together, all or none: a thing goes only if the one for which it makes room
// comes, where nothing else is done in between.
std::vector<std::vector<Json>> steps_of(const Session& session,
                                        const std::vector<Json>& operations) {
  std::vector<edit::Operation> read;
  for (Json one : operations) {
    take_name(one);
    const auto operation = edit::operation_from_json(one, "operation");
    read.push_back(operation ? *operation : edit::Operation(edit::Revert{}));
  }
  std::vector<std::vector<Json>> steps(operations.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    std::size_t step = i;
    const auto* remove = std::get_if<edit::Remove>(&read[i]);
    for (std::size_t j = i + 1; remove && j < read.size(); ++j) {
      const auto* add = std::get_if<edit::Add>(&read[j]);
      if (!add && !std::holds_alternative<edit::Remove>(read[j])) break;
      if (!add || !is_exchange(session, *remove, *add)) continue;
      step = j;
      if (static_cast<int>(steps[j].size()) < add->count) break;
    }
    steps[step].push_back(operations[i]);
  }
  std::erase_if(steps, [](const auto& step) { return step.empty(); });
  return steps;
}

// Where that is which the answer added and now would change in vain.
std::string where_added(const Scene& scene, const NewNames& names, const Json& operation) {
  const Json* said = member(operation, {"object"});
  for (const auto& [name, id] : names)
    if (const Object* object = said && *said == id ? find_object(scene, id) : nullptr)
      return "; it is where it was added, " +
             (object->on.empty() ? "at " + format_number(object->position.x(), 2) + ", " +
                                       format_number(object->position.y(), 2)
                                 : "on " + object->on);
  return "";
}

// Each by itself: what one cannot do costs none of the others.
void carry_out(Session& session, const std::vector<Json>& operations, ReviewRound& round) {
  NewNames names;
  for (const auto& step : steps_of(session, operations)) {
    Json together = Json::array();
    std::string name, asked;
    for (const auto& one : step) {
      together.push_back(with_ids(one, names));
      name = take_name(together.back());
      asked += (asked.empty() ? "" : " ") + told_operation(together.back());
    }
    const auto read = edit::operations_from_json(together, "operation");
    const auto report =
        read ? session.apply(*read, {asked, "model"}) : Result<EditReport>(read.error());
    if (!report)
      round.refused.push_back(asked + ": " + report.error().message +
                              where_added(session.scene(), names, together.back()));
    else round.changes.insert(round.changes.end(), report->changes.begin(), report->changes.end());
    for (std::size_t k = 0; report && !name.empty() && k < report->added.size(); ++k)
      names[k == 0 ? name : name + " " + std::to_string(k + 1)] = report->added[k];
  }
}

}  // namespace

Result<std::vector<ReviewRound>> review(Session& session, const Reviewing& reviewing) {
  std::vector<ReviewRound> rounds;
  Interview interview(reviewing.model, reviewing.prompts, reviewing.answers);
  while (static_cast<int>(rounds.size()) < reviewing.rounds) {
    auto question = review_question(reviewing, session.scene(), rounds);
    if (!question) return question.error();
    if (reviewing.pictures) {
      auto pictures = reviewing.pictures(session);
      if (!pictures) return pictures.error();
      question->images = *std::move(pictures);
    }
    auto answer = interview.ask(*question, read_judged);
    if (!answer && rounds.empty()) return answer.error();
    if (!answer) break;
    ReviewRound round{answer->judgement, {}, {}};
    carry_out(session, answer->operations, round);
    if (answer->beyond > 0)
      round.refused.push_back("the last " + std::to_string(answer->beyond) + " operations: an answer has " +
                              std::to_string(most_operations) + " at most");
    const bool done = answer->operations.empty();
    rounds.push_back(std::move(round));
    if (done || reviewing.cancel.cancelled()) break;
  }
  return rounds;
}

}  // namespace roomgen
