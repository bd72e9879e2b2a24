#include "program_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "room_files.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "summary.h"

namespace roomgen::cli {

using namespace lab;

namespace {

Json constraint_json(const ConstraintVerdict& verdict) {
  return {{"name", verdict.name},
          {"held", verdict.held},
          {"amount", rounded(verdict.amount)},
          {"constraint", verdict.text},
          {"objects", verdict.objects}};
}

Json round_json(const ComposeRound& round) {
  Json json = {{"report", to_json(round.report)},
               {"loss", rounded(round.result.loss)},
               {"moves", round.result.moves},
               {"notes", round.written.notes}};
  if (!round.reason.empty()) json["reason"] = round.reason;
  if (!round.patch.is_null()) json["patch"] = round.patch;
  return json;
}

// How the program came about: the first one whole, then what changed.
Json rounds_json(const Composition& composition, const std::string& author) {
  Json json = {{"format", "roomgen-rounds"}, {"version", 1}, {"author", author}, {"chosen", composition.best}};
  json["program"] = to_json(composition.rounds.front().written.program);
  for (const auto& round : composition.rounds) json["rounds"].push_back(round_json(round));
  json["notes"] = composition.notes;
  return json;
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

Status write_composed_room(const OutputFolder& folder, const Composition& composition, const std::string& author,
                           int pixels) {
  const ComposeRound& chosen = composition.chosen();
  if (auto status = folder.write("rounds.json", dump_json(rounds_json(composition, author))); !status) return status;
  for (std::size_t i = 0; i < composition.rounds.size(); ++i)
    if (const auto& picture = composition.rounds[i].picture; !picture.empty())
      if (auto status = folder.write(
              "rounds/round-" + std::to_string(i + 1) + (picture.starts_with("\xFF\xD8") ? ".jpg" : ".png"), picture);
          !status)
        return status;
  return write_optimised_room(folder, chosen.written.program, chosen.result, chosen.models, pixels);
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

std::vector<std::string> composed_lines(const Composition& composition) {
  const ComposeRound& chosen = composition.chosen();
  std::vector<std::string> lines = unmet_lines(chosen.result);
  for (const auto& measure : chosen.report.measures)
    lines.push_back(measure.name + ": " + range_text(measure.asked) + " asked for, " +
                    format_number(measure.reached, 2) + (measure.missed > 0.0 ? " reached: not met" : " reached"));
  for (const auto& line : lack_lines(chosen.result.scene)) lines.push_back(line);
  return lines;
}

}  // namespace roomgen::cli
