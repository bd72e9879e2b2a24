#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "add_commands.h"
#include "experiments.h"
#include "made.h"
#include "makers.h"
#include "options.h"
#include "resumable_lines.h"
#include "room_files.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/lab/suite.h"
#include "tool_commands.h"

namespace roomgen::cli {

using namespace lab;

namespace {

namespace fs = std::filesystem;

constexpr const char* summary_name = "results.json";
constexpr const char* report_name = "report.md";

struct ExperimentOptions {
  std::string suite, insertions, programs, output, cache;
  std::vector<std::string> variants = {"full"};
  std::vector<int> only;
  std::uint64_t seed = 1;
  bool force = false;
  MakerOptions maker;
};

struct Task {
  create::Variant variant = create::Variant::full;
  int number = 0;  ///< of the sentence, from 1

  auto operator<=>(const Task&) const = default;
};

/// What is made so far; each result is kept as soon as it is there.
class Results {
 public:
  static Result<Results> open(const fs::path& folder, const Json& head, bool force) {
    auto lines = ResumableLines::open(folder, head, force);
    if (!lines) return lines.error();
    Results results(*std::move(lines));
    for (const auto& line : results.lines_.earlier()) {
      auto result = lab::suite_result_from_json(line.json, line.where);
      if (!result) return result.error();
      results.all_.push_back(*std::move(result));
    }
    return results;
  }

  Status add(lab::SuiteResult result) {
    if (auto status = lines_.add(to_json(result)); !status) return status;
    all_.push_back(std::move(result));
    return {};
  }

  bool has(const Task& task) const {
    for (const auto& result : all_)
      if (result.variant == task.variant && result.number == task.number) return true;
    return false;
  }
  /// Of these tasks, in their order.
  std::vector<lab::SuiteResult> of(const std::vector<Task>& tasks) const {
    std::vector<lab::SuiteResult> chosen;
    for (const auto& task : tasks)
      for (const auto& result : all_)
        if (result.variant == task.variant && result.number == task.number) chosen.push_back(result);
    return chosen;
  }

 private:
  explicit Results(ResumableLines lines) : lines_(std::move(lines)) {}

  ResumableLines lines_;
  std::vector<lab::SuiteResult> all_;
};

/// Makes and judges the sentences of a suite.
class Experiment {
 public:
  Experiment(const Context& context, const ExperimentOptions& options,
             std::vector<lab::SuiteSentence> suite, ComposedMakers makers)
      : context_(context),
        options_(options),
        suite_(std::move(suite)),
        makers_(std::move(makers)) {}

  /// An error is one that ends the experiment; that a thing cannot be made is a result.
  Result<lab::SuiteResult> run(const Task& task) {
    const auto& sentence = suite_[static_cast<std::size_t>(task.number - 1)];
    lab::SuiteResult result;
    result.variant = task.variant;
    result.number = task.number;
    result.prompt = sentence.prompt;
    result.group = sentence.group;
    const auto start = std::chrono::steady_clock::now();
    auto creation = make(task.variant, sentence.prompt);
    if (!creation && ends(creation.error())) return creation.error();
    if (context_.cancel.cancelled()) return Error{Error::Kind::cancelled, "interrupted"};
    std::string why = !creation ? creation.error().message : creation->verdict.reason;
    if (creation && creation->verdict.passes) {
      const auto& object = creation->objects.front();
      result.assessment = lab::assess(sentence, *creation);
      result.size = shape::bounds(object.shape).size();
      result.triangles = shape::triangle_count(object.shape);
      result.repairs = static_cast<int>(object.repairs.size());
      result.fell_back = object.fell_back;
      auto all = made_of(*std::move(creation), options_.seed);
      if (!all) return all.error();
      if (auto status = judge(*all, sentence.prompt, result); !status) return status.error();
      why.clear();
      if (auto status = write(task, *all); !status) return status.error();
    } else {
      result.assessment = lab::not_made(sentence, why);
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (auto status = write_result(task, result, why); !status) return status.error();
    return result;
  }

 private:
  Result<create::Creation> make(create::Variant variant, const std::string& prompt) {
    create::CreateOptions options;
    options.seed = options_.seed;
    options.variant = variant;
    options.cancel = context_.cancel;
    // A model that was given up in one sentence is asked again in the next.
    const auto maker = makers_.maker(variant, context_.cancel);
    return create::create(prompt, *maker, options);
  }

  bool ends(const Error& error) const {
    return error.kind == Error::Kind::cancelled || makers_.budget_is_spent() ||
           (makers_.asks_a_model() && error.kind == Error::Kind::unavailable);
  }

  // Points that the model does not give are missing; a model that cannot be asked ends it all.
  Status judge(const MadeAll& all, const std::string& prompt, lab::SuiteResult& result) {
    if (!makers_.judges()) return {};
    auto scores = makers_.judge(prompt, all.model, context_.cancel);
    if (scores)
      result.scores = *std::move(scores);
    else if (ends(scores.error()) || scores.error().kind == Error::Kind::unavailable)
      return with_context(scores.error(), "judging");
    else
      result.assessment.failures.push_back("not judged: " + scores.error().message);
    return {};
  }

  // As bench/create/score.py reads them.
  fs::path file(const Task& task, const std::string& ending) const {
    char number[16];
    std::snprintf(number, sizeof number, "%03d", task.number);
    return fs::path(options_.output) / create::name(task.variant) / (number + ending);
  }

  Status write(const Task& task, const MadeAll& all) const {
    const auto& program = all.objects.front().program;
    const auto glb = make_glb(program.name, all.model, export_options());
    if (!glb) return glb.error();
    if (auto status = make_folder(file(task, "").parent_path()); !status) return status;
    if (auto status = write_file(file(task, ".glb"), *glb); !status) return status;
    if (!program.components.empty())
      if (auto status = write_file(file(task, ".json"), dump_json(shape::write_program(program)));
          !status)
        return status;
    return write_file(file(task, ".summary.json"), dump_json(objects_json(all)));
  }

  Status write_result(const Task& task, const lab::SuiteResult& result,
                      const std::string& why) const {
    if (auto status = make_folder(file(task, "").parent_path()); !status) return status;
    return write_file(file(task, ".result.json"),
                      dump_json({{"prompt", result.prompt},
                                 {"exit", result.assessment.made ? exit_ok : exit_failure},
                                 {"seconds", rounded(result.seconds, 3)},
                                 {"message", why}}));
  }

  const Context& context_;
  const ExperimentOptions& options_;
  std::vector<lab::SuiteSentence> suite_;
  ComposedMakers makers_;
};

std::vector<Task> tasks_of(const ExperimentOptions& options, std::size_t sentences) {
  std::vector<Task> tasks;
  std::set<Task> seen;
  for (const auto& variant : options.variants)
    for (int number = 1; number <= static_cast<int>(sentences); ++number) {
      const bool chosen = options.only.empty() || std::find(options.only.begin(), options.only.end(),
                                                            number) != options.only.end();
      const Task task{*create::variant_named(variant), number};
      if (chosen && seen.insert(task).second) tasks.push_back(task);
    }
  return tasks;
}

Json head_of(const ExperimentOptions& options, const std::string& suite) {
  Json head = {{"format", "roomgen-experiment"},
               {"version", 1},
               {"suite", lab::suite_version(suite)},
               {"seed", options.seed},
               {"designer", options.maker.designer.designer},
               {"judge", options.maker.judge}};
  if (options.maker.designer.designer == "model" || options.maker.judge)
    head["model"] = options.maker.designer.model;
  return head;
}

std::string physics_text(const ExperimentOptions& options) {
  std::string text;
  std::set<std::string> seen;
  for (const auto& variant : options.variants)
    if (seen.insert(variant).second)
      text += "python3 bench/create/score.py " +
              (fs::path(options.output) / variant).string() +
              (options.suite.empty() ? "" : " --prompts " + options.suite) + "\n";
  return text;
}

Status write_report(const ExperimentOptions& options,
                    const std::vector<lab::SuiteResult>& results) {
  const fs::path folder = options.output;
  Json json = {{"seed", options.seed}, {"figures", lab::suite_summary(results)}};
  for (const auto& result : results) json["results"].push_back(to_json(result));
  if (auto status = write_file(folder / summary_name, dump_json(json)); !status) return status;
  return write_file(folder / report_name,
                    lab::suite_markdown(results) +
                        "\nDropped in MuJoCo and measured by others (bench/create/README.md):\n\n" +
                        "```sh\n" + physics_text(options) + "```\n");
}

void tell(const Context& context, std::size_t done, std::size_t total,
          const lab::SuiteResult& result) {
  if (context.quiet) return;
  const auto& failures = result.assessment.failures;
  std::fprintf(stderr, "[%zu/%zu] %s %d %s: %s\n", done, total, create::name(result.variant),
               result.number, printable(shortened(result.prompt, 60)).c_str(),
               failures.empty() ? "as it should be" : printable(shortened(join(failures, "; "), 120)).c_str());
}

// Makes what is missing; what ends the experiment early, if anything does.
Status make_missing(const Context& context, const std::vector<Task>& tasks, Experiment& experiment,
                    Results& results) {
  std::size_t done = 0;
  for (const auto& task : tasks) {
    ++done;
    if (results.has(task)) continue;
    if (context.cancel.cancelled()) return Error{Error::Kind::cancelled, "interrupted"};
    auto result = experiment.run(task);
    if (!result) return result.error();
    tell(context, done, tasks.size(), *result);
    if (auto status = results.add(*std::move(result)); !status) return status;
  }
  return {};
}

Result<int> experiment(const Context& context, const ExperimentOptions& options) {
  const auto text = read_file(options.suite);
  if (!text) return text.error();
  const auto json = parse_json(*text, options.suite);
  if (!json) return json.error();
  auto suite = lab::read_suite(*json, options.suite);
  if (!suite) return suite.error();
  auto makers = ComposedMakers::compose(options.maker, context, options.cache);
  if (!makers) return makers.error();
  auto results = Results::open(options.output, head_of(options, *text), options.force);
  if (!results) return results.error();
  const auto tasks = tasks_of(options, suite->size());
  Experiment experiment(context, options, *std::move(suite), *std::move(makers));
  const auto ended = make_missing(context, tasks, experiment, *results);
  const auto finished = results->of(tasks);
  if (auto status = write_report(options, finished); !status) return status.error();
  if (!ended)
    return Error{ended.error().kind, ended.error().message + "; " +
                                         std::to_string(finished.size()) + " of " +
                                         std::to_string(tasks.size()) +
                                         " are done, the same command goes on from there"};
  if (context.json)
    std::fputs(dump_json(lab::suite_summary(finished)).c_str(), stdout);
  else
    std::fputs(printable(lab::suite_markdown(finished)).c_str(), stdout);
  if (!context.quiet)
    std::fprintf(stderr, "To drop them in MuJoCo (bench/create/README.md):\n%s",
                 physics_text(options).c_str());
  return exit_ok;
}

void check_experiment_usage(const ExperimentOptions& options) {
  if (options.suite.empty() && options.insertions.empty() && options.programs.empty())
    throw CLI::RequiredError("--create, --insertions or --programs");
  for (const auto& variant : options.variants)
    if (variant == "direct" && options.maker.designer.designer != "model")
      throw CLI::ValidationError("--variants", "direct needs --designer model");
}

}  // namespace

void add_experiment_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<ExperimentOptions>();
  auto* sub = add_tool_command(app, "experiment");
  auto* create = sub->add_option("--create", options->suite,
                                 "Sentences with what can be checked, as bench/create/prompts.json");
  auto* insertions = sub->add_option("--insertions", options->insertions,
                                     "Rooms and sentences that change them, as bench/edits/insertions.json: a "
                                     "picture of each step (docs/editing.md)");
  auto* programs = sub->add_option("--programs", options->programs,
                                   "Descriptions with what they demand, as bench/programs/descriptions-open.jsonl: fidelity "
                                   "with and without refinement and moves of clusters");
  create->excludes(insertions)->excludes(programs);
  insertions->excludes(programs);
  sub->add_option("--variants", options->variants,
                  "full, no-validation, no-decomposition, direct; several with commas")
      ->delimiter(',')
      ->check(CLI::IsMember({"full", "no-validation", "no-decomposition", "direct"}))
      ->capture_default_str();
  sub->add_option("-o,--output", options->output,
                  "Folder for the objects, results.json and report.md; the same command again goes "
                  "on where it was stopped")
      ->required();
  sub->add_option("--only", options->only, "Numbers of sentences of --create, from 1, with commas")
      ->delimiter(',')->excludes(programs)->excludes(insertions)
      ->check(CLI::PositiveNumber);
  sub->add_option("--seed", options->seed, "Seed of what sentences leave open")
      ->check(CLI::Range(std::uint64_t{0}, max_seed))
      ->capture_default_str();
  sub->add_flag("--force", options->force, "Start anew whatever the folder holds");
  sub->add_option("--cache", options->cache,
                  "Where answers are kept (default: the user's cache folder)");
  add_maker_options(*sub, options->maker);
  sub->callback([options, &context] {
    check_experiment_usage(*options);
    if (!options->insertions.empty()) {
      context.run = [options, &context] {
        return run_insertions(context, {options->insertions, options->output, options->force, {}});
      };
      return;
    }
    if (!options->programs.empty()) {
      context.run = [options, &context] {
        return run_program_experiment(context, {options->programs, options->output, options->cache, options->seed, options->force,
                                                options->maker.designer});
      };
      return;
    }
    context.run = [options, &context] { return experiment(context, *options); };
  });
}

}  // namespace roomgen::cli
