#include "chain.h"

namespace roomgen {

namespace {

// Poses drawn for a thing that must make way.
constexpr int most_draws = 40;
// Things that make way for one.
constexpr int most_in_the_way = 3;

Pose in_room(std::span<const Movable> movables, const Ensemble& ensemble, std::size_t i, const Pose& local) {
  const auto& anchor = movables[i].anchor;
  if (!anchor) return local;
  return from_frame(local, ensemble.footprint(*anchor), ensemble.base(*anchor), movables[i].task.object.mount);
}

Pose in_frame(std::span<const Movable> movables, const Ensemble& ensemble, std::size_t i, const Pose& pose) {
  const auto& anchor = movables[i].anchor;
  if (!anchor) return pose;
  return to_frame(pose, ensemble.footprint(*anchor), ensemble.base(*anchor), movables[i].task.object.mount);
}

}  // namespace

Chain::Chain(std::span<const Movable> movables, Ensemble& ensemble, ChainState& state)
    : movables_(movables), ensemble_(ensemble), state_(state), loose_(movables.size(), false) {
  for (std::size_t i = 0; i < movables.size(); ++i) {
    ensemble.put(i, state.poses[i]);
    if (!movables[i].fixed && movables[i].domain.size() > 0) free_.push_back(i);
  }
  if (!state.local.empty()) return;
  for (std::size_t i = 0; i < movables.size(); ++i)
    state.local.push_back(in_frame(movables, ensemble, i, ensemble.pose(i)));
}

bool Chain::stands() {
  loose_.assign(movables_.size(), false);
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < movables_.size(); ++i) {
    if (!settles(i)) return false;
    all.push_back(i);
  }
  return ensemble_.is_sound(all);
}

bool Chain::step() {
  if (free_.empty()) return false;
  moved_.clear(), local_before_.clear();
  loose_.assign(movables_.size(), false);
  const std::size_t leader = state_.random.pick(free_);
  if (lead(leader) && followers_find_places(leader) && ensemble_.is_sound(moved_)) return true;
  undo();
  return false;
}

const Poses& Chain::poses() {
  for (std::size_t i = 0; i < movables_.size(); ++i) state_.poses[i] = ensemble_.pose(i);
  return state_.poses;
}

// What it is placed by stays where it is, so its constraints can be asked at once.
bool Chain::lead(std::size_t leader) {
  remember(leader);
  put_local(leader, draw(leader));
  return ensemble_.fits_room(leader) && takes_along(leader) && ensemble_.holds(leader);
}

// All whose place follows from that of the leader or of what is in its way.
bool Chain::takes_along(std::size_t leader) {
  for (std::size_t i : movables_[leader].dependants) loose_[i] = true;
  int in_the_way = 0;
  for (std::size_t i = 0; i < movables_.size(); ++i) {
    if (i == leader || loose_[i] || !ensemble_.collides(leader, i)) continue;
    if (movables_[i].fixed || ++in_the_way > most_in_the_way) return false;
    loose_[i] = true;
    for (std::size_t follower : movables_[i].dependants) loose_[follower] = true;
  }
  return !loose_[leader];
}

bool Chain::followers_find_places(std::size_t leader) {
  for (std::size_t i = 0; i < movables_.size(); ++i)
    if (i != leader && loose_[i] && !finds_place(i)) return false;
  return true;
}

// Along with its anchor, or where it is, or else anywhere.
bool Chain::finds_place(std::size_t follower) {
  remember(follower);
  const Movable& movable = movables_[follower];
  const int draws = movable.fixed || movable.domain.size() == 0 ? 0 : most_draws;
  put_local(follower, state_.local[follower]);
  for (int k = 0; !settles(follower); ++k) {
    if (k == draws) return false;
    put_local(follower, draw(follower));
  }
  loose_[follower] = false;
  return true;
}

void Chain::put_local(std::size_t i, const Pose& local) {
  state_.local[i] = local;
  ensemble_.put(i, in_room(movables_, ensemble_, i, local));
}

// Beside everything whose place is known.
bool Chain::settles(std::size_t i) {
  for (std::size_t j = 0; j < movables_.size(); ++j)
    if (j != i && !loose_[j] && ensemble_.collides(i, j)) return false;
  return ensemble_.fits_room(i) && ensemble_.holds(i);
}

const Pose& Chain::draw(std::size_t i) {
  const Domain& domain = movables_[i].domain;
  const bool meaningful = domain.grid.empty() || (!domain.meaningful.empty() && state_.random.chance(0.5));
  return state_.random.pick(meaningful ? domain.meaningful : domain.grid);
}

void Chain::remember(std::size_t i) {
  moved_.push_back(i);
  local_before_.push_back(state_.local[i]);
}

// Anchors come first.
void Chain::undo() {
  for (std::size_t k = 0; k < moved_.size(); ++k)
    put_local(moved_[k], local_before_[k]);
}

}  // namespace roomgen
