#include <cstdio>
#include <nlohmann/json.hpp>

#include "add_commands.h"
#include "libraries.h"
#include "made.h"
#include "makers.h"
#include "options.h"
#include "room_files.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/create/create.h"
#include "roomgen/export/exporter.h"
#include "roomgen/render/pictures.h"

namespace roomgen::cli {

namespace {

namespace fs = std::filesystem;

constexpr int most_variants = 64;
constexpr int sheet_columns = 4;

struct CreateOptions {
  std::string prompt, program, refine, size, output, write_program, views;
  std::string variant = "full";
  int variants = 1;
  MakerOptions maker;
  bool add = false;
  std::string cache;
  std::vector<std::string> set;
  std::uint64_t seed = 0;
  double tolerance = shape::default_tolerance;
};

Error cancelled() {
  return {Error::Kind::cancelled, "interrupted; nothing was written"};
}

Result<shape::Values> values_of(const CreateOptions& options, const Json& recipe) {
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

Result<shape::Program> load(const CreateOptions& options) {
  const auto recipe = shape::read_recipe(options.program);
  if (!recipe) return recipe.error();
  const auto values = values_of(options, *recipe);
  if (!values) return values.error();
  return shape::instantiate(*recipe, *values, options.seed,
                            shape::recipes_in(fs::path(options.program).parent_path()),
                            options.program);
}

Result<Made> from_program(const CreateOptions& options) {
  auto program = load(options);
  if (!program) return program.error();
  auto shape = shape::evaluate_within(*program, shape::default_triangles, options.tolerance);
  if (!shape) return with_context(shape.error(), options.program);
  return Made{*std::move(program), *std::move(shape), {}, false, false, {}, {}};
}

Result<create::CreateOptions> create_options(const Context& context, const CreateOptions& options) {
  create::CreateOptions result;
  result.seed = options.seed;
  result.cancel = context.cancel;
  result.variant = create::variant_named(options.variant).value_or(create::Variant::full);
  if (!options.size.empty()) {
    auto size = parse_size3(options.size);
    if (!size) return size.error();
    result.size = *size;
  }
  return result;
}

Result<MadeAll> from_words(const Context& context, const CreateOptions& options) {
  const auto chosen = create_options(context, options);
  if (!chosen) return chosen.error();
  auto makers = ComposedMakers::compose(options.maker, context, options.cache);
  if (!makers) return makers.error();
  const auto maker = makers->maker(chosen->variant, context.cancel);
  MadeAll result;
  if (!options.refine.empty()) {
    const auto program = load(options);
    if (!program) return program.error();
    auto object = create::refine(*program, options.refine, *maker, *chosen);
    if (!object) return object.error();
    result.model = to_model(object->shape);
    result.objects.push_back(made_of(*std::move(object)));
    return result;
  }
  auto creation = create::create(options.prompt, *maker, *chosen);
  if (!creation) return creation.error();
  if (!creation->verdict.passes)
    return Error{Error::Kind::invalid_input, creation->verdict.reason};
  auto made = made_of(*std::move(creation), options.seed);
  if (!made || !makers->judges()) return made;
  auto scores = makers->judge(options.prompt, made->model, context.cancel);
  if (!scores) return with_context(scores.error(), "judging");
  made->scores = *std::move(scores);
  return made;
}

Result<MadeAll> make(const Context& context, const CreateOptions& options) {
  if (!options.prompt.empty() || !options.refine.empty()) return from_words(context, options);
  auto made = from_program(options);
  if (!made) return made.error();
  MadeAll result;
  result.model = to_model(made->shape);
  result.objects.push_back(*std::move(made));
  return result;
}

Status write_views(const Context& context, const fs::path& path, const Model& model) {
  const auto pictures = draw_views(model);
  if (!pictures) return pictures.error();
  if (context.cancel.cancelled()) return cancelled();
  auto folder = OutputFolder::open(path);
  if (!folder) return folder.error();
  for (std::size_t k = 0; k < pictures->size(); ++k)
    if (auto status = write_png(*folder, model_view_names()[k] + ".png", (*pictures)[k]);
        !status)
      return status;
  if (auto status = write_png(*folder, "views.png", contact_sheet(*pictures, 2)); !status)
    return status;
  return folder->commit();
}

// All variants from above, side by side.
Status write_sheet(const fs::path& path, const std::vector<Model>& models) {
  std::vector<Image> pictures;
  for (const auto& model : models) {
    auto views = draw_views(model);
    if (!views) return views.error();
    pictures.push_back(std::move(views->back()));
  }
  auto folder = OutputFolder::open(path);
  if (!folder) return folder.error();
  if (auto status = write_png(*folder, "variants.png", contact_sheet(pictures, sheet_columns));
      !status)
    return status;
  return folder->commit();
}

Status write_all(const Context& context, const CreateOptions& options, const shape::Program& program,
                 const Model& model) {
  const std::string name =
      program.name.empty() ? fs::path(options.program).stem().string() : program.name;
  if (!options.output.empty()) {
    const auto glb = make_glb(name, model, export_options());
    if (!glb) return glb.error();
    if (context.cancel.cancelled()) return cancelled();
    if (auto status = write_file(options.output, *glb); !status) return status;
  }
  if (!options.write_program.empty())
    if (auto status = write_file(options.write_program, dump_json(shape::write_program(program)));
        !status)
      return status;
  if (!options.views.empty()) return write_views(context, options.views, model);
  return {};
}

void report(const Context& context, const CreateOptions& options, const MadeAll& all) {
  const auto& objects = all.objects;
  if (context.json) {
    Json json = objects_json(all);
    for (const auto& [key, path] :
         {std::pair<const char*, const std::string&>{"output", options.output},
          {"program", options.write_program},
          {"views", options.views}})
      if (!path.empty()) json[key] = path;
    std::fputs(dump_json(json).c_str(), stdout);
    return;
  }
  if (context.quiet) return;
  for (const auto& made : objects) {
    const Vec3 size = shape::bounds(made.shape).size();
    std::fprintf(stderr, "%s: %s x %s x %s m, %zu bodies, %zu triangles\n",
                 printable(made.program.name.empty() ? options.program : made.program.name).c_str(),
                 format_number(size.x()).c_str(), format_number(size.y()).c_str(),
                 format_number(size.z()).c_str(), made.shape.bodies.size(),
                 shape::triangle_count(made.shape));
    for (const auto& note : made.notes) std::fprintf(stderr, "  note: %s\n", printable(note).c_str());
    for (const auto& repair : made.repairs) std::fprintf(stderr, "  repaired: %s\n", printable(repair).c_str());
    for (const auto& problem : made.soundness.problems)
      std::fprintf(stderr, "  left as it is: %s\n", printable(problem).c_str());
  }
  for (const auto& note : all.notes) std::fprintf(stderr, "  note: %s\n", printable(note).c_str());
  if (!all.scores) return;
  for (const auto& [rubric, score] : {std::pair("structure", all.scores->structure),
                                      std::pair("realism", all.scores->realism),
                                      std::pair("alignment", all.scores->alignment)})
    std::fprintf(stderr, "  %s: %d of 5, %s\n", rubric, score.points, printable(score.reason).c_str());
}

Result<int> make_one(const Context& context, const CreateOptions& options) {
  const auto made = make(context, options);
  if (!made) return made.error();
  if (context.cancel.cancelled()) return cancelled();
  const Made& main = made->objects.front();
  if (auto status = write_all(context, options, main.program, made->model); !status)
    return status.error();
  if (options.add) {
    const auto kept = create::keep_program(main.program, kept_folder(options.cache));
    if (!kept) return kept.error();
    if (!context.quiet && !context.json) std::fprintf(stderr, "kept as %s\n", printable(*kept).c_str());
  }
  report(context, options, *made);
  return exit_ok;
}

// "stool.glb" of variant 2 is "stool-2.glb".
std::string numbered(const std::string& path, int number) {
  if (path.empty()) return path;
  const fs::path whole(path);
  return (whole.parent_path() / (whole.stem().string() + "-" + std::to_string(number) +
                                 whole.extension().string()))
      .string();
}

// The same words with other seeds, and a picture of all.
Result<int> make_variants(const Context& context, const CreateOptions& options) {
  std::vector<Model> models;
  for (int k = 0; k < options.variants; ++k) {
    CreateOptions one = options;
    one.seed = options.seed + static_cast<std::uint64_t>(k);
    one.output = numbered(options.output, k);
    one.write_program = numbered(options.write_program, k);
    one.views.clear();
    const auto made = make(context, one);
    if (!made) return made.error();
    if (context.cancel.cancelled()) return cancelled();
    if (auto status = write_all(context, one, made->objects.front().program, made->model); !status)
      return status.error();
    report(context, one, *made);
    models.push_back(made->model);
  }
  if (!options.views.empty())
    if (auto status = write_sheet(options.views, models); !status) return status.error();
  return exit_ok;
}

Result<int> create_command(const Context& context, const CreateOptions& options) {
  return options.variants > 1 ? make_variants(context, options) : make_one(context, options);
}

void check_create_usage(const CreateOptions& options) {
  for (const auto& setting : options.set)
    if (const auto equals = setting.find('='); equals == std::string::npos || equals == 0)
      throw CLI::ValidationError("--set", "\"" + setting + "\": write name=value");
  if (options.prompt.empty() == options.program.empty() && options.refine.empty())
    throw CLI::ValidationError("prompt", "say what the object is, or give --program");
  if (options.maker.judge && (options.prompt.empty() || !options.refine.empty()))
    throw CLI::ValidationError("--judge", "needs the words to judge by");
  if (!options.refine.empty() && options.program.empty())
    throw CLI::ValidationError("--refine", "needs the earlier object's --program");
  if (options.output.empty() && options.write_program.empty() && options.views.empty() &&
      !options.add)
    throw CLI::RequiredError("--output, --write-program, --views or --add");
}

}  // namespace

void add_create_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<CreateOptions>();
  auto* sub = app.add_subcommand("create", "Make one object from a sentence (docs/objects.md) or from a shape program (docs/shapes.md)");
  sub->add_option("prompt", options->prompt, "What the object is: \"a bar stool with a round seat\"");
  sub->add_option("--program", options->program,
                  "Shape program, JSON; others beside it may be used");
  sub->add_option("--refine", options->refine,
                  "Change the object of --program: \"make the back taller\"");
  sub->add_option("--size", options->size, "Width, depth and height in metres, as in 0.4x0.4x0.7");
  sub->add_option("--variants", options->variants,
                  "So many with seeds one after the other; --views then holds variants.png")
      ->check(CLI::Range(1, most_variants))
      ->capture_default_str();
  sub->add_flag("--add", options->add, "Keep it: later rooms take it before the libraries");
  sub->add_option("--cache", options->cache, "Where --add keeps it (default: the user's cache folder)");
  sub->add_option("--variant", options->variant, "Leave out agents, to see what they are good for")
      ->check(CLI::IsMember({"full", "no-validation", "no-decomposition", "direct"}))
      ->capture_default_str();
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
  sub->add_option("--views", options->views,
                  "Folder for pictures: front, side, back, above, and all in views.png");
  add_maker_options(*sub, options->maker);
  sub->callback([options, &context] {
    check_create_usage(*options);
    context.run = [options, &context] { return create_command(context, *options); };
  });
}

}  // namespace roomgen::cli
