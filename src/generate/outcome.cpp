#include <algorithm>
#include <cmath>
#include <set>

#include "builder_steps.h"
#include "design/asset_text.h"
#include "evaluate/attributes.h"
#include "evaluate/ledger.h"
#include "library/attribute_words.h"
#include "library/qualifiers.h"
#include "moves.h"
#include "objections.h"
#include "roomgen/base/text.h"
#include "scene/judgement.h"
#include "rugs.h"
#include "told.h"

namespace roomgen {

namespace {

// Things in the order of the plan, and what is missing.
void list_objects(const Workplace& place, const BuildState& state, Scene& scene) {
  for (const auto& planned : planned_objects(place.plan)) {
    if (const Object* placed = find_object(state.objects, planned.id)) {
      scene.objects.push_back(with_rounded_pose(*placed));
      // Of a group that was locked while it was built.
      if (!placed->group.empty()) scene.objects.back().locked = false;
      continue;
    }
    const auto reason = state.reasons.find(planned.id);
    scene.unplaced.push_back(
        {planned.id, place.plan.items[planned.item].category,
         reason == state.reasons.end() ? "stopped before it was tried" : reason->second});
  }
}

// The assets of what stands, each once, and what is not the thing itself.
void list_assets(const Workplace& place, const BuildState& state, Generation& result) {
  result.assets = place.joinery;
  std::set<std::string> seen;
  for (const auto& object : result.scene.objects) {
    const AssetInfo& asset = state.assets.at(object.id);
    if (seen.insert(asset_key(asset.ref)).second) result.assets.push_back(asset);
    if (asset.approximate)
      result.notes.push_back(object.id + " is approximate: \"" + object.category +
                             "\" is no kind that is known, and it was put together from the words");
    if (object.stand_in)
      result.notes.push_back("no model of \"" + object.category + "\": " + object.id + " is a plain stand-in of " +
                             size_text(object.size) + " m");
  }
}

// What else a thing is than the plan says; empty: nothing.
std::string other_kind(const PlanItem& item, const AssetInfo& asset) {
  const Vocabulary& vocabulary = Vocabulary::built_in();
  const std::string own = own_name(item.category, item.description).kind;
  const std::string asked = vocabulary.understand(item.category).kind;
  // What has the parts that were said is what was asked for, whatever it is called.
  const bool is_so =
      asset.category == item.category || asset.approximate || asset.stand_in ||
      vocabulary.fit(asset.category, own) + vocabulary.fit(asset.category, asked) > 0.0 ||
      !AttributeWords::built_in().need_of(asset.category).empty();
  return is_so ? "" : "a " + asset.category + ", for there is no such " + item.category;
}

bool is_other_than_chosen(const PlanItem& item, AssetInfo asset) {
  asset.ref.tilt.setZero();
  return !item.asset.empty() && !item.varied && asset_key(asset.ref) != item.asset;
}

// Once for things of one item that differ alike.
void tell_differences(const Workplace& place, const BuildState& state, Generation& result) {
  std::set<std::pair<std::size_t, std::string>> told;
  for (const auto& planned : planned_objects(place.plan)) {
    const Object* placed = find_object(state.objects, planned.id);
    if (!placed) continue;
    const PlanItem& item = place.plan.items[planned.item];
    const AssetInfo& asset = state.assets.at(planned.id);
    std::string text = other_kind(item, asset);
    if (text.empty()) text = other_size(place, state, planned, *placed);
    if (text.empty() && is_other_than_chosen(item, asset))
      text = design::told_looks(asset) + ", for what was chosen found no place";
    if (!text.empty() && told.emplace(planned.item, text).second)
      result.notes.push_back(planned.id + " is " + text);
  }
}

// A place that a model, a person or an edit gave; what stands in rows has one by the plan.
bool is_of_somebody(const PlacementTask& task) { return task.binding && !task.usual; }

// What stands elsewhere than it was said, in the end.
void tell_what_stands_elsewhere(const BuildState& state, const std::set<std::string>& moved,
                                Generation& result) {
  constexpr double elsewhere = 0.5;
  for (const auto& step : state.trace) {
    const Object* object = roomgen::find_object(result.scene, step.planned.id);
    if (!object) continue;
    const Said said = said_of(state, step);
    const double away =
        said.location ? (object->position.head<2>() - *said.location).norm() : 0.0;
    if (const auto other = other_carrier(state, step, state.objects); !other.empty())
      result.notes.push_back(object->id + other);
    else if (away > elsewhere && !moved.count(object->id))
      result.notes.push_back(object->id + " stands " + format_number(away, 2) +
                             " m from its place");
  }
}

// Whatever of a designer's word is not so in the end.
void tell_what_was_not_followed(const BuildState& state, Generation& result) {
  for (const auto& task : state.tasks) {
    const std::string& id = task.object.id;
    const Step* step = is_of_somebody(task) ? step_of(state, id) : nullptr;
    if (!step || !find_object(state.objects, id)) continue;
    for (const auto& attempt : step->attempts)
      if (attempt.refused.empty() && !attempt.objections.empty())
        result.notes.push_back(id + " is not all as it was said: " + join(attempt.objections, "; "));
  }
  constexpr double least_told = 0.005;  // metres
  std::vector<Move> moves;
  for (const auto& step : state.trace) add_moves(step.moved, moves);
  add_moves(state.moved, moves);
  std::erase_if(moves, [&](const Move& move) {
    return move.distance() < least_told || state.rugs.count(move.object) > 0;
  });
  std::set<std::string> moved;
  for (const auto& move : moves)
    for (const auto& task : state.tasks)
      if (is_of_somebody(task) && task.object.id == move.object && moved.insert(move.object).second)
        result.notes.push_back(move.object + " was moved by " + format_number(move.distance(), 2) +
                               " m after it was placed, for what was asked for");
  tell_what_stands_elsewhere(state, moved, result);
}

std::vector<RequirementVerdict> verdicts(const Workplace& place, const Generation& result) {
  return check_requirements(
      place.plan.requirements, result.scene, place.categories,
      [&](const Object& object, const std::string& word) {
        return judge_attribute(known_looks(object, result.models), word);
      },
      [&](const Object& object) {
        const auto model = result.models.find(asset_key(object.asset));
        return model ? std::cbrt(object.size.prod() / bounds(*model).size().cwiseMax(1e-4).prod()) : 1.0;
      });
}

// How far an object ended from where it was suggested.
void count_suggestions(const PlacementTask& task, const Object& placed, const Step* step,
                       SuggestionFigures& figures) {
  if (!is_of_somebody(task)) return;
  if (task.location && !is_in_row(step)) {
    const Vec2 ended = placed.position.head<2>();
    const Vec2 first = step && step->pose ? step->pose->position : ended;
    ++figures.located;
    for (std::size_t i = 0; i < figures.within.size(); ++i) {
      const double most = SuggestionFigures::thresholds[i];
      figures.within[i] += (ended - *task.location).norm() <= most ? 1 : 0;
      figures.placed_within[i] += (first - *task.location).norm() <= most ? 1 : 0;
    }
  }
  if (task.facing) {
    ++figures.faced;
    figures.facing_kept +=
        std::abs(wrap_angle(placed.yaw - *task.facing)) <= facing_tolerance ? 1 : 0;
  }
}

void count_constraints(const Workplace& place, const BuildState& state, Generation& result) {
  for (const auto& task : state.tasks) {
    result.constraints += static_cast<int>(task.object.relations.size());
    if (const Object* placed = roomgen::find_object(result.scene, task.object.id))
      count_suggestions(task, *placed, step_of(state, task.object.id), result.suggestions);
  }
  for (const auto& verdict : judge_scene(result.scene, place.categories))
    result.held += verdict.judgement.held ? 1 : 0;
}

}  // namespace

Generation outcome(const Workplace& place, const BuildState& state) {
  Generation result;
  result.scene = scene_of(place, {});
  result.scene.incomplete = !state.left.empty() || !state.stopped.empty() || state.is_cut ||
                            place.options.cancel.cancelled();
  const auto& notes = place.plan.notes;
  result.notes.assign(notes.begin() + static_cast<std::ptrdiff_t>(place.notes_given), notes.end());
  result.models = state.models;
  result.trace = state.trace;
  result.choices = place.choices;
  if (!place.choices.empty()) result.chosen = {place.plan};
  result.moved = state.moved;
  result.model_use = state.model_use;
  result.stopped = state.stopped;
  list_objects(place, state, result.scene);
  lay_rugs(place, state, result);
  list_assets(place, state, result);
  tell_differences(place, state, result);
  tell_what_was_not_followed(state, result);
  result.scene.requirements = verdicts(place, result);
  result.scene.heard = place.plan.heard;
  count_constraints(place, state, result);
  return result;
}

}  // namespace roomgen
