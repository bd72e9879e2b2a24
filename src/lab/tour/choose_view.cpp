#include "choose_view.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "roomgen/base/text.h"
#include "viewpoints.h"

namespace roomgen::lab::detail {

namespace {

// Once so many are accepted, or are too small to be better than one that was, the best of them will do: the most
// promising ones were tried first.
constexpr int enough_judged = 12;

std::string metres_text(double metres) { return format_number(metres) + " m"; }
std::string percent_text(double share) { return format_number(100.0 * share, 1) + " %"; }

// What the pictures from all viewpoints said.
struct Tally {
  int judged = 0;
  double least_hidden = 2.0, most_hidden = -1.0;

  void add_hidden(double share) {
    least_hidden = std::min(least_hidden, share);
    most_hidden = std::max(most_hidden, share);
  }
  bool any_hidden_share() const { return most_hidden >= 0; }
};

std::string hidden_text(const TourOptions& options, const Tally& tally) {
  const std::string wanted = percent_text(options.least_hidden) + " to " + percent_text(options.greatest_hidden);
  const std::string least = percent_text(tally.least_hidden), most = percent_text(tally.most_hidden);
  return "others hide " + (least == most ? most : least + " to " + most) +
         " of it, from wherever it was looked at; " + wanted + " are asked for";
}

bool can_enter(const TourSite& site, const Room& room, const ShortestWays& ways) {
  for (GridNode node = 0; node < site.grid.size(); ++node)
    if (ways.reach(node) && contains(room.polygon, site.grid.place(node))) return true;
  return false;
}

// Of a room that nobody gets into, or of the ways inside.
std::string out_of_reach_text(const TourSite& site, const Object& target, bool entered) {
  const TourOptions& options = site.options;
  const Room& room = room_of(site.scene, target);
  const std::string wide = "somebody " + metres_text(2.0 * options.agent_radius) + " wide";
  if (!entered && !site.scene.rooms.empty())
    return "its room, " + room.id + ", cannot be entered from where the tour begins by " + wide +
           ": it needs an open way through doors, or a smaller agent";
  return "there is no place to stand that can be walked to by " + wide + ", " + metres_text(options.least_distance) + " to " +
         metres_text(options.greatest_distance) + " from it: a smaller agent or other distances may help";
}

UnseenTarget unseen(const TourSite& site, const Object& target, const ShortestWays& ways, const DrawnViewpoints& drawn,
                    const Tally& tally) {
  using Cause = UnseenTarget::Cause;
  const TourOptions& options = site.options;
  // Walls hide it from the next room; that is not what is in the way.
  const bool entered = can_enter(site, room_of(site.scene, target), ways);
  if (!drawn.any_place || !entered) return {target.id, Cause::out_of_reach, out_of_reach_text(site, target, entered)};
  if (drawn.points.empty())
    return {target.id, Cause::out_of_picture,
            "from no place that can be walked to all of it is in the picture: a wider field of view or greater "
            "distances may help"};
  if (!tally.any_hidden_share())
    return {target.id, Cause::too_small,
            "it has less than " + std::to_string(options.least_pixels) +
                " pixels in every picture: larger pictures or shorter distances may help"};
  return {target.id, Cause::hidden, hidden_text(options, tally)};
}

class ViewChooser {
 public:
  ViewChooser(const TourSite& site, Renderer& renderer, const Object& target)
      : site_(site),
        renderer_(renderer),
        target_(target),
        index_(static_cast<std::size_t>(&target - site.scene.objects.data())) {}

  Status look_from(const Viewpoint& point) {
    const auto camera = tour_camera(point.pose, site_.intrinsics());
    if (!camera) return camera.error();
    const std::size_t least = std::max(pixels_to_be_best(point), static_cast<std::size_t>(site_.options.least_pixels));
    const auto seen = renderer_.visibility(site_.scene, site_.models, *camera, index_, least);
    if (!seen) return seen.error();
    if (seen->pixels_alone >= least)
      judge(point, *seen);
    else if (best_)
      ++tally_.judged;
    return {};
  }

  bool is_done(const Viewpoint& next) const {
    return tally_.judged >= enough_judged || (best_ && best_->view.score >= next.most_score);
  }
  const std::optional<ChosenView>& best() const { return best_; }
  const Tally& tally() const { return tally_; }

 private:
  // With fewer pixels alone it cannot score as much as the best one.
  std::size_t pixels_to_be_best(const Viewpoint& point) const {
    if (!best_) return 0;
    const double pixels = pixels_that_score(site_.options, best_->view.score, point.fixed_score);
    return static_cast<std::size_t>(std::ceil(pixels / std::max(1.0 - site_.options.least_hidden, 1e-6)));
  }

  void judge(const Viewpoint& point, const Visibility& seen) {
    const double hidden = 1.0 - static_cast<double>(seen.pixels) / static_cast<double>(seen.pixels_alone);
    tally_.add_hidden(hidden);
    if (hidden < site_.options.least_hidden || hidden > site_.options.greatest_hidden) return;
    ++tally_.judged;
    const double score = view_score(site_.options, static_cast<double>(seen.pixels), point.fixed_score);
    if (best_ && best_->view.score >= score) return;
    best_ = ChosenView{{target_.id, point.pose, seen.pixels, seen.pixels_alone, score}, point.node};
  }

  const TourSite& site_;
  Renderer& renderer_;
  const Object& target_;
  std::size_t index_;
  Tally tally_;
  std::optional<ChosenView> best_;
};

}  // namespace

Result<std::variant<ChosenView, UnseenTarget>> choose_view(const TourSite& site, Renderer& renderer,
                                                           const Object& target, const ShortestWays& ways) {
  using Outcome = std::variant<ChosenView, UnseenTarget>;
  const DrawnViewpoints drawn = draw_viewpoints(site, target, ways);
  ViewChooser chooser(site, renderer, target);
  for (const auto& point : drawn.points) {
    if (chooser.is_done(point)) break;
    if (site.options.cancel.cancelled()) return Error{Error::Kind::cancelled, "tour: interrupted"};
    if (auto status = chooser.look_from(point); !status) return status.error();
  }
  if (chooser.best()) return Outcome(*chooser.best());
  return Outcome(unseen(site, target, ways, drawn, chooser.tally()));
}

}  // namespace roomgen::lab::detail
