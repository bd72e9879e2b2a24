#include "program_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "room_files.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::cli {

namespace {

Json constraint_json(const ConstraintVerdict& verdict) {
  return {{"name", verdict.name},
          {"held", verdict.held},
          {"amount", rounded(verdict.amount)},
          {"constraint", verdict.text},
          {"objects", verdict.objects}};
}

}  // namespace

Json optimisation_json(const Optimisation& result) {
  Json json;
  json["violation"] = rounded(result.violation);
  json["loss"] = rounded(result.loss);
  json["occupancy"] = rounded(result.occupancy);
  json["constraints"] = Json::array();
  for (const auto& verdict : result.constraints) json["constraints"].push_back(constraint_json(verdict));
  for (const auto& [name, value] : result.scores) json["scores"][name] = rounded(value);
  json["moves"] = {{"tried", result.moves}, {"accepted", result.accepted}};
  for (std::size_t i = 0; i < result.tried_by_kind.size(); ++i)
    json["moves"][optimise_move_names()[i]] = {result.tried_by_kind[i], result.accepted_by_kind[i]};
  json["curve"] = Json::array();
  for (const auto& point : result.curve)
    json["curve"].push_back({point.step, rounded(point.violation), rounded(point.loss)});
  return json;
}

Status write_optimised_room(const OutputFolder& folder, const ConstraintProgram& program, const Optimisation& result,
                            const ModelTable& models, int pixels) {
  if (auto status = folder.write("program.json", dump_json(to_json(program))); !status) return status;
  if (auto status = folder.write("scene.json", dump_json(to_json(result.scene))); !status) return status;
  if (auto status = folder.write("optimise.json", dump_json(optimisation_json(result))); !status) return status;
  if (auto status = write_model_files(folder, result.scene, models); !status) return status;
  if (pixels == 0) return {};
  PictureDrawer drawer;
  const auto renderer = drawer.renderer();
  if (!renderer) return renderer.error();
  return write_pictures(folder, result.scene, models, **renderer, pixels);
}

std::string optimisation_headline(const Optimisation& result) {
  const auto held = std::ranges::count_if(result.constraints, &ConstraintVerdict::held);
  return std::to_string(result.scene.objects.size()) + " things, " + std::to_string(held) + " of " +
         std::to_string(result.constraints.size()) + " constraints held, " +
         format_number(100.0 * result.occupancy, 0) + " % of the floor covered";
}

std::vector<std::string> unmet_lines(const Optimisation& result) {
  std::vector<std::string> lines;
  for (const auto& verdict : result.constraints)
    if (!verdict.held)
      lines.push_back(verdict.name + " is missed by " + format_number(verdict.amount, 2) + ": " + verdict.text);
  return lines;
}

}  // namespace roomgen::cli
