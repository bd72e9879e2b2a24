#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "attachment.h"
#include "collision/solids.h"
#include "collision/support_poses.h"
#include "collision/usability.h"
#include "measures.h"
#include "pair_memo.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"
#include "roomgen/scene/object.h"
#include "solve/room_limits.h"

namespace roomgen::lab::annealing {

/// What can be put into the room: one mesh at one size.
struct Article {
  Object object;              ///< its pose means nothing
  const Kind* kind = nullptr;
  int kind_number = 0;        ///< equal for articles of one kind
  int seats = 0;              ///< people who can sit on it
};

inline constexpr std::size_t most_attachments = 4;

/// Where a thing is and what it is put up against.
struct Stance {
  Vec2 position = Vec2::Zero();
  double yaw = 0.0;
  double bottom = 0.0;
  std::array<Attachment, most_attachments> attachments{};
  std::size_t count = 0;  ///< of attachments
  std::optional<SupportPose> rest = {};  ///< of what stands on another thing, in that one's frame

  std::span<const Attachment> held() const { return {attachments.data(), count}; }
  std::span<Attachment> held() { return {attachments.data(), count}; }
};

/// The use zones of a thing where it is, and whether all of them are taken.
struct Zones {
  Version version = 0;           ///< of the pose that they belong to
  std::vector<Footprint> areas;  ///< none: it needs none
  std::vector<char> inside;      ///< of the room
  Bounds2 reach;                 ///< of all areas
};

/// A thing in the room.
struct Item {
  int article = 0;
  Stance stance;
  int bound = -1;  ///< of the program, for which it was added
  Object object;   ///< the article at its pose
  const Kind* kind = nullptr;
  int kind_number = 0;
  Body body;
  Version version = 0;
  bool fixed = false;  ///< nothing moves or removes it
};

/// A room being furnished by trial: things with lasting slots, what is put up against what, and the hard rules
/// (inside, no two solids in one place, openings free; docs/constraints.md, "Valid"). Every change since
/// mark() can be taken back.
class World {
 public:
  /// All must outlive the world. `relations` are those that attachments name.
  World(const Room& room, const KindTable& kinds, const std::vector<Article>& articles, const ModelTable& models,
        const std::vector<PutUp>& relations);

  const Room& room() const { return room_; }
  const KindTable& kinds() const { return kinds_; }
  const std::vector<Article>& articles() const { return articles_; }
  const PutUp& relation(int number) const { return relations_[static_cast<std::size_t>(number)]; }
  const SupportPoses& support_poses() const { return support_poses_; }
  const SlotSet& things() const { return things_; }
  const SlotSet& doors() const { return doors_; }
  const SlotSet& windows() const { return windows_; }
  const Item& item(Slot slot) const { return *items_[static_cast<std::size_t>(slot)]; }
  /// Of a thing, a door or a window.
  const Body& body(Slot slot) const { return slot < most_things ? item(slot).body : openings_[opening(slot)]; }
  Version version(Slot slot) const { return slot < most_things ? item(slot).version : static_cast<Version>(slot); }
  /// Changes with the room's structure: what is there, of which articles, put up against what. Structures of one
  /// number are one; what is taken back has its old number.
  std::uint64_t structure() const { return structure_; }
  /// That at mark().
  std::uint64_t marked_structure() const { return marked_.structure; }

  // Changes.
  std::optional<Slot> add(int article, const Stance& stance, int bound);
  /// The same in a slot that is known to be free.
  void add_at(Slot slot, int article, const Stance& stance, int bound);
  void remove(Slot slot);
  void fix(Slot slot) { at(slot).fixed = true; }
  void set_stance(Slot slot, const Stance& stance);
  void set_article(Slot slot, int article);

  /// Forgets how to take back what was done.
  void mark();
  /// Takes back all changes since mark().
  void undo();

  /// Things against which others are put up, by whatever relation.
  const SlotSet& supporters();
  /// The thing and all that stands on, in or against it, directly or by way of others.
  SlotSet cluster(Slot slot);

  /// The stretch that the attachments leave the thing, were it of this article; nothing if they contradict each
  /// other, an empty optional inside if no upright one binds it.
  struct Freedom {
    bool possible = true;
    std::optional<Track> track = {};
  };
  Freedom freedom(int article, std::span<const Attachment> attachments) const;
  /// What carries the thing; nothing if the room does.
  std::optional<Slot> carrier(Slot slot) const;
  /// Do the upright attachments still hold at the pose?
  bool attachments_hold(Slot slot) const;
  /// May the moved ones be where they are, and does what is put up against them still stand so? In two parts, since
  /// meshes are dear: boxes first; then, of those that may meet within their boxes, the meshes.
  bool boxes_admit(const SlotSet& moved);
  bool meshes_admit();
  bool admits(const SlotSet& moved) { return boxes_admit(moved) && meshes_admit(); }
  /// The things that the thing may not be in one place with and is.
  SlotSet clashing(Slot slot);

  /// How many things have no free use zone.
  int useless();
  /// Is a free use zone of each thing within reach of every door? Dearer.
  bool is_reachable();

 private:
  struct Change {
    enum class Kind { posed, added, removed, replaced } kind;
    Slot slot;
    Stance stance = {};
    Body body = {};
    Version version = 0;
    std::unique_ptr<Item> item = {};
  };
  static std::size_t opening(Slot slot) { return static_cast<std::size_t>(slot - first_opening_slot); }
  Item& at(Slot slot) { return *items_[static_cast<std::size_t>(slot)]; }
  void put(Item& item, const Stance& stance);
  void dress(Item& item, int article);
  bool rests_on(Slot upper, Slot lower) const;
  enum class Meeting { apart, clash, meshes_decide };
  Meeting meeting(Slot a, Slot b) const;
  void find_zones(Slot slot);
  bool is_zone_free(Slot slot, std::size_t zone) const;
  bool all_zones_taken(Slot slot) const;
  bool reaches_free_zone(Slot slot) const;
  void map_walkways();
  void change_structure() { structure_ = ++last_structure_; }
  /// Something came to, or left, this part of the floor.
  void disturb(const Bounds2& part);
  FloorThing floor_thing_of(const Item& item) const { return {&item.object, item.kind, item.body.footprint}; }

  const Room& room_;
  const KindTable& kinds_;
  const std::vector<Article>& articles_;
  const std::vector<PutUp>& relations_;
  RoomLimits limits_;
  Solids solids_;
  SupportPoses support_poses_;
  std::vector<Body> openings_;
  SlotSet things_, doors_, windows_;
  std::vector<std::unique_ptr<Item>> items_;
  std::vector<Change> changes_;
  std::vector<std::pair<Slot, Slot>> undecided_;  ///< by the boxes of the last move
  Version last_version_ = most_slots;  // doors and windows have their slots for versions
  std::uint64_t structure_ = 0, last_structure_ = 0;
  std::uint64_t supporters_of_ = ~std::uint64_t{0};  ///< the structure for which they are known
  SlotSet supporters_;
  std::vector<Zones> zones_;   ///< by slot
  SlotSet judged_, useless_;   ///< things of which it is known whether all their zones are taken
  OccupancyGrid walkways_;
  /// What stands in the way there, by slot; no version: nothing does.
  struct Obstacle {
    Version version = 0;
    Footprint footprint;
  };
  std::vector<Obstacle> obstacles_;
  struct Marked {
    std::uint64_t structure = 0;
    SlotSet judged, useless;
  } marked_;
};

}  // namespace roomgen::lab::annealing
