#include "attempts.h"
#include "builder_steps.h"
#include "consult.h"
#include "fits_as_it_is.h"
#include "prepare.h"
#include "solve/place.h"

namespace roomgen {

namespace {

Result<Proposal> propose_hanging(Work& work, Proposal proposal) {
  auto hanging = find_hanging(work, proposal.planned);
  if (!hanging) {
    proposal.refusal = hanging.error().message;
    return proposal;
  }
  proposal.asset = hanging->asset;
  proposal.window = hanging->window;
  proposal.task.object = hanging->object;
  proposal.places.push_back({hanging->object, {}, {}, 1, 1});
  return proposal;
}

// Each one the best that is not like those before.
void add_places(Work& work, std::size_t count, Proposal& proposal) {
  PlaceOptions options = work.place_options();
  while (proposal.places.size() < count) {
    auto placed = place(work.layout(), proposal.task, {}, options, work.state.random);
    if (!placed) {
      if (proposal.places.empty()) proposal.refusal = placed.error().message;
      return;
    }
    const Object& object = placed->object;
    options.except.push_back({object.position.head<2>(), bottom(object), object.yaw});
    proposal.places.push_back(*std::move(placed));
  }
}

// What somebody chose is their word.
PlacementTask chosen_by_host(PlacementTask task, const Object& chosen) {
  task.location = chosen.position.head<2>();
  task.facing = chosen.yaw;
  task.usual = false;
  task.binding = true;
  return task;
}

}  // namespace

Result<Proposal> propose_places(Work& work, const PlannedObject& planned, std::size_t count) {
  Proposal proposal;
  proposal.planned = planned;
  if (work.category(planned).covers_window) return propose_hanging(work, std::move(proposal));
  const auto assets = assets_for(work, planned);
  if (!assets) return assets.error();
  if (assets->empty()) {
    proposal.refusal = why_no_asset(work.item(planned));
    return proposal;
  }
  proposal.asset = assets->front();
  auto task = prepare(work, planned, proposal.asset);
  if (!task) return task.error();
  auto answer = consult(work, planned, *task, {});
  if (!answer) return answer.error();
  if (auto status = follow(work, *answer, planned, 0, *task); !status)
    proposal.refusal = status.error().message;
  proposal.task = *std::move(task);
  proposal.answer = *std::move(answer);
  if (proposal.refusal.empty()) add_places(work, count, proposal);
  return proposal;
}

Status take_place(Work& work, const Proposal& proposal, std::size_t choice, Step& step) {
  const Placement& chosen = proposal.places[choice];
  if (auto status = fetch_model(work.place, proposal.asset); !status) return status;
  if (auto status = fits_as_it_is(work.layout(), chosen.object); !status) return status;
  work.state.next = proposal.answer.next;
  step.window = proposal.window;
  if (!proposal.window.empty()) {
    hang_up(work, proposal.planned, {chosen.object, proposal.asset, proposal.window});
    return {};
  }
  step.has_assets = true;
  note(chosen, step.attempts.emplace_back(begun(proposal.asset, proposal.answer)));
  work.layout().add(chosen.object);
  enter(work, proposal.planned, proposal.asset, chosen_by_host(proposal.task, chosen.object));
  return {};
}

}  // namespace roomgen
