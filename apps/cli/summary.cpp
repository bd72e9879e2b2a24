#include "summary.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "roomgen/base/text.h"

namespace roomgen::cli {

namespace {

Json suggestions_json(const SuggestionFigures& figures) {
  Json json = {{"located", figures.located},
               {"faced", figures.faced},
               {"facing_kept", figures.facing_kept}};
  for (std::size_t i = 0; i < figures.within.size(); ++i) {
    const std::string metres = format_number(SuggestionFigures::thresholds[i], 2) + "_m";
    json["within_" + metres] = figures.within[i];
    json["placed_within_" + metres] = figures.placed_within[i];
  }
  return json;
}

/// What the room does not have, and why.
struct Lack {
  std::string what, reason;
};

// The first of them; the rest are only counted.
void add_lacks(const std::vector<Lack>& lacks, const std::string& verb, const std::string& fate,
               std::vector<std::string>& lines) {
  constexpr std::size_t most_lines = 30;
  for (std::size_t i = 0; i < std::min(lacks.size(), most_lines); ++i)
    lines.push_back("  " + fate + ": " + lacks[i].what + ": " + lacks[i].reason);
  if (lacks.size() > most_lines)
    lines.push_back("  and " + std::to_string(lacks.size() - most_lines) + " more " + verb + " " + fate +
                    " (scene.json has them all)");
}

std::vector<Lack> clauses_that_are(const Scene& scene, Compliance compliance) {
  std::vector<Lack> lacks;
  for (const auto& verdict : scene.requirements)
    if (verdict.compliance == compliance)
      lacks.push_back({told(verdict.requirement), verdict.reason});
  return lacks;
}

std::vector<std::string> not_understood(const Scene& scene) {
  std::vector<std::string> words;
  for (const auto& heard : scene.heard)
    if (heard.as == Heard::As::not_understood) words.push_back("\"" + heard.text + "\"");
  return words;
}

// "6 of 9"
struct Met {
  std::ptrdiff_t met = 0, all = 0;
  std::string text() const { return std::to_string(met) + " of " + std::to_string(all); }
};

// People, and what they do, need things that the prompt does not name.
bool is_brought(const RequirementVerdict& verdict) {
  using Source = Requirement::Source;
  return verdict.requirement.source == Source::person || verdict.requirement.source == Source::activity;
}

// What a model changed in its own room nobody asked for.
bool is_of_wish(const RequirementVerdict& verdict) {
  return verdict.requirement.source != Requirement::Source::edit;
}

Met met_of(const Scene& scene, bool brought) {
  Met result;
  for (const auto& verdict : scene.requirements) {
    if (!is_of_wish(verdict) || is_brought(verdict) != brought) continue;
    ++result.all;
    result.met += verdict.met();
  }
  return result;
}

// "6 of 9 things you asked for, and 2 of 3 that people and activities need"
std::string met_of_asked(const Scene& scene) {
  if (scene.requirements.empty()) return "nothing was asked for that can be checked";
  const Met asked = met_of(scene, false), brought = met_of(scene, true);
  std::string text = asked.text() + " things you asked for";
  if (brought.all > 0) text += ", and " + brought.text() + " that people and activities need";
  return text;
}

std::string title(const Scene& scene) {
  if (scene.rooms.empty()) return scene.room.type;
  return "dwelling of " + std::to_string(scene.rooms.size()) + " rooms";
}

}  // namespace

Json summary_json(const std::filesystem::path& folder, const Generation& generation) {
  const Scene& scene = generation.scene;
  Json json;
  json["output"] = folder.string();
  json["room_type"] = scene.rooms.empty() ? scene.room.type : "dwelling";
  for (const auto& room : scene.rooms) json["rooms"].push_back(room.id);
  json["seed"] = scene.seed;
  json["objects"] = scene.objects.size();
  json["unplaced"] = Json::array();
  for (const auto& missing : scene.unplaced)
    json["unplaced"].push_back({{"id", missing.id}, {"reason", missing.reason}});
  json["requirements"] = Json::array();
  for (const auto& verdict : scene.requirements) json["requirements"].push_back(to_json(verdict));
  json["heard"] = to_json(scene.heard);
  json["notes"] = generation.notes;
  json["constraints"] = generation.constraints;
  json["held"] = generation.held;
  json["incomplete"] = scene.incomplete;
  json["suggestions"] = suggestions_json(generation.suggestions);
  return json;
}

std::string headline(const Scene& scene) {
  return met_of_asked(scene) + "; a " + title(scene) + " with " + std::to_string(scene.objects.size()) + " objects";
}

std::vector<std::string> note_lines(const AnyPlan& plan, const Generation& generation) {
  std::vector<std::string> lines;
  for (const auto& note : notes_of(plan)) lines.push_back("note: " + note);
  for (const auto& note : generation.notes) lines.push_back("note: " + note);
  return lines;
}

std::vector<std::string> lack_lines(const Scene& scene) {
  std::vector<std::string> lines;
  add_lacks(clauses_that_are(scene, Compliance::not_met), "are", "not met", lines);
  add_lacks(clauses_that_are(scene, Compliance::not_judged), "cannot be", "cannot be judged", lines);
  if (const auto words = not_understood(scene); !words.empty())
    lines.push_back("  not understood: " + join(words, ", "));
  std::vector<Lack> left_out;
  for (const auto& missing : scene.unplaced) left_out.push_back({missing.id, missing.reason});
  add_lacks(left_out, "were", "left out", lines);
  return lines;
}

bool is_as_asked(const Scene& scene) {
  return scene.unplaced.empty() && not_understood(scene).empty() &&
         std::all_of(scene.requirements.begin(), scene.requirements.end(),
                     [](const RequirementVerdict& verdict) {
                       return verdict.met() || verdict.compliance == Compliance::withdrawn;
                     });
}

}  // namespace roomgen::cli
