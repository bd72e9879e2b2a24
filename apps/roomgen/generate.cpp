#include "roomgen/generate/generate.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <variant>

#include "add_commands.h"
#include "any_plan.h"
#include "designers.h"
#include "libraries.h"
#include "model_bill.h"
#include "options.h"
#include "print.h"
#include "review_room.h"
#include "room_files.h"
#include "roomgen/base/text.h"
#include "roomgen/export/exporter.h"
#include "roomgen/render/pictures.h"
#include "summary.h"
#include "wish_pictures.h"

namespace roomgen::cli {

namespace {

namespace fs = std::filesystem;

struct GenerateCommand {
  PlanWish wish;
  std::string output, plan_file;
  std::vector<std::string> images;
  bool force = false, strict = false, marks = false, no_pictures = false;
  int pixels = 1024;
  double alpha = 0.5, rrf_c = 60.0, pitch = 0.10;
  int reviews = 2;
  double seconds = 0.0;  // 0: usual_seconds()
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
                 std::string(width - filled, '.').c_str(), done, total, printable(what).c_str());
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
    case BuildEvent::Kind::choosing:
    case BuildEvent::Kind::making:
      return event.text;
    default:
      return event.object;
  }
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
  PictureDrawer drawer;
  PictureDrawer* drawn_by = command.no_pictures ? nullptr : &drawer;
  if (auto status =
          write_new_room(folder, plan_json(plan, generation), generation, drawn_by, command.pixels);
      !status)
    return status;
  if (command.marks)
    if (auto status = write_shown(folder, shown); !status) return status;
  if (command.marks && drawn_by) {
    const auto renderer = drawer.renderer();
    if (!renderer) return renderer.error();
    if (auto status = write_marks(command, folder, generation, **renderer); !status) return status;
  }
  return folder.commit();
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

void print_summary(const Context& context, const fs::path& folder, const AnyPlan& plan,
                   const Generation& generation, const ComposedDesigner& composed, double seconds) {
  if (context.json) {
    Json json = summary_json(folder, generation);
    if (composed.model) json["model"] = bill_json(composed, generation);
    json["steps"] = step_times(generation);
    json["seconds"] = rounded(seconds, 3);
    std::fputs(dump_json(json).c_str(), stdout);
    return;
  }
  print_lines(note_lines(plan, generation));
  std::printf("%s: %s (%.1f s)\n", printable(folder.string()).c_str(), printable(headline(generation.scene)).c_str(), seconds);
  if (composed.model) print_lines(bill_lines(composed, generation));
  print_lines(lack_lines(generation.scene));
}

// What a model looks at; none for designers without eyes.
Result<std::unique_ptr<Renderer>> renderer_for(const GenerateCommand& command,
                                               const ComposedDesigner& composed) {
  if (!composed.model || command.designer.model_mode() == ModelMode::constraints)
    return std::unique_ptr<Renderer>();
  return make_osmesa_renderer();
}

// How long a whole run may take (docs/limits.md): far above what rooms take, so that only one that would
// not end is cut.
constexpr double seconds_a_room = 60.0;
constexpr double seconds_a_room_with_model = 900.0;

double usual_seconds(const AnyPlan& plan, bool model) {
  const auto* dwelling = std::get_if<DwellingPlan>(&plan);
  const auto rooms = static_cast<double>(dwelling ? std::max<std::size_t>(dwelling->rooms.size(), 1) : 1);
  return rooms * (model ? seconds_a_room_with_model : seconds_a_room);
}

// Rules plan what a sentence wishes for: they can plan larger rooms of it too.
bool is_rules_wish(const GenerateCommand& command, const ComposedDesigner& composed) {
  return command.plan_file.empty() && !composed.model;
}

// Of a wish that could not be planned.
Error with_least(const Context& context, const GenerateCommand& command,
                 const ComposedDesigner& composed, const Error& error) {
  if (error.kind != Error::Kind::too_small || !is_rules_wish(command, composed)) return error;
  const auto library = open_all_libraries(command.libraries, context);
  BuildOptions options;
  options.seed = command.wish.seed;
  options.cancel = context.cancel;
  return library ? told_with_least_size(error, command.wish, nullptr, **library, options) : error;
}

// A model that designs whole rooms looks at them in the end, unless it may ask no more.
int rounds_of_review(const GenerateCommand& command, const ComposedDesigner& composed) {
  const bool looks = composed.model && command.designer.steps == "groups" &&
                     command.designer.model_mode() == ModelMode::fused && !command.designer.paper_frame();
  const bool is_spent = composed.limited && composed.limited->refused();
  return looks && !is_spent ? command.reviews : 0;
}

std::vector<std::string> with_reviews(std::vector<std::string> notes, const std::vector<ReviewRound>& rounds) {
  for (const auto& round : rounds) {
    if (!round.judgement.empty()) notes.push_back("the model's judgement: " + round.judgement);
    for (const auto& change : round.changes) notes.push_back("changed by the model: " + change);
    for (const auto& refused : round.refused) notes.push_back("the model's change could not be made: " + refused);
  }
  return notes;
}

fs::path usual_folder(const GenerateCommand& command) {
  std::string name = command.plan_file.empty() ? command.wish.prompt : command.plan_file;
  if (name.empty()) name = fs::path(command.images.front()).stem().string();
  return fs::path("out") / folder_name(name);
}

Result<int> run(const Context& context, const GenerateCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  const fs::path folder = command.output.empty() ? usual_folder(command) : fs::path(command.output);
  auto composed = compose_designer(command.designer, context, cache_folder(command.libraries).string());
  if (!composed) return composed.error();
  Designer& designer = *composed->designer;
  const ProgressBar bar(context.quiet);
  if (composed->model) bar.show(0, 1, "asking for a plan");
  auto plan = command.plan_file.empty()
                  ? make_plan(command.wish, designer, context.cancel, composed->reader.get())
                  : read_any_plan(command.plan_file);
  bar.clear();
  if (!plan) return with_bill(with_least(context, command, *composed, plan.error()), *composed);
  auto output = open_room_folder(folder, command.force);
  if (!output) return output.error();
  auto library = open_all_libraries(command.libraries, context);
  if (!library) return library.error();

  BuildOptions options;
  options.seed = std::visit([](const auto& each) { return each.seed; }, *plan);
  const double seconds = command.seconds > 0.0 ? command.seconds : usual_seconds(*plan, composed->model != nullptr);
  options.cancel = context.cancel.within(std::chrono::duration<double>(seconds));
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
  const bool is_wish = is_rules_wish(command, *composed);
  options.tells_least = !is_wish || !std::holds_alternative<Plan>(*plan);
  auto generation = std::visit(
      [&](const auto& each) {
        return generate(each, designer, **library, KindTable::built_in(), options);
      },
      *plan);
  if (!generation && is_wish)
    generation = told_with_least_size(generation.error(), command.wish, &*plan, **library, options);
  if (!generation) return with_bill(generation.error(), *composed);
  if (context.cancel.cancelled() && holds_whole_scene(folder / "scene.json"))
    return older_stays(folder);
  bar.show(1, 1, "writing files");
  if (auto status = write_all(command, *output, *plan, *generation, *composed->shown); !status) return status.error();
  bar.clear();

  if (const int rounds = rounds_of_review(command, *composed); rounds > 0) {
    bar.show(1, 1, "looking at the room");
    auto reviewed = review_room({folder, command.designer, *composed, **library, rounds, !command.no_pictures,
                                 command.pixels, options.cancel}, generation->scene);
    bar.clear();
    if (reviewed) generation->notes = with_reviews(std::move(generation->notes), *reviewed);
    else generation->notes.push_back("the model did not look at the room: " + reviewed.error().message);
  }

  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  print_summary(context, folder, *plan, *generation, *composed, elapsed.count());
  if (context.cancel.cancelled()) return exit_interrupted;
  if (options.cancel.cancelled() && generation->scene.incomplete)
    std::fprintf(stderr, "roomgen: cut after %s s: this is the room so far; --seconds gives it more time\n",
                 format_number(seconds, 1).c_str());
  return command.strict && !is_as_asked(generation->scene) ? exit_failure : exit_ok;
}

}  // namespace

void add_generate_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<GenerateCommand>();
  auto* sub =
      app.add_subcommand("generate", "Furnish a room, or a dwelling of several, from a sentence and write all its files");
  auto* prompt = sub->add_option("prompt", command->wish.prompt, "What the room or dwelling shall be");
  sub->add_option("-o,--output", command->output,
                  "Folder to write (default: out/ and the first words of the prompt)");
  sub->add_option("--seed", command->wish.seed, "Another seed, another room")
      ->check(CLI::Range(std::uint64_t{0}, max_seed))
      ->capture_default_str();
  auto* size =
      sub->add_option("--size", command->wish.size, "Inner width x depth in metres, as in 4x5");
  auto* room = sub->add_option("--room", command->wish.floor_plan,
                               "Floor plan to use: room.json, SVG or DXF (docs/floor-plans.md)");
  auto* images = add_image_option(*sub, command->images);
  sub->add_option("--plan", command->plan_file, "Inventory to use (docs/plan.schema.json)")
      ->excludes(prompt)
      ->excludes(images)
      ->excludes(size)
      ->excludes(room);
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
  sub->add_option("--reviews", command->reviews,
                  "How often at most the model looks at the finished room and changes it")
      ->check(CLI::Range(0, 10))
      ->capture_default_str();
  sub->add_option("--seconds", command->seconds,
                  "Most time once there is a plan, after which the room so far is written (default: 60 a room, 900 with a model)")
      ->check(CLI::PositiveNumber);
  add_designer_options(*sub, command->designer);
  add_reader_option(*sub, command->designer);
  add_finish_options(*sub, command->designer);
  add_library_options(*sub, command->libraries);
  sub->callback([command, sub, &context] {
    if (command->wish.prompt.empty() && command->plan_file.empty() && command->images.empty())
      throw CLI::ValidationError("prompt", "say what the room shall be, or give --plan");
    let_model_design(*sub, command->designer);
    if (!command->images.empty() && !command->designer.reads_by_model())
      throw CLI::ValidationError("--image",
                                 "a language model reads pictures: name one with --model "
                                 "(docs/models.md), or say in words what they show");
    apply_preset(command->designer);
    context.run = [command, &context]() -> Result<int> {
      auto pictures = read_wish_pictures(command->images, command->designer);
      if (!pictures) return pictures.error();
      command->wish.pictures = *std::move(pictures);
      return run(context, *command);
    };
  });
}

}  // namespace roomgen::cli
