#include "model_author.h"

#include <memory>
#include <nlohmann/json.hpp>

#include "base/resource.h"
#include "chat/interview.h"
#include "roomgen/base/text.h"
#include "roomgen/design/designer.h"

namespace roomgen::lab {

namespace {

using namespace compose;

constexpr const char* shown_examples[] = {"examples/programs/living-room.json", "examples/programs/classroom.json",
                                          "examples/programs/kitchen.json"};

std::string operators_text() {
  std::string text;
  for (const auto& form : program_op_forms())
    text += "- " + std::string(form.name) + " (" + std::string(form.operands) + (form.truth ? ", a truth): " : "): ") +
            std::string(form.meaning) + "\n";
  return text + "Operands: S a set, N a number, B a truth, L a plain number, v a variable's name, s a face or nothing, "
                "a {\"dir\", \"depth\"} or nothing; + one or more.\n";
}

std::string relations_text() {
  std::vector<std::string> names;
  for (const auto& [name, how] : built_in_relations()) names.push_back(name);
  return join(names, ", ");
}

std::string tags_text() {
  std::vector<std::string> names;
  for (const auto& [name, kinds] : ProgramVocabulary::built_in().tags) names.push_back(name);
  return join(names, ", ");
}

std::string kinds_text(const std::vector<KindOffer>& offers) {
  std::vector<std::string> texts;
  for (const auto& offer : offers)
    texts.push_back(offer.kind + " " + format_number(offer.size.x(), 2) + "x" + format_number(offer.size.y(), 2) + "x" +
                    format_number(offer.size.z(), 2));
  return join(texts, ", ");
}

std::string examples_text() {
  std::string text;
  for (const auto* path : shown_examples)
    if (const auto example = resource(path)) text += std::string(*example) + "\n";
  return text;
}

std::string measures_text(const Complexity& asked) {
  std::vector<std::string> texts;
  for (const auto& [name, range] : complexity_measures())
    if (const auto& wanted = asked.*range) texts.push_back(std::string(name) + " " + range_text(*wanted));
  return texts.empty() ? "" : "In numbers: " + join(texts, ", ") + ".";
}

Json answer_schema() {
  return {{"type", "object"},
          {"properties",
           {{"reasoning", {{"type", "string"}}},
            {"program", {{"type", "object"}}},
            {"patch", {{"type", "array"}, {"items", {{"type", "object"}, {"required", {"op", "path"}}}}}}}}};
}

/// Asks one model for one room's programs.
class ModelAuthor {
 public:
  ModelAuthor(ChatModel& model, Prompts prompts, ModelAuthorOptions options)
      : interview_(model, std::move(prompts), options.answers), options_(std::move(options)) {}

  Result<WrittenProgram> write(const ComposeRequest& request) {
    request_ = request;
    asked_ = overridden(complexity_of(request.plan.prompt), request.complexity);
    Question question = new_question("program-user");
    question.user_slots = {{"wish", request.plan.prompt}, {"measures", measures_text(asked_)}};
    auto answer = ask(question, nullptr);
    if (!answer) return answer.error();
    return written(*std::move(answer), {});
  }

  Result<std::optional<Revision>> revise(const std::vector<ComposeRound>& rounds) {
    const ComposeRound& last = rounds.back();
    const Json before = to_json(last.written.program);
    Question question = new_question("program-revise-user");
    question.user_slots = {{"wish", request_.plan.prompt},
                           {"measures", measures_text(asked_)},
                           {"program", dump_json(before)},
                           {"report", to_text(last.report)},
                           {"earlier", earlier_text(rounds)}};
    if (!last.picture.empty()) question.images = {last.picture};
    auto answer = ask(question, before);
    if (!answer) return answer.error();
    const std::string reason = answer->reasoning;
    auto next = written(*std::move(answer), last.written.plan.room);
    if (!next) return next.error();
    Revision revision{*std::move(next), reason, {}, 0};
    revision.patch = Json::diff(before, to_json(revision.written.program));
    if (revision.patch.empty()) return std::optional<Revision>();
    return std::optional(std::move(revision));
  }

 private:
  Question new_question(const char* user) const {
    Question question;
    question.system = "program-system";
    question.user = user;
    question.system_slots = {{"operators", operators_text()},
                             {"relations", relations_text()},
                             {"kinds", kinds_text(options_.kinds)},
                             {"tags", tags_text()},
                             {"examples", examples_text()}};
    question.schema = answer_schema();
    question.schema_name = "program";
    question.max_tokens = options_.max_tokens;
    question.thinking = options_.thinking;
    question.cancel = request_.plan.cancel;
    return question;
  }

  Result<ProgramAnswer> ask(const Question& question, const Json& before) {
    return interview_.ask(question, [&](const std::string& text) -> Result<Reading<ProgramAnswer>> {
      auto answer = read_program_answer(text, before, KindTable::built_in());
      if (!answer) return answer.error();
      auto repairs = answer->repairs;
      return Reading<ProgramAnswer>{*std::move(answer), std::move(repairs), {}};
    });
  }

  static std::string earlier_text(const std::vector<ComposeRound>& rounds) {
    if (rounds.size() < 2) return "";
    std::string text = "Changes that were made before:\n";
    for (std::size_t i = 1; i < rounds.size(); ++i) text += "- " + rounds[i].reason + "\n";
    return text;
  }

  // The room of a program is drawn once: a revision that says nothing new of it keeps it.
  Result<WrittenProgram> written(ProgramAnswer answer, const std::optional<Room>& before) {
    WrittenProgram result;
    result.notes = interview_.take_notes();
    answer.program.prompt = request_.plan.prompt;
    answer.program.seed = request_.plan.seed;
    auto plan = make_rule_designer()->plan(request_.plan);
    if (!plan) return plan.error();
    result.plan = *std::move(plan);
    auto room = request_.plan.room ? Result<Room>(*request_.plan.room) : room_for(answer.program, before, result.notes);
    if (!room) return room.error();
    result.plan.room = *std::move(room);
    result.stock = wishes_for(kinds_to_stock(answer.program, KindTable::built_in(), request_.plan.seed));
    result.program = std::move(answer.program);
    result.asked = asked_;
    return result;
  }

  Result<Room> room_for(ConstraintProgram& program, const std::optional<Room>& before,
                        std::vector<std::string>& notes) const {
    if (request_.plan.size) {
      program.room.polygon.reset();
      program.room.area.reset();
      program.room.width = Range{request_.plan.size->x(), request_.plan.size->x()};
      program.room.depth = Range{request_.plan.size->y(), request_.plan.size->y()};
    }
    auto room = room_of(program, request_.plan.seed, notes);
    if (room && before && bounds(before->polygon).size().isApprox(bounds(room->polygon).size(), 1e-6)) return *before;
    return room;
  }

  Interview interview_;
  ModelAuthorOptions options_;
  ComposeRequest request_;
  Complexity asked_;
};

}  // namespace

ProgramAuthor model_author(ChatModel& model, Prompts prompts, ModelAuthorOptions options) {
  const auto author = std::make_shared<ModelAuthor>(model, std::move(prompts), std::move(options));
  return {"model", [author](const ComposeRequest& request) { return author->write(request); },
          [author](const std::vector<ComposeRound>& rounds) { return author->revise(rounds); }, true};
}

}  // namespace roomgen::lab
