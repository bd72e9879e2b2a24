#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "check_options.h"
#include "choose_view.h"
#include "motion.h"
#include "roomgen/base/text.h"
#include "scene/dwelling.h"

namespace roomgen::lab {

namespace {

using namespace detail;

/// Where one comes in.
struct Entry {
  GridNode node = 0;
  double yaw = 0.0;
};

std::optional<GridNode> nearest_inside(const WalkGrid& grid, const Footprint& area, const Vec2& place) {
  std::optional<GridNode> nearest;
  for (GridNode node = 0; node < grid.size(); ++node) {
    if (!grid.can_stand(node) || !contains(area, grid.place(node))) continue;
    if (!nearest || (grid.place(node) - place).norm() < (grid.place(*nearest) - place).norm()) nearest = node;
  }
  return nearest;
}

// By the first door from outdoors inside which the agent can stand.
std::optional<Entry> find_entry(const Scene& scene, const WalkGrid& grid) {
  const auto rooms = rooms_of(scene);
  for (const auto& room : rooms)
    for (const auto& opening : room.openings) {
      if (!opening.is_entrance() || other_side(rooms, room, opening)) continue;
      const auto node = nearest_inside(grid, door_clearance(room, opening), segment(room, opening).middle());
      if (node) return Entry{*node, yaw_facing(inward(room, opening))};
    }
  return std::nullopt;
}

bool has_entrance(const Scene& scene) {
  const auto rooms = rooms_of(scene);
  for (const auto& room : rooms)
    for (const auto& opening : room.openings)
      if (opening.is_entrance() && !other_side(rooms, room, opening)) return true;
  return false;
}

std::vector<const Object*> targets_of(const Scene& scene, const TourOptions& options) {
  std::vector<const Object*> targets;
  for (const auto& object : scene.objects)
    if (options.targets.empty() || std::count(options.targets.begin(), options.targets.end(), object.id) > 0)
      targets.push_back(&object);
  return targets;
}

/// A target that is still to be visited, and the place nearest to it that can be walked to.
struct Waiting {
  const Object* target;
  GridNode beside;
};

GridNode place_beside(const WalkGrid& grid, const ShortestWays& ways, GridNode start, const Object& target) {
  const Footprint area = footprint(target);
  GridNode nearest = start;
  double least = gap(area, grid.place(start));
  for (GridNode node = 0; node < grid.size(); ++node) {
    if (!ways.reach(node)) continue;
    const double distance = gap(area, grid.place(node));
    if (distance >= least) continue;
    least = distance;
    nearest = node;
  }
  return nearest;
}

class Guide {
 public:
  Guide(const TourSite& site, Renderer& renderer, const Entry& entry)
      : site_(site),
        renderer_(renderer),
        node_(entry.node),
        place_(site.grid.place(entry.node)),
        ways_(site.grid.ways_from(entry.node)),
        motion_(site.options, {{place_.x(), place_.y(), site.options.eye_height}, entry.yaw, 0.0}) {
    for (const Object* target : targets_of(site.scene, site.options))
      waiting_.push_back({target, place_beside(site.grid, ways_, node_, *target)});
  }

  Status visit_all(Tour& tour) {
    while (!waiting_.empty()) {
      const auto view = choose_view(site_, renderer_, take_next(), ways_);
      if (!view) return view.error();
      if (const auto* chosen = std::get_if<ChosenView>(&*view))
        tour.views.push_back(go_to(*chosen));
      else
        tour.unseen.push_back(std::get<UnseenTarget>(*view));
    }
    tour.keyframes = motion_.keyframes();
    return {};
  }

 private:
  // Those that are to come first, as they are named; then the nearest; then those that are to come last.
  const Object& take_next() {
    const auto nearest = std::min_element(waiting_.begin(), waiting_.end(), [&](const Waiting& a, const Waiting& b) {
      return std::pair(turn(a), ways_.metres[a.beside]) < std::pair(turn(b), ways_.metres[b.beside]);
    });
    const Object* target = nearest->target;
    waiting_.erase(nearest);
    return *target;
  }

  std::ptrdiff_t turn(const Waiting& waiting) const {
    const auto &first = site_.options.first, &last = site_.options.last;
    const auto in_first = std::find(first.begin(), first.end(), waiting.target->id);
    if (in_first != first.end()) return in_first - first.end();
    const auto in_last = std::find(last.begin(), last.end(), waiting.target->id);
    return in_last == last.end() ? 0 : in_last - last.begin() + 1;
  }

  TourView go_to(const ChosenView& chosen) {
    const Vec2 there = chosen.view.pose.eye.head<2>();
    std::vector<Vec2> way = {place_};
    for (const GridNode node : ways_.to(chosen.node)) way.push_back(site_.grid.place(node));
    way.push_back(there);
    way = pulled_straight(site_.space, way);
    motion_.walk(way);
    motion_.turn_to(chosen.view.pose.yaw, chosen.view.pose.pitch);
    TourView view = chosen.view;
    view.walked = length_of(way);
    view.keyframe = motion_.keyframes().size() - 1;
    motion_.pause();
    node_ = chosen.node;
    place_ = there;
    ways_ = site_.grid.ways_from(node_);
    return view;
  }

  const TourSite& site_;
  Renderer& renderer_;
  GridNode node_;
  Vec2 place_;
  ShortestWays ways_;
  Motion motion_;
  std::vector<Waiting> waiting_;
};

// Nobody gets in.
void report_all(const Scene& scene, const TourOptions& options, Tour& tour) {
  const std::string reason =
      has_entrance(scene) ? "inside no door is there room for somebody " + format_number(2.0 * options.agent_radius) +
                                " m wide: a smaller agent may get in"
                          : "there is no door or passage to come in by: give the room one";
  for (const Object* target : targets_of(scene, options))
    tour.unseen.push_back({target->id, UnseenTarget::Cause::no_way_in, reason});
}

}  // namespace

Result<Tour> make_tour(const Scene& scene, const ModelTable& models, const KindTable& kinds, Renderer& renderer,
                       const TourOptions& options) {
  if (auto status = check_tour_options(scene, options); !status) return status.error();
  const FreeSpace space(scene, kinds, options.eye_height, options.agent_radius, options.flies);
  const WalkGrid grid(space);
  const TourSite site{scene, models, options, space, grid};
  Tour tour{options.seed, site.intrinsics(), options.agent_radius, options.least_hidden, options.greatest_hidden,
            {}, {}, {}};
  const auto entry = find_entry(scene, grid);
  if (!entry) {
    report_all(scene, options, tour);
    return tour;
  }
  if (auto status = Guide(site, renderer, *entry).visit_all(tour); !status) return status.error();
  return tour;
}

}  // namespace roomgen::lab
