#include "room_scopes.h"

#include <algorithm>

#include "brief/opening_phrase.h"
#include "room_names.h"
#include "roomgen/base/text.h"
#include "scene/opening_kind.h"
#include "wording.h"

namespace roomgen {

namespace {

constexpr const char* of_room[] = {"in", "of", "for", "inside", "within", "from"};

std::size_t end_of_sentence(const EditText& text, std::size_t at) {
  while (at < text.tokens.size() && text.tokens[at].kind != brief::Token::Kind::stop) ++at;
  return at;
}

// "the kitchen and the bathroom"
std::optional<SpokenRooms> all_rooms_at(const EditText& text, std::size_t at) {
  auto named = rooms_named_at(text, at);
  while (named && (named->plural || named->ids.size() == 1) && text.is_word(named->end, "and")) {
    const auto more = rooms_named_at(text, named->end + 1);
    if (!more || (!more->plural && more->ids.size() > 1)) break;
    named->ids.insert(named->ids.end(), more->ids.begin(), more->ids.end());
    named->end = more->end;
    named->plural = true;
  }
  return named;
}

// What the operations change is in this room.
void place_in(edit::Operation& operation, const std::string& room) {
  const auto whole = [&](std::string& opening) {
    if (opening.find('/') == std::string::npos) opening = room + "/" + opening;
  };
  std::visit([&](auto& one) {
    if constexpr (requires { one.openings; }) std::for_each(one.openings.begin(), one.openings.end(), whole);
    if constexpr (requires { one.opening; }) whole(one.opening);
    if constexpr (requires { one.room; one.looks; } || requires { one.room; one.category; } ||
                  requires { one.room; one.kind; })
      if (one.room.empty()) one.room = room;
  }, operation);
}

// "paint the walls white": of every room.
void spread_over_rooms(const Scene& scene, Clause& clause) {
  std::vector<edit::Operation> all;
  for (const auto& operation : clause.operations) {
    const auto* cover = std::get_if<edit::Cover>(&operation);
    if (!cover || !cover->room.empty()) {
      all.push_back(operation);
      continue;
    }
    for (const auto& room : scene.rooms) all.push_back(edit::Cover{cover->part, cover->looks, room.id});
  }
  clause.operations = std::move(all);
}

const OpeningKind* opening_kind_at(const EditText& text, std::size_t at) {
  const auto& kinds = OpeningKinds::built_in();
  const std::size_t length = kinds ? brief::opening_name_at(text.tokens, at, *kinds) : 0;
  return length > 0 ? kinds->find(text.words_from(at, at + length)) : nullptr;
}

bool has_opening(const Room& room, OpeningType type) {
  return std::any_of(room.openings.begin(), room.openings.end(),
                     [&](const Opening& opening) { return opening.type == type; });
}

// Is it of walls, doors or windows, of which each room has its own?
bool speaks_of_shell(const EditText& text, std::size_t at) {
  const auto place = place_named_at(text, at);
  const bool is_of_wall =
      place && (place->place == brief::Place::window || place->place == brief::Place::door ||
                place->place == brief::Place::wall);
  return is_of_wall || opening_kind_at(text, at) || room_part_at(text, at);
}

// The rooms that have all that is named there.
Ids rooms_with_all(const EditText& text, std::size_t at, std::size_t end) {
  Ids rooms;
  for (const auto& room : text.scene.rooms) rooms.push_back(room.id);
  for (std::size_t i = at; i < end; ++i) {
    const bool is_definite = i > at && text.words.definite.count(text.tokens[i - 1].text) > 0;
    const OpeningKind* kind = opening_kind_at(text, i);
    if (kind && is_definite)
      std::erase_if(rooms, [&](const std::string& id) {
        return !has_opening(room_with_id(text.scene, id), kind->type);
      });
    const auto thing = named_thing_at(text, i);
    if (!thing || thing->which == NamedThing::Which::indefinite || thing->end > end) continue;
    const auto ids = thing->which == NamedThing::Which::pronoun ? text.latest : fitting(text, *thing);
    if (ids.empty()) continue;
    std::erase_if(rooms, [&](const std::string& room) {
      return std::none_of(ids.begin(), ids.end(), [&](const std::string& id) {
        const Object* object = text.object(id);
        return object && object->room == room;
      });
    });
  }
  return rooms;
}

}  // namespace

RoomScopes::RoomScopes(const Scene& scene) {
  if (scene.rooms.size() < 2) return;
  for (auto& part : parts_of(scene)) {
    const std::string id = part.room.id;
    parts_.emplace(id, std::move(part));
  }
}

ReadClause RoomScopes::read_in(const Ids& rooms, const EditText& text, std::size_t at, const ReadWithin& read) const {
  std::optional<Clause> all;
  ReadClause failed = what_at(text, at, "not understood");
  for (const auto& room : rooms) {
    EditText within = in_scene(text, parts_.at(room));
    auto clause = read(within, at);
    if (!goes_to_its_end(within, clause)) {
      failed = clause ? what_at(text, clause->end, "not understood") : std::move(clause);
      continue;
    }
    for (auto& operation : clause->operations) place_in(operation, room);
    clause->end += text.tokens.size() - within.tokens.size();
    if (!all) all = *std::move(clause);
    else if (all->end != clause->end) return what_at(text, at, "it is not the same in " + join(rooms, ", "));
    else {
      const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
      append(all->operations, clause->operations);
      append(all->about, clause->about);
      append(all->coming, clause->coming);
      append(all->gone, clause->gone);
    }
  }
  return all ? ReadClause(*std::move(all)) : failed;
}

std::vector<RoomScopes::Wording> RoomScopes::wordings(const EditText& text, std::size_t at) {
  std::vector<Wording> all;
  const std::size_t end = end_of_sentence(text, at);
  const auto add = [&](std::size_t begin, std::size_t behind, const char* instead, const SpokenRooms& named) {
    EditText other = without(text, begin, behind);
    if (*instead) insert_word(other, begin, instead);
    all.push_back({std::move(other), begin, named.ids, named.plural, text.words_from(named.begin, named.end)});
  };
  for (std::size_t i = at; i < end; ++i) {
    const bool is_told = std::any_of(std::begin(of_room), std::end(of_room),
                                     [&](const char* word) { return text.is_word(i, word); });
    if (const auto named = is_told ? all_rooms_at(text, i + 1) : std::nullopt) {
      add(i, i == at ? text.behind_comma(named->end) : named->end, "", *named);
      continue;
    }
    const auto named = all_rooms_at(text, i);
    if (!named) continue;
    add(named->begin, named->end, "", *named);
    add(i, named->end, "room", *named);
    i = named->end - 1;
  }
  return all;
}

ReadClause RoomScopes::read_as(const EditText& text, const Wording& wording, std::size_t at, const ReadWithin& read) {
  auto clause = read_in(wording.rooms, wording.text, at, read);
  if (!clause) return clause;
  if (clause->end < wording.begin) return what_at(wording.text, clause->end, "not understood");
  if (wording.rooms.size() > 1 && !wording.plural) return several_rooms(wording.named, wording.rooms);
  standing_ = wording.rooms;
  clause->end += text.tokens.size() - wording.text.tokens.size();
  return clause;
}

ReadClause RoomScopes::read_implied(const EditText& text, std::size_t at, const ReadWithin& read,
                                    const ReadClause& plain) const {
  std::size_t end = at;
  bool is_of_shell = false;
  for (; !text.ends(end); ++end) is_of_shell = is_of_shell || speaks_of_shell(text, end);
  if (!is_of_shell) return plain;
  const Ids rooms = rooms_with_all(text, at, end);
  if (rooms.size() == 1) return read_in(rooms, text, at, read);
  for (const auto& room : rooms)
    if (read_in({room}, text, at, read)) return several_rooms(text.words_from(at, end), rooms);
  return plain;
}

// What is wrong with the clause is told of the room that it names.
ReadClause RoomScopes::read_wordings(const EditText& text, std::size_t at, const std::vector<Wording>& wordings,
                                     const ReadWithin& read, const ReadClause& plain) {
  std::optional<ReadClause> failed;
  for (const auto& wording : wordings) {
    auto clause = read_as(text, wording, at, read);
    if (clause) return clause;
    if (!failed) failed = std::move(clause);
  }
  return failed ? *std::move(failed) : read_implied(text, at, read, plain);
}

ReadClause RoomScopes::read(EditText& text, std::size_t at, const ReadWithin& read) {
  if (parts_.empty()) return read(text, at);
  if (!standing_.empty())
    if (auto clause = read_in(standing_, text, at, read)) return clause;
  // "in the bedroom, …"
  const auto wording = wordings(text, at);
  if (!wording.empty() && wording.front().begin == at)
    if (auto clause = read_as(text, wording.front(), at, read)) return clause;
  auto plain = read(text, at);
  if (goes_to_its_end(text, plain)) {
    spread_over_rooms(text.scene, *plain);
    return plain;
  }
  return read_wordings(text, at, wording, read, plain);
}

}  // namespace roomgen
