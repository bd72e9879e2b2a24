#include "spots.h"

#include <algorithm>

namespace roomgen {

namespace {

using Token = design::Token;

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
std::optional<Result<Whereabouts>> where_it_is(const EditText& text, std::size_t at, const std::vector<std::string>& subjects) {
  if (text.is_word(at, "to") || text.is_word(at, "at") || text.is_word(at, "right") || text.is_word(at, "exactly")) ++at;
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

// "in the place of the chair", "in the chair's place", "in its place"
std::optional<Result<Whereabouts>> in_place_of(const EditText& text, std::size_t at, const std::vector<std::string>& subjects) {
  const auto of = longest_in(text.edits.place_of, text.tokens, at);
  if (of > 0) {
    const auto target = target_at(text, at + of, subjects);
    if (!target) return std::nullopt;
    if (!*target) return target->error();
    return place_of_thing(text, (*target)->id, (*target)->end);
  }
  if (const auto there = longest_in(text.edits.there, text.tokens, at); there > 0 && text.gone.size() == 1 && text.ends(at + there))
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
    const auto side = design::longest(text.edits.sides_of_things, text.tokens, at, 2);
    more = static_cast<bool>(side) && !text.is_word(at + side.length, "of");
    if (more) way += *side.value, at += side.length;
  }
  const auto part = design::longest(text.edits.parts_of_things, text.tokens, at, 2);
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
Result<Whereabouts> on_part(const EditText& text, const PartOfThing& part, const Object& host, const Object& subject,
                            std::size_t end) {
  if (!text.kinds.get(host.category).supports) return not_understood("nothing stands on " + host.id);
  const double reach = 0.5 * std::max(subject.size.x(), subject.size.y());
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

std::optional<Result<Whereabouts>> part_of_thing(const EditText& text, std::size_t at, const std::vector<std::string>& subjects) {
  const auto before = longest_in(text.edits.at_parts, text.tokens, at);
  if (before == 0) return std::nullopt;
  // "at its head"
  if (text.is_word(at + before, "its") && text.latest.size() == 1) {
    const auto own = design::longest(text.edits.parts_of_things, text.tokens, at + before + 1, 2);
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
    if (subjects.size() != 1) return std::nullopt;
    return on_part(text, *part, *host, *text.object(subjects.front()), (*target)->end);
  }
  auto relations = beside_part(part->way, host->id);
  if (!relations) return std::nullopt;
  return Whereabouts{*std::move(relations), {}, (*target)->end};
}

}  // namespace

std::optional<Result<Whereabouts>> spot_at(const EditText& text, std::size_t at, const std::vector<std::string>& subjects) {
  for (const auto& read : {where_it_is, in_place_of, part_of_thing})
    if (auto spot = read(text, at, subjects)) return spot;
  return std::nullopt;
}

}  // namespace roomgen
