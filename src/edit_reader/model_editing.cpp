#include <nlohmann/json.hpp>
#include <optional>

#include "chat/interview.h"
#include "chat/loose_json.h"
#include "edit_words.h"
#include "scene_words.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t most_bytes = 4000;  // of a sentence

struct Answer {
  std::vector<edit::Operation> operations;
  std::string unclear;
};

Result<Answer> read_answer(const std::string& text) {
  const auto found = find_json(text, {{"operations"}, {"operation", "edits", "unclear"}});
  if (!found) return found.error();
  Answer answer;
  if (const Json* why = member(found->json, {"unclear"}); why && why->is_string())
    answer.unclear = why->get<std::string>();
  const Json* list = member(found->json, {"operations", "operation", "edits"});
  const bool is_empty = !list || (list->is_array() && list->empty());
  if (is_empty && !answer.unclear.empty()) return answer;
  if (is_empty) return Error{Error::Kind::invalid_input, "it holds no \"operations\""};
  auto operations = edit::operations_from_json(*list, "operations");
  if (!operations) return operations.error();
  answer.operations = *std::move(operations);
  return answer;
}

Result<Question> question_of(const ModelEditing& editing, std::string_view sentence, const Scene& scene,
                             const Recall& recall) {
  auto system = operation_slots(editing.prompts, scene);
  if (!system) return system.error();
  const SceneWords words = words_of_scene(scene);
  const auto& recent = recall.added.empty() ? recall.touched : recall.added;
  Question question{.system = "edit-system", .user = "edit-user"};
  question.system_slots = *std::move(system);
  question.user_slots = {{"room", words.room},
                         {"parts", words.parts},
                         {"placed", words.placed},
                         {"recent", recent.empty() ? "nothing" : join(recent, ", ")},
                         {"sentence", std::string(sentence)}};
  question.schema = operations_schema("unclear");
  question.schema_name = "edit";
  question.max_tokens = editing.tokens;
  question.images = editing.pictures;
  question.cancel = editing.cancel;
  return question;
}

}  // namespace

Result<Understanding> ask_for_edit(const ModelEditing& editing, std::string_view sentence, const Scene& scene,
                                   const Recall& recall, const TryOperations& attempt) {
  if (sentence.size() > most_bytes)
    return Error{Error::Kind::limit, "an edit has " + std::to_string(most_bytes) + " bytes at most"};
  const auto question = question_of(editing, sentence, scene, recall);
  if (!question) return question.error();
  std::optional<Error> refused;  // what was wrong with the last answer
  const auto read = [&](const std::string& text) -> Result<Reading<Answer>> {
    auto answer = read_answer(text);
    refused.reset();
    if (!answer) {
      refused = not_understood("the model's answer cannot be used: " + answer.error().message);
      return answer.error();
    }
    if (answer->operations.empty()) return Reading<Answer>{*std::move(answer)};
    if (const Status possible = attempt(answer->operations); !possible) return *(refused = possible.error());
    return Reading<Answer>{*std::move(answer)};
  };
  auto answer = Interview(editing.model, editing.prompts, editing.answers).ask(*question, read);
  if (!answer) return refused ? *refused : answer.error();
  if (answer->operations.empty()) return not_understood(answer->unclear);
  return Understanding{std::move(answer->operations), {}};
}

}  // namespace roomgen
