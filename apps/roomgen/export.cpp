#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "add_commands.h"
#include "models.h"
#include "room_files.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/export/exporter.h"
#include "roomgen/scene/scene.h"

namespace roomgen::cli {

namespace {

struct Options {
  std::string scene, output, format;
  ModelOptions models;
};

std::string known_formats(bool explained) {
  std::string known;
  for (const auto& format : export_formats()) {
    known += (known.empty() ? "" : explained ? "; " : ", ") + std::string(format.name);
    if (explained) known += ": " + std::string(format.about);
  }
  return known;
}

Result<const ExportFormat*> format_of(const Options& options) {
  const std::string ending = std::filesystem::path(options.output).extension().string();
  const std::string name = !options.format.empty() ? options.format : ending.empty() ? "" : ending.substr(1);
  if (const ExportFormat* format = find_export_format(name)) return format;
  return Error{Error::Kind::not_understood,
               "no format \"" + name + "\" of " + options.output + "; known are " + known_formats(false)};
}

Result<int> export_scene(const Context& context, const Options& options) {
  const auto format = format_of(options);
  if (!format) return format.error();
  const auto scene = read_scene(options.scene);
  if (!scene) return scene.error();
  const auto models = models_of(*scene, options.scene, options.models, context);
  if (!models) return models.error();
  const auto exporter = (*format)->make(export_options());
  if (auto status = exporter->write(*scene, *models, options.output); !status) return status.error();
  if (context.json)
    std::printf("%s\n", json_line(Json{{"file", options.output}, {"format", (*format)->name}}).c_str());
  else if (!context.quiet)
    std::fprintf(stderr, "wrote %s\n", printable(options.output).c_str());
  return exit_ok;
}

}  // namespace

void add_export_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("export", "Write a scene for another program");
  command->add_option("scene", options->scene, "scene.json")->required()->check(CLI::ExistingFile);
  command->add_option("-o,--output", options->output, "File to write")->required();
  command->add_option("--format", options->format,
                      "What the file's ending says, unless told (" + known_formats(true) + ")");
  add_model_options(*command, options->models);
  command->callback([&context, options] {
    context.run = [&context, options] { return export_scene(context, *options); };
  });
}

}  // namespace roomgen::cli
