#include <array>
#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"
#include "roomgen/generate/generate.h"

namespace roomgen {

namespace {

Json terms_json(const PlacementTerms& terms) {
  Json json = {{"held", terms.held},
          {"lost", terms.lost},
          {"relations", rounded(terms.relations)},
          {"rest", rounded(terms.rest)},
          {"walkway", rounded(terms.walkway)},
          {"spread", rounded(terms.spread)},
          {"evenness", rounded(terms.evenness)},
          {"closeness", rounded(terms.closeness)},
          {"arrangement", rounded(terms.arrangement)},
          {"rank_c", rounded(terms.rank_c)},
          {"rank_l", rounded(terms.rank_l)},
          {"fused", rounded(terms.fused, 8)}};
  if (terms.off > 0.0) json["off"] = rounded(terms.off);
  return json;
}

Json point_json(const Vec3& point) {
  return {rounded(point.x()), rounded(point.y()), rounded(point.z())};
}

// Null for rules.
Json consultation_json(const Consultation& consultation) {
  if (consultation.calls == 0 && consultation.notes.empty()) return nullptr;
  return {{"calls", consultation.calls},
          {"input_tokens", consultation.input_tokens},
          {"output_tokens", consultation.output_tokens},
          {"prompt_sha256", consultation.prompt_sha256},
          {"image_sha256", consultation.image_sha256},
          {"notes", consultation.notes},
          {"fell_back", consultation.fell_back}};
}

Json advice_json(const PlaceAdvice& advice) {
  Json json;
  json["reasoning"] = advice.reasoning;
  json["constraints"] = to_text(advice.relations);
  json["location"] =
      advice.location ? Json{rounded(advice.location->x()), rounded(advice.location->y())} : Json();
  json["usual"] = advice.usual;
  if (advice.spread) json["spread"] = true;
  json["facing_deg"] = advice.yaw ? Json(rounded(degrees(*advice.yaw), 2)) : Json();
  return json;
}

Json attempt_json(const Attempt& attempt) {
  Json json;
  json["asset"] = attempt.asset;
  json["answer"] = advice_json(attempt.answer);
  if (Json asked = consultation_json(attempt.answer.consultation); !asked.is_null())
    json["model"] = std::move(asked);
  if (attempt.chosen) {
    json["candidates"] = attempt.candidates;
    json["feasible"] = attempt.feasible;
    json["chosen"] = terms_json(*attempt.chosen);
    if (attempt.runner_up) json["runner_up"] = terms_json(*attempt.runner_up);
  }
  if (attempt.made_room) json["made_room"] = true;
  if (!attempt.objections.empty()) json["objections"] = attempt.objections;
  if (!attempt.refused.empty()) json["refused"] = attempt.refused;
  return json;
}

Json choice_json(const AssetChoice& choice, const ChoiceRound& round) {
  static constexpr std::array<const char*, 4> names = {"", "search", "make", "leave out"};
  const auto kind = static_cast<std::size_t>(choice.kind);
  Json json = {{"take", kind == 0 ? round.offers[choice.offer].label(choice.asset) : names[kind]}};
  if (!choice.words.empty()) json["words"] = choice.words;
  if (choice.size) json["size"] = point_json(*choice.size);
  if (!choice.paint.empty()) json["paint"] = choice.paint;
  if (!choice.reason.empty()) json["why"] = choice.reason;
  return json;
}

Json making_json(const ChoiceRound& round) {
  Json things = Json::array();
  for (std::size_t i = 0; i < round.making.size(); ++i) {
    const ThingToMake& thing = round.making[i];
    things.push_back({{"item", thing.offer.id},
                      {"items", thing.offer.items},
                      {"words", thing.offer.words},
                      {"size", point_json(thing.offer.size)},
                      {"notes", thing.notes}});
    if (const auto program = parse_json(thing.program, "")) things.back()["program"] = *program;
    if (!round.taken[i].empty()) things.back()["taken"] = round.taken[i];
  }
  return things;
}

Json pose_json(const Pose& pose) {
  return {{"position", point_json({pose.position.x(), pose.position.y(), pose.bottom})},
          {"yaw_deg", rounded(degrees(pose.yaw), 2)}};
}

}  // namespace

Json to_json(const Move& move) {
  return {{"object", move.object},
          {"from", point_json(move.from)},
          {"to", point_json(move.to)},
          {"by", rounded(move.distance(), 3)},
          {"turned_deg", rounded(degrees(move.turn), 2)}};
}

Json to_json(const ChoiceRound& round) {
  Json offered = Json::array();
  for (std::size_t i = 0; i < round.offers.size(); ++i) {
    const AssetOffer& offer = round.offers[i];
    Json json = {{"item", offer.id},
                 {"items", offer.items},
                 {"words", offer.words},
                 {"assets", Json::array()}};
    for (const auto& one : offer.assets) json["assets"].push_back(asset_key(one.asset.ref));
    if (i < round.taken.size() && !round.taken[i].empty()) json["taken"] = round.taken[i];
    offered.push_back(std::move(json));
  }
  for (const auto& choice : round.answer.choices)
    offered[choice.offer]["answer"] = choice_json(choice, round);
  Json json = round.making.empty() ? Json{{"choice", std::move(offered)}}
                                   : Json{{"making", making_json(round)}};
  if (Json asked = consultation_json(round.answer.consultation); !asked.is_null())
    json["model"] = std::move(asked);
  if (!round.notes.empty()) json["notes"] = round.notes;
  if (!round.room.empty()) json["room"] = round.room;
  return json;
}

Json to_json(const Step& step) {
  Json json;
  json["object"] = step.planned.id;
  json["asked"] = {{"category", step.category}, {"description", step.description}};
  if (!step.window.empty()) json["window"] = step.window;
  if (step.has_assets) json["attempts"] = Json::array();
  for (const auto& attempt : step.attempts) json["attempts"].push_back(attempt_json(attempt));
  if (step.pose) json["pose"] = pose_json(*step.pose);
  if (step.repaired) json["repaired"] = true;
  if (!step.moved.empty()) json["moved"] = Json::array();
  for (const auto& move : step.moved) json["moved"].push_back(to_json(move));
  json["outcome"] = step.reason.empty() ? "placed" : "unplaced";
  if (!step.reason.empty()) json["reason"] = step.reason;
  if (!step.room.empty()) json["room"] = step.room;
  return json;
}

}  // namespace roomgen
