#include "roomgen/tour/tour.h"

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "command.h"
#include "models.h"
#include "roomgen/base/file.h"
#include "roomgen/render/pictures.h"

namespace roomgen::cli {

namespace {

struct TourCommand {
  std::string scene, output = "tour";
  std::string picture_size = "160x120";
  double field_of_view = 90.0, steepest_pitch = 75.0, turn_rate = 60.0;  // degrees
  TourOptions tour;
  ModelOptions models;
};

// "160x120"
Status read_size(const std::string& text, TourOptions& options) {
  char rest = 0;
  if (std::sscanf(text.c_str(), "%4dx%4d%c", &options.width, &options.height, &rest) == 2) return {};
  return Error{Error::Kind::invalid_input, "--size " + text + ": write it as WIDTHxHEIGHT, 160x120"};
}

Result<TourOptions> options_of(const TourCommand& command, const Context& context) {
  TourOptions options = command.tour;
  if (auto status = read_size(command.picture_size, options); !status) return status.error();
  options.field_of_view = radians(command.field_of_view);
  options.steepest_pitch = radians(command.steepest_pitch);
  options.turn_rate = radians(command.turn_rate);
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
    std::printf("%s\n", summary.dump().c_str());
  }
  if (context.quiet) return;
  for (const auto& target : tour.unseen)
    std::fprintf(stderr, "not seen: %s: %s\n", target.id.c_str(), target.reason.c_str());
  if (!context.json)
    std::fprintf(stderr, "wrote a tour of %zu views into %s\n", tour.views.size(), path.c_str());
}

Result<int> make(const Context& context, const TourCommand& command) {
  const auto options = options_of(command, context);
  if (!options) return options.error();
  const auto scene = read_scene(command.scene);
  if (!scene) return scene.error();
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
  TourOptions& tour = command.tour;
  app.add_option("--targets", tour.targets, "Ids of the objects to look at, with commas (all)")->delimiter(',');
  app.add_option("--eye-height", tour.eye_height, "Metres above the floor")->capture_default_str();
  app.add_option("--fov", command.field_of_view, "Degrees from side to side")->capture_default_str();
  app.add_option("--size", command.picture_size, "Of the pictures in which visibility is measured")
      ->capture_default_str();
  app.add_option("--min-distance", tour.least_distance, "Metres from a target's footprint")->capture_default_str();
  app.add_option("--max-distance", tour.greatest_distance, "Metres from a target's footprint")
      ->capture_default_str();
  app.add_option("--min-hidden", tour.least_hidden, "Share of a target that others must hide")
      ->capture_default_str();
  app.add_option("--max-hidden", tour.greatest_hidden, "Share of a target that others may hide")
      ->capture_default_str();
  app.add_option("--max-pitch", command.steepest_pitch, "Degrees up or down")->capture_default_str();
  app.add_option("--samples", tour.samples, "Viewpoints that are tried for a target")->capture_default_str();
}

void add_motion_options(CLI::App& app, TourCommand& command) {
  TourOptions& tour = command.tour;
  app.add_option("--radius", tour.agent_radius, "Metres that the camera keeps from things and walls")
      ->capture_default_str();
  app.add_option("--speed", tour.speed, "Metres a second")->capture_default_str();
  app.add_option("--turn-rate", command.turn_rate, "Degrees a second")->capture_default_str();
  app.add_option("--pause", tour.pause, "Seconds before each target")->capture_default_str();
  app.add_option("--keyframes", tour.keyframes_per_second, "At least, a second")->capture_default_str();
  app.add_option("--seed", tour.seed, "Same seed, same tour")->capture_default_str();
}

}  // namespace

void add_tour_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<TourCommand>();
  CLI::App* tour = app.add_subcommand("tour", "Walk a camera through a scene so that it sees every object");
  tour->add_option("scene", command->scene, "scene.json")->required()->check(CLI::ExistingFile);
  tour->add_option("-o,--output", command->output, "Folder for tour.json and path.png")->capture_default_str();
  add_view_options(*tour, *command);
  add_motion_options(*tour, *command);
  add_model_options(*tour, command->models);
  tour->callback([&context, command] { context.run = [&context, command] { return make(context, *command); }; });
}

}  // namespace roomgen::cli
