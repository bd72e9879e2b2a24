#include "improve.h"

#include <algorithm>
#include <optional>
#include <set>

#include "arrange.h"
#include "place.h"
#include "propose.h"
#include "quality.h"
#include "scene/judgement.h"
#include "score.h"
#include "trials.h"
#include "words.h"

namespace roomgen {

namespace {

constexpr double eject_pitch = 0.3;
// Rounds without gain before a new start.
constexpr int patience = 12;
// Rounds for one object before its wishes are given up.
constexpr int most_vain_tries = 4;
// What is drawn, and how often: by judgement, so that no round is always in vain.
constexpr double share_with_targets = 0.6;  // what a chosen thing relates to is put elsewhere too
constexpr double share_of_wishes = 0.7;     // those whose wishes may still be gained come before other trouble
constexpr double share_wishes_only = 0.5;   // only the wishes need hold where a thing is put by force
constexpr double burden_noise = 1.5;        // a thing in the way weighs 1 or 2: so chains differ

int constraints_of(const PlacementTask& task) {
  return static_cast<int>(task.object.relations.size());
}

int constraint_count(const std::vector<PlacementTask>& tasks) {
  int count = 0;
  for (const auto& task : tasks) count += constraints_of(task);
  return count;
}

int held_by(const Layout& layout, const Object& object) {
  return count_held(resolve(object, layout.room(), layout.objects(), layout.categories()), object,
                    layout.room());
}

// Its wishes alone, without what its kind usually likes.
PlacementTask with_wishes_only(PlacementTask task) {
  task.object.relations.resize(
      std::min(static_cast<std::size_t>(task.wishes), task.object.relations.size()));
  return task;
}

class Search {
 public:
  /// What `words` says stays where it is, or moves as little as can be if it `may_move_words`.
  Search(Layout& layout, const std::vector<PlacementTask>& tasks,
         std::map<std::string, std::string>& reasons, const ImproveOptions& options, Random& random,
         const Words* words = nullptr, bool may_move_words = false)
      : layout_(layout),
        tasks_(tasks),
        reasons_(reasons),
        options_(options),
        random_(random),
        words_(words),
        may_move_words_(may_move_words) {}

  int run() {
    State best = state(), current = best;
    const int wanted = constraint_count(tasks_);
    int round = 0, barren = 0;
    const int rounds = rounds_within_limit(options_.rounds, layout_.room().polygon.size(), layout_.wall_yaws().size());
    for (; round < rounds && !options_.cancel.cancelled(); ++round) {
      if (best.quality.placed == static_cast<int>(tasks_.size()) && best.quality.held == wanted)
        break;
      if (is_all_that_words_allow()) break;
      if (has_wishes_ && is_hopeless()) break;
      const bool start_anew = barren >= patience;
      // For a wish any number of habits may go.
      lost_allowed_ =
          start_anew || !wishes_fulfilled() ? wanted : wanted - current.quality.held;
      if (start_anew)
        put_elsewhere(everything(), 7);
      else if (round % 2 == 0)
        eject();
      else
        put_elsewhere(choose_ruin(), 1);
      if (options_.cancel.cancelled()) break;  // in the middle of a round
      const LayoutQuality now = measured();
      const bool gained = !current.quality.as_good_as(now);
      barren = start_anew || gained ? 0 : barren + 1;
      if (!gained && !start_anew) ++vain_tries_[chosen_];
      // Sideways steps lead out of dead ends, and so does a new start, however it ends.
      if (start_anew || now.as_good_as(current.quality))
        current = state();
      else
        restore(current);
      if (now.better_than(best.quality)) best = current;
    }
    restore(best);
    if (round == 0) return 0;
    if (may_move_words_) bring_back_words(best.quality);
    polish(layout_, tasks_, options_.place, options_.cancel, random_);
    return round;
  }

 private:
  struct State {
    std::vector<Object> objects;
    std::map<std::string, std::string> reasons;
    LayoutQuality quality;
  };

  State state() const {
    return {{layout_.objects().begin(), layout_.objects().end()}, reasons_, measured()};
  }

  LayoutQuality measured() const {
    LayoutQuality result = quality(layout_, tasks_);
    if (words_) result.displaced = words_->displaced(layout_);
    return result;
  }

  // Words move for what was asked for alone; while they stay, others move for anything.
  bool is_all_that_words_allow() const {
    if (!words_) return false;
    return may_move_words_ ? requirements_hold(layout_, tasks_)
                           : movable_that([this](const auto& task) { return is_troubled(task); }).empty();
  }

  void bring_back_words(const LayoutQuality& reached) {
    words_->bring_back(layout_, [&] {
      LayoutQuality now = measured();
      now.displaced = reached.displaced;
      return now.as_good_as(reached);
    });
  }

  // Touches only what moved.
  void restore(const State& state) {
    const auto same_pose = [](const Object& a, const Object& b) {
      return a.position == b.position && a.yaw == b.yaw;
    };
    std::vector<std::string> moved;
    for (const auto& object : layout_.objects()) {
      const Object* before = find_object(state.objects, object.id);
      if (!before || !same_pose(*before, object)) moved.push_back(object.id);
    }
    for (const auto& id : moved) layout_.remove(id);
    for (const auto& object : state.objects)
      if (!layout_.find(object.id)) layout_.add(object);
    reasons_ = state.reasons;
  }

  bool is_troubled(const PlacementTask& task) const {
    const Object* placed = layout_.find(task.object.id);
    return !placed || held_by(layout_, *placed) < static_cast<int>(task.object.relations.size());
  }

  bool lacks_wishes(const PlacementTask& task) const {
    if (!task.asked && task.wishes == 0) return false;
    const Object* placed = layout_.find(task.object.id);
    if (!placed) return task.asked;
    Object wishful = *placed;
    wishful.relations = with_wishes_only(task).object.relations;
    return held_by(layout_, wishful) < static_cast<int>(wishful.relations.size());
  }

  // Worth another try: some wishes contradict each other.
  bool may_gain_wishes(const PlacementTask& task) const {
    return !is_given_up(task.object.id) && lacks_wishes(task);
  }

  bool is_given_up(const std::string& id) const {
    const auto tries = vain_tries_.find(id);
    return tries != vain_tries_.end() && tries->second >= most_vain_tries;
  }

  bool wishes_fulfilled() const {
    return std::none_of(tasks_.begin(), tasks_.end(),
                        [this](const PlacementTask& task) { return may_gain_wishes(task); });
  }

  bool is_hopeless() const {
    return std::all_of(tasks_.begin(), tasks_.end(), [this](const PlacementTask& task) {
      return !is_troubled(task) || is_given_up(task.object.id);
    });
  }

  bool is_fixed(const std::string& id) const {
    const Object* placed = layout_.find(id);
    return placed && (placed->locked || (words_ && !may_move_words_ && words_->hold(id)));
  }

  std::set<std::string> everything() const {
    std::set<std::string> ids;
    for (const auto& task : tasks_)
      if (!is_fixed(task.object.id)) ids.insert(task.object.id);
    return ids;
  }

  std::set<std::string> choose_ruin() {
    std::set<std::string> ruin;
    const PlacementTask& chosen = choose_troubled();
    ruin.insert(chosen.object.id);
    for (const auto& relation : chosen.object.relations)
      if (layout_.find(relation.target) && random_.chance(share_with_targets)) ruin.insert(relation.target);
    for (int others = random_.integer(0, 3); others > 0; --others)
      ruin.insert(random_.pick(tasks_).object.id);
    add_dependants(ruin);
    std::erase_if(ruin, [this](const std::string& id) { return is_fixed(id); });
    return ruin;
  }

  // What stands in relation to a thing that moves must be placed anew.
  void add_dependants(std::set<std::string>& ruin) const {
    for (const auto& task : tasks_) {  // in placement order: one pass reaches all
      const Object& object = task.object;
      if (std::any_of(ruin.begin(), ruin.end(),
                      [&](const std::string& id) { return depends_on(object, id); }))
        ruin.insert(object.id);
    }
  }

  template <typename Test>
  std::vector<const PlacementTask*> movable_that(Test test) const {
    std::vector<const PlacementTask*> found;
    for (const auto& task : tasks_)
      if (!is_fixed(task.object.id) && test(task)) found.push_back(&task);
    return found;
  }

  // Those whose wishes are not fulfilled come first, mostly.
  const PlacementTask& choose_troubled() {
    auto troubled = movable_that([this](const auto& task) { return may_gain_wishes(task); });
    if (troubled.empty() || !random_.chance(share_of_wishes))
      troubled = movable_that([this](const auto& task) { return is_troubled(task); });
    const PlacementTask& chosen = troubled.empty() ? random_.pick(tasks_) : *random_.pick(troubled);
    chosen_ = chosen.object.id;
    return chosen;
  }

  // Gives a troubled object a pose where all its constraints hold, whoever stands there: those are
  // put elsewhere (an ejection chain).
  void eject() {
    const PlacementTask& task = choose_troubled();
    if (is_fixed(task.object.id)) return;
    const bool for_wishes = lacks_wishes(task) && random_.chance(share_wishes_only);
    layout_.remove(task.object.id);
    const auto pose = pose_with_least_in_the_way(for_wishes ? with_wishes_only(task) : task);
    std::set<std::string> ruin = {task.object.id};
    if (pose)
      for (const auto& id : in_the_way(task, *pose)) ruin.insert(id);
    add_dependants(ruin);
    std::erase_if(ruin, [this](const std::string& id) { return is_fixed(id); });
    for (const auto& id : ruin) layout_.remove(id);
    if (pose) {
      const auto candidate = layout_.candidate(at_pose(task.object, *pose));
      const Footprint area = footprint(candidate.object);
      if (layout_.fits(candidate, area, pose->bottom) && layout_.fits_exactly(candidate)) {
        layout_.add(candidate.object);
        reasons_.erase(task.object.id);
        ruin.erase(task.object.id);
      }
    }
    recreate(ruin);
  }

  std::vector<std::string> in_the_way(const PlacementTask& task, const Pose& pose) const {
    const auto candidate = layout_.candidate(at_pose(task.object, pose));
    const Footprint area = footprint(candidate.object);
    std::vector<std::string> ids;
    for (const auto& thing : layout_.things())
      if (layout_.collides(candidate, area, pose.bottom, thing)) ids.push_back(thing.object->id);
    return ids;
  }

  // What was asked for is harder to put elsewhere, since it may not be left out.
  double burden_of(const std::vector<std::string>& ids) const {
    double burden = 0.0;
    for (const auto& task : tasks_)
      if (std::find(ids.begin(), ids.end(), task.object.id) != ids.end())
        burden += task.asked ? 2.0 : 1.0;
    return burden;
  }

  std::optional<Pose> pose_with_least_in_the_way(const PlacementTask& task) {
    const auto context = make_context(
        layout_, task,
        resolve(task.object, layout_.room(), layout_.objects(), layout_.categories()), 1);
    const auto candidate = layout_.candidate(task.object);
    std::optional<Pose> best;
    double best_cost = 1e9;
    auto poses = propose_exact(context);
    if (!wants(context, RelationKind::edge)) {
      const auto grid = propose_grid(context, eject_pitch);
      poses.insert(poses.end(), grid.begin(), grid.end());
    }
    const FootprintAt footprint_at(task.object);
    for (const auto& pose : poses) {
      if (options_.cancel.cancelled()) return std::nullopt;
      const Footprint area = footprint_at(pose);
      if (!layout_.fits_room(candidate, area, pose.bottom)) continue;
      if (!holds_all(context, area, pose.bottom)) continue;
      const auto blockers = in_the_way(task, pose);
      const bool fixed = std::any_of(blockers.begin(), blockers.end(),
                                     [this](const std::string& id) { return is_fixed(id); });
      const double cost = burden_of(blockers) + burden_noise * random_.uniform();
      if (!fixed && cost < best_cost) best = pose, best_cost = cost;
    }
    return best;
  }

  // So that every constraint of the ruin holds, or else in a way that may lead there.
  void put_elsewhere(const std::set<std::string>& ruin, int tries) {
    std::vector<const PlacementTask*> moving;
    for (const auto& task : tasks_)
      if (ruin.count(task.object.id)) moving.push_back(&task);
    for (const auto& id : ruin) layout_.remove(id);
    ArrangeOptions arrange_options;
    arrange_options.pitch = 2.0 * options_.place.pitch;
    arrange_options.tries = tries;
    arrange_options.cancel = options_.cancel;
    if (!arrange(layout_, moving, arrange_options, random_)) return recreate(ruin);
    for (const auto& id : ruin) reasons_.erase(id);
  }

  void recreate(const std::set<std::string>& ruin) {
    int lost_allowed = lost_allowed_;
    for (const auto& task : tasks_) {
      const Object* kept = layout_.find(task.object.id);
      if (kept && !ruin.count(task.object.id))
        lost_allowed -= constraints_of(task) - held_by(layout_, *kept);
      else if (!ruin.count(task.object.id))
        lost_allowed -= constraints_of(task);
    }
    for (const auto& id : ruin) layout_.remove(id);
    PlaceOptions place_options = options_.place;
    place_options.cancel = options_.cancel;
    // Many rough rounds find more than few fine ones.
    place_options.grid = GridUse::last_resort;
    place_options.lookahead = random_.integer(1, std::max(1, options_.place.lookahead / 2));
    place_options.noise = options_.noise * random_.uniform();
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      const std::string& id = tasks_[i].object.id;
      if (!ruin.count(id)) continue;
      std::vector<PlacementTask> later;
      for (std::size_t j = i + 1; j < tasks_.size(); ++j)
        if (ruin.count(tasks_[j].object.id)) later.push_back(tasks_[j]);
      auto placed = place(layout_, tasks_[i], later, place_options, random_);
      if (placed) {
        layout_.add(placed->object);
        reasons_.erase(id);
      } else {
        reasons_[id] = placed.error().message;
      }
      // No use in going on once more is lost than before.
      lost_allowed -= placed ? placed->terms.lost : constraints_of(tasks_[i]);
      if (lost_allowed < 0) return;
    }
  }

  Layout& layout_;
  const std::vector<PlacementTask>& tasks_;
  std::map<std::string, std::string>& reasons_;
  const ImproveOptions& options_;
  Random& random_;
  const Words* words_;
  bool may_move_words_;
  bool has_wishes_ = std::any_of(tasks_.begin(), tasks_.end(), [](const PlacementTask& task) {
    return task.asked || task.wishes > 0;
  });
  std::string chosen_;                     ///< the troubled object of this round
  std::map<std::string, int> vain_tries_;  ///< rounds that gained nothing, by object
  int lost_allowed_ = 0;  ///< a round that loses more constraints is given up
};

}  // namespace

int improve(Layout& layout, const std::vector<PlacementTask>& tasks,
            std::map<std::string, std::string>& reasons, const ImproveOptions& options,
            Random& random) {
  if (tasks.empty() || options.mode == Improvement::off || !layout.has_way_in()) return 0;
  const Words words(layout, tasks);
  if (options.mode == Improvement::free || words.empty())
    return Search(layout, tasks, reasons, options, random).run();
  int rounds = Search(layout, tasks, reasons, options, random, &words).run();
  if (!requirements_hold(layout, tasks))
    rounds += Search(layout, tasks, reasons, options, random, &words, true).run();
  return rounds;
}

}  // namespace roomgen
