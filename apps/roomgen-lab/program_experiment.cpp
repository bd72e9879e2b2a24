#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "authors.h"
#include "descriptions.h"
#include "experiments.h"
#include "resumable_lines.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/lab/compose.h"
#include "roomgen/render/pictures.h"

namespace roomgen::cli {

using namespace lab;

namespace {

namespace fs = std::filesystem;

constexpr std::array<int, 3> looked_at = {1, 3, 5};  // rounds, as in the source
constexpr int most_rounds = looked_at.back();

/// What a room was worth after so many rounds, rounded as it is kept.
struct Figures {
  double fidelity = 0.0, held = 0.0, seconds = 0.0;
};

/// One description, with or without moves of clusters.
struct Run {
  std::string id;
  bool clusters = true;
  std::vector<Figures> after;  ///< each of `looked_at`
};

Json to_json(const Run& run) {
  Json json = {{"id", run.id}, {"clusters", run.clusters}, {"after", Json::array()}};
  for (const auto& figures : run.after)
    json["after"].push_back({figures.fidelity, figures.held, figures.seconds});
  return json;
}

bool are_figures(const Json& json) {
  return json.is_array() && json.size() == 3 &&
         std::ranges::all_of(json, [](const Json& one) { return one.is_number(); });
}

Result<Run> run_from(const ResumableLines::Line& line) {
  const Json& json = line.json;
  const Json after = json.is_object() ? json.value("after", Json()) : Json();
  const bool is_run = after.is_array() && after.size() == looked_at.size() && std::ranges::all_of(after, are_figures) &&
                      json.value("id", Json()).is_string() && json.value("clusters", Json()).is_boolean();
  if (!is_run) return Error{Error::Kind::invalid_input, line.where + ": is no result of this experiment"};
  Run run{json["id"].get<std::string>(), json["clusters"].get<bool>(), {}};
  for (const auto& one : after) run.after.push_back({one[0].get<double>(), one[1].get<double>(), one[2].get<double>()});
  return run;
}

double held_share(const Optimisation& result) {
  if (result.constraints.empty()) return 1.0;
  return static_cast<double>(std::ranges::count_if(result.constraints, &ConstraintVerdict::held)) /
         static_cast<double>(result.constraints.size());
}

class ProgramExperiment {
 public:
  ProgramExperiment(const Context& context, std::uint64_t seed, const AssetLibrary& library, Authors& authors)
      : context_(context), seed_(seed), library_(library), authors_(authors) {}

  Result<Run> run(const Description& description, bool clusters) {
    const KindTable& kinds = KindTable::built_in();
    const auto start = std::chrono::steady_clock::now();
    std::vector<double> seconds;
    ComposeOptions how;
    how.rounds = most_rounds;
    how.optimise.seed = seed_;
    how.optimise.cluster_moves = clusters;
    how.optimise.cancel = context_.cancel;
    how.on_round = [&](const ComposeRound&) {
      seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    };
    authors_.show(how);
    ComposeRequest request;
    request.plan.prompt = description.text;
    request.plan.seed = seed_;
    request.plan.cancel = context_.cancel;
    const auto made = compose_room(request, authors_.author(), library_, kinds, how);
    if (context_.cancel.cancelled()) return Error{Error::Kind::cancelled, "interrupted"};
    Run result{description.id, clusters, {}};
    for (std::size_t i = 0; i < looked_at.size(); ++i) {
      // What cannot be made meets nothing.
      if (!made) {
        result.after.push_back({0.0, 0.0, 0.0});
        continue;
      }
      const std::size_t played = std::min(made->rounds.size(), static_cast<std::size_t>(looked_at[i]));
      const ComposeRound& round = made->rounds[best_of({made->rounds.data(), played})];
      // As they are kept, so that a report from the file says the same.
      result.after.push_back(
          {rounded(fidelity(description, round.result.scene, round.result.occupancy, kinds).value_or(1.0)),
           rounded(held_share(round.result)), rounded(seconds[played - 1], 2)});
    }
    return result;
  }

 private:
  const Context& context_;
  std::uint64_t seed_;
  const AssetLibrary& library_;
  Authors& authors_;
};

Figures mean_of(const std::vector<Run>& runs, bool clusters, std::size_t after) {
  Figures mean;
  int count = 0;
  for (const auto& run : runs) {
    if (run.clusters != clusters) continue;
    ++count;
    mean.fidelity += run.after[after].fidelity, mean.held += run.after[after].held,
        mean.seconds += run.after[after].seconds;
  }
  if (count > 0) mean.fidelity /= count, mean.held /= count, mean.seconds /= count;
  return mean;
}

std::string report_of(const std::vector<Run>& runs) {
  std::string text = "| variant | rounds | fidelity | constraints held | seconds |\n|---|---|---|---|---|\n";
  for (const bool clusters : {false, true})
    for (std::size_t i = 0; i < looked_at.size(); ++i) {
      const Figures mean = mean_of(runs, clusters, i);
      const bool is_refined = looked_at[i] > 1;
      const std::string name =
          clusters ? (is_refined ? "both" : "cluster moves") : (is_refined ? "refinement" : "base");
      text += "| " + name + " | " + std::to_string(looked_at[i]) + " | " + format_number(mean.fidelity, 3) + " | " +
              format_number(mean.held, 3) + " | " + format_number(mean.seconds, 1) + " |\n";
    }
  return text;
}

// Fidelity over rounds, a line for each variant.
std::string plot_of(const std::vector<Run>& runs) {
  constexpr double left = 60, top = 20, width = 360, height = 220, least = 0.5;
  const auto x = [&](int rounds) { return left + width * (rounds - 1) / (most_rounds - 1); };
  const auto y = [&](double value) { return top + height * (1.0 - (std::max(value, least) - least) / (1.0 - least)); };
  const auto at = [](double value) { return format_number(value, 1); };
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"560\" height=\"290\" font-family=\"sans-serif\" "
      "font-size=\"12\">\n"
      "<rect width=\"560\" height=\"290\" fill=\"white\"/>\n";
  for (double value = least; value <= 1.001; value += 0.1)
    svg += "<line x1=\"" + at(left) + "\" x2=\"" + at(left + width) + "\" y1=\"" + at(y(value)) + "\" y2=\"" +
           at(y(value)) + "\" stroke=\"#ddd\"/><text x=\"" + at(left - 30) + "\" y=\"" + at(y(value) + 4) + "\">" +
           format_number(value, 1) + "</text>\n";
  for (const int rounds : looked_at)
    svg += "<text x=\"" + at(x(rounds) - 3) + "\" y=\"" + at(top + height + 18) + "\">" + std::to_string(rounds) +
           "</text>\n";
  svg += "<text x=\"" + at(left + width / 2 - 20) + "\" y=\"" + at(top + height + 38) + "\">rounds</text>\n"
         "<text x=\"8\" y=\"14\">fidelity</text>\n";
  for (const bool clusters : {false, true}) {
    std::string points;
    for (std::size_t i = 0; i < looked_at.size(); ++i)
      points += at(x(looked_at[i])) + "," + at(y(mean_of(runs, clusters, i).fidelity)) + " ";
    const std::string color = clusters ? "#c0392b" : "#2c6fbb";
    svg += "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" + color + "\" points=\"" + points + "\"/>\n";
    svg += "<text x=\"" + at(left + width + 10) + "\" y=\"" +
           at(y(mean_of(runs, clusters, 2).fidelity) + (clusters ? -4 : 12)) + "\" fill=\"" + color + "\">" +
           (clusters ? "with clusters" : "without") + "</text>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace

Result<int> run_program_experiment(const Context& context, const ProgramExperimentOptions& options) {
  const auto descriptions = read_descriptions(options.descriptions);
  if (!descriptions) return descriptions.error();
  const fs::path folder = options.output;
  const Json head = {{"format", "roomgen-program-experiment"}, {"version", 1},
                     {"seed", options.seed}, {"descriptions", descriptions->size()},
                     {"author", options.designer.designer}};
  auto lines = ResumableLines::open(folder, head, options.force);
  if (!lines) return lines.error();
  std::vector<Run> runs;
  for (const auto& line : lines->earlier()) {
    auto run = run_from(line);
    if (!run) return run.error();
    runs.push_back(*std::move(run));
  }
  auto model = compose_model(options.designer, context, options.cache);
  if (!model) return model.error();
  LibraryOptions libraries;
  libraries.cache = options.cache;
  auto library = open_all_libraries(libraries, context);
  if (!library) return library.error();
  Authors authors(*model, options.designer, **library);
  ProgramExperiment experiment(context, options.seed, **library, authors);
  const std::size_t total = 2 * descriptions->size();
  for (const auto& description : *descriptions)
    for (const bool clusters : {false, true}) {
      const auto same = [&](const Run& run) { return run.id == description.id && run.clusters == clusters; };
      if (std::ranges::any_of(runs, same)) continue;
      auto run = experiment.run(description, clusters);
      if (!run)
        return Error{run.error().kind, run.error().message + "; " + std::to_string(runs.size()) + " of " +
                                           std::to_string(total) + " are done, the same command goes on from there"};
      if (auto status = lines->add(to_json(*run)); !status) return status.error();
      runs.push_back(*std::move(run));
      if (!context.quiet) std::fprintf(stderr, "[%zu/%zu] %s\n", runs.size(), total, printable(description.id).c_str());
    }
  const std::string report = report_of(runs);
  if (auto status = write_file(folder / "report.md", report); !status) return status.error();
  if (auto status = write_file(folder / "fidelity.svg", plot_of(runs)); !status) return status.error();
  std::fputs(printable(report).c_str(), stdout);
  return exit_ok;
}

}  // namespace roomgen::cli
