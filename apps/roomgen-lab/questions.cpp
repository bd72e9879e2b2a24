#include "roomgen/lab/questions.h"

#include <cstdio>
#include <memory>

#include "add_commands.h"
#include "models.h"
#include "question_files.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "tool_commands.h"

namespace roomgen::cli {

using namespace lab;

namespace {

struct QuestionsCommand {
  std::string scene, tour = "tour", output;
  QuestionOptions questions;
  ModelOptions models;
};

void report(const Context& context, const std::string& path, const std::vector<SpatialQuestion>& questions) {
  std::map<std::string, int> by_task;
  for (const auto& question : questions) ++by_task[question.task];
  if (context.json) {
    std::printf("%s\n", json_line(Json{{"file", path}, {"questions", questions.size()}, {"by_task", by_task}}).c_str());
    return;
  }
  if (context.quiet) return;
  std::fprintf(stderr, "wrote %zu questions into %s\n", questions.size(), printable(path).c_str());
  for (const auto& [task, count] : by_task) std::fprintf(stderr, "  %s: %d\n", printable(task).c_str(), count);
}

Result<int> ask(const Context& context, const QuestionsCommand& command) {
  const std::filesystem::path folder = command.tour;
  const std::string output = command.output.empty() ? (folder / "questions.jsonl").string() : command.output;
  const auto scene = read_scene(command.scene);
  if (!scene) return scene.error();
  const auto frames = read_frames(folder / "frames.jsonl");
  if (!frames) return with_context(frames.error(), "draw them with `roomgen frames`");
  const auto models = models_of(*scene, command.scene, command.models, context);
  if (!models) return models.error();
  const auto questions = make_questions(*scene, *models, KindTable::built_in(), *frames, command.questions);
  if (!questions) return questions.error();
  if (auto status = write_file(output, question_lines(*questions)); !status) return status.error();
  report(context, output, *questions);
  return exit_ok;
}

}  // namespace

std::string question_lines(const std::vector<SpatialQuestion>& questions) {
  std::string lines;
  for (const auto& question : questions) lines += json_line(to_json(question)) + "\n";
  return lines;
}

void add_questions_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<QuestionsCommand>();
  QuestionOptions& options = command->questions;
  CLI::App* sub = add_tool_command(app, "questions");
  sub->add_option("scene", command->scene, "scene.json")->required()->check(CLI::ExistingFile);
  sub->add_option("--tour", command->tour, "Folder of frames.jsonl")->capture_default_str();
  sub->add_option("-o,--output", command->output, "File to write (questions.jsonl in the tour's folder)");
  sub->add_option("--tasks", options.tasks, "Of measurement, perspective, spatiotemporal, relation, control (all)")
      ->delimiter(',');
  sub->add_option("--per-form", options.per_form, "Questions of each form at most")->capture_default_str();
  sub->add_option("--seed", options.seed, "Same seed, same questions")->capture_default_str();
  add_model_options(*sub, command->models);
  sub->callback([&context, command] { context.run = [&context, command] { return ask(context, *command); }; });
}

}  // namespace roomgen::cli
