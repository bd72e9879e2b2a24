#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "roomgen/scene/problem.h"
#include "layout.h"

namespace roomgen {

/// Where things stand that somebody put there (PlacementTask::binding), and what it costs to move them.
class Words {
 public:
  /// As they stand now.
  Words(const Layout& layout, const std::vector<PlacementTask>& tasks);

  bool empty() const { return stood_.empty(); }
  /// Those, and what carries them.
  bool hold(const std::string& id) const { return held_.count(id) > 0; }
  /// LayoutQuality::displaced.
  double displaced(const Layout& layout) const;
  /// Puts what was moved back, or as near to where it stood as `is_no_worse` allows of the layout then: the
  /// earlier thing first, so that rather the later one stays away.
  void bring_back(Layout& layout, const std::function<bool()>& is_no_worse) const;

 private:
  struct Stood {
    Object object;
    double weight;
  };

  std::vector<Stood> stood_;  ///< in placement order
  std::set<std::string> held_;
};

/// Does everything that was asked for stand, with its wishes?
bool requirements_hold(const Layout& layout, const std::vector<PlacementTask>& tasks);

}  // namespace roomgen
