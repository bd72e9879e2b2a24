#include "roomgen/lab/scores.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

struct Share {
  double held = 0.0;  ///< a count, or the sum of shares
  std::size_t of = 0;

  std::optional<double> percent() const {
    if (of == 0) return std::nullopt;
    return 100.0 * held / static_cast<double>(of);
  }
};

Share satisfied(const std::vector<JudgedRequirement>& verdicts) {
  Share share;
  share.of = verdicts.size();
  for (const auto& verdict : verdicts) share.held += verdict.satisfied;
  return share;
}

Share share_of(std::size_t held, std::size_t of) { return {static_cast<double>(held), of}; }

Share unjudged(const std::vector<JudgedRequirement>& verdicts) {
  return share_of(static_cast<std::size_t>(
                      std::count_if(verdicts.begin(), verdicts.end(),
                                    [](const JudgedRequirement& verdict) { return !verdict.unjudged.empty(); })),
                  verdicts.size());
}

struct Measure {
  const char* name;
  const char* meaning;
  std::function<Share(const RoomScore&)> share;
};

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all = {
      {"CNT", "counts that hold", [](const RoomScore& s) { return satisfied(s.counts); }},
      {"ATR", "attributes that hold", [](const RoomScore& s) { return satisfied(s.attributes); }},
      {"ATR unjudged", "attributes that fail because nothing could tell",
       [](const RoomScore& s) { return unjudged(s.attributes); }},
      {"OOR", "object-object relations that hold",
       [](const RoomScore& s) { return satisfied(s.object_relations); }},
      {"OAR", "object-architecture relations that hold",
       [](const RoomScore& s) { return satisfied(s.room_relations); }},
      {"COL", "objects in collision, rugs included",
       [](const RoomScore& s) { return share_of(s.colliding.size(), s.objects); }},
      {"COL solids", "solids in collision with another",
       [](const RoomScore& s) { return share_of(s.colliding_solids.size(), s.solids); }},
      {"COL scenes", "rooms with a collision",
       [](const RoomScore& s) { return share_of(s.colliding.empty() ? 0 : 1, 1); }},
      {"OOB", "objects out of bounds",
       [](const RoomScore& s) { return share_of(s.outside.size(), s.objects); }},
      {"SUP", "objects that something holds",
       [](const RoomScore& s) { return share_of(s.objects - s.unsupported.size(), s.objects); }},
      {"NAV", "free floor that hangs together, mean of the rooms",
       [](const RoomScore& s) { return Share{s.navigability, 1}; }},
      {"CLR doors", "doors with nothing before them",
       [](const RoomScore& s) { return share_of(s.clear_doors, s.doors); }},
      {"CLR windows", "windows with nothing before them",
       [](const RoomScore& s) { return share_of(s.clear_windows, s.windows); }},
  };
  return all;
}

Share total(std::span<const RoomScore> scores, const Measure& measure,
            const std::string& difficulty) {
  Share sum;
  for (const auto& score : scores) {
    if (!difficulty.empty() && score.difficulty != difficulty) continue;
    const Share share = measure.share(score);
    sum.held += share.held;
    sum.of += share.of;
  }
  return sum;
}

std::vector<std::string> difficulties(std::span<const RoomScore> scores) {
  std::vector<std::string> result;
  for (const auto* name : {"easy", "medium", "hard"})
    for (const auto& score : scores)
      if (score.difficulty == name) {
        result.emplace_back(name);
        break;
      }
  return result;
}

Json share_json(const Share& share) {
  Json json = {{"held", rounded(share.held, 4)}, {"of", share.of}};
  if (const auto percent = share.percent()) json["percent"] = rounded(*percent, 2);
  return json;
}

Json totals_json(std::span<const RoomScore> scores, const std::string& difficulty) {
  Json json;
  for (const auto& measure : measures())
    json[measure.name] = share_json(total(scores, measure, difficulty));
  return json;
}

Json verdicts_json(const std::vector<JudgedRequirement>& verdicts) {
  Json json = Json::array();
  for (const auto& verdict : verdicts) {
    Json entry = {{"requirement", verdict.text},
                  {"satisfied", verdict.satisfied},
                  {"reason", verdict.reason}};
    if (!verdict.missing.empty()) entry["missing"] = verdict.missing;
    if (!verdict.unjudged.empty()) entry["unjudged"] = verdict.unjudged;
    json.push_back(std::move(entry));
  }
  return json;
}

void add_physics(const RoomScore& score, Json& json) {
  json["collisions"] = score.collisions;
  json["colliding"] = score.colliding;
  json["colliding_solids"] = score.colliding_solids;
  json["outside"] = score.outside;
  json["unsupported"] = score.unsupported;
  json["navigability"] = rounded(score.navigability, 4);
  json["in_the_way"] = score.in_the_way;
}

Json room_json(const RoomScore& score) {
  Json json = {{"id", score.id}, {"difficulty", score.difficulty}, {"objects", score.objects}};
  json["matched"] = score.matched;
  json["CNT"] = verdicts_json(score.counts);
  json["ATR"] = verdicts_json(score.attributes);
  json["OOR"] = verdicts_json(score.object_relations);
  json["OAR"] = verdicts_json(score.room_relations);
  add_physics(score, json);
  for (const auto& room : score.rooms) {
    Json own = {{"id", room.id}, {"objects", room.objects}};
    add_physics(room, own);
    json["rooms"].push_back(std::move(own));
  }
  return json;
}

std::string cell(const Share& share) {
  const auto percent = share.percent();
  if (!percent) return "-";
  return format_number(*percent, 1) + " % (" + format_number(share.held, 1) + "/" +
         std::to_string(share.of) + ")";
}

void add_failures(std::string& text, const char* name, const std::vector<JudgedRequirement>& verdicts) {
  for (const auto& verdict : verdicts)
    if (!verdict.satisfied)
      text += std::string("- ") + name + " `" + verdict.text + "`: " + verdict.reason + "\n";
}

void add_failures_of(std::string& text, const RoomScore& score) {
  std::string failures;
  add_failures(failures, "CNT", score.counts);
  add_failures(failures, "ATR", score.attributes);
  add_failures(failures, "OOR", score.object_relations);
  add_failures(failures, "OAR", score.room_relations);
  for (const auto& [a, b] : score.collisions)
    failures += "- COL " + a + " and " + b + "\n";
  for (const auto& id : score.outside) failures += "- OOB " + id + "\n";
  for (const auto& id : score.unsupported) failures += "- SUP " + id + "\n";
  for (const auto& [opening, ids] : score.in_the_way)
    failures += "- CLR " + opening + ": " + join(ids, ", ") + "\n";
  if (!failures.empty()) text += "\n## " + score.id + "\n\n" + failures;
}

}  // namespace

Json score_json(std::span<const RoomScore> scores, std::span<const Unscored> unscored) {
  Json json;
  json["format"] = "roomgen-evaluation";
  json["version"] = 1;
  json["rooms"] = scores.size();
  json["total"] = totals_json(scores, "");
  for (const auto& difficulty : difficulties(scores))
    json["by_difficulty"][difficulty] = totals_json(scores, difficulty);
  json["scores"] = Json::array();
  for (const auto& score : scores) json["scores"].push_back(room_json(score));
  for (const auto& room : unscored)
    json["unscored"].push_back({{"id", room.id}, {"reason", room.reason}});
  return json;
}

std::string score_markdown(std::span<const RoomScore> scores,
                           std::span<const Unscored> unscored) {
  const auto columns = difficulties(scores);
  std::string text = "# " + std::to_string(scores.size()) + " rooms\n\n| measure | all |";
  for (const auto& difficulty : columns) text += " " + difficulty + " |";
  text += " meaning |\n|---|---|";
  for (std::size_t i = 0; i < columns.size(); ++i) text += "---|";
  text += "---|\n";
  for (const auto& measure : measures()) {
    text += std::string("| ") + measure.name + " | " + cell(total(scores, measure, "")) + " |";
    for (const auto& difficulty : columns)
      text += " " + cell(total(scores, measure, difficulty)) + " |";
    text += std::string(" ") + measure.meaning + " |\n";
  }
  for (const auto& score : scores) add_failures_of(text, score);
  if (!unscored.empty()) text += "\n## Not scored\n\n";
  for (const auto& room : unscored) text += "- " + room.id + ": " + room.reason + "\n";
  return text;
}

}  // namespace roomgen::lab
