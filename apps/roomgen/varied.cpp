#include "varied.h"

#include <nlohmann/json.hpp>

#include "program_format.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "roomgen/scene/plan.h"
#include "roomgen/solve/solve.h"

namespace roomgen::cli {

namespace {

Result<std::unique_ptr<AssetLibrary>> open_library([[maybe_unused]] const ModelOptions& options,
                                                   [[maybe_unused]] const Context& context) {
#ifdef ROOMGEN_HAS_ASSETS
  return open_all_libraries(options.libraries, context);
#else
  return Error{Error::Kind::invalid_input, "this build has no furniture libraries: layouts are drawn of a problem or a scene"};
#endif
}

Result<Varied> furnished(const Json& json, const std::string& file, const ModelOptions& models, const Context& context) {
  if (is_dwelling_plan(json))
    return Error{Error::Kind::invalid_input, file + ": layouts are drawn of one room, and this is the plan of a dwelling"};
  auto plan = plan_from_json(json, file);
  if (!plan) return plan.error();
  settle(*plan);
  const auto library = open_library(models, context);
  if (!library) return library.error();
  BuildOptions options;
  options.seed = plan->seed;
  options.cancel = context.cancel;
  auto generation = generate(*plan, *make_rule_designer(), **library, KindTable::built_in(), options);
  if (!generation) return generation.error();
  return Varied{std::nullopt, std::move(generation->scene), std::move(generation->models), true};
}

Result<Varied> placed(const Json& json, const std::string& file, const ModelOptions& models, const Context& context) {
  auto scene = scene_from_json(json, file);
  if (!scene) return scene.error();
  auto table = models_of(*scene, file, models, context);
  if (!table) return table.error();
  return Varied{std::nullopt, *std::move(scene), *std::move(table), false};
}

Result<Varied> unsolved(const Json& json, const std::string& file) {
  auto problem = problem_from_json(json, file);
  if (!problem) return problem.error();
  Scene things = things_of(*problem);
  return Varied{*std::move(problem), std::move(things), {}, false};
}

}  // namespace

Result<Varied> read_varied(const std::string& file, const ModelOptions& models,
                           const Context& context) {
  const auto text = read_file(file);
  if (!text) return text.error();
  const auto json = parse_json(*text, file);
  if (!json) return json.error();
  const Json format = json->is_object() ? json->value("format", Json()) : Json();
  if (format == "roomgen-scene") return placed(*json, file, models, context);
  if (format == "roomgen-plan") return furnished(*json, file, models, context);
  if (is_constraint_program(*json))
    return Error{Error::Kind::invalid_input,
                 file + ": layouts are not drawn of a program; roomgen optimise " + file +
                     " -o FOLDER makes a room of it, and FOLDER/scene.json can be varied"};
  return unsolved(*json, file);
}

}  // namespace roomgen::cli
