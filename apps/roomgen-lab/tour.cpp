#include "roomgen/lab/draw_frames.h"
#include "roomgen/lab/tour.h"

#include <cstdio>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <utility>

#include "add_commands.h"
#include "models.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/render/pictures.h"
#include "tool_commands.h"
#include "tours.h"

namespace roomgen::cli {

using namespace lab;

namespace {

struct TourCommand {
  std::string scene, output = "tour";
  std::optional<std::string> words;
  bool birds_eye = false;
  std::string picture_size = "160x120";
  ModelOptions models;

  using Setter = std::function<void(TourOptions&)>;
  /// Of options that were given.
  std::vector<Setter> given() const {
    std::vector<Setter> setters;
    for (const auto& [option, set] : options)
      if (option->count() > 0) setters.push_back(set);
    return setters;
  }
  std::vector<std::pair<const CLI::Option*, Setter>> options;
};

// An option of one value that words may set as well; `unit` is that of the field in the file's unit.
template <typename T>
void add_tour_option(CLI::App& app, TourCommand& command, const std::string& name, T TourOptions::* field,
                     const std::string& text, double unit = 1.0) {
  const auto value = std::make_shared<T>(TourOptions().*field);
  if constexpr (std::is_floating_point_v<T>) *value /= unit;
  CLI::Option* option = app.add_option(name, *value, text);
  if constexpr (std::is_arithmetic_v<T>)
    option->capture_default_str();
  else
    option->delimiter(',');
  command.options.emplace_back(option, [value, field, unit](TourOptions& tour) {
    tour.*field = *value;
    if constexpr (std::is_floating_point_v<T>) tour.*field *= unit;
  });
}

// What the words say, and over it what was given by options.
Result<TourOptions> options_of(const TourCommand& command, const Scene& scene, const Context& context) {
  const auto words = read_tour_words(command.words.value_or(scene.prompt), scene, KindTable::built_in());
  if (!context.quiet) {
    for (const auto& wish : words.understood) std::fprintf(stderr, "understood: %s\n", printable(wish).c_str());
    for (const auto& wish : words.not_understood) std::fprintf(stderr, "not understood: %s\n", printable(wish).c_str());
  }
  TourOptions options = words.options;
  if (command.birds_eye) options = birds_eye(scene, options);
  for (const auto& set : command.given()) set(options);
  if (auto status = read_picture_size(command.picture_size, options.width, options.height); !status)
    return status.error();
  options.cancel = context.cancel;
  return options;
}

Status write_tour(const std::string& path, const Tour& tour, const Image& picture) {
  auto folder = OutputFolder::open(path);
  if (!folder) return folder.error();
  if (auto status = folder->write("tour.json", dump_json(to_json(tour))); !status) return status;
  if (auto status = write_png(*folder, "path.png", picture); !status) return status;
  return folder->commit();
}

void report(const Context& context, const std::string& path, const Tour& tour) {
  if (context.json) {
    const Json summary = {{"folder", path},
                          {"views", tour.views.size()},
                          {"unseen", tour.unseen.size()},
                          {"seconds", tour.keyframes.empty() ? 0.0 : rounded(tour.keyframes.back().time)}};
    std::printf("%s\n", json_line(summary).c_str());
  }
  if (context.quiet) return;
  for (const auto& target : tour.unseen)
    std::fprintf(stderr, "not seen: %s: %s\n", printable(target.id).c_str(), printable(target.reason).c_str());
  if (!context.json)
    std::fprintf(stderr, "wrote a tour of %zu views into %s\n", tour.views.size(), printable(path).c_str());
}

Result<int> make(const Context& context, const TourCommand& command) {
  const auto scene = read_scene(command.scene);
  if (!scene) return scene.error();
  const auto options = options_of(command, *scene, context);
  if (!options) return options.error();
  const auto models = models_of(*scene, command.scene, command.models, context);
  if (!models) return models.error();
  const auto renderer = make_osmesa_renderer();
  if (!renderer) return renderer.error();
  const auto tour = make_tour(*scene, *models, KindTable::built_in(), **renderer, *options);
  if (!tour) return tour.error();
  const auto picture = tour_picture(**renderer, *scene, *models, *tour);
  if (!picture) return picture.error();
  if (auto status = write_tour(command.output, *tour, *picture); !status) return status.error();
  report(context, command.output, *tour);
  return exit_ok;
}

void add_view_options(CLI::App& app, TourCommand& command) {
  using O = TourOptions;
  const double degree = radians(1.0);
  app.add_option("--words", command.words, "How to film it, instead of the scene's prompt: \"look at the shelf last\"");
  app.add_flag("--birds-eye", command.birds_eye, "Fly over the furniture, 2 m above the floor");
  add_tour_option(app, command, "--targets", &O::targets, "Ids of the objects to look at, with commas (all)");
  add_tour_option(app, command, "--first", &O::first, "Ids of those to look at before all others, in order");
  add_tour_option(app, command, "--last", &O::last, "Ids of those to look at after all others, in order");
  add_tour_option(app, command, "--eye-height", &O::eye_height, "Metres above the floor");
  add_tour_option(app, command, "--fov", &O::field_of_view, "Degrees from side to side", degree);
  app.add_option("--size", command.picture_size, "Of the pictures in which visibility is measured")
      ->capture_default_str();
  add_tour_option(app, command, "--min-distance", &O::least_distance, "Metres from a target's footprint");
  add_tour_option(app, command, "--max-distance", &O::greatest_distance, "Metres from a target's footprint");
  add_tour_option(app, command, "--min-hidden", &O::least_hidden, "Share of a target that others must hide");
  add_tour_option(app, command, "--max-hidden", &O::greatest_hidden, "Share of a target that others may hide");
  add_tour_option(app, command, "--max-pitch", &O::steepest_pitch, "Degrees up or down", degree);
  add_tour_option(app, command, "--samples", &O::samples, "Viewpoints that are tried for a target");
}

void add_motion_options(CLI::App& app, TourCommand& command) {
  using O = TourOptions;
  add_tour_option(app, command, "--radius", &O::agent_radius, "Metres that the camera keeps from things and walls");
  add_tour_option(app, command, "--speed", &O::speed, "Metres a second");
  add_tour_option(app, command, "--turn-rate", &O::turn_rate, "Degrees a second", radians(1.0));
  add_tour_option(app, command, "--pause", &O::pause, "Seconds at each target");
  add_tour_option(app, command, "--keyframes", &O::keyframes_per_second, "At least, a second");
  add_tour_option(app, command, "--seed", &O::seed, "Same seed, same tour");
}

}  // namespace

void add_tour_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<TourCommand>();
  CLI::App* tour = add_tool_command(app, "tour");
  tour->add_option("scene", command->scene, "scene.json")->required()->check(CLI::ExistingFile);
  tour->add_option("-o,--output", command->output, "Folder for tour.json and path.png")->capture_default_str();
  add_view_options(*tour, *command);
  add_motion_options(*tour, *command);
  add_model_options(*tour, command->models);
  tour->callback([&context, command] { context.run = [&context, command] { return make(context, *command); }; });
}

}  // namespace roomgen::cli
