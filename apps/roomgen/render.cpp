#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "add_commands.h"
#include "models.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/render/pictures.h"
#include "roomgen/scene/scene.h"
#include "views.h"

namespace roomgen::cli {

namespace {

constexpr const char* segments_view = "segments";

struct RenderOptions {
  std::string scene, output, frame = "plan", cameras;
  std::vector<std::string> views = {"top"};
  int pixels = 1024;
  bool marks = false, layers = false, alone = false;
  ModelOptions models;

  std::string output_path() const {
    if (!output.empty()) return output;
    return layers ? "layers" : views[0] == "top" ? "top.png" : views[0] + ".png";
  }
};

void report(const Context& context, const RenderOptions& options, const Image& image) {
  const std::string path = options.output_path();
  if (context.json) {
    const Json summary = {{"file", path}, {"width", image.width}, {"height", image.height}};
    std::printf("%s\n", json_line(summary).c_str());
  } else if (!context.quiet) {
    std::fprintf(stderr, "wrote %s (%d x %d)\n", printable(path).c_str(), image.width, image.height);
  }
}

Result<Image> draw_picture(const RenderOptions& options, Renderer& renderer, const Scene& scene,
                           const ModelTable& models) {
  if (options.views[0] == segments_view) return segmentation_picture(renderer, scene, models, options.pixels);
  View view = view_named(options.views[0], options.pixels);
  view.marks = options.marks;
  view.paper_frame = options.frame == "paper";
  return renderer.render(scene, models, view);
}

struct NamedShot {
  std::string name;
  Shot shot;
};

// What the views see, or the cameras of the file.
Result<std::vector<NamedShot>> shots_of(const RenderOptions& options, const Scene& scene) {
  std::vector<NamedShot> shots;
  if (options.cameras.empty()) {
    for (const auto& name : options.views) {
      const View view = view_named(name, options.pixels);
      const auto camera = make_camera(scene, view);
      if (!camera) return camera.error();
      shots.push_back({name, {*camera, view.kind, true, options.alone}});
    }
    return shots;
  }
  const auto text = read_file(options.cameras);
  if (!text) return text.error();
  const auto json = parse_json(*text, options.cameras);
  if (!json) return json.error();
  const auto cameras = cameras_from_json(*json, options.cameras);
  if (!cameras) return cameras.error();
  for (const auto& [name, camera] : *cameras)
    shots.push_back({name, {camera, View::Kind::eye, true, options.alone}});
  return shots;
}

Result<int> write_all_layers(const Context& context, const RenderOptions& options, Renderer& renderer,
                             const Scene& scene, const ModelTable& models) {
  const auto shots = shots_of(options, scene);
  if (!shots) return shots.error();
  auto folder = OutputFolder::open(options.output_path());
  if (!folder) return folder.error();
  Json names = Json::array();
  for (const auto& [name, shot] : *shots) {
    if (context.cancel.cancelled()) return Error{Error::Kind::cancelled, "interrupted; nothing was written"};
    if (!options.cameras.empty() && !context.quiet && !is_indoors(scene, shot.camera.eye->head<2>()))
      std::fprintf(stderr, "in a wall or outdoors: camera %s of %s\n", printable(name).c_str(), printable(options.cameras).c_str());
    const auto layers = renderer.layers(scene, models, shot);
    if (!layers) return layers.error();
    if (auto status = write_layers(*folder, name, *layers); !status) return status.error();
    names.push_back(name);
  }
  if (auto status = folder->commit(); !status) return status.error();
  if (context.json)
    std::printf("%s\n", json_line(Json{{"folder", options.output_path()}, {"shots", names}}).c_str());
  else if (!context.quiet)
    std::fprintf(stderr, "wrote the layers of %zu shots into %s\n", shots->size(), printable(options.output_path()).c_str());
  return exit_ok;
}

Result<int> render(const Context& context, const RenderOptions& options) {
  const auto scene = read_scene(options.scene);
  if (!scene) return scene.error();
  const auto models = models_of(*scene, options.scene, options.models, context);
  if (!models) return models.error();
  const auto renderer = make_osmesa_renderer();
  if (!renderer) return renderer.error();
  if (options.layers) return write_all_layers(context, options, **renderer, *scene, *models);
  const auto image = draw_picture(options, **renderer, *scene, *models);
  if (!image) return image.error();
  if (auto status = write_png(options.output_path(), *image); !status) return status.error();
  report(context, options, *image);
  return exit_ok;
}

void check_usage(const RenderOptions& options) {
  const std::string& view = options.views[0];
  if (options.marks && (view != "top" || options.layers))
    throw CLI::ValidationError("--marks", "marks need the top view, and no layers");
  if (options.views.size() > 1 && !options.layers)
    throw CLI::ValidationError("--view", "several views at once need --layers");
  const auto is_drawing = [](const std::string& name) {
    return name == segments_view || name == "elevation";
  };
  if (options.layers && std::any_of(options.views.begin(), options.views.end(), is_drawing))
    throw CLI::ValidationError("--view", "layers are of the views top, iso and eye");
  if (!options.layers && (options.alone || !options.cameras.empty()))
    throw CLI::ValidationError(options.alone ? "--alone" : "--cameras", "needs --layers");
}

}  // namespace

void add_render_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Draw a picture of a scene, or its depths, normals and segments");
  command->add_option("scene", options->scene, "scene.json")->required()->check(CLI::ExistingFile);
  command->add_option("-o,--output", options->output,
                      "PNG file to write (VIEW.png); with --layers the folder (layers)");
  CLI::Option* views = command
                           ->add_option("--view", options->views,
                                        "top: plan from above; iso: from a corner, above; eye: as "
                                        "a visitor sees it; elevation: the "
                                        "walls side by side; segments: plan with a colour a "
                                        "category, ids and a legend. With --layers "
                                        "several, with commas")
                           ->delimiter(',')
                           ->check(CLI::IsMember({"top", "iso", "eye", "elevation", segments_view}))
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
  command->add_flag("--layers", options->layers,
                    "Write depths, normals, instances, categories and the camera too (docs/layers.md)");
  command->add_option("--cameras", options->cameras, "JSON file of cameras, for --layers instead of --view")
      ->check(CLI::ExistingFile)
      ->excludes(views);
  command->add_flag("--alone", options->alone,
                    "With --layers: count what each thing would show if nothing hid it");
  add_model_options(*command, options->models);
  command->callback([&context, options] {
    check_usage(*options);
    context.run = [&context, options] { return render(context, *options); };
  });
}

}  // namespace roomgen::cli
