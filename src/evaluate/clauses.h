#pragma once

#include "evaluate/finding.h"
#include "evaluate/ledger.h"
#include "scene/finish_words.h"

namespace roomgen {

/// Why not every owner has `count` of the things that are its own, each thing being one owner's at
/// most; empty if every one has. `belongs` tells whether a thing is where the owner's would be.
std::string each_fault(std::span<const Object* const> things, std::span<const std::string> owners, int count,
                       const std::function<bool(const Object&, const std::string&)>& belongs);

/// Why not every corner of a room has `count` of the things; a thing that is in a corner is in the
/// nearest.
std::string corners_fault(std::span<const Object* const> things, const Room& room, int count,
                          const std::function<bool(const Object&)>& is_in_corner);

/// Why things do not stand in so many straight rows (0: however many there are, at least two), as
/// many in each, or fewer in one of them; empty if they do. A row's centres lie within 0.15 m of a
/// line along a side of the first thing, none farther than 2.5 m from the next.
std::string rows_fault(std::span<const Object* const> things, int rows);

/// Why things (three or more) do not stand in a circle, empty if they do: their centres within 0.25
/// m of it (the best by least squares), and no gap between neighbours wider than 1.6 times the even
/// one.
std::string circle_fault(std::span<const Object* const> things);

/// Why things (three or more) do not stand in an arc, empty if they do: their centres within 0.25 m
/// of a circle, of which they span from 80 to 300 degrees, no gap between neighbours within it
/// twice as wide as the even one.
std::string arc_fault(std::span<const Object* const> things);

/// Why things do not stand in islands of so many, empty if they do: those of one are at most 0.12 m
/// apart, those of different ones farther; what is left over when they are dealt out may make a
/// smaller one.
std::string islands_fault(std::span<const Object* const> things, int size);

/// What is there besides the things of a requirement of Kind::only: of its kind, on one of its
/// targets (or on what stands there), of its mount; of any kind and anywhere where it names none.
/// Empty if nothing is.
std::string other_fault(const Requirement& requirement, const Scene& scene,
                        const std::function<bool(const Object&)>& is_of_kind);

/// Whether a room is as a requirement of Kind::room asks: measured on its polygon and openings.
/// docs/requirements.md lists what may be asked.
Finding judge_room(const Requirement& requirement, const Room& room);

/// Can so many people sit (scene/attribute_names.h)? A chair or a stool seats one, a wider seat one
/// on each 0.6 m.
Finding judge_seats(const Requirement& requirement, const Scene& scene, const KindTable& kinds);

/// What is seen of a part of a room that is covered with `worn` instead of what was asked: "partly:
/// drawn as grey metal plates; nothing draws "riveted"". Empty if all of it is.
std::string finish_fault(std::string_view asked, std::string_view worn, RoomPart part,
                         std::string_view room_type);

/// Is a room lit as a clause of its light says ("bright noon", "candlelight")? Not judged if it
/// speaks of no light.
Finding judge_light(const std::string& said, const Lighting& light);

/// The attributes of requirements of Kind::room about how a room looks as a whole; their category
/// is the style, or the colours and stuffs.
inline constexpr std::string_view style_of_room = "style", palette_of_room = "palette";

/// Is at least half of the furniture of a style (docs/finishes.md)? What stands on other things
/// does not count, nor what nothing is known of.
Finding judge_style(const Requirement& requirement, const Scene& scene, const AttributeJudge& has_attribute);

/// Is each word of a palette that of the floor, the walls, the ceiling or of some thing?
Finding judge_palette(const Requirement& requirement, const Scene& scene, const AttributeJudge& has_attribute);

}  // namespace roomgen
