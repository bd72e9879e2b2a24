#include "roomgen/generate/room_builder.h"

#include <algorithm>
#include <utility>

#include "attempts.h"
#include "builder_steps.h"
#include "moves.h"
#include "order.h"
#include "patience.h"
#include "rugs.h"
#include "workplace.h"

namespace roomgen {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = RoomBuilder::Seconds;

Error cut_error(const CancelToken& all) {
  if (all.cancelled()) return {Error::Kind::cancelled, "stopped"};
  return {Error::Kind::limit, "the time for this step is over; nothing has changed"};
}

Error not_found(const std::string& what) { return {Error::Kind::not_found, what}; }

std::optional<Pose> pose_in(const BuildState& state, const std::string& id) {
  for (const auto& object : state.objects)
    if (object.id == id) return Pose{object.position.head<2>(), object.position.z(), object.yaw};
  return std::nullopt;
}

}  // namespace

struct RoomBuilder::Impl {
  explicit Impl(std::unique_ptr<Workplace> the_place)
      : place(std::move(the_place)), state(first_state(*place)) {}

  std::unique_ptr<Workplace> place;
  BuildState state;
  std::vector<BuildState> earlier;  ///< before each step
  std::future<void> abandoned;      ///< works in `place`; last, so that it ends before that goes

  /// A call at work on a state of its own.
  template <typename T>
  struct Job {
    BuildState state;
    std::optional<Result<T>> result;
  };

  /// Does the work on another thread, from the state as it is. Done or not, the state of the builder is the
  /// same afterwards; what the work made of its own is in the job, if it was done in time.
  template <typename T, typename Call>
  std::shared_ptr<Job<T>> work_on(const CancelToken& cancel, Call call) {
    if (abandoned.valid()) abandoned.wait();
    if (cancel.cancelled()) return nullptr;
    auto job = std::make_shared<Job<T>>(Job<T>{state, {}});
    std::future<void> work = std::async(std::launch::async, [this, job, cancel, call] {
      arrange_as(place->layout, job->state.objects);
      Work at{*place, job->state, cancel};
      job->result.emplace(call(at));
      const auto standing = place->layout.objects();
      job->state.objects.assign(standing.begin(), standing.end());
      job->state.models = place->models;
    });
    if (!is_done(work, cancel)) return abandoned = std::move(work), nullptr;
    work.get();
    return job;
  }

  CancelToken token(std::optional<Seconds> time) const {
    return time ? place->options.cancel.within(*time) : place->options.cancel;
  }

  void commit(BuildState next) {
    earlier.push_back(std::exchange(state, std::move(next)));
  }

  Scene scene() const { return scene_of(*place, state.objects); }

  void tell(BuildEvent event) const {
    if (!place->options.on_event) return;
    const Scene now = scene();
    event.total = planned_objects(place->plan).size();
    event.done = event.total - state.left.size();
    event.scene = &now;
    for (const auto& object : now.objects)
      if (event.kind == BuildEvent::Kind::placed && object.id == event.object)
        event.placed = &object;
    place->options.on_event(event);
  }

  /// The planned object of this id, unless it stands already.
  Result<PlannedObject> wanted(std::string_view id) const {
    for (const auto& object : state.objects)
      if (object.id == id)
        return Error{Error::Kind::invalid_input, "\"" + std::string(id) + "\" stands already"};
    for (const auto& planned : planned_objects(place->plan))
      if (planned.id == id) return planned;
    return not_found("\"" + std::string(id) + "\" is no object of the plan");
  }

  /// A step for one object: `call` tries to place it and fills the record.
  template <typename Call>
  Result<Step> step(const PlannedObject& planned, std::optional<Seconds> time, Call call) {
    const auto start = Clock::now();
    tell({BuildEvent::Kind::begun, 0, 0, planned.id});
    const CancelToken cancel = token(time);
    auto job = work_on<Step>(cancel, [planned, call](Work& work) -> Result<Step> {
      take_up(work.state, planned.id);
      work.state.reasons.erase(planned.id);
      Step step;
      step.planned = planned;
      step.category = work.item(planned).category;
      step.description = work.item(planned).description;
      if (auto status = call(work, step); !status) return status.error();
      settle_rugs(work, &step);
      return step;
    });
    if (!job || cancel.cancelled()) return cut_error(place->options.cancel);
    if (!*job->result) return job->result->error();
    Step step = **std::move(job->result);
    step.seconds = Seconds(Clock::now() - start).count();
    step.pose = pose_in(job->state, planned.id);
    step.moved = moves_between(state.objects, job->state.objects);
    record(step, std::move(job->state));
    return step;
  }

  void record(const Step& step, BuildState next) {
    if (!step.reason.empty()) next.reasons[step.planned.id] = step.reason;
    std::erase_if(next.trace,
                  [&](const Step& other) { return other.planned.id == step.planned.id; });
    next.trace.push_back(step);
    commit(std::move(next));
    BuildEvent event;
    event.kind = step.reason.empty() ? BuildEvent::Kind::placed : BuildEvent::Kind::left_out;
    event.object = step.planned.id;
    event.step = &step;
    tell(event);
  }
};

RoomBuilder::RoomBuilder(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RoomBuilder::RoomBuilder(RoomBuilder&&) noexcept = default;
RoomBuilder& RoomBuilder::operator=(RoomBuilder&&) noexcept = default;
RoomBuilder::~RoomBuilder() = default;

Result<RoomBuilder> RoomBuilder::begin(Plan plan, Designer& designer, const AssetLibrary& library,
                                       const KindTable& categories, BuildOptions options) {
  if (auto status = options.place.validate(); !status) return status.error();
  auto place =
      open_workplace(std::move(plan), designer, library, categories, std::move(options));
  if (!place) return place.error();
  return RoomBuilder(std::make_unique<Impl>(*std::move(place)));
}

Result<RoomBuilder> RoomBuilder::begin(const PlanRequest& request, Designer& designer,
                                       const AssetLibrary& library, const KindTable& categories,
                                       BuildOptions options) {
  auto plan = designer.plan(request);
  if (!plan) return plan.error();
  return begin(*std::move(plan), designer, library, categories, std::move(options));
}

const Plan& RoomBuilder::plan() const { return impl_->place->plan; }
const std::vector<PlannedObject>& RoomBuilder::left() const { return impl_->state.left; }
std::optional<PlannedObject> RoomBuilder::next() const { return next_of(impl_->state); }
const std::string& RoomBuilder::stopped() const { return impl_->state.stopped; }
Scene RoomBuilder::scene() const { return impl_->scene(); }
const ModelTable& RoomBuilder::models() const { return impl_->state.models; }
Generation RoomBuilder::generation() const { return outcome(*impl_->place, impl_->state); }
Status RoomBuilder::check_kind() const { return roomgen::check_kind(*impl_->place, impl_->state); }

Status RoomBuilder::choose(std::string_view id) {
  const auto& left = impl_->state.left;
  if (std::none_of(left.begin(), left.end(),
                   [&](const PlannedObject& planned) { return planned.id == id; }))
    return not_found("\"" + std::string(id) + "\" is not left to be placed");
  impl_->state.next = id;
  return {};
}

Result<Step> RoomBuilder::step(std::optional<Seconds> time) {
  const auto planned = next();
  if (!planned) return not_found("everything was tried");
  return impl_->step(*planned, time, [planned = *planned](Work& work, Step& step) -> Status {
    if (!work.category(planned).covers_window) return try_all(work, planned, step), Status();
    auto hanging = find_hanging(work, planned);
    if (!hanging) return step.reason = hanging.error().message, Status();
    step.window = hanging->window;
    hang_up(work, planned, *std::move(hanging));
    return {};
  });
}

Result<Proposal> RoomBuilder::propose(std::string_view id, std::size_t count,
                                      std::optional<Seconds> time) {
  const auto planned = impl_->wanted(id);
  if (!planned) return planned.error();
  const CancelToken cancel = impl_->token(time);
  auto job = impl_->work_on<Proposal>(cancel, [planned = *planned, count](Work& work) {
    take_up(work.state, planned.id);
    return propose_places(work, planned, count);
  });
  if (!job || cancel.cancelled()) return cut_error(impl_->place->options.cancel);
  return *std::move(job->result);
}

Result<Step> RoomBuilder::place(const Proposal& proposal, std::size_t choice) {
  if (choice >= proposal.places.size())
    return not_found("the proposal has no place " + std::to_string(choice));
  const auto planned = impl_->wanted(proposal.planned.id);
  if (!planned) return planned.error();
  return impl_->step(*planned, {}, [proposal, choice](Work& work, Step& step) {
    return take_place(work, proposal, choice, step);
  });
}

Result<Step> RoomBuilder::place(std::string_view id, const WantedPose& pose) {
  const auto planned = impl_->wanted(id);
  if (!planned) return planned.error();
  return impl_->step(*planned, {}, [planned = *planned, pose](Work& work, Step& step) {
    return put_at(work, planned, pose, step);
  });
}

Result<Step> RoomBuilder::place(std::string_view id, const PlaceAdvice& wish,
                                std::optional<Seconds> time) {
  const auto planned = impl_->wanted(id);
  if (!planned) return planned.error();
  return impl_->step(*planned, time, [planned = *planned, wish](Work& work, Step& step) {
    return put_by(work, planned, wish, step);
  });
}

Status RoomBuilder::refuse(std::string_view id, std::string reason) {
  const auto planned = impl_->wanted(id);
  if (!planned) return planned.error();
  Step step;
  step.planned = *planned;
  step.category = plan().items[planned->item].category;
  step.description = plan().items[planned->item].description;
  step.reason = reason.empty() ? "refused" : std::move(reason);
  BuildState next = impl_->state;
  take_up(next, planned->id);
  impl_->record(step, std::move(next));
  return {};
}

Status RoomBuilder::improve(std::optional<Seconds> time) {
  impl_->tell({BuildEvent::Kind::improving});
  const CancelToken cancel = impl_->token(time);
  auto job = impl_->work_on<bool>(cancel, [](Work& work) -> Result<bool> {
    improve_all(work, work.place.options.improve_rounds, work.place.options.improvement);
    settle_rugs(work, nullptr);
    return true;
  });
  if (!job) return cut_error(impl_->place->options.cancel);
  job->state.is_cut = cancel.cancelled();
  add_moves(moves_between(impl_->state.objects, job->state.objects), job->state.moved);
  impl_->commit(std::move(job->state));
  impl_->tell({BuildEvent::Kind::improved});
  return {};
}

std::size_t RoomBuilder::undo(std::size_t steps) {
  auto& earlier = impl_->earlier;
  const std::size_t count = std::min(steps, earlier.size());
  if (count == 0) return 0;
  const auto first = earlier.end() - static_cast<std::ptrdiff_t>(count);
  impl_->state = std::move(*first);
  earlier.erase(first, earlier.end());
  impl_->tell({BuildEvent::Kind::undone});
  return count;
}

}  // namespace roomgen
