#include "roomgen/lab/scores.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "add_commands.h"
#include "models.h"
#include "print.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::cli {

using namespace lab;

namespace {

namespace fs = std::filesystem;

struct EvaluateCommand {
  std::string requirements, id, scene, rooms, markdown, json_file, part;
  ModelOptions models;
};

Result<Scene> part_of(const Scene& scene, const std::string& id, const fs::path& file) {
  std::vector<std::string> ids;
  for (auto& part : parts_of(scene)) {
    if (part.room.id == id) return std::move(part);
    ids.push_back(part.room.id);
  }
  return Error{Error::Kind::invalid_input,
               file.string() + ": has no room \"" + id + "\", but " + join(ids, ", ")};
}

Result<RoomScore> score_file(const Requirements& row, const fs::path& file,
                             const EvaluateCommand& command, const Context& context) {
  auto scene = read_scene(file);
  if (!scene) return scene.error();
  if (!command.part.empty() && !scene->rooms.empty()) scene = part_of(*scene, command.part, file);
  if (!scene) return scene.error();
  const auto models = models_of(*scene, file, command.models, context);
  if (!models) return models.error();
  return score_room(row, *scene, *models);
}

fs::path scene_in(const fs::path& path) {
  std::error_code code;
  return fs::is_directory(path, code) ? path / "scene.json" : path;
}

struct Scores {
  std::vector<RoomScore> scored;
  std::vector<Unscored> unscored;
};

Result<Scores> score_one(const std::vector<Requirements>& rows, const EvaluateCommand& command,
                         const Context& context) {
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const Requirements& r) { return r.id == command.id; });
  if (row == rows.end())
    return Error{Error::Kind::not_found, command.requirements + ": no row \"" + command.id + "\""};
  auto score = score_file(*row, scene_in(command.scene), command, context);
  if (!score) return score.error();
  return Scores{{*std::move(score)}, {}};
}

// Rows without a room are told and left out, and so are rooms that cannot be read.
Result<Scores> score_rooms(const std::vector<Requirements>& rows, const EvaluateCommand& command,
                           const Context& context) {
  Scores scores;
  std::size_t missing = 0;
  for (const auto& row : rows) {
    if (context.cancel.cancelled()) return Error{Error::Kind::cancelled, "stopped"};
    const fs::path file = fs::path(command.rooms) / row.id / "scene.json";
    std::error_code code;
    if (!fs::exists(file, code)) {
      ++missing;
      continue;
    }
    auto score = score_file(row, file, command, context);
    if (score) {
      scores.scored.push_back(*std::move(score));
      continue;
    }
    warn(score.error().message + "; not scored");
    scores.unscored.push_back({row.id, score.error().message});
  }
  if (scores.scored.empty() && scores.unscored.empty())
    return Error{Error::Kind::not_found, command.rooms + ": holds no room of a row's id"};
  if (missing > 0 && !context.quiet)
    std::fprintf(stderr, "roomgen: %zu rows have no room in %s\n", missing, printable(command.rooms).c_str());
  return scores;
}

Result<int> run(const Context& context, const EvaluateCommand& command) {
  const auto text = read_file(command.requirements);
  if (!text) return text.error();
  const auto rows = parse_requirements(*text, command.requirements);
  if (!rows) return rows.error();
  const auto scores = command.rooms.empty() ? score_one(*rows, command, context)
                                            : score_rooms(*rows, command, context);
  if (!scores) return scores.error();
  const Json json = score_json(scores->scored, scores->unscored);
  const std::string markdown = score_markdown(scores->scored, scores->unscored);
  if (!command.json_file.empty())
    if (auto status = write_file(command.json_file, dump_json(json)); !status)
      return status.error();
  if (!command.markdown.empty())
    if (auto status = write_file(command.markdown, markdown); !status) return status.error();
  std::fputs((context.json ? dump_json(json) : printable(markdown)).c_str(), stdout);
  return scores->unscored.empty() ? exit_ok : exit_failure;
}

}  // namespace

void add_evaluate_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<EvaluateCommand>();
  auto* sub = app.add_subcommand(
      "evaluate", "Score rooms against what their descriptions ask for (SceneEval's measures)");
  sub->add_option("--requirements", command->requirements,
                  "CSV file of requirements (docs/evaluation.md)")
      ->required()
      ->check(CLI::ExistingFile);
  auto* scene = sub->add_option("room", command->scene, "scene.json, or the folder that holds it");
  auto* id = sub->add_option("--id", command->id, "The row that the room answers")->needs(scene);
  scene->needs(id);
  sub->add_option("--part", command->part, "Score this room of a dwelling only, by its id");
  auto* rooms = sub->add_option("--rooms", command->rooms,
                                "Folder with a folder of each row's id, instead of one room");
  rooms->excludes(scene);
  sub->add_option("--markdown", command->markdown, "Also write the report to this file");
  sub->add_option("--json-file", command->json_file, "Also write all verdicts to this file");
  add_model_options(*sub, command->models);
  sub->callback([command, &context] {
    if (command->rooms.empty() && command->scene.empty())
      throw CLI::ValidationError("room", "give a room with --id, or --rooms");
    context.run = [command, &context] { return run(context, *command); };
  });
}

}  // namespace roomgen::cli
