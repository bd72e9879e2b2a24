#include "roomgen/lab/draw_frames.h"

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "add_commands.h"
#include "models.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "tool_commands.h"
#include "tours.h"

namespace roomgen::cli {

using namespace lab;

namespace {

struct FramesCommand {
  std::string scene, tour = "tour", size = "640x480";
  FrameOptions frames;
  ModelOptions models;
};

void report(const Context& context, const std::string& folder, const FrameFigures& figures) {
  if (context.json) {
    const Json summary = {{"folder", folder},
                          {"frames", figures.frames},
                          {"drawn", figures.drawn},
                          {"video", figures.video.empty() ? Json() : Json(figures.video)}};
    std::printf("%s\n", json_line(summary).c_str());
  }
  if (context.quiet) return;
  if (figures.video.empty() && !figures.no_video.empty())
    std::fprintf(stderr, "no video: %s\n", printable(figures.no_video).c_str());
  if (!context.json)
    std::fprintf(stderr, "%zu frames in %s, %zu of them drawn now\n", figures.frames, printable(folder).c_str(), figures.drawn);
}

// Tours that were written by hand may lead through walls.
void warn_of_walls(const Context& context, const Scene& scene, const Tour& tour) {
  std::size_t count = 0, first = 0;
  for (std::size_t k = tour.keyframes.size(); k-- > 0;)
    if (!is_indoors(scene, tour.keyframes[k].pose.eye.head<2>())) ++count, first = k;
  if (count > 0 && !context.quiet)
    std::fprintf(stderr, "in a wall or outdoors: the camera at %zu of %zu keyframes, first at /keyframes/%zu of tour.json\n",
                 count, tour.keyframes.size(), first);
}

Result<int> draw(const Context& context, const FramesCommand& command) {
  FrameOptions options = command.frames;
  if (auto status = read_picture_size(command.size, options.width, options.height); !status) return status.error();
  options.cancel = context.cancel;
  const auto scene = read_scene(command.scene);
  if (!scene) return scene.error();
  const auto tour = read_tour(command.tour, *scene);
  if (!tour) return tour.error();
  warn_of_walls(context, *scene, *tour);
  const auto models = models_of(*scene, command.scene, command.models, context);
  if (!models) return models.error();
  const auto figures = draw_frames(*scene, *models, *tour, options, command.tour);
  if (!figures) return figures.error();
  report(context, command.tour, *figures);
  return exit_ok;
}

}  // namespace

void add_frames_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<FramesCommand>();
  FrameOptions& options = command->frames;
  options.threads = std::max(1, static_cast<int>(std::min(16u, std::thread::hardware_concurrency())));
  CLI::App* frames = add_tool_command(app, "frames");
  frames->add_option("scene", command->scene, "scene.json")->required()->check(CLI::ExistingFile);
  frames->add_option("--tour", command->tour, "Folder of tour.json, where the frames go too")->capture_default_str();
  frames->add_option("--size", command->size, "Of the pictures")->capture_default_str();
  frames->add_option("--fps", options.per_second, "Frames a second of the tour's time")->capture_default_str();
  frames->add_option("--layers", options.layers, "Of rgb, depth, instance, category, normal, with commas (all)")
      ->delimiter(',');
  frames->add_option("--quality", options.quality, "Of the JPEG pictures, 1 to 100")->capture_default_str();
  frames
      ->add_option("--threads", options.threads,
                   "Frames at work at once: one is drawn, others become files")
      ->capture_default_str();
  add_model_options(*frames, command->models);
  frames->callback([&context, command] { context.run = [&context, command] { return draw(context, *command); }; });
}

}  // namespace roomgen::cli
