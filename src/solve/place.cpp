#include "roomgen/solve/place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "propose.h"
#include "roomgen/base/text.h"
#include "score.h"

namespace roomgen {

namespace {

struct Scored {
  Pose pose;
  PlacementTerms terms;
};

bool is_excepted(const Object& object, const Pose& pose, const PlaceOptions& options) {
  return std::any_of(options.except.begin(), options.except.end(),
                     [&](const Pose& other) { return are_alike(object, pose, other); });
}

// The poses that pass the cheap tests, with their scores. Without a suggestion the constraints come
// first, and a pose that loses more of them than another is dropped as soon as that is known.
void score_feasible(const ProposalContext& context, const Layout::Candidate& candidate,
                    const std::vector<Pose>& poses, const PlaceOptions& options,
                    std::vector<Scored>& scored) {
  const FootprintAt footprint_at(context.task.object);
  int most_lost = std::numeric_limits<int>::max();
  for (const auto& pose : poses) {
    if (options.cancel.cancelled()) return;
    if (is_excepted(context.task.object, pose, options)) continue;
    const Footprint footprint = footprint_at(pose);
    if (!context.layout.fits(candidate, footprint, pose.bottom)) continue;
    const auto terms = score_relations(context, footprint, pose.bottom, most_lost);
    if (!terms) continue;
    scored.push_back({pose, *terms});
    // One more may be lost, so that something is left should the best fail the exact tests.
    if (!context.task.location) most_lost = std::min(most_lost, terms->lost + 1);
  }
}

bool one_holds_all(const std::vector<Scored>& scored) {
  return std::any_of(scored.begin(), scored.end(),
                     [](const Scored& s) { return s.terms.lost == 0; });
}

// Without a suggestion the number of lost constraints comes first, and the dearer terms are only
// asked of those that can win.
void add_general_terms(const ProposalContext& context, std::vector<Scored>& scored) {
  int least = std::numeric_limits<int>::max();
  for (const auto& s : scored) least = std::min(least, s.terms.lost);
  const FootprintAt footprint_at(context.task.object);
  for (auto& s : scored)
    if (context.task.location || s.terms.lost == least)
      add_general_terms(context, footprint_at(s.pose), s.pose.bottom, s.terms);
}

std::vector<std::size_t> rank(const ProposalContext& context, std::vector<Scored>& scored,
                              const PlaceOptions& options, Random& random) {
  const PlacementTask& task = context.task;
  add_general_terms(context, scored);
  std::vector<Ranked> ranked;
  ranked.reserve(scored.size());
  for (const auto& s : scored) {
    const double noise = options.noise > 0.0 ? options.noise * random.uniform() : 0.0;
    ranked.push_back({s.pose.position, s.terms.lost, total_degree(s.terms) + noise});
  }
  fuse(ranked, task.location, options.fusion);
  for (std::size_t i = 0; i < scored.size(); ++i) {
    scored[i].terms.rank_c = ranked[i].rank_c;
    scored[i].terms.rank_l = task.location ? ranked[i].rank_l : 0.0;
    scored[i].terms.fused = ranked[i].fused;
  }
  return order_of_choice(ranked);
}

int count_around(const PlacementTask& task, std::span<const Object> placed,
                 std::span<const PlacementTask> later) {
  int count = count_around(task.object, placed);
  for (const auto& other : later) count += count_around(task.object, {&other.object, 1}) - 1;
  return count;
}

// Places a task by the cheap tests alone where all its constraints hold, if it can.
bool place_roughly(Layout& layout, const PlacementTask& task,
                   std::span<const PlacementTask> later) {
  auto relations = resolve(task.object, layout.room(), layout.objects(), layout.categories());
  // What waits for a target of its own cannot be judged yet.
  std::erase_if(relations, [](const ResolvedRelation& r) { return r.targets.empty(); });
  const auto context =
      make_context(layout, task, std::move(relations), count_around(task, layout.objects(), later));
  const auto candidate = layout.candidate(task.object);
  const FootprintAt footprint_at(task.object);
  std::optional<Pose> best;
  double best_degree = 0.0;
  for (const auto& pose : propose_exact(context)) {
    const Footprint area = footprint_at(pose);
    if (!layout.fits(candidate, area, pose.bottom)) continue;
    if (!holds_all(context, area, pose.bottom)) continue;
    const double degree = total_degree(score(context, area, pose.bottom));
    if (!best || degree > best_degree) best = pose, best_degree = degree;
  }
  if (best) layout.add(at_pose(task.object, *best));
  return best.has_value();
}

// How many of the tasks that depend on an object just added, directly or through each other, do not
// find a place that holds all their constraints. The layout is left as it was. Counts no further
// than `limit`.
int count_homeless(Layout& layout, const std::string& id, std::span<const PlacementTask> later,
                   int limit) {
  int homeless = 0;
  std::vector<std::string> family = {id};
  for (const auto& task : later) {
    const bool related = std::any_of(family.begin(), family.end(), [&](const std::string& member) {
      return depends_on(task.object, member);
    });
    if (!related) continue;
    if (homeless >= limit) break;
    if (place_roughly(layout, task, later))
      family.push_back(task.object.id);
    else
      ++homeless;
  }
  for (std::size_t i = 1; i < family.size(); ++i) layout.remove(family[i]);
  return homeless;
}

std::string size_text(const Vec3& size) {
  return format_number(size.x(), 2) + " x " + format_number(size.y(), 2) + " x " +
         format_number(size.z(), 2) + " m";
}

// What is in the way at the suggested place, whichever way the object is turned there.
std::string blocked_by(const Layout& layout, const Layout::Candidate& candidate,
                       const Vec2& location) {
  const FootprintAt footprint_at(candidate.object);
  const double bottom = candidate.object.position.z();
  std::set<std::string> names;
  for (const double yaw : layout.wall_yaws()) {
    const Footprint footprint = footprint_at({location, bottom, yaw});
    if (!layout.fits_room(candidate, footprint, bottom))
      names.insert("a wall, a door or a window");
    for (const auto& thing : layout.things())
      if (layout.collides(candidate, footprint, bottom, thing)) names.insert(thing.object->id);
  }
  return join({names.begin(), names.end()}, ", ");
}

// Why nothing more goes onto a thing.
Error refusal_on(const Layout& layout, const Object& object) {
  std::string why = "no place for " + object.id + " (" + size_text(object.size) + ") on ";
  const Object* support = layout.find(object.on);
  if (!support) return {Error::Kind::not_found, why + (object.on.empty() ? "anything" : object.on) +
                                                    ": it is not in the room"};
  why += support->id + ": ";
  const auto& surfaces = layout.support_poses().surfaces(*support);
  const auto on_it = std::count_if(layout.objects().begin(), layout.objects().end(),
                                   [&](const Object& other) { return other.on == support->id; });
  if (surfaces.empty()) {
    why += "it has no level surface";
  } else if (layout.support_poses().everywhere(object, *support).empty()) {
    const Vec2 most = surfaces.front().box().size();
    why += "none of its surfaces is large and high enough; the largest is " +
           format_number(most.x(), 2) + " x " + format_number(most.y(), 2) + " m";
  } else if (on_it > 0) {
    why += "what stands there already (" + std::to_string(on_it) +
           (on_it == 1 ? " thing" : " things") + ") leaves no room";
  } else {
    why += "what stands around it is in the way";
  }
  return {Error::Kind::not_found, why};
}

Error refusal(const Layout& layout, const PlacementTask& task, const Layout::Candidate& candidate,
              int candidates, int feasible) {
  if (task.object.mount == Mount::surface) return refusal_on(layout, task.object);
  std::string why = "no place for " + task.object.id + " (" + size_text(task.object.size) + "): ";
  if (feasible == 0)
    why += "none of " + std::to_string(candidates) +
           " positions is inside the room and clear of doors, windows and other things";
  else
    why += "each of the " + std::to_string(feasible) +
           " clear positions would leave something unusable or out of reach";
  if (!task.location) return {Error::Kind::not_found, why};
  const std::string blockers = blocked_by(layout, candidate, *task.location);
  if (!blockers.empty()) why += "; in the way at the suggested place: " + blockers;
  return {Error::Kind::not_found, why};
}

// Walks through candidates in the order of choice and tests each on meshes and reachability. Near
// one that failed, others will probably fail too; near one that passed, others are no real
// alternative: both come after those elsewhere. Only when the first to pass ranks clearly below
// some that were put off are those tried before it: a fine grid, with many failures close together,
// must not be driven from a suggestion.
class Chooser {
 public:
  Chooser(Layout& layout, const PlacementTask& task, const std::vector<Scored>& scored,
          std::vector<std::size_t> order, const PlaceOptions& options)
      : layout_(layout),
        task_(task),
        scored_(scored),
        order_(std::move(order)),
        cancel_(options.cancel),
        tests_left_(options.max_exact_tests) {}

  /// The next candidate that passes, if any.
  std::optional<std::size_t> next() {
    while (next_ < order_.size() && may_test()) {
      const std::size_t i = order_[next_++];
      if (failures_near(i) >= 2 || is_like_one_passed(i)) {
        deferred_.push_back(i);
      } else if (passes(i)) {
        const auto better = first_deferred_that_passes(scored_[i].terms.fused + worth_going_back);
        if (better) --next_;
        return accepted(better.value_or(i));
      }
    }
    const auto last = first_deferred_that_passes(0.0);
    if (!last) return std::nullopt;
    return accepted(*last);
  }

 private:
  static constexpr double neighbourhood = 0.25;
  static constexpr double worth_going_back = 5e-5;  // of the fused sum: a rank at the top

  std::pair<int, int> cell(std::size_t i) const {
    const Vec2 index = (scored_[i].pose.position / neighbourhood).array().floor();
    return {static_cast<int>(index.x()), static_cast<int>(index.y())};
  }
  int failures_near(std::size_t i) const {
    const auto found = failures_.find(cell(i));
    return found == failures_.end() ? 0 : found->second;
  }
  bool is_like_one_passed(std::size_t i) const {
    return std::any_of(passed_.begin(), passed_.end(), [&](std::size_t j) {
      return are_alike(task_.object, scored_[i].pose, scored_[j].pose);
    });
  }
  std::size_t accepted(std::size_t i) {
    passed_.push_back(i);
    return i;
  }
  // Of those put off, while none has been accepted: the first above `bar` that passes.
  std::optional<std::size_t> first_deferred_that_passes(double bar) {
    while (passed_.empty() && next_deferred_ < deferred_.size() && may_test()) {
      const std::size_t i = deferred_[next_deferred_];
      if (scored_[i].terms.fused < bar) break;
      ++next_deferred_;
      if (passes(i)) return i;
    }
    return std::nullopt;
  }
  bool may_test() const { return tests_left_ > 0 && !cancel_.cancelled(); }
  bool passes(std::size_t i) {
    --tests_left_;
    const bool passed{
        layout_.fits_exactly(layout_.candidate(at_pose(task_.object, scored_[i].pose)))};
    if (!passed) ++failures_[cell(i)];
    return passed;
  }

  Layout& layout_;
  const PlacementTask& task_;
  const std::vector<Scored>& scored_;
  std::vector<std::size_t> order_, deferred_, passed_;
  std::map<std::pair<int, int>, int> failures_;
  std::size_t next_ = 0, next_deferred_ = 0;
  const CancelToken& cancel_;
  int tests_left_;
};

// The first candidate that passes; when others depend on the object, of the first few that pass the
// one that costs the fewest constraints, its own and those of dependants without a place.
std::optional<std::size_t> choose(Layout& layout, const PlacementTask& task,
                                  std::span<const PlacementTask> later,
                                  const std::vector<Scored>& scored,
                                  const std::vector<std::size_t>& order,
                                  const PlaceOptions& options) {
  Chooser chooser(layout, task, scored, order, options);
  const auto first = chooser.next();
  const bool has_dependants = std::any_of(
      later.begin(), later.end(),
      [&](const PlacementTask& other) { return depends_on(other.object, task.object.id); });
  if (!first || !has_dependants) return first;
  std::optional<std::size_t> best;
  int best_cost = 0;
  int tried = 0;
  for (auto i = first; i; i = chooser.next()) {
    layout.add(at_pose(task.object, scored[*i].pose));
    const int lost = scored[*i].terms.lost;
    const int limit = best ? std::max(0, best_cost - lost) : std::numeric_limits<int>::max();
    const int cost = lost + count_homeless(layout, task.object.id, later, limit);
    layout.remove(task.object.id);
    if (!best || cost < best_cost) best = i, best_cost = cost;
    if (cost <= scored[*first].terms.lost || ++tried >= options.lookahead) break;
  }
  return best;
}

// The grid is looked at coarsely first, so that the choice of a neighbourhood does not depend on
// the pitch that was asked for.
constexpr double coarse_pitch = 0.20;
// Metres about the suggested location that are looked at first.
constexpr double about_suggestion = 2.0;

// One object's way to its pose: from the poses that mean something over those near the suggestion
// to all of the grid, each step only if the one before does not settle it.
class Placing {
 public:
  Placing(Layout& layout, const PlacementTask& task, std::span<const PlacementTask> later,
          const PlaceOptions& options, Random& random)
      : layout_(layout),
        task_(task),
        later_(later),
        options_(options),
        random_(random),
        context_(
            make_context(layout, task,
                         resolve(task.object, layout.room(), layout.objects(), layout.categories()),
                         count_around(task, layout.objects(), later))),
        candidate_(layout.candidate(task.object)) {}

  Result<Placement> run() {
    add(propose_exact(context_));
    meaningful_ = scored_.size();
    if (meaningful_poses_are_enough()) decide();
    if (!best_ && options_.grid != GridUse::never) look_at_grid();
    if (options_.cancel.cancelled()) return Error{Error::Kind::cancelled, "stopped"};
    if (!best_) return refusal(layout_, task_, candidate_, proposed_, static_cast<int>(scored_.size()));
    return placement();
  }

 private:
  // Without a suggestion, a meaningful pose that holds everything needs no grid beside it, and no
  // grid point is flush with a wall.
  bool meaningful_poses_are_enough() const {
    if (options_.grid == GridUse::never) return true;
    if (options_.grid == GridUse::near_suggestions && task_.location) return false;
    return one_holds_all(scored_) || wants(context_, RelationKind::edge) ||
           wants(context_, RelationKind::corner);
  }

  void look_at_grid() {
    // Without a suggestion the meaningful poses are the fine ones.
    const double pitch = task_.location && options_.fusion.ordinal_ranks
                             ? options_.pitch
                             : std::max(coarse_pitch, options_.pitch);
    if (near_suggestion_may_be_enough()) {
      decide_with(propose_grid(context_, pitch, Disc{*task_.location, about_suggestion}));
      if (best_ && scored_[*best_].terms.lost > 0) best_.reset();
    }
    if (!best_) decide_with(propose_grid(context_, pitch));
    if (best_ && task_.location && options_.pitch < pitch) refine();
  }

  // Where everything holds near the suggestion, nothing farther away has a higher sum.
  bool near_suggestion_may_be_enough() const {
    return task_.location && !options_.fusion.ordinal_ranks && options_.fusion.alpha < 1.0;
  }

  // A suggestion is followed closely: once more about the choice, as finely as was asked.
  void refine() {
    const Disc part{scored_[*best_].pose.position, coarse_pitch};
    const auto coarse = scored_[*best_];
    add(propose_grid(context_, options_.pitch, part));
    decide(part);
    if (!best_) scored_.push_back(coarse), best_ = scored_.size() - 1;
  }

  void add(const std::vector<Pose>& poses) {
    proposed_ += static_cast<int>(poses.size());
    score_feasible(context_, candidate_, poses, options_, scored_);
  }

  void decide(const std::optional<Disc>& part = std::nullopt) {
    order_ = rank(context_, scored_, options_, random_);
    if (part)
      std::erase_if(order_, [&](std::size_t i) {
        return (scored_[i].pose.position - part->center).norm() > part->radius + 1e-9;
      });
    best_ = choose(layout_, task_, later_, scored_, order_, options_);
  }

  void decide_with(const std::vector<Pose>& grid) {
    scored_.resize(meaningful_);
    add(grid);
    decide();
  }

  Placement placement() const {
    Placement placement;
    placement.object = at_pose(task_.object, scored_[*best_].pose);
    placement.terms = scored_[*best_].terms;
    if (order_.size() > 1)
      placement.runner_up = scored_[order_[0] == *best_ ? order_[1] : order_[0]].terms;
    placement.candidates = proposed_;
    placement.feasible = static_cast<int>(scored_.size());
    return placement;
  }

  Layout& layout_;
  const PlacementTask& task_;
  std::span<const PlacementTask> later_;
  const PlaceOptions& options_;
  Random& random_;
  ProposalContext context_;
  Layout::Candidate candidate_;
  std::vector<Scored> scored_;
  std::size_t meaningful_ = 0;  ///< the first of scored_ that are no grid points
  std::vector<std::size_t> order_;
  std::optional<std::size_t> best_;
  int proposed_ = 0;
};

}  // namespace

Status PlaceOptions::validate() const {
  const auto error = [](const std::string& what) {
    return Error{Error::Kind::invalid_input, what};
  };
  if (!(fusion.alpha >= 0 && fusion.alpha <= 1)) return error("alpha must be between 0 and 1");
  if (!(fusion.c >= 1)) return error("the fusion constant must be at least 1");
  if (!(pitch >= 0.02 && pitch <= 1)) return error("the pitch must be between 0.02 and 1 m");
  return {};
}

Result<Placement> place(Layout& layout, const PlacementTask& task,
                        std::span<const PlacementTask> later, const PlaceOptions& options,
                        Random& random) {
  return Placing(layout, task, later, options, random).run();
}

}  // namespace roomgen
