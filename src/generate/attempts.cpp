#include "attempts.h"

#include <optional>

#include "amend.h"
#include "consult.h"
#include "objections.h"
#include "prepare.h"
#include "roomgen/base/text.h"
#include "solve/improve.h"
#include "solve/place.h"
#include "solve/refusal.h"

namespace roomgen {

namespace {

// How much smaller a thing gets where others make room for it, and in which steps.
constexpr double least_squeeze = 0.65;
constexpr double squeeze_step = 0.81;

// Where a small thing was asked for and found no room: others there make some, and it gets smaller.
bool squeeze_in(Work& work, PlacementTask& task) {
  if (!work.place.options.repair || !task.asked || task.object.mount != Mount::surface) return false;
  PlacementTask smaller = task;
  for (double factor = 1.0; factor >= least_squeeze && !work.cancel.cancelled();
       factor *= squeeze_step) {
    smaller.object.size = factor * task.object.size;
    if (!make_room(work.layout(), smaller, work.state.tasks, work.cancel, work.state.random)) continue;
    task = smaller;
    return true;
  }
  return false;
}

/// The attempts for one object.
struct Trial {
  const PlannedObject& planned;
  Step& step;
  EarlierAnswers earlier = {};
  std::optional<PlacementTask> first = {};  ///< as the first attempt had it
};

// The asset and the task as the designer amends the plan.
Result<AssetInfo> amended(Work& work, const PlannedObject& planned, const AssetInfo& asset, const PlaceAdvice& advice,
                          PlacementTask& task) {
  if (!amend(work, planned, advice)) return asset;
  AssetInfo taken = asset;
  if (advice.size) {
    const auto assets = assets_for(work, planned);
    if (!assets) return assets.error();
    if (!assets->empty()) taken = assets->front();
    if (taken.ref.procedural) taken.size = *advice.size;  // what is built may be stretched
  }
  auto anew = prepare(work, planned, taken);
  if (!anew) return anew.error();
  task = *std::move(anew);
  return taken;
}

// Whatever comes of it, the room may go on with the first answer.
Result<Attempt> second_answer(Work& work, const AssetInfo& asset, Trial& trial,
                              const Object& standing) {
  auto task = prepare(work, trial.planned, asset);
  if (!task) return task.error();
  EarlierAnswers earlier = trial.earlier;
  earlier.objections = trial.step.attempts.back().objections;
  earlier.standing_at = standing.position.head<2>();
  const std::string stopped = work.state.stopped;
  auto advice = consult(work, trial.planned, *task, earlier);
  work.state.stopped = stopped;
  if (!advice) return advice.error();
  if (advice->consultation.fell_back)
    return Error{Error::Kind::invalid_input, "the model had no second answer"};
  if (!advice->leave_out.empty() && !work.role_of(trial.planned.id)) return begun(asset, *advice);
  const auto not_moved = move_standing(work, advice->moves);
  const auto taken = amended(work, trial.planned, asset, *advice, *task);
  if (!taken) return taken.error();
  auto attempt =
      try_to_place(work, trial.planned, *taken, *advice, trial.earlier.refusals.size(), *task);
  if (attempt) attempt->objections = not_moved;
  return attempt;
}

// How many they are.
std::size_t add_objections(const Work& work, const Object& standing, Attempt& attempt) {
  const auto objections = objections_to(work.place, attempt.answer, standing);
  attempt.objections.insert(attempt.objections.end(), objections.begin(), objections.end());
  return objections.size();
}

// Who is asked again where a thing shall go that stands elsewhere learns what was in the way.
void explain(Work& work, const AssetInfo& asset, Trial& trial, const Object& standing) {
  Attempt& attempt = trial.step.attempts.back();
  constexpr double told_from = 0.3;  // metres
  const auto& said = attempt.answer.location;
  if (!said || standing.mount == Mount::surface ||
      (standing.position.head<2>() - *said).norm() < told_from)
    return;
  auto task = prepare(work, trial.planned, asset);
  if (!task) return;
  task->location = said;
  if (attempt.answer.yaw) task->facing = attempt.answer.yaw;
  const std::string why = why_not_there(work.layout(), with_companions(work, trial.planned, *task));
  if (!why.empty() && !attempt.objections.empty()) attempt.objections.back() += why;
}

bool is_of_model(const Consultation& asked) {
  return (asked.calls > 0 || !asked.prompt_sha256.empty()) && !asked.fell_back;
}

// Nothing of an answer is dropped silently: a model is told once what could not be followed, and
// the answer by which the thing itself stands better stays; what else is moved is moved by both.
void reconsider(Work& work, const AssetInfo& asset, Trial& trial) {
  Attempt& first = trial.step.attempts.back();
  const Object standing = *work.layout().find(trial.planned.id);
  const bool is_worth_it =
      !first.objections.empty() || is_worth_asking(work.place, first.answer, standing);
  const std::size_t lost = add_objections(work, standing, first);
  if (!is_worth_it || first.made_room || !is_of_model(first.answer.consultation)) return;
  BuildState before = work.state;
  const auto all = work.layout().objects();
  const std::vector<Object> stood(all.begin(), all.end());
  work.layout().remove(standing.id);
  disband(work, standing.id);
  explain(work, asset, trial, standing);
  auto second = second_answer(work, asset, trial, standing);
  const Object* moved = work.layout().find(standing.id);
  if (second && !moved && second->refused.empty()) {
    second->objections = move_standing(work, second->answer.moves);
    std::erase_if(work.state.tasks,
                  [&](const PlacementTask& task) { return task.object.id == standing.id; });
    trial.step.reason = "the designer left it out: " + second->answer.leave_out;
  } else if (moved && add_objections(work, *moved, *second) <= lost) {
    first.refused = "the answer after it is followed no less";
  } else {
    arrange_as(work.layout(), stood);
    before.model_use = work.state.model_use;
    work.state = std::move(before);
    if (second && moved) second->refused = "the answer before is followed more closely";
    if (second) second->objections = move_standing(work, second->answer.moves);
  }
  if (second) trial.step.attempts.push_back(*std::move(second));
}

// Of a group its anchor alone: what belongs to it is a question of its own.
void leave_out(Work& work, const std::string& why, const PlacementTask& task, Trial& trial) {
  trial.step.reason = "the designer left it out: " + why;
  if (begins_group(work, trial.planned)) fall_apart(work, trial.planned, task);
}

// An asset as the designer says. Whether that was the end: it stands, or nothing more can be tried.
bool try_asset(Work& work, const AssetInfo& offered, Trial& trial) {
  auto task = prepare(work, trial.planned, offered);
  if (!task) return trial.step.reason = task.error().message, true;
  const auto advice = consult(work, trial.planned, *task, trial.earlier);
  if (!advice) return trial.step.reason = advice.error().message, true;
  const auto not_moved = move_standing(work, advice->moves);
  if (!advice->leave_out.empty()) {
    trial.step.attempts.push_back(begun(offered, *advice));
    trial.step.attempts.back().objections = not_moved;
    return leave_out(work, advice->leave_out, *task, trial), true;
  }
  const auto asset = amended(work, trial.planned, offered, *advice, *task);
  if (!asset) return trial.step.reason = asset.error().message, true;
  auto attempt =
      try_to_place(work, trial.planned, *asset, *advice, trial.earlier.refusals.size(), *task);
  if (!attempt) return trial.step.reason = attempt.error().message, true;
  attempt->objections = not_moved;
  if (!trial.first) trial.first = *std::move(task);
  trial.step.attempts.push_back(*std::move(attempt));
  const std::string& refused = trial.step.attempts.back().refused;
  trial.earlier.answers.push_back(*advice);
  if (refused.empty()) return reconsider(work, *asset, trial), true;
  trial.earlier.refusals.push_back(refused +
                                   (not_moved.empty() ? "" : "; " + join(not_moved, "; ")));
  return false;
}

// Where the finish may move nothing, a repair still does, as little as can be.
Improvement repairing(const Work& work) {
  const Improvement mode = work.place.options.improvement;
  return mode == Improvement::off ? Improvement::minimal : mode;
}

// Neighbours make way for an object that found no place.
void repair(Work& work, const AssetInfo& asset, const Trial& trial) {
  const PlannedObject& planned = trial.planned;
  enter(work, planned, asset, *trial.first);
  work.state.reasons[planned.id] = trial.earlier.refusals.back();
  if (work.place.options.repair)
    improve_all(work, work.place.options.repair_rounds, repairing(work));
  trial.step.repaired = work.layout().find(planned.id) != nullptr;
  if (trial.step.repaired) return;
  work.state.hopeless_items.insert(planned.item);
  trial.step.reason = trial.earlier.refusals.back();
}

void try_assets(Work& work, const std::vector<AssetInfo>& assets, Trial& trial) {
  // When one of a kind found no place after all, the next ones are not worth the same pains.
  const bool brief = work.state.hopeless_items.count(trial.planned.item) > 0;
  const int answers = brief ? 1 : work.place.options.answers_per_object;
  for (int answer = 0; answer < answers; ++answer) {
    const std::size_t count = answer == 0 && !brief ? assets.size() : 1;
    for (std::size_t a = 0; a < count; ++a)
      if (work.cancel.cancelled() || try_asset(work, assets[a], trial)) return;
  }
  if (begins_group(work, trial.planned)) {
    fall_apart(work, trial.planned, *trial.first);
    trial.earlier = {};
    trial.first.reset();
    return try_assets(work, assets, trial);
  }
  if (brief)
    trial.step.reason = trial.earlier.refusals.back();
  else
    repair(work, assets.front(), trial);
}

}  // namespace

Attempt begun(const AssetInfo& asset, const PlaceAdvice& answer) {
  Attempt attempt;
  attempt.asset = asset_key(asset.ref);
  attempt.answer = answer;
  return attempt;
}

void note(const Placement& placement, Attempt& attempt) {
  attempt.candidates = placement.candidates;
  attempt.feasible = placement.feasible;
  attempt.chosen = placement.terms;
  attempt.runner_up = placement.runner_up;
}

namespace {

Result<Placement> place_with_its_own(Work& work, const PlannedObject& planned, PlacementTask& task,
                                     const PlaceOptions& options) {
  if (begins_group(work, planned)) return place_with_group(work, planned, task, options);
  return place(work.layout(), task, {}, options, work.state.random);
}

// Just where it was said.
PlaceOptions insisting(const Work& work, const PlacementTask& task) {
  constexpr double just_there = 0.05;  // metres
  PlaceOptions options = work.place_options();
  options.even_useless = true;
  options.accepts = [at = *task.location](const Pose& pose) {
    return (pose.position - at).norm() <= just_there;
  };
  return options;
}

}  // namespace

Result<Attempt> try_to_place(Work& work, const PlannedObject& planned, const AssetInfo& asset,
                             const PlaceAdvice& advice, std::size_t refused, PlacementTask& task) {
  if (auto status = follow(work, advice, planned, refused, task); !status) return status.error();
  Attempt attempt = begun(asset, advice);
  auto placed = place_with_its_own(work, planned, task, work.place_options());
  // What is said again is meant, even if nobody can use it there.
  if (!placed && refused > 0 && task.location && !advice.usual) {
    placed = place_with_its_own(work, planned, task, insisting(work, task));
    if (placed)
      work.place.plan.notes.push_back(planned.id + " stands where the designer put it again; there it, or what is near, cannot be used as usual");
  }
  if (placed) {
    note(*placed, attempt);
    work.layout().add(placed->object);
    enter(work, planned, asset, task);
  } else if (PlacementTask smaller = task; squeeze_in(work, smaller)) {
    attempt.made_room = true;
    enter(work, planned, asset, std::move(smaller));
  } else {
    attempt.refused = placed.error().message;
  }
  return attempt;
}

void try_all(Work& work, const PlannedObject& planned, Step& step) {
  if (take_place_in_group(work, planned, step)) return;
  const auto assets = assets_for(work, planned);
  if (!assets) {
    step.reason = assets.error().message;
  } else if (assets->empty()) {
    step.reason = why_no_asset(work.item(planned));
  } else {
    step.has_assets = true;
    Trial trial{planned, step};
    try_assets(work, *assets, trial);
  }
}

void improve_all(Work& work, int rounds, Improvement mode) {
  ImproveOptions options;
  options.mode = mode;
  options.place = work.place.options.place;
  options.rounds = rounds;
  options.cancel = work.cancel;
  improve(work.layout(), work.state.tasks, work.state.reasons, options, work.state.random);
}

}  // namespace roomgen
