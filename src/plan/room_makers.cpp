#include "room_makers.h"

#include <algorithm>
#include <cstdio>

#include "roomgen/base/text.h"
#include "roomgen/geometry/polygon.h"

namespace roomgen::plan {

namespace {

constexpr const char* least_that_does = " is the least size that would do";

// "toilet, bathtub or shower"
std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return join(names, "");
  return join({names.begin(), names.end() - 1}, ", ") + " or " + names.back();
}

std::string with_article(const std::string& noun) {
  const bool is_vowel =
      !noun.empty() && std::string_view("aeio").find(noun.front()) != std::string_view::npos;
  return (is_vowel ? "an " : "a ") + noun;
}

std::string sides(const Vec2& size) {
  return format_number(size.x(), 2) + " x " + format_number(size.y(), 2) + " m";
}

}  // namespace

std::vector<std::string> usual_makers(const brief::RoomKind& kind, const KindTable& table) {
  const auto brings = [&](const brief::Piece& piece, const std::string& maker) {
    return std::any_of(piece.any.begin(), piece.any.end(),
                       [&](const auto& choice) { return table.is_a(choice.first, maker); });
  };
  std::vector<std::string> usual;
  for (const auto& maker : kind.made_by)
    if (std::any_of(kind.core.begin(), kind.core.end(),
                    [&](const brief::Piece& piece) { return brings(piece, maker); }))
      usual.push_back(maker);
  return usual;
}

std::vector<std::string> needed_makers(const brief::RoomKind& kind, const brief::Brief& brief,
                                       const KindTable& table) {
  if (brief.bare) return {};
  brief::RoomKind wanted = kind;
  wanted.made_by.clear();
  for (const auto& maker : kind.made_by)
    if (!table.is_any_of(maker, brief.excluded)) wanted.made_by.push_back(maker);
  // Who wants no bed means no sofa bed either.
  return usual_makers(wanted, table).empty() ? std::vector<std::string>() : wanted.made_by;
}

Error no_place_for(const std::vector<std::string>& makers, const Room& room) {
  const Vec2 size = bounds(room.polygon).size();
  return {Error::Kind::too_small, with_article(room.type) + " of " + sides(size) +
                                      " cannot be one: no " + listed(makers) +
                                      " finds a place in it"};
}

Error with_least(const Error& too_small, const std::optional<Vec2>& least) {
  const std::string found = least ? sides(*least) + least_that_does
                                  : "nor does one in any larger room that was tried";
  return {too_small.kind,
          too_small.message.substr(0, too_small.message.rfind("; ")) + "; " + found};
}

std::optional<Vec2> told_least(const Error& too_small) {
  const auto told = too_small.message.rfind("; ");
  Vec2 size;
  if (told == std::string::npos || !too_small.message.ends_with(least_that_does))
    return std::nullopt;
  if (std::sscanf(too_small.message.c_str() + told, "; %lf x %lf m", &size.x(), &size.y()) != 2)
    return std::nullopt;
  return size;
}

}  // namespace roomgen::plan
