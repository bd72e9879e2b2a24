#include <algorithm>

#include "destinations.h"

namespace roomgen {

namespace {

using Token = brief::Token;

constexpr double at_side = 1.0;  // metres within which something is at the side of another

// Which way from the middle of a thing, in its own frame: halves of its width and depth.
struct PartOfThing {
  Vec2 way = Vec2::Zero();
  std::size_t end = 0;
};

bool is_definite(const EditText& text, std::size_t at) {
  return at < text.tokens.size() && text.words.definite.count(text.tokens[at].text) > 0;
}

Spot place_of(const Object& object) { return {object.position.head<2>(), object.on, object.id, true}; }

std::optional<Result<Whereabouts>> place_of_thing(const EditText& text, const std::string& id, std::size_t end) {
  const Object* object = find_object(text.scene, id);
  if (!object) return not_understood(id + " has no place yet");
  return Whereabouts{{}, place_of(*object), end};
}

// "where the lamp is now"
std::optional<Result<Whereabouts>> where_it_is(const EditText& text, std::size_t at,
                                               const std::vector<std::string>& subjects) {
  if (text.is_word(at, "to") || text.is_word(at, "at") || text.is_word(at, "right") || text.is_word(at, "exactly"))
    ++at;
  if (!text.is_word(at, "where")) return std::nullopt;
  const auto target = target_at(text, at + 1, subjects);
  if (!target) return std::nullopt;
  if (!*target) return target->error();
  const auto is = longest_in(text.edits.being, text.tokens, (*target)->end);
  if (is == 0) return std::nullopt;
  std::size_t end = (*target)->end + is;
  end += longest_in(text.edits.presently, text.tokens, end);
  return place_of_thing(text, (*target)->id, end);
}

// Of several posters that went any has a place for what comes instead.
bool are_alike(const EditText& text, const std::vector<std::string>& ids) {
  return !ids.empty() && std::all_of(ids.begin(), ids.end(), [&](const std::string& id) {
    const Object* object = text.object(id);
    return object && object->category == text.object(ids.front())->category;
  });
}

// "in the place of the chair", "in the chair's place", "in its place"
std::optional<Result<Whereabouts>> in_place_of(const EditText& text, std::size_t at,
                                               const std::vector<std::string>& subjects) {
  const auto of = longest_in(text.edits.place_of, text.tokens, at);
  if (of > 0) {
    const auto target = target_at(text, at + of, subjects);
    if (!target) return std::nullopt;
    if (!*target) return target->error();
    return place_of_thing(text, (*target)->id, (*target)->end);
  }
  if (const auto there = longest_in(text.edits.there, text.tokens, at);
      there > 0 && are_alike(text, text.gone) && text.ends(at + there))
    return place_of_thing(text, text.gone.front(), at + there);
  if (!text.is_word(at, "in") && !text.is_word(at, "into") && !text.is_word(at, "to")) return std::nullopt;
  const auto thing = named_thing_at(text, at + 1);
  if (!thing || thing->which == NamedThing::Which::pronoun) return std::nullopt;
  if (!text.is_word(thing->end, "place") && !text.is_word(thing->end, "spot")) return std::nullopt;
  const auto target = target_at(text, at + 1, subjects);
  if (!target || !*target) return std::nullopt;
  return place_of_thing(text, (*target)->id, thing->end + 1);
}

// "the left edge of", "the front of", "the far right-hand corner of"
std::optional<PartOfThing> part_at(const EditText& text, std::size_t at) {
  if (!is_definite(text, at)) return std::nullopt;
  ++at;
  Vec2 way = Vec2::Zero();
  for (bool more = true; more;) {
    const auto side = brief::longest(text.edits.sides_of_things, text.tokens, at, 2);
    more = static_cast<bool>(side) && !text.is_word(at + side.length, "of");
    if (more) way += *side.value, at += side.length;
  }
  const auto part = brief::longest(text.edits.parts_of_things, text.tokens, at, 2);
  if (!part || !text.is_word(at + part.length, "of")) return std::nullopt;
  way += *part.value;
  return PartOfThing{way, at + part.length + 1};
}

bool stands_on_others(const EditText& text, const std::vector<std::string>& subjects) {
  return !subjects.empty() && std::all_of(subjects.begin(), subjects.end(), [&](const std::string& id) {
    const Object* object = text.object(id);
    return object && object->mount == Mount::surface;
  });
}

// On the thing, so that the other stands there with all of itself. As seen from in front of it.
Result<Whereabouts> on_part(const EditText& text, const PartOfThing& part, const Object& host, double reach,
                            std::size_t end) {
  const auto stands_there = [&](const Object& object) { return object.on == host.id; };
  const bool carries = std::any_of(text.scene.objects.begin(), text.scene.objects.end(), stands_there);
  if (!carries && !text.kinds.get(host.category).supports) return not_understood("nothing stands on " + host.id);
  const Footprint area = footprint(host);
  const Vec2 room = (area.half() - Vec2::Constant(reach)).cwiseMax(0.0);
  const Vec2 seen(-part.way.x(), part.way.y());  // who looks at its front sees its own left on the right
  return Whereabouts{{}, Spot{area.to_world(room.cwiseProduct(seen)), host.id, host.id, false}, end};
}

// At a side of what stands on the floor. The front of a bar is before it; its ends are at its sides.
std::optional<std::vector<Relation>> beside_part(const Vec2& way, const std::string& id) {
  if (way.x() != 0.0 && way.y() != 0.0) return std::nullopt;
  if (way.y() < 0.0) return std::vector<Relation>{{RelationKind::in_front_of, id}};
  if (way.y() > 0.0) return std::vector<Relation>{{RelationKind::behind, id}};
  if (way.x() == 0.0) return std::vector<Relation>{{RelationKind::near, id}};
  return std::vector<Relation>{{way.x() < 0.0 ? RelationKind::right_of : RelationKind::left_of, id}};
}

std::optional<Result<Whereabouts>> part_of_thing(const EditText& text, std::size_t at,
                                                 const std::vector<std::string>& subjects) {
  const auto before = longest_in(text.edits.at_parts, text.tokens, at);
  if (before == 0) return std::nullopt;
  // "at its head"
  if (text.is_word(at + before, "its") && text.latest.size() == 1) {
    const auto own = brief::longest(text.edits.parts_of_things, text.tokens, at + before + 1, 2);
    const auto relations = own ? beside_part(*own.value, text.latest.front()) : std::nullopt;
    if (relations) return Whereabouts{*relations, {}, at + before + 1 + own.length};
  }
  const auto part = part_at(text, at + before);
  if (!part) return std::nullopt;
  const auto target = target_at(text, part->end, subjects);
  if (!target || !*target) return std::nullopt;
  const Object* host = find_object(text.scene, (*target)->id);
  if (!host) return std::nullopt;
  if (stands_on_others(text, subjects)) {
    double reach = 0.0;
    for (const auto& id : subjects) reach = std::max(reach, 0.5 * text.object(id)->size.head<2>().maxCoeff());
    return on_part(text, *part, *host, reach, (*target)->end);
  }
  auto relations = beside_part(part->way, host->id);
  if (!relations) return std::nullopt;
  return Whereabouts{*std::move(relations), {}, (*target)->end};
}

// Which side of a thing another one is at, in its frame: the axis by which it is farther out.
Vec2 side_at(const Object& host, const Object& object) {
  const Footprint area = footprint(host);
  const Vec2 off = Vec2(object.position.head<2>()) - Vec2(host.position.head<2>());
  const Vec2 own(off.dot(area.x_axis()), off.dot(area.y_axis()));
  const Vec2 beyond = own.cwiseAbs() - area.half();
  if (beyond.x() >= beyond.y()) return {own.x() < 0.0 ? -1.0 : 1.0, 0.0};
  return {0.0, own.y() < 0.0 ? -1.0 : 1.0};
}

RelationKind relation_at(const Vec2& side) {
  if (side.y() != 0.0) return side.y() < 0.0 ? RelationKind::in_front_of : RelationKind::behind;
  return side.x() < 0.0 ? RelationKind::right_of : RelationKind::left_of;
}

// The one of them that tells which side is this one: what goes there, or what is like what comes.
const Object* at_this_side(const EditText& text, const std::vector<std::string>& subjects, const Object& host) {
  if (!subjects.empty()) return find_object(text.scene, subjects.front());
  const Object* only = nullptr;
  for (const auto& object : text.scene.objects) {
    const bool is_named = object.room == host.room && object.id != host.id &&
                          std::any_of(text.tokens.begin(), text.tokens.end(), [&](const Token& token) {
                            return object.category == token.text || object.category.ends_with(" " + token.text);
                          });
    if (!is_named || gap(footprint(object), footprint(host)) > at_side) continue;
    if (only) return nullptr;
    only = &object;
  }
  return only;
}

// "to the other side of the room": the half in which it does not stand.
std::optional<Result<Whereabouts>> other_half(const EditText& text, std::size_t at,
                                              const std::vector<std::string>& subjects) {
  const auto room_words = longest_in(text.edits.whole_room, text.tokens, at);
  const Object* object = subjects.size() == 1 ? find_object(text.scene, subjects.front()) : nullptr;
  if (room_words == 0 || !object) return std::nullopt;
  const Bounds2 box = bounds(room_of(text.scene, *object).polygon);
  const Vec2 off = (Vec2(object->position.head<2>()) - 0.5 * (box.low + box.high)).cwiseQuotient(box.size());
  const bool is_across = std::abs(off.x()) >= std::abs(off.y());
  const char* half =
      is_across ? (off.x() < 0.0 ? "east-half" : "west-half") : (off.y() < 0.0 ? "north-half" : "south-half");
  return Whereabouts{{{RelationKind::in_part, half}}, {}, at + room_words};
}

// "on the other side of the bed": opposite to where it is now, or to the one that is there already.
std::optional<Result<Whereabouts>> other_side(const EditText& text, std::size_t at,
                                              const std::vector<std::string>& subjects) {
  const auto length = longest_in(text.edits.other_side, text.tokens, at);
  if (length == 0) return std::nullopt;
  if (auto half = other_half(text, at + length, subjects)) return half;
  const auto target = target_at(text, at + length, subjects);
  if (!target) return std::nullopt;
  if (!*target) return target->error();
  const Object* host = find_object(text.scene, (*target)->id);
  if (!host) return std::nullopt;
  const Object* there = at_this_side(text, subjects, *host);
  if (!there)
    return not_understood("it is not clear which side of " + host->id + " is the other one; say left or right");
  return Whereabouts{{{relation_at(-side_at(*host, *there)), host->id}}, {}, (*target)->end};
}

}  // namespace

std::optional<Result<Whereabouts>> spot_at(const EditText& text, std::size_t at,
                                           const std::vector<std::string>& subjects) {
  for (const auto& read : {where_it_is, in_place_of, other_side, part_of_thing})
    if (auto spot = read(text, at, subjects)) return spot;
  return std::nullopt;
}

}  // namespace roomgen
