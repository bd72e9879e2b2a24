#include "validate.h"

#include <algorithm>
#include <cmath>

#include "alignment.h"
#include "search.h"

namespace roomgen::create {

namespace {

using namespace detail;

constexpr std::size_t problems_a_round = 16;
constexpr int changes_a_round = 12;

class Repair {
 public:
  Repair(State state, const std::vector<Link>& links, const ValidateOptions& options)
      : state_(std::move(state)), links_(links), options_(options) {}

  void run() {
    if (options_.footing == Footing::ground) settle(floor_level(state_.assembly, links_));
    const int most = options_.rounds * changes_a_round;
    for (int change = 0; change < most && !state_.judgement.perfect(); ++change)
      if (!improve()) break;
    if (options_.footing == Footing::ground) settle(state_.judgement.standing.low);
  }

  const State& state() const { return state_; }
  const std::vector<std::string>& repairs() const { return repairs_; }

 private:
  void settle(double level) {
    if (std::abs(level) < 1e-5) return;
    shift_level(state_.assembly, level);
    state_.judgement = judge(state_.assembly, links_, options_);
    repairs_.push_back("set on the floor");
  }

  // The first problem that can be made smaller is.
  bool improve() {
    if (attempt([](Trials& trials) { try_alignment(trials); })) return true;
    if (!state_.judgement.grounded && attempt([](Trials& trials) { try_lifting(trials); }))
      return true;
    const auto to_close = links_to_close(state_, links_);
    for (std::size_t k = 0; k < std::min(to_close.size(), problems_a_round); ++k)
      if (attempt([&](Trials& trials) { try_closing(trials, to_close, k); })) return true;
    return !state_.judgement.stable && options_.footing == Footing::ground &&
           attempt([](Trials& trials) { try_steadying(trials); });
  }

  template <typename Try>
  bool attempt(const Try& try_changes) {
    Trials trials(state_, links_, options_);
    try_changes(trials);
    const std::string what = trials.what();
    auto best = std::move(trials).best();
    if (!best) return false;
    state_ = *std::move(best);
    repairs_.push_back(what);
    return true;
  }

  State state_;
  const std::vector<Link>& links_;
  const ValidateOptions& options_;
  std::vector<std::string> repairs_;
};

}  // namespace

Result<Soundness> inspect(const shape::Program& program, const ValidateOptions& options) {
  const auto assembly = Assembly::make(program, options.contact);
  if (!assembly) return assembly.error();
  const auto links =
      options.as_drawn ? std::vector<Link>() : connection_map(*assembly, options.footing);
  return soundness(*assembly, links, judge(*assembly, links, options), options);
}

Result<Validation> validate(const shape::Program& program, const ValidateOptions& options) {
  const auto assembly = Assembly::make(program, options.contact);
  if (!assembly) return assembly.error();
  const auto links = connection_map(*assembly, options.footing);
  const State start{*assembly, judge(*assembly, links, options)};
  Validation result;
  result.program = program;
  result.before = result.after = soundness(*assembly, links, start.judgement, options);
  if (start.judgement.perfect()) return result;
  Repair repair(start, links, options);
  repair.run();
  if (!repair.state().judgement.no_worse_than(start.judgement)) return result;
  result.program = repair.state().assembly.program();
  result.repairs = repair.repairs();
  result.after = soundness(repair.state().assembly, links, repair.state().judgement, options);
  return result;
}

}  // namespace roomgen::create
