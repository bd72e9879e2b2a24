#include "benchmark_make.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "benchmark_base.h"
#include "benchmark_levels.h"
#include "question_files.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/render/pictures.h"
#include "roomgen/lab/frames.h"

namespace roomgen::cli {

using namespace lab;

namespace {

namespace fs = std::filesystem;

Error bad_benchmark(const std::string& what) { return {Error::Kind::invalid_input, "benchmark: " + what}; }

std::vector<std::string> names_of(const auto& map) {
  std::vector<std::string> names;
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

Status check_names(const std::vector<std::string>& asked, const std::vector<std::string>& known, const char* what) {
  for (const auto& name : asked)
    if (std::count(known.begin(), known.end(), name) == 0)
      return bad_benchmark(std::string("no ") + what + " is called " + name + "; there are " + join(known, ", "));
  return {};
}

Status check_make(const BenchmarkMakeOptions& options, const BenchmarkLevels& levels) {
  std::vector<std::string> observational;
  for (const auto& [level, json] : levels.observational.items()) observational.push_back(level);
  if (auto status = check_names(options.rooms, names_of(levels.rooms), "room"); !status) return status;
  if (auto status = check_names(options.compositional, names_of(levels.compositional), "level"); !status) return status;
  if (auto status = check_names(options.relational, names_of(levels.relational), "level"); !status) return status;
  if (auto status = check_names(options.observational, observational, "level"); !status) return status;
  return check_names(options.tasks, question_tasks(), "task");
}

// One scene of the grid.
struct Job {
  const BaseRoom* base;
  BenchmarkCell cell;

  std::string folder() const { return "scenes/" + cell.name() + "/" + base->name; }
};

Json complexity_json(const Job& job, const Reduced& made) {
  return {{"compositional", job.cell.compositional}, {"relational", job.cell.relational},
          {"observational", job.cell.observational}, {"seats", made.seats}, {"occupancy", rounded(made.occupancy, 3)},
          {"as_defined", made.as_defined()}, {"room", job.base->name}, {"folder", job.folder()}};
}

class CellMaker {
 public:
  CellMaker(const Context& context, const BenchmarkMakeOptions& options, const BenchmarkLevels& levels)
      : context_(context), options_(options), levels_(levels) {}

  Status make(const Job& job) {
    const fs::path folder = fs::path(options_.output) / job.folder();
    std::error_code code;
    if (fs::exists(folder / "questions.jsonl", code)) return {};
    if (auto status = make_folder(folder); !status) return status;
    const Reduced made = reduced(job.base->scene, levels_, job.cell);
    if (auto status = write_file(folder / "scene.json", dump_json(to_json(made.scene))); !status) return status;
    const auto tour = make_tour_of(job, made.scene, folder);
    if (!tour) return tour.error();
    FrameOptions frames = options_.frames;
    frames.threads = 1;
    frames.cancel = context_.cancel;
    const auto drawn = draw_frames(made.scene, job.base->models, *tour, frames, folder);
    if (!drawn) return drawn.error();
    return ask(job, made, folder);
  }

 private:
  Result<Tour> make_tour_of(const Job& job, const Scene& scene, const fs::path& folder) {
    auto tour_options_of_cell = tour_options(scene, levels_, job.cell);
    if (!tour_options_of_cell) return tour_options_of_cell.error();
    tour_options_of_cell->cancel = context_.cancel;
    tour_options_of_cell->seed = options_.seed;
    if (!renderer_) {
      auto renderer = make_osmesa_renderer();
      if (!renderer) return renderer.error();
      renderer_ = std::move(*renderer);
    }
    auto tour = make_tour(scene, job.base->models, KindTable::built_in(), *renderer_, *tour_options_of_cell);
    if (!tour) return tour.error();
    if (tour->keyframes.empty()) return bad_benchmark(job.folder() + ": nobody gets into the room");
    if (auto status = write_file(folder / "tour.json", dump_json(to_json(*tour))); !status) return status.error();
    return tour;
  }

  Status ask(const Job& job, const Reduced& made, const fs::path& folder) {
    const auto frames = read_frames(folder / "frames.jsonl");
    if (!frames) return frames.error();
    QuestionOptions questions;
    questions.tasks = options_.tasks;
    questions.per_form = options_.per_form;
    questions.seed = options_.seed;
    questions.complexity = complexity_json(job, made);
    questions.prefix = job.cell.name() + "-" + job.base->name;
    const auto asked = make_questions(made.scene, job.base->models, KindTable::built_in(), *frames, questions);
    if (!asked) return asked.error();
    return write_file(folder / "questions.jsonl", question_lines(*asked));
  }

  const Context& context_;
  const BenchmarkMakeOptions& options_;
  const BenchmarkLevels& levels_;
  std::unique_ptr<Renderer> renderer_;
};

Status make_all(const Context& context, const BenchmarkMakeOptions& options, const BenchmarkLevels& levels,
                const std::vector<Job>& jobs) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::size_t done = 0;
  Status status;
  const auto work = [&] {
    CellMaker maker(context, options, levels);
    for (std::size_t k = next++; k < jobs.size(); k = next++) {
      const Status made = maker.make(jobs[k]);
      const std::lock_guard lock(mutex);
      if (!made && status) status = made;
      if (!status) next = jobs.size();
      if (made && !context.quiet) std::fprintf(stderr, "[%zu/%zu] %s\n", ++done, jobs.size(), printable(jobs[k].folder()).c_str());
    }
  };
  std::vector<std::thread> threads;
  for (int k = 1; k < options.jobs; ++k) threads.emplace_back(work);
  work();
  for (auto& thread : threads) thread.join();
  return status;
}

// What a table of the data card says of a scene.
std::string card_line(const std::vector<SpatialQuestion>& questions, const Job& job) {
  if (questions.empty()) return "| " + job.folder() + " | | | | | 0 |\n";
  const Json& complexity = questions.front().complexity;
  return "| " + job.folder() + " | " + complexity.at("objects").dump() + " | " + complexity.at("seats").dump() + " | " +
         complexity.at("occupancy").dump() + " | " + (complexity.at("as_defined").get<bool>() ? "yes" : "no") + " | " +
         std::to_string(questions.size()) + " |\n";
}

// Cells whose base room does not allow their levels, once for all levels of the camera.
std::string shortfall_list(const BenchmarkLevels& levels, const std::vector<Job>& jobs) {
  std::string list;
  std::set<std::string> told;
  for (const auto& job : jobs) {
    const std::string where = job.base->name + ", " + job.cell.compositional + " compositional, " + job.cell.relational + " relational";
    const Reduced made = reduced(job.base->scene, levels, job.cell);
    if (!made.as_defined() && told.insert(where).second) list += "- " + where + ": " + made.shortfall + "\n";
  }
  return list;
}

Result<std::size_t> put_together(const BenchmarkMakeOptions& options, const BenchmarkLevels& levels,
                                 const std::vector<Job>& jobs) {
  std::string lines, table;
  std::map<std::string, int> forms;
  std::size_t count = 0;
  for (const auto& job : jobs) {
    const auto questions = read_questions(fs::path(options.output) / job.folder() / "questions.jsonl");
    if (!questions) return questions.error();
    lines += question_lines(*questions);
    table += card_line(*questions, job);
    for (const auto& question : *questions) ++forms[question.task + " / " + question.form];
    count += questions->size();
  }
  std::string card =
      "# Spatial questions about furnished rooms\n\nMade by `roomgen benchmark make`, seed " + std::to_string(options.seed) +
      ". Every answer follows from scene.json and the frames; docs/questions.md of roomgen defines forms, levels and "
      "scores. Rooms and assets of a base room are the same at all levels: lower levels leave things out. \"As defined\" "
      "says whether seats and occupancy lie in the ranges of the levels.\n\n"
      "The meshes have licences of their own: `asset` in each scene.json.\n\n"
      "| scene | objects | seats | occupancy | as defined | questions |\n|---|---|---|---|---|---|\n" + table;
  if (const auto list = shortfall_list(levels, jobs); !list.empty())
    card += "\nWhat the base rooms do not allow; these scenes are as near as they get:\n\n" + list;
  card += "\n| task / form | questions |\n|---|---|\n";
  for (const auto& [form, number] : forms) card += "| " + form + " | " + std::to_string(number) + " |\n";
  if (auto status = write_file(fs::path(options.output) / "questions.jsonl", lines); !status) return status.error();
  if (auto status = write_file(fs::path(options.output) / "README.md", card); !status) return status.error();
  return count;
}

std::string job_text(const BenchmarkMakeOptions& options, const BenchmarkLevels& levels) {
  return dump_json({{"format", "roomgen-benchmark"}, {"version", 1}, {"seed", options.seed}, {"rooms", levels.rooms},
                    {"observational", levels.observational}, {"tasks", options.tasks}, {"per_form", options.per_form},
                    {"size", {options.frames.width, options.frames.height}}, {"fps", options.frames.per_second},
                    {"layers", options.frames.layers}});
}

// More scenes and levels may be added to a set; the rest must stay.
Status open_set(const BenchmarkMakeOptions& options, const std::string& job) {
  const fs::path file = fs::path(options.output) / "benchmark.json";
  if (auto status = make_folder(options.output); !status) return status;
  std::error_code code;
  if (!fs::exists(file, code)) {
    if (!fs::is_empty(options.output, code)) return bad_benchmark(options.output + " is not empty and holds no benchmark");
    return write_file(file, job);
  }
  const auto earlier = read_file(file);
  if (!earlier) return earlier.error();
  if (*earlier != job) return bad_benchmark(options.output + " holds a benchmark of other options; choose another folder");
  return {};
}

}  // namespace

Result<int> make_benchmark(const Context& context, const BenchmarkMakeOptions& options) {
  const auto levels = read_levels(options.levels);
  if (!levels) return levels.error();
  if (auto status = check_make(options, *levels); !status) return status.error();
  if (auto status = open_set(options, job_text(options, *levels)); !status) return status.error();
  const auto rooms = options.rooms.empty() ? names_of(levels->rooms) : options.rooms;
  std::vector<BaseRoom> bases;
  for (const auto& room : rooms)
    for (int number = 0; number < options.scenes; ++number) {
      auto base = base_room(context, options, *levels, room, number);
      if (!base) return base.error();
      bases.push_back(std::move(*base));
    }
  std::vector<Job> jobs;
  for (const auto& base : bases)
    for (const auto& compositional : options.compositional)
      for (const auto& relational : options.relational)
        for (const auto& observational : options.observational)
          jobs.push_back({&base, {compositional, relational, observational}});
  if (auto status = make_all(context, options, *levels, jobs); !status) return status.error();
  const auto questions = put_together(options, *levels, jobs);
  if (!questions) return questions.error();
  if (context.json)
    std::printf("%s\n", json_line(Json{{"folder", options.output}, {"scenes", jobs.size()}, {"questions", *questions}}).c_str());
  else if (!context.quiet)
    std::fprintf(stderr, "%s%zu questions about %zu scenes in %s\n", shortfall_list(*levels, jobs).c_str(), *questions,
                 jobs.size(), printable(options.output).c_str());
  return exit_ok;
}

}  // namespace roomgen::cli
