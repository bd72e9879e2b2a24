#include <algorithm>
#include <set>

#include "handles.h"
#include "search.h"

namespace roomgen::create::detail {

namespace {

constexpr double widest = 0.6;  ///< added to the base's width
constexpr std::size_t most_movers = 12;

class Steadying {
 public:
  explicit Steadying(Trials& trials) : trials_(trials), assembly_(trials.from().assembly) {
    const auto& parts = assembly_.parts();
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (trials.from().judgement.level[k] == 0) ground_.insert(parts[k].source.front());
    }
  }

  void try_all() {
    reach_floor();
    for (double factor : {0.15, 0.3, 0.45, widest}) widen_base(factor);
    const Standing& standing = trials_.from().judgement.standing;
    const Vec2 way = standing.centre_of_mass - standing.centre_of_ground;
    for (double part : {0.35, 0.6, 1.0}) move_base(part * way);
    move_heavy(-way);
  }

 private:
  void widen_base(double factor) {
    Assembly trial = assembly_;
    for (std::size_t top : ground_)
      pull(trial, {Handle::Kind::widen, {top}}, Eigen::VectorXd::Constant(1, factor));
    trials_.consider(std::move(trial), "the base widened");
  }

  static bool move(Assembly& trial, std::size_t top, const Vec2& way) {
    std::vector<Wish> wishes;
    for (std::size_t k = 0; k < trial.parts().size(); ++k)
      if (trial.parts()[k].source.front() == top) wishes.push_back({k, 0, {way.x(), way.y(), 0}});
    const Handle handle{Handle::Kind::move, {top}};
    const auto amounts = solve(trial, handle, wishes);
    return amounts && pull(trial, handle, *amounts);
  }

  void move_base(const Vec2& way) {
    Assembly trial = assembly_;
    for (std::size_t top : ground_) move(trial, top, way);
    trials_.consider(std::move(trial), "the base moved under the centre of mass");
  }

  // Each by itself, the heaviest first, over what it stands on.
  void move_heavy(const Vec2& way) {
    std::vector<double> volumes(assembly_.program().components.size(), 0.0);
    std::vector<std::size_t> order;
    double all = 0.0;
    for (const auto& part : assembly_.parts()) {
      if (volumes[part.source.front()] == 0.0) order.push_back(part.source.front());
      volumes[part.source.front()] += part.volume + 1e-9;
      all += part.volume + 1e-9;
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return volumes[a] > volumes[b]; });
    if (order.size() > most_movers) order.resize(most_movers);
    for (std::size_t top : order)
      for (double part : {0.35, 0.6, 1.0}) {
        if (ground_.count(top) || trials_.exhausted()) continue;
        const Vec2 needed = part * all / volumes[top] * way;
        Assembly trial = assembly_;
        if (needed.norm() < 2.0 && move(trial, top, needed))
          trials_.consider(std::move(trial), "moved over what it stands on");
      }
  }

  // Feet and bases in the air.
  void reach_floor() {
    std::vector<Link> floating;
    for (const auto& link : trials_.links())
      if (link.floor && gap(assembly_, link) > trials_.options().contact) floating.push_back(link);
    for (std::size_t k = 0; k < floating.size() && k < most_movers; ++k)
      try_closing(trials_, floating, k);
  }

  Trials& trials_;
  const Assembly& assembly_;
  std::set<std::size_t> ground_;
};

}  // namespace

void try_steadying(Trials& trials) {
  if (!trials.exhausted()) Steadying(trials).try_all();
}

}  // namespace roomgen::create::detail
