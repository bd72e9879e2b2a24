#include "brief/placement_phrase.h"
#include "destinations.h"
#include "edit/walls.h"

namespace roomgen {

namespace {

constexpr const char* into_wall[] = {"in", "into", "on", "to", "through", "onto", "inside", "at"};

double place_along(const Room& room, std::size_t wall, const Vec2& point) {
  const Segment edge = room.polygon.edge(wall);
  return (point - edge.a).dot(edge.direction());
}

}  // namespace

std::size_t wall_opposite(const Room& room, std::size_t wall) {
  std::size_t best = wall;
  const auto share = [&](std::size_t k) { return -room.polygon.inward(k).dot(room.polygon.inward(wall)); };
  for (std::size_t k = 0; k < room.polygon.size(); ++k)
    if (share(k) > share(best) + 1e-9) best = k;
  return best;
}

std::optional<NamedWall> wall_by_target(const EditText& text, std::size_t at, bool may_be_near) {
  const Room& room = text.room();
  if (room.polygon.size() == 0) return std::nullopt;
  std::size_t next = at;
  const bool is_opposite = text.is_word(at, "opposite") || text.is_word(at, "facing") || text.is_word(at, "across");
  const bool is_beside =
      text.is_word(at, "by") || text.is_word(at, "above") || text.is_word(at, "over") || text.is_word(at, "beside");
  const bool is_near = text.is_word(at, "behind") || text.is_word(at, "with") || (may_be_near && is_beside);
  if (!is_opposite && !is_near) return std::nullopt;
  ++next;
  if (text.is_word(next, "from") || text.is_word(next, "of") || text.is_word(next, "to")) ++next;
  const auto target = target_at(text, next, {});
  if (!target || !*target) return std::nullopt;
  if (const Opening* opening = find_opening(room, (*target)->id))
    return NamedWall{is_opposite ? wall_opposite(room, opening->wall) : opening->wall, {}, (*target)->end};
  const Object* object = text.object((*target)->id);
  if (!object) return std::nullopt;
  const std::size_t wall = *wall_named(room, nearest_wall(text, *object));
  if (is_opposite) return NamedWall{wall_opposite(room, wall), {}, (*target)->end};
  return NamedWall{wall, place_along(room, wall, object->position.head<2>()), (*target)->end};
}

std::optional<NamedWall> wall_at(const EditText& text, std::size_t at) {
  for (const char* word : into_wall)
    if (text.is_word(at, word)) {
      ++at;
      break;
    }
  if (auto named = wall_by_target(text, at, true)) return named;
  const auto place = brief::read_place({text.tokens.data(), text.tokens.size()}, at, text.words);
  if (!place || place->place != brief::Place::wall) return std::nullopt;
  const std::size_t end = at + place->length;
  if (auto named = wall_by_target(text, end, true)) return named;
  const auto target = target_at(text, at, {});
  if (!target || !*target) return std::nullopt;
  const auto wall = wall_named(text.room(), (*target)->id);
  return wall ? std::optional(NamedWall{*wall, {}, end}) : std::nullopt;
}

}  // namespace roomgen
