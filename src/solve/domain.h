#pragma once

#include <array>
#include <set>
#include <vector>

#include "layout.h"
#include "propose.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

/// Where a thing may be put while layouts are drawn: poses in the room, or in the frame of the thing that it goes
/// along with. They hold the constraints that concern only the room and that thing.
struct Domain {
  std::vector<Pose> meaningful;
  std::vector<Pose> grid;

  std::size_t size() const { return meaningful.size() + grid.size(); }
};

/// A pose in the room of what is placed by another thing, and back. Heights are the other thing's only for
/// what stands on it.
Pose from_frame(const Pose& local, const Footprint& frame, double base, Mount mount);
Pose to_frame(const Pose& pose, const Footprint& frame, double base, Mount mount);

/// Finds the domain of one thing.
class DomainSearch {
 public:
  /// Both must outlive this. Nothing stands in the layout.
  DomainSearch(Layout& layout, const PlacementTask& task) : layout_(layout), task_(task) {}

  /// Adds the poses that are worth trying while the anchor, if the thing has one, stands so.
  void look(const Object* anchor);

  /// The poses in the room that were found.
  const std::vector<Pose>& stands() const { return stands_; }
  Domain take_domain() { return std::move(domain_); }

 private:
  std::vector<ResolvedRelation> judged() const;
  std::vector<Pose> grid_about(const ProposalContext& context, const Object* anchor) const;
  void collect(const ProposalContext& context, const std::vector<Pose>& poses, const Object* anchor,
               std::vector<Pose>& found);
  bool is_new(const Pose& pose);

  Layout& layout_;
  const PlacementTask& task_;
  Domain domain_;
  std::vector<Pose> stands_;
  std::set<std::array<long long, 4>> known_;
};

}  // namespace roomgen
