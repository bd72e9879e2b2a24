#include <memory>

#include "add_commands.h"
#include "benchmark_make.h"
#include "benchmark_run.h"
#include "tool_commands.h"
#include "tours.h"

namespace roomgen::cli {

using namespace lab;

namespace {

struct MakeCommand {
  std::string size = "640x480";
  BenchmarkMakeOptions options;
};

void add_make_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<MakeCommand>();
  BenchmarkMakeOptions& options = command->options;
  options.frames.layers = {"rgb", "instance"};
  CLI::App* make = app.add_subcommand("make", "Scenes, tours, frames and questions over a grid of complexities");
  make->add_option("-o,--output", options.output, "Folder; what is done in it is kept")->required();
  make->add_option("--rooms", options.rooms, "Sorts of rooms, with commas (all of the levels' file)")->delimiter(',');
  make->add_option("--tasks", options.tasks, "Of measurement, perspective, spatiotemporal, relation, control (all)")
      ->delimiter(',');
  make->add_option("--compositional", options.compositional, "Levels of the number of seats")->delimiter(',')->capture_default_str();
  make->add_option("--relational", options.relational, "Levels of the occupied floor")->delimiter(',')->capture_default_str();
  make->add_option("--observational", options.observational, "Levels of the camera's height and of hiding")
      ->delimiter(',')->capture_default_str();
  make->add_option("--scenes", options.scenes, "Base rooms of each sort")->check(CLI::Range(1, 1000))->capture_default_str();
  make->add_option("--per-form", options.per_form, "Questions of each form and scene at most")->capture_default_str();
  make->add_option("--jobs", options.jobs, "Scenes that are made at once")->check(CLI::Range(1, 64))->capture_default_str();
  make->add_option("--seed", options.seed, "Same seed, same set")->capture_default_str();
  make->add_option("--levels", options.levels, "What the levels mean (data/benchmark/levels.json)");
  make->add_option("--size", command->size, "Of the pictures")->capture_default_str();
  make->add_option("--fps", options.frames.per_second, "Frames a second of the tours")->capture_default_str();
  make->add_option("--layers", options.frames.layers, "Of the frames")->delimiter(',')->capture_default_str();
  add_library_options(*make, options.libraries);
  make->callback([&context, command] {
    context.run = [&context, command]() -> Result<int> {
      FrameOptions& frames = command->options.frames;
      if (auto status = read_picture_size(command->size, frames.width, frames.height); !status) return status.error();
      return make_benchmark(context, command->options);
    };
  });
}

void add_run_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<BenchmarkRunOptions>();
  options->model.designer = "model";
  CLI::App* run = app.add_subcommand("run", "Ask a model the questions of a set, score and tabulate its answers");
  run->add_option("set", options->set, "Folder of `roomgen benchmark make`")->required()->check(CLI::ExistingDirectory);
  run->add_option("-o,--output", options->output, "Folder for results.jsonl, report.md and plots")->required();
  run->add_option("--frames", options->frames, "Frames that are shown with a question at most")->capture_default_str();
  run->add_flag("--evidence", options->evidence, "Show only the frames that prove the answer");
  run->add_flag("--video", options->video, "Show the whole video, and frames only where the endpoint takes no videos");
  run->add_option("--limit", options->limit, "Ask only the first so many")->capture_default_str();
  run->add_option("--answer-tokens", options->answer_tokens, "Tokens of an answer, its reasoning included")->capture_default_str();
  run->add_option("--thinking", options->thinking, "Tokens for thinking besides, for models that can be told")
      ->check(CLI::Range(0, 1000000))->capture_default_str();
  run->add_flag("--force", options->force, "Begin anew in a folder that holds other results");
  run->add_option("--cache", options->cache, "Folder for kept answers");
  add_chat_options(*run, options->model);
  run->callback([&context, options] { context.run = [&context, options] { return run_benchmark(context, *options); }; });
}

void add_score_command(CLI::App& app, Context& context) {
  struct Files {
    std::string questions, answers, output = "scores";
  };
  auto files = std::make_shared<Files>();
  CLI::App* score = app.add_subcommand("score", "Score answers that were given elsewhere");
  score->add_option("questions", files->questions, "questions.jsonl")->required()->check(CLI::ExistingFile);
  score->add_option("answers", files->answers, "JSON lines with id and answer")->required()->check(CLI::ExistingFile);
  score->add_option("-o,--output", files->output, "Folder for report.md and plots")->capture_default_str();
  score->callback([&context, files] {
    context.run = [&context, files] { return score_answers(context, files->questions, files->answers, files->output); };
  });
}

}  // namespace

void add_benchmark_command(CLI::App& app, Context& context) {
  CLI::App* benchmark = add_tool_command(app, "benchmark");
  benchmark->require_subcommand(1);
  add_make_command(*benchmark, context);
  add_run_command(*benchmark, context);
  add_score_command(*benchmark, context);
}

}  // namespace roomgen::cli
