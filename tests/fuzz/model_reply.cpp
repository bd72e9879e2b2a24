// What a model may answer: plans, places, programs, meshes, verdicts. What is taken from it is sound.
#include <nlohmann/json.hpp>

#include "brief/prompt.h"
#include "brief/said_wish.h"
#include "bytes.h"
#include "create/maker_replies.h"
#include "lab/compose/model_author.h"
#include "design/place_reply.h"
#include "design/plan_reply.h"

namespace {

using namespace roomgen;
using namespace roomgen::lab;

void read_plan(const std::string& text) {
  static const PlanRequest request = [] {
    PlanRequest made;
    made.prompt = "a bedroom with a desk";
    return made;
  }();
  static const brief::Brief brief =
      brief::read_prompt(request.prompt, *brief::built_in_room_kinds(), KindTable::built_in());
  const auto reply = design::read_plan_reply(text, request, brief, KindTable::built_in());
  if (reply) must(plan_from_json(to_json(reply->plan), "plan.json").ok());
}

void read_wish(const std::string& text) {
  const auto json = parse_json(text, "answer");
  if (!json) return;
  const auto& kinds = *brief::built_in_room_kinds();
  const auto reading = brief::wish_from_json(*json, "two red chairs at a desk and a lamp on each desk", kinds, KindTable::built_in());
  for (const auto& words : reading.wish.brief.heard) must(words.tokens.begin < words.tokens.end && words.tokens.end <= reading.wish.brief.tokens.size());
}

void read_place(const std::string& text) {
  static const Scene scene = [] {
    Scene made;
    made.room.polygon.points = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    return made;
  }();
  static const Object desk = [] {
    Object made;
    made.id = "desk-0", made.category = "desk", made.size = {1.2, 0.6, 0.75};
    return made;
  }();
  const auto reply = design::read_place_reply(text, {scene, desk});
  if (!reply) must(!reply.error().message.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedBytes bytes{data, size};
  const auto which = bytes.choice(6);
  const std::string text(bytes.text());
  switch (which) {
    case 0:
      read_plan(text);
      break;
    case 1:
      read_place(text);
      break;
    case 2:
      (void)compose::read_program_answer(text, {}, KindTable::built_in());
      break;
    case 3:
      read_wish(text);
      break;
    case 4:
      (void)create::read_mesh_reply(text, "stool");
      break;
    default:
      (void)create::read_verdict_reply(text);
  }
  return 0;
}
