#include "roomgen/generate/generate.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <variant>

#include "command.h"
#include "designers.h"
#include "libraries.h"
#include "options.h"
#include "room_files.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/design/designer.h"
#include "roomgen/export/exporter.h"
#include "roomgen/generate/output.h"
#include "roomgen/import/import.h"
#include "roomgen/render/pictures.h"

namespace roomgen::cli {

namespace {

namespace fs = std::filesystem;

struct GenerateCommand {
  std::string prompt, output, plan_file, room_file, size;
  std::uint64_t seed = 0;
  bool force = false, strict = false, marks = false, no_pictures = false;
  int pixels = 1024;
  double alpha = 0.5, rrf_c = 60.0, pitch = 0.10;
  LibraryOptions libraries;
  DesignerOptions designer;
};

// A bar with the object's name, on a terminal only.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet) : shown_(!quiet && ::isatty(STDERR_FILENO)) {}
  ~ProgressBar() { clear(); }

  void show(std::size_t done, std::size_t total, const std::string& what) const {
    if (!shown_) return;
    constexpr std::size_t width = 24;
    const std::size_t filled = total == 0 ? width : width * done / total;
    std::fprintf(stderr, "\r\033[K[%s%s] %zu/%zu %s", std::string(filled, '#').c_str(),
                 std::string(width - filled, '.').c_str(), done, total, what.c_str());
  }
  void clear() const {
    if (shown_) std::fputs("\r\033[K", stderr);
  }

 private:
  bool shown_;
};

std::string label(const BuildEvent& event) {
  switch (event.kind) {
    case BuildEvent::Kind::placed:
      return event.object + " at " + format_number(event.placed->position.x(), 2) + ", " +
             format_number(event.placed->position.y(), 2);
    case BuildEvent::Kind::left_out:
      return event.object + " left out";
    case BuildEvent::Kind::improving:
      return "improving";
    default:
      return event.object;
  }
}

/// What is to be furnished: one room, or the rooms of a dwelling.
using AnyPlan = std::variant<Plan, DwellingPlan>;

Result<AnyPlan> read_any_plan(const std::string& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  const auto json = parse_json(*text, file);
  if (!json) return json.error();
  if (is_dwelling_plan(*json)) {
    auto plan = dwelling_plan_from_json(*json, file);
    if (!plan) return plan.error();
    return AnyPlan(*std::move(plan));
  }
  auto plan = plan_from_json(*json, file);
  if (!plan) return plan.error();
  return AnyPlan(*std::move(plan));
}

Result<AnyPlan> make_plan(const GenerateCommand& command, const Context& context,
                          Designer& designer) {
  if (!command.plan_file.empty()) return read_any_plan(command.plan_file);
  PlanRequest request;
  request.prompt = command.prompt;
  request.seed = command.seed;
  request.cancel = context.cancel;
  if (!command.size.empty()) {
    auto size = parse_size(command.size);
    if (!size) return size.error();
    request.size = *size;
  }
  if (!command.room_file.empty()) {
    auto room = read_floor_plan(command.room_file);
    if (!room) return room.error();
    request.room = *std::move(room);
  }
  auto dwelling = plan_dwelling(request, designer);
  if (!dwelling) return dwelling.error();
  if (*dwelling) return AnyPlan(**std::move(dwelling));
  auto plan = designer.plan(request);
  if (!plan) return plan.error();
  return AnyPlan(*std::move(plan));
}

// The room after each step, as a designer with eyes would have seen it.
Status write_marks(const GenerateCommand& command, const OutputFolder& folder,
                   const Generation& generation, Renderer& renderer) {
  Scene partial = generation.scene;
  partial.objects.clear();
  View view;
  view.pixels = command.pixels;
  view.marks = true;
  view.paper_frame = command.designer.paper_frame();
  for (std::size_t step = 0; step <= generation.scene.objects.size(); ++step) {
    if (step > 0) partial.objects.push_back(generation.scene.objects[step - 1]);
    const auto image = renderer.render(partial, generation.models, view);
    if (!image) return image.error();
    char name[32];
    std::snprintf(name, sizeof name, "marks/step-%02zu.png", step);
    if (auto status = write_png(folder, name, *image); !status) return status;
  }
  return {};
}

// What a model was shown, in order.
Status write_shown(const OutputFolder& folder, const std::vector<std::string>& shown) {
  for (std::size_t i = 0; i < shown.size(); ++i) {
    char name[40];
    const bool jpeg = shown[i].starts_with("\xFF\xD8");
    std::snprintf(name, sizeof name, "marks/shown-%03zu.%s", i, jpeg ? "jpg" : "png");
    if (auto status = folder.write(name, shown[i]); !status) return status;
  }
  return {};
}

Status write_all(const GenerateCommand& command, OutputFolder& folder, const AnyPlan& plan,
                 const Generation& generation, const std::vector<std::string>& shown) {
  const Json json = std::visit([](const auto& each) { return to_json(each); }, plan);
  if (auto status = write_documents(folder, json, generation); !status) return status;
  if (auto status = write_model_files(folder, generation.scene, generation.models); !status) return status;
  if (command.marks)
    if (auto status = write_shown(folder, shown); !status) return status;
  if (command.no_pictures) return folder.commit();
  auto renderer = make_osmesa_renderer();
  if (!renderer) return renderer.error();
  if (auto status = write_pictures(folder, generation.scene, generation.models, **renderer, command.pixels); !status) return status;
  if (command.marks)
    if (auto status = write_marks(command, folder, generation, **renderer); !status) return status;
  return folder.commit();
}

Json suggestions_json(const SuggestionFigures& figures) {
  Json json = {{"located", figures.located},
               {"faced", figures.faced},
               {"facing_kept", figures.facing_kept}};
  for (std::size_t i = 0; i < figures.within.size(); ++i) {
    const std::string metres = format_number(SuggestionFigures::thresholds[i], 2) + "_m";
    json["within_" + metres] = figures.within[i];
    json["placed_within_" + metres] = figures.placed_within[i];
  }
  return json;
}

// What each object took, waiting for a model included; in no file, since files do not depend on the clock.
Json step_times(const Generation& generation) {
  Json json = Json::array();
  for (const auto& step : generation.trace) {
    double waited = 0.0;
    for (const auto& attempt : step.attempts) waited += attempt.answer.consultation.seconds;
    json.push_back({{"object", step.planned.id},
                    {"seconds", rounded(step.seconds)},
                    {"model_seconds", rounded(waited)}});
  }
  return json;
}

// The whole job's: of the plan and of all places.
ModelUse total_use(const Consultation& planning, const Generation& generation) {
  ModelUse use = generation.model_use;
  use.calls += planning.calls;
  use.input_tokens += planning.input_tokens;
  use.output_tokens += planning.output_tokens;
  use.seconds += planning.seconds;
  return use;
}

Json model_json(const ComposedDesigner& composed, const Generation& generation) {
  const Consultation planning = composed.designer->plan_consultation();
  const ModelUse use = total_use(planning, generation);
  Json json = {{"calls", use.calls},
               {"input_tokens", use.input_tokens},
               {"output_tokens", use.output_tokens},
               {"seconds", rounded(use.seconds, 3)},
               {"plan_by_rules", planning.fell_back},
               {"fallbacks", use.fallbacks},
               {"stopped", generation.stopped}};
  if (composed.limited && composed.limited->totals().dollars)
    json["dollars"] = rounded(*composed.limited->totals().dollars);
  return json;
}

void print_model_use(const ComposedDesigner& composed, const Generation& generation) {
  const Consultation planning = composed.designer->plan_consultation();
  const ModelUse use = total_use(planning, generation);
  const SuggestionFigures& figures = generation.suggestions;
  std::printf("  the model: %d calls, %lld + %lld tokens, %.1f s; rules made %s%d of the places\n",
              use.calls, use.input_tokens, use.output_tokens, use.seconds,
              planning.fell_back ? "the plan and " : "", use.fallbacks);
  std::printf("  of %d suggested places %d were followed within 0.5 m (%d when placed), %d within 1 m\n",
              figures.located, figures.within[1], figures.placed_within[1], figures.within[2]);
  if (!generation.stopped.empty()) std::printf("  stopped: %s\n", generation.stopped.c_str());
}

/// What the room does not have, and why.
struct Lack {
  std::string what, reason;
};

// The first of them; the rest are only counted.
void print_lacks(const std::vector<Lack>& lacks, const char* verb, const char* fate) {
  constexpr std::size_t most_lines = 30;
  for (std::size_t i = 0; i < std::min(lacks.size(), most_lines); ++i)
    std::printf("  %s: %s: %s\n", fate, lacks[i].what.c_str(), lacks[i].reason.c_str());
  if (lacks.size() > most_lines)
    std::printf("  and %zu more %s %s (scene.json has them all)\n", lacks.size() - most_lines, verb,
                fate);
}

std::vector<Lack> clauses_that_are(const Scene& scene, Compliance compliance) {
  std::vector<Lack> lacks;
  for (const auto& verdict : scene.requirements)
    if (verdict.compliance == compliance)
      lacks.push_back({verdict.requirement.clause, verdict.reason});
  return lacks;
}

std::vector<std::string> not_understood(const Scene& scene) {
  std::vector<std::string> words;
  for (const auto& heard : scene.heard)
    if (heard.as == Heard::As::not_understood) words.push_back("\"" + heard.text + "\"");
  return words;
}

// What the prompt asked for and the room does not have, and what of it nobody understood.
void print_requirements(const Scene& scene) {
  print_lacks(clauses_that_are(scene, Compliance::not_met), "are", "not met");
  print_lacks(clauses_that_are(scene, Compliance::not_judged), "cannot be", "cannot be judged");
  if (const auto words = not_understood(scene); !words.empty())
    std::printf("  not understood: %s\n", join(words, ", ").c_str());
}

// "6 of 9 things you asked for"
std::string met_of_asked(const Scene& scene) {
  if (scene.requirements.empty()) return "nothing was asked for that can be checked";
  const auto met = std::count_if(scene.requirements.begin(), scene.requirements.end(),
                                 [](const RequirementVerdict& verdict) { return verdict.met(); });
  return std::to_string(met) + " of " + std::to_string(scene.requirements.size()) +
         " things you asked for";
}

void print_left_out(const Scene& scene) {
  std::vector<Lack> left_out;
  for (const auto& missing : scene.unplaced) left_out.push_back({missing.id, missing.reason});
  print_lacks(left_out, "were", "left out");
}

// Of a dwelling those of its rooms too.
std::vector<std::string> notes_of(const AnyPlan& plan) {
  auto notes = std::visit([](const auto& each) { return each.notes; }, plan);
  if (const auto* dwelling = std::get_if<DwellingPlan>(&plan))
    for (const auto& room : dwelling->rooms)
      for (const auto& note : room.notes) notes.push_back(room.room.id + ": " + note);
  return notes;
}

std::string title(const Scene& scene) {
  if (scene.rooms.empty()) return scene.room.type;
  return "dwelling of " + std::to_string(scene.rooms.size()) + " rooms";
}

void print_summary(const Context& context, const fs::path& folder, const AnyPlan& plan,
                   const Generation& generation, const ComposedDesigner& composed, double seconds) {
  const Scene& scene = generation.scene;
  if (context.json) {
    Json json;
    json["output"] = folder.string();
    json["room_type"] = scene.rooms.empty() ? scene.room.type : "dwelling";
    for (const auto& room : scene.rooms) json["rooms"].push_back(room.id);
    json["seed"] = scene.seed;
    json["objects"] = scene.objects.size();
    json["unplaced"] = Json::array();
    for (const auto& missing : scene.unplaced)
      json["unplaced"].push_back({{"id", missing.id}, {"reason", missing.reason}});
    json["requirements"] = Json::array();
    for (const auto& verdict : scene.requirements)
      json["requirements"].push_back(to_json(verdict));
    json["heard"] = to_json(scene.heard);
    json["notes"] = generation.notes;
    json["constraints"] = generation.constraints;
    json["held"] = generation.held;
    json["incomplete"] = scene.incomplete;
    json["suggestions"] = suggestions_json(generation.suggestions);
    if (composed.model) json["model"] = model_json(composed, generation);
    json["steps"] = step_times(generation);
    json["seconds"] = rounded(seconds, 3);
    std::fputs(dump_json(json).c_str(), stdout);
    return;
  }
  for (const auto& note : notes_of(plan)) std::printf("note: %s\n", note.c_str());
  for (const auto& note : generation.notes) std::printf("note: %s\n", note.c_str());
  std::printf("%s: %s; a %s with %zu objects (%.1f s)\n", folder.string().c_str(),
              met_of_asked(scene).c_str(), title(scene).c_str(), scene.objects.size(), seconds);
  if (composed.model) print_model_use(composed, generation);
  print_requirements(scene);
  print_left_out(scene);
}

// Everything has its place, and nothing that was asked for is missing, doubtful or not understood.
bool is_as_asked(const Scene& scene) {
  return scene.unplaced.empty() && not_understood(scene).empty() &&
         std::all_of(scene.requirements.begin(), scene.requirements.end(),
                     [](const RequirementVerdict& verdict) {
                       return verdict.met() || verdict.compliance == Compliance::withdrawn;
                     });
}

// What a model looks at; none for designers without eyes.
Result<std::unique_ptr<Renderer>> renderer_for(const GenerateCommand& command,
                                               const ComposedDesigner& composed) {
  if (!composed.model || command.designer.model_mode() == ModelMode::constraints)
    return std::unique_ptr<Renderer>();
  return make_osmesa_renderer();
}

Result<int> run(const Context& context, const GenerateCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  const fs::path folder =
      command.output.empty()
          ? fs::path("out") /
                folder_name(command.plan_file.empty() ? command.prompt : command.plan_file)
          : fs::path(command.output);
  const fs::path cache = command.libraries.cache.empty() ? assets::default_cache_dir()
                                                         : fs::path(command.libraries.cache);
  auto composed = compose_designer(command.designer, context, cache.string());
  if (!composed) return composed.error();
  Designer& designer = *composed->designer;
  const ProgressBar bar(context.quiet);
  if (composed->model) bar.show(0, 1, "asking for a plan");
  auto plan = make_plan(command, context, designer);
  bar.clear();
  if (!plan) return plan.error();
  auto output = open_room_folder(folder, command.force);
  if (!output) return output.error();
  auto library = open_all_libraries(command.libraries, context);
  if (!library) return library.error();

  BuildOptions options;
  options.seed = std::visit([](const auto& each) { return each.seed; }, *plan);
  options.cancel = context.cancel;
  options.place.fusion.alpha = command.alpha;
  options.place.fusion.c = command.rrf_c;
  apply(command.designer, options);
  options.place.pitch = command.pitch;
  auto renderer = renderer_for(command, *composed);
  if (!renderer) return renderer.error();
  options.renderer = renderer->get();
  options.marks_view.pixels = command.pixels;
  options.marks_view.paper_frame = command.designer.paper_frame();
  options.on_event = [&](const BuildEvent& event) { bar.show(event.done, event.total, label(event)); };
  auto generation = std::visit(
      [&](const auto& each) {
        return generate(each, designer, **library, KindTable::built_in(), options);
      },
      *plan);
  if (!generation) return generation.error();
  if (context.cancel.cancelled() && holds_whole_scene(folder / "scene.json"))
    return older_stays(folder);
  bar.show(1, 1, "writing files");
  if (auto status = write_all(command, *output, *plan, *generation, *composed->shown); !status) return status.error();
  bar.clear();

  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  print_summary(context, folder, *plan, *generation, *composed, elapsed.count());
  if (context.cancel.cancelled()) return exit_interrupted;
  return command.strict && !is_as_asked(generation->scene) ? exit_failure : exit_ok;
}

}  // namespace

void add_generate_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<GenerateCommand>();
  auto* sub =
      app.add_subcommand("generate", "Furnish a room, or a dwelling of several, from a sentence and write all its files");
  auto* prompt = sub->add_option("prompt", command->prompt, "What the room or dwelling shall be");
  sub->add_option("-o,--output", command->output,
                  "Folder to write (default: out/ and the first words of the prompt)");
  sub->add_option("--seed", command->seed, "Another seed, another room")
      ->check(CLI::Range(std::uint64_t{0}, max_seed))
      ->capture_default_str();
  sub->add_option("--size", command->size, "Inner width x depth in metres, as in 4x5");
  sub->add_option("--room", command->room_file, "Floor plan to use: room.json, SVG or DXF (docs/floor-plans.md)");
  sub->add_option("--plan", command->plan_file, "Inventory to use (docs/plan.schema.json)")
      ->excludes(prompt);
  sub->add_flag("--force", command->force, "Write into a folder that holds other files");
  sub->add_flag("--strict", command->strict, "Exit with 1 if something found no place, is not as asked, or was not understood");
  sub->add_flag("--marks", command->marks,
                "Also draw the room with coordinate marks after each step");
  sub->add_flag("--no-pictures", command->no_pictures, "Leave out the pictures");
  sub->add_option("--pixels", command->pixels, "Length of the pictures' longer side")
      ->capture_default_str();
  sub->add_option("--alpha", command->alpha,
                  "Weight of constraints against suggested locations, 0 to 1")
      ->capture_default_str();
  sub->add_option("--rrf-c", command->rrf_c, "The fusion's constant")->capture_default_str();
  sub->add_option("--pitch", command->pitch, "Grid pitch in metres")->capture_default_str();
  add_designer_options(*sub, command->designer);
  add_finish_options(*sub, command->designer);
  add_library_options(*sub, command->libraries);
  sub->callback([command, &context] {
    if (command->prompt.empty() && command->plan_file.empty())
      throw CLI::ValidationError("prompt", "say what the room shall be, or give --plan");
    apply_preset(command->designer);
    context.run = [command, &context] { return run(context, *command); };
  });
}

}  // namespace roomgen::cli
