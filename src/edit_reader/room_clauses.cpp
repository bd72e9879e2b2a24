#include <cmath>

#include "brief/opening_phrase.h"
#include "brief/placement_phrase.h"
#include "clause.h"
#include "destinations.h"
#include "language/measure.h"
#include "scene/opening_kind.h"
#include "size_phrases.h"
#include "edit/walls.h"

namespace roomgen {

namespace {

constexpr double least_share = 0.5;  // of a way that must lie along a wall, or across it

/// "a second door", "both windows"
struct NamedOpening {
  bool is_new = false;
  std::string kind;
  Ids ids;
  std::size_t end = 0;
};

Ids openings_of(const Room& room, OpeningType type) {
  Ids ids;
  for (const auto& opening : room.openings)
    if (opening.type == type) ids.push_back(opening.id);
  return ids;
}

std::optional<Result<NamedOpening>> opening_at(const EditText& text, std::size_t at) {
  const auto& kinds = OpeningKinds::built_in();
  if (!kinds) return std::nullopt;
  bool is_new = false, is_all = false;
  std::size_t next = at;
  for (; next < text.tokens.size(); ++next) {
    const std::string& word = text.tokens[next].text;
    if (word == "a" || word == "an" || word == "another" || text.edits.more.count(word)) is_new = true;
    else if (text.edits.all.count(word)) is_all = true;
    else if (!text.words.definite.count(word)) break;
  }
  const std::size_t length = brief::opening_name_at(text.tokens, next, *kinds);
  const OpeningKind* kind = length > 0 ? kinds->find(text.words_from(next, next + length)) : nullptr;
  if (kind && is_new) return NamedOpening{true, kind->name, {}, next + length};
  if (kind && (is_all || text.tokens[next + length - 1].text.ends_with("s")))
    return NamedOpening{false, kind->name, openings_of(text.room(), kind->type), next + length};
  const auto target = target_at(text, at, {});
  if (!target) return std::nullopt;
  // "the two nearest the door" are none.
  if (*target)
    for (std::size_t i = at; i < (*target)->end; ++i)
      if (longest_in(text.edits.nearest, text.tokens, i) > 0 || longest_in(text.edits.farthest, text.tokens, i) > 0)
        return std::nullopt;
  if (!*target) return kind ? std::optional<Result<NamedOpening>>(target->error()) : std::nullopt;
  if (!find_opening(text.room(), (*target)->id)) return std::nullopt;
  return NamedOpening{false, "", {(*target)->id}, (*target)->end};
}

// ---- Orders ------------------------------------------------------------------------------------

Clause open_there(const EditText& text, const NamedOpening& opening) {
  edit::Open open{opening.kind};
  std::size_t end = opening.end;
  if (const auto wall = wall_at(text, end)) {
    open.wall = wall_name(wall->wall);
    open.at = wall->at;
    end = wall->end;
  }
  return Clause{{open}, {}, {}, end};
}

// "30 cm to the left", as metres along a wall or outwards.
std::optional<Read<double>> way_along(const EditText& text, std::size_t at, const Vec2& direction) {
  const auto shifting = shifting_at(text, at, {});
  if (!shifting || !*shifting || !(*shifting)->direction || !(*shifting)->metres) return std::nullopt;
  const double share = (*shifting)->direction->head<2>().dot(direction);
  if (std::abs(share) < least_share) return std::nullopt;
  return Read<double>{share * *(*shifting)->metres, (*shifting)->end};
}

// Where the picture's left and right lie across the wall, they are those of who looks at it from inside.
std::optional<Read<double>> way_along_wall(const EditText& text, std::size_t at, const Room& room, std::size_t wall) {
  const Vec2 direction = room.polygon.edge(wall).direction();
  if (auto way = way_along(text, at, direction)) return way;
  return way_along(text, at, Vec2(-1.0, 0.0));
}

// "along its wall" says nothing more.
std::size_t skip_along(const EditText& text, std::size_t at) {
  if (!text.is_word(at, "along")) return at;
  ++at;
  if (text.is_word(at, "the") || text.is_word(at, "its")) ++at;
  return text.is_word(at, "wall") ? at + 1 : at;
}

ReadClause move_opening(const EditText& text, const NamedOpening& named) {
  const Room& room = text.room();
  if (named.ids.size() != 1) return what_at(text, named.end, "say which one is to be moved");
  const Opening& opening = *find_opening(room, named.ids.front());
  const std::size_t begin = skip_along(text, named.end);
  edit::Refit refit{opening.id};
  if (const auto way = way_along_wall(text, begin, room, opening.wall)) {
    refit.at = 0.5 * (opening.from + opening.to) + way->value;
    return Clause{{refit}, {}, {}, skip_along(text, way->end)};
  }
  if (const auto wall = wall_at(text, begin)) {
    refit.wall = wall_name(wall->wall);
    refit.at = wall->at;
    return Clause{{refit}, {}, {}, wall->end};
  }
  return what_at(text, begin, "it is not clear where to");
}

ReadClause resize_openings(const EditText& text, const std::string& verb, const NamedOpening& named) {
  const auto growth = text.edits.verbs_of_size.find(verb);
  const bool is_by_verb = growth != text.edits.verbs_of_size.end();
  const auto size = is_by_verb ? size_behind_verb(text, named.end, growth->second) : size_at(text, named.end);
  if (!size || !*size) return what_at(text, named.end, "it is not clear how large");
  Clause clause;
  clause.end = (*size)->end;
  for (const auto& id : named.ids) {
    const Opening& opening = *find_opening(text.room(), id);
    const Vec3 was(opening.width(), 0.01, opening.head - opening.sill), is = resized(was, (*size)->value);
    edit::Refit refit{id};
    if (is.x() != was.x()) refit.width = is.x();
    if (is.z() != was.z()) refit.height = is.z();
    clause.operations.push_back(refit);
  }
  return clause;
}

ReadClause move_wall(const EditText& text, const NamedWall& wall) {
  const Room& room = text.room();
  std::size_t at = wall.end;
  std::optional<double> metres;
  double sign = 0.0;
  for (bool more = true; more;) {
    more = false;
    if (text.is_word(at, "by")) ++at, more = true;
    if (const auto measure = language::measure_at(text.raw, at);
        !metres && measure && measure->kind == language::Measure::Kind::length && measure->has_unit)
      metres = measure->values[0], at += measure->length, more = true;
    if (const auto way = longest(text.edits.wall_ways, text.tokens, at); sign == 0.0 && way)
      sign = *way.value, at += way.length, more = true;
  }
  const std::string id = wall_name(wall.wall);
  if (metres && sign != 0.0) return Clause{{edit::Reshape{id, sign * *metres}}, {}, {}, at};
  if (const auto way = way_along(text, wall.end, -room.polygon.inward(wall.wall)))
    return Clause{{edit::Reshape{id, way->value}}, {}, {}, way->end};
  return what_at(text, wall.end, "it is not clear how far, and whether in or out");
}

// The wall to the east for a wider room, to the north for a deeper one.
ReadClause resize_room(const EditText& text, std::size_t at) {
  const auto size = size_at(text, at);
  if (!size || !*size) return what_at(text, at, "it is not clear how large");
  const Room& room = text.room();
  if (room.polygon.size() == 0) return what_at(text, at, "say which room");
  const Vec2 box = bounds(room.polygon).size();
  const Vec3 was(box.x(), box.y(), room.height), is = resized(was, (*size)->value);
  Clause clause;
  clause.end = (*size)->end;
  const Vec2 outward[] = {{1, 0}, {0, 1}};
  for (int axis = 0; axis < 2; ++axis) {
    if (is[axis] == was[axis]) continue;
    std::size_t wall = 0;
    for (std::size_t k = 1; k < room.polygon.size(); ++k)
      if (-room.polygon.inward(k).dot(outward[axis]) > -room.polygon.inward(wall).dot(outward[axis])) wall = k;
    clause.operations.push_back(edit::Reshape{wall_name(wall), is[axis] - was[axis]});
  }
  if (is.z() != was.z()) clause.operations.push_back(edit::Reshape{"", 0.0, is.z()});
  return clause;
}

// "raise the ceiling to 3 m", "lower the ceiling by 20 cm"
ReadClause move_ceiling(const EditText& text, const std::string& verb, std::size_t at) {
  const double height = text.room().height;
  if (text.room().polygon.size() == 0) return what_at(text, at, "say in which room");
  const bool is_by = text.is_word(at, "by");
  if (is_by || text.is_word(at, "to")) {
    const auto measure = language::measure_at(text.raw, at + 1);
    if (measure && measure->kind == language::Measure::Kind::length) {
      const double sign = verb.starts_with("low") || verb.starts_with("bring down") ? -1.0 : 1.0;
      return Clause{{edit::Reshape{"", 0.0, is_by ? height + sign * measure->values[0] : measure->values[0]}}, {}, {},
                    at + 1 + measure->length};
    }
  }
  const auto size = size_at(text, at);
  if (!size || !*size) return what_at(text, at, "it is not clear how high");
  return Clause{{edit::Reshape{"", 0.0, resized(Vec3(1e-3, 1e-3, height), (*size)->value).z()}}, {}, {}, (*size)->end};
}

}  // namespace

std::optional<ReadClause> read_room_order(const EditText& text, const std::string& meaning, const std::string& verb,
                                          std::size_t at) {
  const bool is_resized =
      meaning == "make" || meaning == "resize" || meaning == "want" || meaning == "move" || meaning == "change";
  if (const auto part = room_part_at(text, at); part && part->value == "ceiling" && is_resized)
    if (auto moved = move_ceiling(text, verb, part->end); moved) return moved;
  if (const auto whole = longest_in(text.edits.whole_room, text.tokens, at); whole > 0 && is_resized)
    return resize_room(text, at + whole);
  const auto opening = opening_at(text, at);
  if (!opening) {
    if (meaning != "move" && meaning != "put") return std::nullopt;
    const auto wall = wall_at(text, at);
    return wall ? std::optional(move_wall(text, *wall)) : std::nullopt;
  }
  if (!*opening) return opening->error();
  if ((*opening)->is_new && meaning != "remove" && meaning != "close") return open_there(text, **opening);
  if ((*opening)->ids.empty()) return what_at(text, at, "there is no such opening");
  if (meaning == "remove" || meaning == "close" || meaning == "unwanted")
    return Clause{{edit::Close{(*opening)->ids}}, {}, {}, (*opening)->end};
  if (meaning == "move" || meaning == "put") return move_opening(text, **opening);
  if (is_resized) return resize_openings(text, verb, **opening);
  return std::nullopt;
}

}  // namespace roomgen
