#include <nlohmann/json.hpp>
#include <numeric>

#include "arguments.h"
#include "options.h"
#include "program_files.h"
#include "roomgen/lab/compose.h"
#include "roomgen/generate/generate.h"
#include "tools.h"

namespace roomgen::mcp {

using namespace lab;

namespace {

namespace fs = std::filesystem;

constexpr int default_steps = 40000, steps_of_progress = 1000;

Result<ConstraintProgram> wanted_program(const Workplace& place, const Json& arguments) {
  if (arguments.contains("program") == arguments.contains("file"))
    return Error{Error::Kind::invalid_input, "optimise: give either program or file"};
  if (arguments.contains("program")) return program_from_json(arguments["program"], "/program");
  const auto file = place.root.find(arguments["file"].get<std::string>());
  if (!file) return with_context(file.error(), "/file");
  return read_program(*file);
}

// What the checker says of a program, for whoever wrote it to mend.
std::vector<std::string> remarks_on(const ConstraintProgram& program) {
  std::vector<std::string> remarks;
  for (const auto& finding : check(program, KindTable::built_in()))
    remarks.push_back("/program" + finding.at + ": " + finding.message);
  return remarks;
}

OptimiseOptions search_options(const ToolCall& call, std::uint64_t seed) {
  OptimiseOptions options;
  options.seed = seed;
  options.steps = call.arguments.value("steps", default_steps);
  options.cancel = call.cancel;
  return options;
}

Json verdicts_json(const std::vector<ConstraintVerdict>& verdicts) {
  Json json = Json::array();
  for (const auto& verdict : verdicts)
    json.push_back({{"name", verdict.name}, {"held", verdict.held}, {"amount", verdict.amount}});
  return json;
}

Json answer_json(const std::string& name, const Optimisation& made) {
  return {{"room", name},
          {"objects", made.scene.objects.size()},
          {"constraints", verdicts_json(made.constraints)},
          {"occupancy", made.occupancy},
          {"incomplete", made.scene.incomplete}};
}

// The room's files are there, and the agent is told of it.
Result<ToolAnswer> answer(Workplace& place, const ToolCall& call, const fs::path& folder, OutputFolder& output,
                          const Optimisation& made, const ModelTable& models, std::vector<std::string> lines,
                          Json data) {
  if (call.cancel.cancelled()) return Error{Error::Kind::cancelled, "stopped; nothing was written"};
  if (auto status = output.commit(); !status) return status.error();
  lines.insert(lines.begin(), place.root.name_of(folder) + ": " + cli::optimisation_headline(made));
  ToolAnswer answer = text_answer(text_of(lines), std::move(data));
  add_wanted_picture(place, made.scene, models, call, answer);
  return answer;
}

Result<ComposeRequest> wanted_composition(const Workplace& place, const ToolCall& call) {
  const auto wish = plan_wish(place, call.arguments);
  if (!wish) return wish.error();
  ComposeRequest request;
  request.plan.prompt = wish->prompt;
  request.plan.seed = wish->seed;
  request.plan.cancel = call.cancel;
  if (!wish->size.empty()) request.plan.size = *cli::parse_size(wish->size);
  for (const auto& [name, range] : complexity_measures()) {
    if (!call.arguments.contains(name)) continue;
    const auto read = range_from(call.arguments[name].get<std::string>(), std::string("/") + name, most_of_measure(name));
    if (!read) return read.error();
    request.complexity.*range = *read;
  }
  return request;
}

}  // namespace

Result<ToolAnswer> optimise_room(Workplace& place, const ToolCall& call) {
  const auto folder = new_room_folder(place, call.arguments);
  if (!folder) return folder.error();
  const auto program = wanted_program(place, call.arguments);
  if (!program) return program.error();
  const KindTable& kinds = KindTable::built_in();
  std::vector<std::string> lines = remarks_on(*program);
  OptimiseOptions options = search_options(call, call.arguments.value("seed", program->seed));
  std::vector<int> steps(static_cast<std::size_t>(options.chains));  // of each chain
  options.on_progress = [&](const OptimiseProgress& progress) {
    steps[static_cast<std::size_t>(progress.chain)] = progress.step;
    if (progress.step % steps_of_progress == 0)
      call.progress(std::accumulate(steps.begin(), steps.end(), 0.0),
                    options.steps * options.chains, std::to_string(progress.things) + " things");
  };
  const auto room = room_of(*program, options.seed, lines);
  if (!room) return room.error();
  auto output = open_room_folder(*folder, false);
  if (!output) return output.error();
  const auto stock = load_stock(wishes_for(kinds_to_stock(*program, kinds, options.seed)), *place.library, kinds);
  if (!stock) return stock.error();
  for (const auto& kind : stock->missing) lines.push_back("the libraries have no " + kind);
  const auto made = optimise(*program, *room, *stock, kinds, options);
  if (!made) return made.error();
  const int pixels = place.keeps_pictures ? kept_pixels : 0;
  if (auto status = cli::write_optimised_room(*output, *program, *made, stock->models, pixels); !status)
    return status.error();
  Json data = answer_json(place.root.name_of(*folder), *made);
  data["notes"] = lines;
  for (const auto& line : cli::unmet_lines(*made)) lines.push_back(line);
  return answer(place, call, *folder, *output, *made, stock->models, std::move(lines), std::move(data));
}

Result<ToolAnswer> compose_room(Workplace& place, const ToolCall& call) {
  const auto folder = new_room_folder(place, call.arguments);
  if (!folder) return folder.error();
  const auto request = wanted_composition(place, call);
  if (!request) return request.error();
  auto output = open_room_folder(*folder, false);
  if (!output) return output.error();
  ComposeOptions options;
  options.rounds = call.arguments.value("rounds", options.rounds);
  options.optimise = search_options(call, request->plan.seed);
  int rounds = 0;
  options.on_round = [&](const ComposeRound& round) {
    call.progress(++rounds, options.rounds, cli::optimisation_headline(round.result));
  };
  const ProgramAuthor author = rule_author();
  const auto made = lab::compose_room(*request, author, *place.library, KindTable::built_in(), options);
  if (!made) return made.error();
  const ComposeRound& chosen = made->chosen();
  const int pixels = place.keeps_pictures ? kept_pixels : 0;
  if (auto status = cli::write_composed_room(*output, *made, author.name, pixels); !status) return status.error();
  Json data = answer_json(place.root.name_of(*folder), chosen.result);
  const Json report = to_json(chosen.report);
  data["met"] = report["met"];
  data["measures"] = report["measures"];
  data["rounds"] = made->rounds.size();
  data["notes"] = chosen.written.notes;
  data["not_understood"] = not_understood(chosen.result.scene);
  std::vector<std::string> lines = chosen.written.notes;
  for (const auto& line : cli::composed_lines(*made)) lines.push_back(line);
  return answer(place, call, *folder, *output, chosen.result, chosen.models, std::move(lines), std::move(data));
}

}  // namespace roomgen::mcp
