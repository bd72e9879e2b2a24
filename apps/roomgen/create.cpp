#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "command.h"
#include "options.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/export/glb.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/recipe.h"
#ifdef ROOMGEN_HAS_RENDER
#include "roomgen/render/image_file.h"
#include "roomgen/render/model_picture.h"
#include "roomgen/view/model_camera.h"
#endif

namespace roomgen::cli {

namespace {

namespace fs = std::filesystem;

constexpr int view_pixels = 512;

struct Options {
  std::string program, output, write_program, views;
  std::vector<std::string> set;
  std::uint64_t seed = 0;
  double tolerance = shape::default_tolerance;
};

Error cancelled() {
  return {Error::Kind::cancelled, "interrupted; nothing was written"};
}

Result<shape::Values> values_of(const Options& options, const Json& recipe) {
  const auto parameters = shape::describe_parameters(recipe, options.program);
  if (!parameters) return parameters.error();
  shape::Values values;
  for (const auto& setting : options.set) {
    const auto equals = setting.find('=');  // checked when parsed
    const std::string name = setting.substr(0, equals), text = setting.substr(equals + 1);
    // The recipe's reader says what is wrong with an unknown name.
    values[name] = text;
    for (const auto& parameter : *parameters)
      if (parameter.name == name) values[name] = shape::parameter_value(parameter, text);
  }
  return values;
}

Result<shape::Program> load(const Options& options) {
  const auto recipe = shape::read_recipe(options.program);
  if (!recipe) return recipe.error();
  const auto values = values_of(options, *recipe);
  if (!values) return values.error();
  return shape::instantiate(*recipe, *values, options.seed,
                            shape::recipes_in(fs::path(options.program).parent_path()),
                            options.program);
}

#ifdef ROOMGEN_HAS_RENDER
Status write_views(const Context& context, const fs::path& folder, const Model& model) {
  std::vector<Camera> cameras;
  for (const auto& view : model_views())
    cameras.push_back(model_camera(bounds(model), view, view_pixels));
  const auto pictures = draw_model(std::make_shared<Model>(model), cameras);
  if (!pictures) return pictures.error();
  if (context.cancel.cancelled()) return cancelled();
  std::error_code code;
  fs::create_directories(folder, code);
  if (code)
    return Error{Error::Kind::io, folder.string() + ": cannot make the folder: " + code.message()};
  for (std::size_t k = 0; k < pictures->size(); ++k) {
    const auto path = folder / (std::string(model_views()[k].name) + ".png");
    if (auto status = write_png(path, (*pictures)[k]); !status) return status;
  }
  return write_png(folder / "views.png", contact_sheet(*pictures, 2));
}
#endif

GlbOptions glb_options() {
  GlbOptions options;
#ifdef ROOMGEN_HAS_RENDER
  options.encode_image = encode_texture;
#endif
  return options;
}

Status write_all(const Context& context, const Options& options, const shape::Program& program,
                 const Model& model) {
  const std::string name =
      program.name.empty() ? fs::path(options.program).stem().string() : program.name;
  if (!options.output.empty()) {
    const auto glb = make_glb(name, model, glb_options());
    if (!glb) return glb.error();
    if (context.cancel.cancelled()) return cancelled();
    if (auto status = write_file(options.output, *glb); !status) return status;
  }
  if (!options.write_program.empty())
    if (auto status = write_file(options.write_program, dump_json(shape::write_program(program)));
        !status)
      return status;
#ifdef ROOMGEN_HAS_RENDER
  if (!options.views.empty()) return write_views(context, options.views, model);
#endif
  return {};
}

void report(const Context& context, const Options& options, const shape::Program& program,
            const shape::Shape& made) {
  const Vec3 size = shape::bounds(made).size();
  if (context.json) {
    Json json;
    json["name"] = program.name;
    json["size"] = {rounded(size.x()), rounded(size.y()), rounded(size.z())};
    json["components"] = made.bodies.size();
    json["triangles"] = shape::triangle_count(made);
    json["materials"] = program.materials.size();
    for (const auto& [key, path] :
         {std::pair<const char*, const std::string&>{"output", options.output},
          {"program", options.write_program},
          {"views", options.views}})
      if (!path.empty()) json[key] = path;
    std::fputs(dump_json(json).c_str(), stdout);
  } else if (!context.quiet) {
    std::fprintf(stderr, "%s: %s x %s x %s m, %zu bodies, %zu triangles\n",
                 program.name.empty() ? options.program.c_str() : program.name.c_str(),
                 format_number(size.x()).c_str(), format_number(size.y()).c_str(),
                 format_number(size.z()).c_str(), made.bodies.size(), shape::triangle_count(made));
  }
}

Result<int> create(const Context& context, const Options& options) {
  const auto program = load(options);
  if (!program) return program.error();
  if (context.cancel.cancelled()) return cancelled();
  const auto made = shape::evaluate_within(*program, shape::default_triangles, options.tolerance);
  if (!made) return with_context(made.error(), options.program);
  if (context.cancel.cancelled()) return cancelled();
  if (auto status = write_all(context, options, *program, shape::to_model(*made)); !status)
    return status.error();
  report(context, options, *program, *made);
  return exit_ok;
}

void check_usage(const Options& options) {
  for (const auto& setting : options.set)
    if (const auto equals = setting.find('='); equals == std::string::npos || equals == 0)
      throw CLI::ValidationError("--set", "\"" + setting + "\": write name=value");
  if (options.output.empty() && options.write_program.empty() && options.views.empty())
    throw CLI::RequiredError("--output, --write-program or --views");
}

}  // namespace

void add_create_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<Options>();
  auto* sub = app.add_subcommand("create", "Make one object from a shape program (docs/shapes.md)");
  sub->add_option("--program", options->program,
                  "Shape program, JSON; others beside it may be used")
      ->required();
  sub->add_option("-o,--output", options->output, "GLB file to write");
  sub->add_option("--set", options->set, "A parameter, name=value; may be repeated")
      ->allow_extra_args(false);
  sub->add_option("--seed", options->seed, "Seed of what the program leaves to chance")
      ->check(CLI::Range(std::uint64_t{0}, max_seed))
      ->capture_default_str();
  sub->add_option(
         "--tolerance", options->tolerance,
         "How far round surfaces may be from true, metres; more when it takes too many triangles")
      ->check(CLI::Range(0.0001, 0.1))
      ->capture_default_str();
  sub->add_option("--write-program", options->write_program,
                  "Write the program with all parameters put in, JSON");
#ifdef ROOMGEN_HAS_RENDER
  sub->add_option("--views", options->views,
                  "Folder for pictures: front, side, back, above, and all in views.png");
#endif
  sub->callback([options, &context] {
    check_usage(*options);
    context.run = [options, &context] { return create(context, *options); };
  });
}

}  // namespace roomgen::cli
