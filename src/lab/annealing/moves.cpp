#include "moves.h"

#include <algorithm>

namespace roomgen::lab::annealing {

namespace {

constexpr std::array<std::string_view, move_kinds> names = {
    "add", "remove", "resample", "translate", "rotate", "change plane", "change target", "swap",
    "resample cluster", "translate cluster", "rotate cluster"};

constexpr double slanted_turns = 0.02;  // share of turns by 45 degrees

bool hangs_on_wall(std::span<const Attachment> attachments) {
  return std::ranges::any_of(attachments, [](const Attachment& a) { return a.parent == Face::wall; });
}

}  // namespace

std::string_view name(MoveKind kind) { return names[static_cast<std::size_t>(kind)]; }

Moves::Moves(World& world, Evaluator& evaluator, const std::vector<Bound>& bounds,
             const std::vector<std::vector<int>>& articles_of_kind, const Language& language, Random& random)
    : world_(world),
      evaluator_(evaluator),
      bounds_(bounds),
      articles_of_kind_(articles_of_kind),
      language_(language),
      random_(random),
      settler_(world, random),
      bounds_with_variables_(std::ranges::any_of(bounds, [](const Bound& bound) { return !bound.variables.empty(); })) {
}

std::optional<SlotSet> Moves::propose(MoveKind kind, double reach) {
  switch (kind) {
    case MoveKind::add: return add();
    case MoveKind::remove: return remove();
    case MoveKind::resample: return resample(false);
    case MoveKind::translate: return translate(reach, false);
    case MoveKind::rotate: return rotate(false);
    case MoveKind::change_plane: return change_plane();
    case MoveKind::change_target: return change_target();
    case MoveKind::swap: return swap();
    case MoveKind::resample_cluster: return resample(true);
    case MoveKind::translate_cluster: return translate(reach, true);
    default: return rotate(true);
  }
}

std::optional<Slot> Moves::any_thing(bool with_dependants) {
  std::vector<Slot> all;
  const SlotSet& supporters = world_.supporters();
  world_.things().each([&](Slot slot) {
    if (supporters.has(slot) == with_dependants) all.push_back(slot);
  });
  if (all.empty()) return std::nullopt;
  return random_.pick(all);
}

std::optional<SlotSet> Moves::put(Slot slot, const Stance& stance) {
  const Stance before = world_.item(slot).stance;
  const Body body = world_.item(slot).body;
  world_.set_stance(slot, stance);
  return settler_.carry(slot, before, body);
}

// Another mesh for all of one design.
std::optional<SlotSet> Moves::resample(bool cluster) {
  const auto slot = any_thing(cluster);
  if (!slot) return std::nullopt;
  const Item& item = world_.item(*slot);
  const auto& articles = articles_of_kind_[static_cast<std::size_t>(item.kind_number)];
  if (articles.size() < 2) return std::nullopt;
  const int article = random_.pick(articles), before = item.article, bound = item.bound;
  if (article == before) return std::nullopt;
  SlotSet alike, moved;
  world_.things().each([&](Slot other) {
    if (world_.item(other).bound == bound && world_.item(other).article == before) alike.insert(other);
  });
  alike.each([&](Slot other) { world_.set_article(other, article); });
  bool fits = true;
  alike.each([&](Slot other) {
    if (fits && !moved.has(other)) fits = settle_anew(other, moved);
  });
  if (!fits) return std::nullopt;
  return moved;
}

// A thing that has become another finds its place near where it was, and so does all that is up against it: on
// another shelf things rest elsewhere. Carriers first.
bool Moves::settle_anew(Slot root, SlotSet& moved) {
  SlotSet waiting = world_.cluster(root);
  while (!waiting.empty()) {
    std::optional<Slot> next;
    waiting.each([&](Slot other) {
      const auto held = world_.item(other).stance.held();
      if (!next && std::ranges::none_of(held, [&](const Attachment& a) {
            return a.target < most_things && waiting.has(a.target);
          }))
        next = other;
    });
    if (!next) return false;
    const auto there = settler_.near(world_.item(*next).article, world_.item(*next).stance);
    if (!there) return false;
    world_.set_stance(*next, *there);
    waiting.erase(*next);
    moved.insert(*next);
  }
  return true;
}

std::optional<SlotSet> Moves::translate(double reach, bool cluster) {
  const auto slot = any_thing(cluster);
  if (!slot) return std::nullopt;
  const Item& item = world_.item(*slot);
  Stance wanted = item.stance;
  wanted.position.x() += random_.normal(0.0, reach);
  wanted.position.y() += random_.normal(0.0, reach);
  if (item.object.mount == Mount::wall) wanted.bottom += random_.normal(0.0, 0.2 * reach);
  const auto stance = settler_.near(item.article, wanted);
  if (!stance) return std::nullopt;
  return put(*slot, *stance);
}

std::optional<SlotSet> Moves::rotate(bool cluster) {
  const auto slot = any_thing(cluster);
  if (!slot) return std::nullopt;
  const Item& item = world_.item(*slot);
  Stance wanted = item.stance;
  bool upright = false;
  for (auto& attachment : wanted.held()) {
    if (!is_upright(attachment.parent)) continue;
    upright = true;
    if (!choose_faces(attachment, *item.kind)) return std::nullopt;
  }
  if (!upright && !wanted.rest) {
    const int quarters = random_.integer(1, 3);
    wanted.yaw = wrap_angle(wanted.yaw + (random_.chance(slanted_turns) ? pi / 4 : quarters * pi / 2));
    return put(*slot, wanted);
  }
  const auto stance = settler_.anywhere(item.article, wanted.held());
  if (!stance) return std::nullopt;
  return put(*slot, *stance);
}

std::optional<SlotSet> Moves::change_plane() {
  std::vector<Slot> bound;
  world_.things().each([&](Slot slot) {
    const auto& stance = world_.item(slot).stance;
    if (stance.rest || hangs_on_wall(stance.held())) bound.push_back(slot);
  });
  if (bound.empty()) return std::nullopt;
  const Slot slot = random_.pick(bound);
  const Item& item = world_.item(slot);
  Stance wanted = item.stance;
  for (auto& attachment : wanted.held())
    if (attachment.parent == Face::wall)
      attachment.wall = random_.integer(0, static_cast<int>(world_.room().polygon.size()) - 1);
  const auto stance = settler_.anywhere(item.article, wanted.held());
  if (!stance) return std::nullopt;
  return put(slot, *stance);
}

// Back to the bound for which the thing came: other values of its variables, other targets.
std::optional<SlotSet> Moves::change_target() {
  std::vector<Slot> against;
  world_.things().each([&](Slot slot) {
    for (const auto& attachment : world_.item(slot).stance.held())
      if (attachment.target < most_things) {
        against.push_back(slot);
        return;
      }
  });
  if (against.empty()) return std::nullopt;
  const Slot slot = random_.pick(against);
  const Item& item = world_.item(slot);
  const Bound& bound = bounds_[static_cast<std::size_t>(item.bound)];
  std::vector<Slot> variables;
  for (const int set : bound.variables) {
    std::vector<Slot> possible;
    evaluator_.members(set, variables).each([&](Slot other) { possible.push_back(other); });
    if (possible.empty()) return std::nullopt;
    variables.push_back(random_.pick(possible));
  }
  const auto attachments = attach_all(random_.pick(bound.recipes), variables, *item.kind, slot);
  if (!attachments) return std::nullopt;
  const auto stance = settler_.anywhere(item.article, *attachments);
  if (!stance) return std::nullopt;
  return put(slot, *stance);
}

// Two things of one mount change places and what they are put up against.
std::optional<SlotSet> Moves::swap() {
  std::vector<Slot> all;
  world_.things().each([&](Slot slot) { all.push_back(slot); });
  if (all.size() < 2) return std::nullopt;
  const Slot a = random_.pick(all), b = random_.pick(all);
  if (a == b || world_.item(a).object.mount != world_.item(b).object.mount) return std::nullopt;
  if (world_.cluster(a).has(b) || world_.cluster(b).has(a)) return std::nullopt;
  // Only what was put up in the same ways can take the other's part.
  const auto ways = [&](Slot slot) {
    std::vector<int> relations;
    for (const auto& attachment : world_.item(slot).stance.held()) relations.push_back(attachment.relation);
    return relations;
  };
  if (ways(a) != ways(b)) return std::nullopt;
  const Stance at_a = world_.item(a).stance, at_b = world_.item(b).stance;
  const auto a_there = settler_.near(world_.item(a).article, at_b);
  const auto b_there = settler_.near(world_.item(b).article, at_a);
  if (!a_there || !b_there) return std::nullopt;
  auto moved = put(a, *a_there);
  const auto others = put(b, *b_there);
  if (!moved || !others) return std::nullopt;
  *moved |= *others;
  return moved;
}

}  // namespace roomgen::lab::annealing
