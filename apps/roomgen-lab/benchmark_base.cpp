#include "benchmark_base.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "any_plan.h"
#include "designers.h"
#include "models.h"
#include "roomgen/base/file.h"
#include "roomgen/generate/generate.h"

namespace roomgen::cli {

using namespace lab;

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t next_try = 1000;  // from seed to seed: others belong to other base rooms

std::string base_name(const std::string& room, int number) {
  std::string name = room + "-" + std::to_string(number);
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

Result<Scene> furnished(const Context& context, const BenchmarkMakeOptions& options, const std::string& prompt,
                        std::uint64_t seed) {
  auto composed = compose_designer({}, context, cache_folder(options.libraries).string());
  if (!composed) return composed.error();
  PlanWish wish;
  wish.prompt = prompt;
  wish.seed = seed;
  const auto plan = make_plan(wish, *composed->designer, context.cancel);
  if (!plan) return plan.error();
  const auto* room = std::get_if<Plan>(&*plan);
  if (!room) return Error{Error::Kind::invalid_input, "benchmark: \"" + prompt + "\" is a dwelling; base rooms are single rooms"};
  auto library = open_all_libraries(options.libraries, context);
  if (!library) return library.error();
  BuildOptions build;
  build.seed = seed;
  build.cancel = context.cancel;
  auto made = generate(*room, *composed->designer, **library, KindTable::built_in(), build);
  if (!made) return made.error();
  if (made->scene.incomplete) return Error{Error::Kind::cancelled, "benchmark: interrupted"};
  return std::move(made->scene);
}

// Levels of seats and floor that the room does not allow, of those that are asked for.
int missed_levels(const Scene& base, const BenchmarkMakeOptions& options, const BenchmarkLevels& levels) {
  int missed = 0;
  for (const auto& compositional : options.compositional)
    for (const auto& relational : options.relational)
      missed += !reduced(base, levels, {compositional, relational, ""}).as_defined();
  return missed;
}

// Where all of many things find room is by chance: the first of several rooms that allows all levels, else the one that
// allows most.
Result<Scene> best_furnished(const Context& context, const BenchmarkMakeOptions& options, const BenchmarkLevels& levels,
                             const std::string& prompt, std::uint64_t seed) {
  std::optional<Scene> best;
  int least = 0;
  for (int attempt = 0; attempt < levels.tries; ++attempt) {
    auto scene = furnished(context, options, prompt, seed + next_try * static_cast<std::uint64_t>(attempt));
    if (!scene) return scene.error();
    const int missed = missed_levels(*scene, options, levels);
    if (best && missed >= least) continue;
    least = missed;
    best = std::move(*scene);
    if (least == 0) break;
  }
  return std::move(*best);
}

}  // namespace

Result<BaseRoom> base_room(const Context& context, const BenchmarkMakeOptions& options, const BenchmarkLevels& levels,
                           const std::string& room, int number) {
  const std::string name = base_name(room, number);
  const fs::path file = fs::path(options.output) / "base" / name / "scene.json";
  std::error_code code;
  if (!fs::exists(file, code)) {
    const auto made = best_furnished(context, options, levels, levels.rooms.at(room),
                                     options.seed + static_cast<std::uint64_t>(number));
    if (!made) return made.error();
    if (auto status = make_folder(file.parent_path()); !status) return status.error();
    if (auto status = write_file(file, dump_json(to_json(*made))); !status) return status.error();
  }
  auto scene = read_scene(file);
  if (!scene) return scene.error();
  ModelOptions models_from;
  models_from.libraries = options.libraries;
  auto models = models_of(*scene, file, models_from, context);
  if (!models) return models.error();
  return BaseRoom{name, std::move(*scene), std::move(*models)};
}

}  // namespace roomgen::cli
