#include "arrange.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "propose.h"
#include "refusal.h"
#include "score.h"

namespace roomgen {

namespace {

// Things have a depth: how many were placed by the search before them. Sets of depths are bit
// vectors.
using Depths = std::vector<bool>;
constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

std::optional<std::size_t> deepest(const Depths& depths) {
  for (std::size_t i = depths.size(); i-- > 0;)
    if (depths[i]) return i;
  return std::nullopt;
}

void unite(Depths& into, const Depths& from) {
  for (std::size_t i = 0; i < into.size(); ++i) into[i] = into[i] || from[i];
}

// 1, 1, 2, 1, 1, 2, 4, 1, … for i = 1, 2, …
int luby(int i) {
  int power = 1;
  while (2 * power - 1 < i) power *= 2;
  return 2 * power - 1 == i ? power : luby(i - power + 1);
}

// A pose at which all constraints of a thing hold.
struct Option {
  Pose pose;
  double degree = 0.0;
  std::size_t taken_at = nowhere;  // depth of what stands in its way
};

// A thing that is to be placed.
struct Member {
  const PlacementTask* task = nullptr;
  std::vector<std::size_t> targets;  // members that its constraints name
  int around = 1;
  // Points of the grid that the room allows, found when first needed.
  std::optional<std::vector<Pose>> grid;
  std::size_t depth = nowhere;
  // What remains for it, known as soon as all its targets are placed; a sample where there is
  // plenty.
  std::size_t known_at = nowhere;
  std::vector<Option> domain;
  bool is_sample = false;
  Depths culprits;  // whoever took something from the domain before it was known, and its targets
};

// A thing's turn in the search.
struct Turn {
  std::size_t member = 0;
  std::vector<Option> choices;  // best first
  std::size_t next = 0;
  bool grid_is_left = false;
  std::vector<Pose> tried;
  Depths culprits;  // whoever must move if no choice leads on
};

class LayoutSearch {
 public:
  LayoutSearch(Layout& layout, std::span<const PlacementTask* const> tasks,
              const ArrangeOptions& options, Random& random)
      : layout_(layout), options_(options), random_(random), settled_(layout.objects().size()) {
    for (const auto* task : tasks) members_.push_back(member_of(*task, tasks));
  }

  bool run() {
    const int unit = 20 + 3 * static_cast<int>(members_.size());
    for (int k = 0; k < options_.tries && !options_.cancel.cancelled(); ++k) {
      noise_ = k == 0 && options_.first_without_noise ? 0.0 : options_.noise;
      const Outcome outcome = search(unit * luby(k + 1));
      if (outcome != Outcome::gave_up) return outcome == Outcome::done;
    }
    return false;
  }

 private:
  enum class Outcome { done, impossible, gave_up };

  Outcome search(int steps) {
    if (members_.empty()) return Outcome::done;
    if (look_ahead()) return Outcome::impossible;
    begin_turn();
    for (; steps > 0 && !options_.cancel.cancelled(); --steps) {
      const auto object = next_object(turns_.back());
      if (object) make(*object);
      // Whoever must move, if this leads nowhere.
      const auto culprits = object ? look_ahead() : turns_.back().culprits;
      if (culprits) {
        if (!go_back(*culprits)) break;
      } else if (turns_.size() == members_.size()) {
        turns_.clear();
        return Outcome::done;
      } else {
        begin_turn();
      }
    }
    unmake_from(0);
    turns_.clear();
    return Outcome::gave_up;
  }

  // Another turn for the last culprit; its other choices must fail on the rest of them, too.
  bool go_back(Depths culprits) {
    const auto last = deepest(culprits);
    if (!last) return false;
    culprits[*last] = false;
    unmake_from(*last);
    unite(turns_.back().culprits, culprits);
    return true;
  }

  Member member_of(const PlacementTask& task, std::span<const PlacementTask* const> tasks) const {
    Member member;
    member.task = &task;
    member.around = count_around(task.object, layout_.objects());
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const Object& other = tasks[i]->object;
      member.around += count_around(task.object, {&other, 1}) - 1;
      if (depends_on(task.object, other.id)) member.targets.push_back(i);
    }
    return member;
  }

  bool is_ready(const Member& member) const {
    return member.depth == nowhere &&
           std::all_of(member.targets.begin(), member.targets.end(),
                       [&](std::size_t i) { return members_[i].depth != nowhere; });
  }

  ProposalContext context_of(const Member& member) const {
    auto relations =
        resolve(member.task->object, layout_.room(), layout_.objects(), layout_.categories());
    std::stable_sort(relations.begin(), relations.end(),
                     [](const ResolvedRelation& a, const ResolvedRelation& b) {
                       return cost(a.kind) < cost(b.kind);
                     });
    return make_context(layout_, *member.task, std::move(relations), member.around);
  }

  // What is quickly judged and rarely holds comes first.
  static int cost(RelationKind kind) {
    switch (kind) {
      case RelationKind::middle:
        return 3;
      case RelationKind::edge:
      case RelationKind::corner:
        return 2;
      case RelationKind::near:
      case RelationKind::next_to:
      case RelationKind::far:
      case RelationKind::gap:
      case RelationKind::around:
        return 1;
      default:
        return 0;
    }
  }

  void make(Object object) {
    members_[turns_.back().member].depth = turns_.size() - 1;
    layout_.add(std::move(object));
  }

  // Takes away what was placed at `depth` and deeper, whose turn it is again.
  void unmake_from(std::size_t depth) {
    turns_.resize(depth + 1);
    while (layout_.objects().size() > settled_ + depth) {
      const std::string id = layout_.objects().back().id;
      layout_.remove(id);
    }
    for (auto& member : members_) {
      if (member.depth != nowhere && member.depth >= depth) member.depth = nowhere;
      if (member.known_at != nowhere && member.known_at > depth) member.known_at = nowhere;
      for (auto& choice : member.domain)
        if (choice.taken_at != nowhere && choice.taken_at >= depth) choice.taken_at = nowhere;
    }
  }

  // Brings what remains for each thing up to date. Whoever must move if nothing remains for one of
  // them.
  std::optional<Depths> look_ahead() {
    for (auto& member : members_) {
      if (!is_ready(member)) continue;
      if (member.known_at == nowhere)
        learn(member);
      else if (!turns_.empty())
        take_what_is_covered(member);
      if (remaining(member) == 0 && member.is_sample) learn(member);
      if (remaining(member) > 0) continue;
      Depths culprits = member.culprits;
      for (const auto& choice : member.domain)
        if (choice.taken_at != nowhere) culprits[choice.taken_at] = true;
      return culprits;
    }
    return std::nullopt;
  }

  static std::size_t remaining(const Member& member) {
    return static_cast<std::size_t>(
        std::count_if(member.domain.begin(), member.domain.end(),
                      [](const Option& choice) { return choice.taken_at == nowhere; }));
  }

  void learn(Member& member) {
    member.known_at = layout_.objects().size() - settled_;
    member.culprits.assign(members_.size(), false);
    for (std::size_t target : member.targets) member.culprits[members_[target].depth] = true;
    const auto context = context_of(member);
    member.domain = allowed(context, propose_exact(context), Asked::all, member.culprits);
    if (member.domain.size() < few && may_stand_anywhere(context)) {
      const auto more = allowed(context, grid_of(member, context), Asked::things, member.culprits);
      member.domain.insert(member.domain.end(), more.begin(), more.end());
    }
    member.is_sample = member.domain.size() > plenty;
    thin(member.domain, plenty);
  }

  // Leaves at most `count`, evenly chosen.
  static void thin(std::vector<Option>& choices, std::size_t count) {
    if (choices.size() <= count) return;
    for (std::size_t i = 0; i < count; ++i) choices[i] = choices[i * choices.size() / count];
    choices.resize(count);
  }

  void take_what_is_covered(Member& member) {
    const FloorThing& newcomer = layout_.things().back();
    const auto candidate = layout_.candidate(member.task->object);
    const FootprintAt footprint_at(member.task->object);
    const double reach =
        0.5 * (member.task->object.size.head<2>().norm() + newcomer.object->size.head<2>().norm());
    for (auto& choice : member.domain)
      if (choice.taken_at == nowhere &&
          (choice.pose.position - newcomer.footprint.center()).squaredNorm() < reach * reach &&
          layout_.collides(candidate, footprint_at(choice.pose), choice.pose.bottom, newcomer))
        choice.taken_at = turns_.size() - 1;
  }

  const std::vector<Pose>& grid_of(Member& member, const ProposalContext& context) const {
    if (member.grid) return *member.grid;
    member.grid = propose_grid(context, options_.pitch);
    const auto candidate = layout_.candidate(member.task->object);
    const FootprintAt footprint_at(member.task->object);
    std::erase_if(*member.grid, [&](const Pose& pose) {
      const Footprint area = footprint_at(pose);
      return !layout_.fits_room(candidate, area, pose.bottom) ||
             !holds_all(context, area, pose.bottom, Asked::room);
    });
    return *member.grid;
  }

  static bool may_stand_anywhere(const ProposalContext& context) {
    return !wants(context, RelationKind::edge) && !wants(context, RelationKind::corner);
  }

  // The poses where the cheap tests pass and all constraints hold. Of those where they would hold
  // were the place free, the first thing in the way is noted: going back to it helps most.
  std::vector<Option> allowed(const ProposalContext& context, const std::vector<Pose>& poses,
                              Asked asked, Depths& culprits) const {
    std::vector<Option> choices;
    const auto candidate = layout_.candidate(context.task.object);
    const FootprintAt footprint_at(context.task.object);
    for (const auto& pose : poses) {
      if (options_.cancel.cancelled()) break;
      const Footprint area = footprint_at(pose);
      if (!holds_all(context, area, pose.bottom, asked) ||
          (asked == Asked::all && !layout_.fits_room(candidate, area, pose.bottom)))
        continue;
      const auto blocker = first_in_the_way(candidate, area, pose.bottom);
      if (blocker && *blocker < settled_) continue;
      if (blocker)
        culprits[*blocker - settled_] = true;
      else
        choices.push_back({pose});
    }
    return choices;
  }

  std::optional<std::size_t> first_in_the_way(const Layout::Candidate& candidate,
                                              const Footprint& area, double bottom) const {
    const auto things = layout_.things();
    for (std::size_t k = 0; k < things.size(); ++k)
      if (layout_.collides(candidate, area, bottom, things[k])) return k;
    return std::nullopt;
  }

  // The turn is that of the thing with the least left (Haralick and Elliott 1980: fail first).
  void begin_turn() {
    std::size_t least = nowhere;
    Turn turn;
    for (std::size_t i = 0; i < members_.size(); ++i) {
      if (!is_ready(members_[i])) continue;
      const std::size_t left = remaining(members_[i]);
      if (left < least) least = left, turn.member = i;
    }
    const Member& member = members_[turn.member];
    turn.culprits.assign(members_.size(), false);
    for (std::size_t target : member.targets) turn.culprits[members_[target].depth] = true;
    const auto context = context_of(member);
    turn.grid_is_left = may_stand_anywhere(context);
    add_choices(context, propose_exact(context), Asked::all, turn);
    turns_.push_back(std::move(turn));
  }

  void add_choices(const ProposalContext& context, const std::vector<Pose>& poses, Asked asked,
                   Turn& turn) {
    auto choices = allowed(context, poses, asked, turn.culprits);
    thin(choices, most_scored);
    const FootprintAt footprint_at(context.task.object);
    for (auto& choice : choices) {
      const double noise = noise_ > 0.0 ? noise_ * random_.uniform() : 0.0;
      choice.degree =
          total_degree(score(context, footprint_at(choice.pose), choice.pose.bottom),
                       layout_.weights()) +
          noise;
    }
    std::stable_sort(choices.begin(), choices.end(),
                     [](const Option& a, const Option& b) { return a.degree > b.degree; });
    turn.choices.insert(turn.choices.end(), choices.begin(), choices.end());
  }

  // The next choice that passes the exact tests too; the points of the grid come after the poses
  // with a meaning.
  std::optional<Object> next_object(Turn& turn) {
    auto object = next_among_choices(turn);
    if (object || !turn.grid_is_left) return object;
    turn.grid_is_left = false;
    Member& member = members_[turn.member];
    const auto context = context_of(member);
    add_choices(context, grid_of(member, context), Asked::things, turn);
    return next_among_choices(turn);
  }

  std::optional<Object> next_among_choices(Turn& turn) {
    const Object& object = members_[turn.member].task->object;
    while (turn.next < turn.choices.size() &&
           static_cast<int>(turn.tried.size()) < options_.choices) {
      const Pose& pose = turn.choices[turn.next++].pose;
      const bool known = std::any_of(turn.tried.begin(), turn.tried.end(), [&](const Pose& other) {
        return are_alike(object, pose, other);
      });
      if (known) continue;
      turn.tried.push_back(pose);
      const auto candidate = layout_.candidate(at_pose(object, pose));
      const auto verdict = layout_.fits_exactly(candidate);
      if (verdict) return candidate.object;
      for (std::size_t blamed : verdict.blamed)
        if (blamed >= settled_) turn.culprits[blamed - settled_] = true;
      if (verdict.blamed.empty() && turns_.size() > 1) turn.culprits[turns_.size() - 2] = true;
    }
    return std::nullopt;
  }

  static constexpr std::size_t few = 4;
  static constexpr std::size_t plenty = 100;
  static constexpr std::size_t most_scored = 500;

  Layout& layout_;
  const ArrangeOptions& options_;
  Random& random_;
  double noise_ = 0.0;
  std::size_t settled_;  // things of the layout that were there before
  std::vector<Member> members_;
  std::vector<Turn> turns_;
};

}  // namespace

bool arrange(Layout& layout, std::span<const PlacementTask* const> tasks,
             const ArrangeOptions& options, Random& random) {
  const auto is_useless = [&](const PlacementTask* task) { return needs_way_in(layout, *task); };
  if (!layout.has_way_in() && std::any_of(tasks.begin(), tasks.end(), is_useless)) return false;
  return LayoutSearch(layout, tasks, options, random).run();
}

}  // namespace roomgen
