#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/result.h"
#include "roomgen/generate/generate.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/problem.h"

namespace roomgen {

/// Where an object could stand, best first: what a host chooses from.
struct Proposal {
  PlannedObject planned;
  AssetInfo asset;
  PlacementTask task;             ///< the object with its size, its constraints and the suggested place
  PlaceAdvice answer;             ///< of the designer
  std::vector<Placement> places;  ///< each valid as things stand, no two alike, with the solver's terms
  std::string refusal;            ///< why there are none
  std::string window;             ///< the one that a curtain or blind would cover
};

/// A pose that a host wants, for the bottom centre of the object's box.
struct WantedPose {
  Vec2 position = Vec2::Zero();
  double yaw = 0.0;                      ///< radians
  std::optional<double> bottom = {};     ///< else the floor, the surface below, or the usual height
  std::string on = {};                   ///< id of what carries it; else the highest thing below
};

/// Of a room that is built; what is planned beyond that stays unplaced, with the reason.
inline constexpr std::size_t max_things_of_room = 300;

/// Furnishes a room one step at a time: what generate() does at one go, and what a host may do its own way
/// in between. Each planned object goes through retrieval of an asset, advice of the designer, proposal,
/// score and fusion to its pose (docs/architecture.md).
///
///     auto builder = RoomBuilder::begin(*plan, *designer, *library, KindTable::built_in());
///     while (builder->next()) {
///       auto step = builder->step();               // or propose() and place(), or refuse()
///       if (!step) return step.error();
///     }
///     (void)builder->improve();
///     if (auto status = builder->check_kind(); !status) return status.error();
///     Generation room = builder->generation();
///
/// A call either does what it says or leaves everything as it was. Once `options.cancel` is set, or the time
/// given to a call is over, the call ends within 50 ms with Error::Kind::cancelled or limit: what is in the
/// middle of something that cannot be stopped (a mesh being read, a picture, a model's answer) is abandoned
/// and runs out by itself; the next call that works, and the destructor, wait for that.
///
/// Equal plans, libraries, options and calls give equal rooms. Not for use by two threads at once; several
/// builders on several threads share nothing but what they were given, so designers and renderers must not
/// be shared; the libraries of roomgen may be.
class RoomBuilder {
 public:
  using Seconds = std::chrono::duration<double>;

  /// The empty room of a plan. Reads the meshes of its doors and windows. `designer`, `library`,
  /// `categories` and the renderer must outlive the builder; they may be the host's own.
  static Result<RoomBuilder> begin(Plan plan, Designer& designer, const AssetLibrary& library,
                                   const KindTable& categories, BuildOptions options = {});
  /// The same from words: the designer makes the plan.
  static Result<RoomBuilder> begin(const PlanRequest& request, Designer& designer,
                                   const AssetLibrary& library, const KindTable& categories,
                                   BuildOptions options = {});
  RoomBuilder(RoomBuilder&&) noexcept;
  RoomBuilder& operator=(RoomBuilder&&) noexcept;
  ~RoomBuilder();

  const Plan& plan() const;
  /// What was not tried yet, in the plan's order.
  const std::vector<PlannedObject>& left() const;
  /// Whose turn it is: the one that the designer or choose() named, else the first one left.
  std::optional<PlannedObject> next() const;
  /// Makes one of those left the next one.
  Status choose(std::string_view id);
  /// Why the designer may not be asked any more (its budget is spent); empty while it may.
  const std::string& stopped() const;

  /// What stands now, in the order of placement.
  Scene scene() const;
  /// The meshes of what stands, and of what was tried.
  const ModelTable& models() const;
  /// All that is known by now: the scene in the plan's order, what found no place, figures, the trace.
  /// Complete when nothing is left.
  Generation generation() const;
  /// Fails with too_small where all was tried and the room is not what it is called: of the kinds
  /// that make it so (data/rooms.json, "made_by": a bedroom's bed) some are planned, and none found
  /// a place. The message says which. No failure is what the plan leaves out, nor a room that was
  /// stopped. generate() ends with this check, and tells the least size that would do.
  Status check_kind() const;

  // Steps. Each takes one planned object that is not in the room; one that was left out may be
  // tried again.

  /// The next one, by all means: other assets, other answers, making room, a repair. That nothing helped
  /// is no error: Step::reason says so.
  Result<Step> step(std::optional<Seconds> time = {});
  /// Up to `count` places for an object, with the first asset and the first answer. Changes nothing.
  Result<Proposal> propose(std::string_view id, std::size_t count = 5,
                           std::optional<Seconds> time = {});
  /// One of the places of a proposal, if it still is one.
  Result<Step> place(const Proposal& proposal, std::size_t choice = 0);
  /// Exactly there, locked; not_found with the reason if that would break docs/constraints.md.
  Result<Step> place(std::string_view id, const WantedPose& pose);
  /// Where constraints, a location and a facing of the host's own lead; not_found if nowhere.
  Result<Step> place(std::string_view id, const PlaceAdvice& wish, std::optional<Seconds> time = {});
  /// Leaves it out, for this reason.
  Status refuse(std::string_view id, std::string reason);
  /// Wins back lost constraints and objects by moving what is not locked. What was won when the time is over
  /// is kept, and the room marked incomplete.
  Status improve(std::optional<Seconds> time = {});

  /// Takes back the last steps, improvements included; returns how many there were. Doing the same again
  /// gives the same.
  std::size_t undo(std::size_t steps = 1);

 private:
  struct Impl;
  explicit RoomBuilder(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace roomgen
