#include <algorithm>

#include "clause_parts.h"
#include "edit/placing.h"
#include "room_names.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;

constexpr double clearly_nearer = 0.3;  // metres by which one is nearer than the others
constexpr double reach = 0.75;          // metres within which something is at another

bool is_among(const Ids& ids, const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

Ids those_where(const EditText& text, Ids ids, const std::vector<Relation>& relations) {
  std::erase_if(ids, [&](const std::string& id) {
    const Object* object = find_object(text.scene, id);
    return !object || !lost_relations(*object, relations, text.scene, text.kinds).empty();
  });
  return ids;
}

double distance_to(const EditText& text, const Object& object, const std::string& target) {
  if (const Object* other = find_object(text.scene, target)) return gap(footprint(object), footprint(*other));
  const Room& room = room_of(text.scene, object);
  if (const Opening* opening = find_opening(room, target)) return gap(footprint(object), segment(room, *opening));
  return 1e9;
}

// The nearest of them first, `count` of them, if the next one is clearly farther.
Result<Ids> nearest_to(const EditText& text, Ids ids, const std::string& target, std::size_t count, double sign,
                       double margin) {
  const auto away = [&](const std::string& id) { return sign * distance_to(text, *text.object(id), target); };
  std::stable_sort(ids.begin(), ids.end(),
                   [&](const std::string& a, const std::string& b) { return away(a) < away(b); });
  if (ids.size() > count) {
    if (away(ids[count]) - away(ids[count - 1]) < margin)
      return not_understood(ids[count - 1] + " and " + ids[count] + " are about as near to " + target +
                            "; say which one");
    ids.resize(count);
  }
  return ids;
}

std::size_t number_of(const NamedThing& thing) { return thing.count > 0 ? static_cast<std::size_t>(thing.count) : 1; }

// "nearest the door", "farthest from the counter"
MayRead<Ids> extreme_of(const EditText& text, const NamedThing& thing, const Ids& ids) {
  const bool is_near = text.is_word(thing.end, "nearest") || text.is_word(thing.end, "closest");
  const auto farthest = longest_in(text.edits.farthest, text.tokens, thing.end);
  if (!is_near && farthest == 0) return std::nullopt;
  const auto length = is_near ? longest_in(text.edits.nearest, text.tokens, thing.end) : farthest;
  const auto target = target_at(text, thing.end + length, ids);
  if (!target) return std::nullopt;
  if (!*target) return target->error();
  auto few = nearest_to(text, ids, (*target)->id, number_of(thing), is_near ? 1.0 : -1.0, 1e-3);
  if (!few) return few.error();
  return Read<Ids>{*std::move(few), (*target)->end};
}

// "off the desk", "from the desk": what is cleared was on it.
std::optional<Result<Whereabouts>> place_of_reference(const EditText& text, std::size_t at, const NamedThing& thing,
                                                      const Ids& ids) {
  if (const auto room = in_room_at(text, at); room && *room) return Whereabouts{{}, {}, (*room)->end, (*room)->value};
  if (text.is_word(at, "off") || text.is_word(at, "from") || text.is_word(at, "of")) {
    const auto target = target_at(text, at + 1, {});
    if (!target) return std::nullopt;
    if (!*target) return target->error();
    return Whereabouts{{{RelationKind::on, (*target)->id}}, {}, (*target)->end};
  }
  return destination_at(text, at, thing.which == Which::everything ? Ids() : ids);
}

bool is_nearness(const std::vector<Relation>& relations) {
  return !relations.empty() && std::all_of(relations.begin(), relations.end(), [](const Relation& relation) {
    return relation.kind == RelationKind::near || relation.kind == RelationKind::next_to ||
           relation.kind == RelationKind::side_of;
  });
}

// "by the window": of several the one that is clearly nearest to it.
MayRead<Ids> told_by_place(const EditText& text, const NamedThing& thing, const Ids& all, std::size_t at) {
  const auto place = place_of_reference(text, at, thing, all);
  if (!place) return std::nullopt;
  if (!*place) return place->error();
  if ((*place)->spot) return std::nullopt;
  if (const std::string& room = (*place)->room; !room.empty()) {
    Ids inside = all;
    std::erase_if(inside, [&](const std::string& id) { return text.object(id)->room != room; });
    auto there = meant(text, thing, &inside);
    if (!there) return there.error();
    return Read<Ids>{*std::move(there), (*place)->end};
  }
  const Ids among = those_where(text, all, (*place)->relations);
  auto ids = meant(text, thing, &among);
  const bool is_one = thing.which == Which::definite && (!thing.plural || thing.count > 0);
  if (!ids && is_one && all.size() > number_of(thing) && is_nearness((*place)->relations))
    ids = nearest_to(text, all, (*place)->relations.front().target, number_of(thing), 1.0, clearly_nearer);
  if (!ids) return ids.error();
  return Read<Ids>{*ids, (*place)->end};
}

// "isn't at the bar", behind "that": all others.
MayRead<Ids> told_by_absence(const EditText& text, const NamedThing& thing, const Ids& all, std::size_t at) {
  const auto place = destination_at(text, at, all);
  if (!place) return std::nullopt;
  if (!*place) return place->error();
  if ((*place)->spot) return std::nullopt;
  Ids there = is_nearness((*place)->relations) ? all : those_where(text, all, (*place)->relations);
  if (is_nearness((*place)->relations))
    std::erase_if(there, [&](const std::string& id) {
      return distance_to(text, *text.object(id), (*place)->relations.front().target) > reach;
    });
  Ids others = all;
  std::erase_if(others, [&](const std::string& id) { return is_among(there, id); });
  auto ids = meant(text, thing, &others);
  if (!ids) return ids.error();
  return Read<Ids>{*ids, (*place)->end};
}

// "that is too high": which is the most so.
MayRead<Ids> told_by_size(const EditText& text, NamedThing thing, std::size_t at) {
  if (text.is_word(at, "too") || text.is_word(at, "so")) ++at;
  if (at >= text.tokens.size()) return std::nullopt;
  const auto size = text.edits.sizes.find(text.tokens[at].text);
  if (size == text.edits.sizes.end()) return std::nullopt;
  thing.size = size->second;
  const auto ids = meant(text, thing);
  if (!ids) return ids.error();
  return Read<Ids>{*ids, at + 1};
}

// "that is on the left", "which isn't at the bar", "not at the bar"
MayRead<Ids> told_by_clause(const EditText& text, const NamedThing& thing, const Ids& all) {
  std::size_t at = thing.end;
  const bool is_relative = text.is_word(at, "that") || text.is_word(at, "which");
  if (is_relative) ++at;
  bool denies = false;
  if (is_relative) {
    const auto are = longest_in(text.edits.being, text.tokens, at);
    const auto are_not = longest_in(text.edits.not_being, text.tokens, at);
    if (std::max(are, are_not) == 0) return std::nullopt;
    denies = are_not >= are;
    at += std::max(are, are_not);
  }
  if (text.is_word(at, "not")) denies = true, ++at;
  if (denies) return told_by_absence(text, thing, all, at);
  if (!is_relative) return std::nullopt;
  if (auto place = told_by_place(text, thing, all, at)) return place;
  return told_by_size(text, thing, at);
}

// "on the left": the one that is there, seen in the picture.
MayRead<Ids> told_by_side(const EditText& text, NamedThing thing) {
  const auto side = brief::longest(text.edits.side_tails, text.tokens, thing.end);
  if (!side || thing.which == Which::everything || text.is_word(thing.end + side.length, "of")) return std::nullopt;
  // "on the left nightstand"
  if (const std::size_t next = thing.end + side.length; !text.ends(next) && named_thing_at(text, next))
    return std::nullopt;
  thing.side = *side.value;
  const auto ids = meant(text, thing);
  if (!ids) return ids.error();
  return Read<Ids>{*ids, thing.end + side.length};
}

MayRead<Ids> just_added(const EditText& text, const NamedThing& thing) {
  const auto length = longest_in(text.edits.just_added, text.tokens, thing.end);
  if (length == 0) return std::nullopt;
  Ids ids = fitting(text, thing);
  std::erase_if(ids, [&](const std::string& id) { return !is_among(text.recall.added, id); });
  if (ids.empty()) return not_understood("no \"" + thing.kind.name + "\" was added just now");
  return Read<Ids>{ids, thing.end + length};
}

}  // namespace

MayRead<Ids> told_by_tail(const EditText& text, const NamedThing& thing) {
  if (auto added = just_added(text, thing)) return added;
  if (thing.which == Which::pronoun) return std::nullopt;
  const Ids all = fitting(text, thing);
  if (auto extreme = extreme_of(text, thing, all)) return extreme;
  if (auto clause = told_by_clause(text, thing, all)) return clause;
  if (auto side = told_by_side(text, thing)) return side;
  return told_by_place(text, thing, all, thing.end);
}

}  // namespace roomgen
