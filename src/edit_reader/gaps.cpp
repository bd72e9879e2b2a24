#include <algorithm>
#include <cmath>

#include "clause.h"
#include "language/measure.h"
#include "edit/walls.h"

namespace roomgen {

namespace {

struct Space {
  double metres = 0.0;
  bool is_named = false;  ///< "gap", "free", "left"
  std::size_t end = 0;
};

// "so that there is", "exactly 40 cm are left", "of free space"
void skip_words_of_space(const EditText& text, std::size_t& at, bool& is_named) {
  for (;;) {
    const auto named = longest_in(text.edits.space, text.tokens, at),
               around = longest_in(text.edits.around_space, text.tokens, at);
    if (named == 0 && around == 0) return;
    is_named = is_named || named > 0;
    at += std::max(named, around);
  }
}

std::optional<Space> space_at(const EditText& text, std::size_t at) {
  Space space;
  skip_words_of_space(text, at, space.is_named);
  const auto measure = language::measure_at(text.raw, at);
  if (!measure || measure->kind != language::Measure::Kind::length || !measure->has_unit) return std::nullopt;
  space.metres = measure->values[0];
  at += measure->length;
  skip_words_of_space(text, at, space.is_named);
  space.end = at;
  return space;
}

std::optional<Read<std::string>> other_at(const EditText& text, std::size_t at, const Ids& subjects) {
  const auto target = target_at(text, at, subjects);
  if (!target || !*target) return std::nullopt;
  return Read<std::string>{(*target)->id, (*target)->end};
}

// "between it and the dresser", "between the bed and the wall", "from the nightstand to the bed", "to the wardrobe"
MayRead<KeptGap> ends_of(const EditText& text, const Space& space, const Ids& subjects) {
  const bool is_between = text.is_word(space.end, "between") || text.is_word(space.end, "from");
  if (is_between && longest_in(text.edits.pronouns, text.tokens, space.end + 1) == 1 && !subjects.empty() &&
      text.is_word(space.end + 2, "and"))
    if (const auto second = other_at(text, space.end + 3, subjects))
      return Read<KeptGap>{{space.metres, subjects, second->value}, second->end};
  if (is_between) {
    const auto first = things_at(text, space.end + 1, false);
    // "between the bed and the wardrobe" is two things at once.
    if (first && *first && (*first)->value.size() == 2 && text.is_word(space.end, "between"))
      return Read<KeptGap>{{space.metres, {(*first)->value[0]}, (*first)->value[1]}, (*first)->end};
    if (first && *first && (text.is_word((*first)->end, "and") || text.is_word((*first)->end, "to")))
      if (const auto second = other_at(text, (*first)->end + 1, (*first)->value))
        return Read<KeptGap>{{space.metres, (*first)->value, second->value}, second->end};
  }
  const auto to = longest_in(text.edits.gap_to, text.tokens, space.end);
  if (subjects.empty()) return std::nullopt;
  const auto second = other_at(text, space.end + std::max<std::size_t>(to, is_between ? 1 : 0), subjects);
  if (!second) return std::nullopt;
  return Read<KeptGap>{{space.metres, subjects, second->value}, second->end};
}

// How far apart along x and y, below 0 where they overlap; and which way the first lies.
struct Apart {
  Vec2 by = Vec2::Zero(), way = Vec2::Ones();
};

Bounds2 bounds_of_target(const EditText& text, const Object& object, const std::string& id) {
  if (const Object* other = find_object(text.scene, id)) return footprint(*other).bounds();
  const Room& room = room_of(text.scene, object);
  Bounds2 box;
  const auto add = [&](const Segment& line) { box.add(line.a), box.add(line.b); };
  if (const Opening* opening = find_opening(room, id)) add(segment(room, *opening));
  if (const auto wall = wall_named(room, id)) add(room.polygon.edge(*wall));
  return box;
}

Apart apart(const Bounds2& first, const Bounds2& second) {
  Apart apart;
  for (int axis = 0; axis < 2; ++axis) {
    const bool is_beyond = first.low[axis] + first.high[axis] >= second.low[axis] + second.high[axis];
    apart.by[axis] = is_beyond ? first.low[axis] - second.high[axis] : second.low[axis] - first.high[axis];
    apart.way[axis] = is_beyond ? 1.0 : -1.0;
  }
  return apart;
}

// Along the axis on which they stand farther apart; what lies aside of each other counts too.
std::optional<Vec3> way_to_gap(const EditText& text, const Object& object, const KeptGap& gap) {
  const Bounds2 target = bounds_of_target(text, object, gap.second);
  if (target.high.x() < target.low.x()) return std::nullopt;
  const Apart now = apart(footprint(object).bounds(), target);
  const int axis = now.by.x() >= now.by.y() ? 0 : 1;
  const double aside = std::max(0.0, now.by[1 - axis]);
  if (aside >= gap.metres) return std::nullopt;
  Vec3 by = Vec3::Zero();
  by[axis] = now.way[axis] * (std::sqrt(gap.metres * gap.metres - aside * aside) - now.by[axis]);
  return by;
}

}  // namespace

MayRead<KeptGap> gap_at(const EditText& text, std::size_t at, const Ids& subjects) {
  const auto space = space_at(text, at);
  if (!space) return std::nullopt;
  if (!space->is_named && !text.is_word(space->end, "between")) return std::nullopt;
  return ends_of(text, *space, subjects);
}

ReadClause keep_gap(const EditText& text, const Read<KeptGap>& gap) {
  Clause clause;
  clause.about = gap.value.first;
  clause.end = gap.end;
  for (const auto& id : gap.value.first) {
    const Object* object = find_object(text.scene, id);
    if (!object) return not_understood(id + " has no place yet from which it could move");
    const auto by = way_to_gap(text, *object, gap.value);
    if (!by) return not_understood("it is not clear which way " + id + " shall move for that gap");
    clause.operations.push_back(edit::Shift{id, *by});
  }
  return clause;
}

}  // namespace roomgen
