#include "any_plan.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "options.h"
#include "roomgen/base/file.h"
#include "roomgen/import/import.h"

namespace roomgen::cli {

Result<PlanRequest> request_of(const PlanWish& wish, const CancelToken& cancel) {
  PlanRequest request;
  request.prompt = wish.prompt;
  request.seed = wish.seed;
  request.pictures = wish.pictures;
  request.cancel = cancel;
  if (!wish.size.empty()) {
    auto size = parse_size(wish.size);
    if (!size) return size.error();
    request.size = *size;
  }
  if (!wish.floor_plan.empty()) {
    auto room = read_floor_plan(wish.floor_plan);
    if (!room) return room.error();
    request.room = *std::move(room);
  }
  return request;
}

Result<AnyPlan> make_plan(const PlanWish& wish, Designer& designer, const CancelToken& cancel,
                          Reader* reader) {
  auto request = request_of(wish, cancel);
  if (!request) return request.error();
  if (reader)
    if (auto read = reader->read(*request); !read) return read.error();
  auto dwelling = plan_dwelling(*request, designer);
  if (!dwelling) return dwelling.error();
  if (*dwelling) return AnyPlan(**std::move(dwelling));
  auto plan = designer.plan(*request);
  if (!plan) return plan.error();
  return AnyPlan(*std::move(plan));
}

Error told_with_least_size(const Error& error, const PlanWish& wish, const AnyPlan* plan,
                           const AssetLibrary& library, const BuildOptions& options) {
  auto request = request_of(wish, options.cancel);
  if (error.kind != Error::Kind::too_small || !request) return error;
  if (plan) {
    const Plan* room = std::get_if<Plan>(plan);
    if (!room) return error;
    request->size = bounds(room->room.polygon).size();
  } else {
    const auto dwelling = plan_dwelling(*request, *make_rule_designer());
    if (!dwelling || *dwelling) return error;
  }
  return with_least_size(error, *request, library, KindTable::built_in(), options);
}

Result<AnyPlan> read_any_plan(const std::string& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  const auto json = parse_json(*text, file);
  if (!json) return json.error();
  if (is_dwelling_plan(*json)) {
    auto plan = dwelling_plan_from_json(*json, file);
    if (!plan) return plan.error();
    settle(*plan);
    return AnyPlan(*std::move(plan));
  }
  auto plan = plan_from_json(*json, file);
  if (!plan) return plan.error();
  settle(*plan);
  return AnyPlan(*std::move(plan));
}

Json plan_json(const AnyPlan& plan) {
  return std::visit([](const auto& each) { return to_json(each); }, plan);
}

Json plan_json(AnyPlan plan, const Generation& generation) {
  auto* dwelling = std::get_if<DwellingPlan>(&plan);
  if (!generation.chosen.empty() && dwelling) dwelling->rooms = generation.chosen;
  if (!generation.chosen.empty() && !dwelling) plan = generation.chosen.front();
  return plan_json(plan);
}

std::vector<std::string> notes_of(const AnyPlan& plan) {
  auto notes = std::visit([](const auto& each) { return each.notes; }, plan);
  if (const auto* dwelling = std::get_if<DwellingPlan>(&plan))
    for (const auto& room : dwelling->rooms)
      for (const auto& note : room.notes) notes.push_back(room.room.id + ": " + note);
  return notes;
}

}  // namespace roomgen::cli
