#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "command.h"
#include "models.h"
#include "roomgen/base/json.h"
#include "roomgen/render/pictures.h"
#include "roomgen/scene/scene.h"
#include "views.h"

namespace roomgen::cli {

namespace {

struct RenderOptions {
  std::string scene, output = "top.png", view = "top", frame = "plan";
  int pixels = 1024;
  bool marks = false;
  ModelOptions models;
};

void report(const Context& context, const RenderOptions& options, const Image& image) {
  if (context.json) {
    const Json summary = {
        {"file", options.output}, {"width", image.width}, {"height", image.height}};
    std::printf("%s\n", summary.dump().c_str());
  } else if (!context.quiet) {
    std::fprintf(stderr, "wrote %s (%d x %d)\n", options.output.c_str(), image.width, image.height);
  }
}

Result<int> render(const Context& context, const RenderOptions& options) {
  const auto scene = read_scene(options.scene);
  if (!scene) return scene.error();
  const auto models = models_of(*scene, options.scene, options.models, context);
  if (!models) return models.error();
  const auto renderer = make_osmesa_renderer();
  if (!renderer) return renderer.error();

  View view = view_named(options.view, options.pixels);
  view.marks = options.marks;
  view.paper_frame = options.frame == "paper";
  const auto image = (*renderer)->render(*scene, *models, view);
  if (!image) return image.error();
  if (auto status = write_png(options.output, *image); !status) return status.error();
  report(context, options, *image);
  return exit_ok;
}

}  // namespace

void add_render_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Draw a picture of a scene");
  command->add_option("scene", options->scene, "scene.json")->required()->check(CLI::ExistingFile);
  command->add_option("-o,--output", options->output, "PNG file to write")->capture_default_str();
  command->add_option("--view", options->view, "top: plan from above; iso: from a corner, above; eye: as a visitor sees it")
      ->check(CLI::IsMember({"top", "iso", "eye"}))
      ->capture_default_str();
  command->add_flag("--marks", options->marks,
                    "Draw the coordinate grid, ids and fronts (top view only)");
  command
      ->add_option("--frame", options->frame,
                   "Coordinates of the marks. plan: x right, y up; paper: x down, y left")
      ->check(CLI::IsMember({"plan", "paper"}))
      ->capture_default_str();
  command->add_option("--pixels", options->pixels, "Length of the picture's longer side")
      ->capture_default_str();
  add_model_options(*command, options->models);
  command->callback([&context, options] {
    if (options->marks && options->view != "top")
      throw CLI::ValidationError("--marks", "marks need the top view");
    context.run = [&context, options] { return render(context, *options); };
  });
}

}  // namespace roomgen::cli
