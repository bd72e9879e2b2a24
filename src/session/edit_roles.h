#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "edit_text.h"

namespace roomgen {

/// What words of an edit are there for.
enum class EditRole : std::uint8_t {
  order,   ///< say what to do: "move", "get rid of", "could … go"
  thing,   ///< what the order is about, with its own clause that says which
  place,   ///< "next to", "to the left"
  target,  ///< what a place is told by
  amount,  ///< "20 cm", "a bit", "twice as"
  look,    ///< how it shall become, or what shall come instead
  next,    ///< begins a further order: "and", "then"
  idle,    ///< asks nothing: courtesies, reasons, remarks
  keep     ///< what shall stay as it is
};
inline constexpr std::size_t edit_role_count = 9;
inline constexpr std::array<std::string_view, edit_role_count> edit_role_names = {
    "do", "thing", "place", "target", "amount", "look", "next", "idle", "keep"};

/// What an order is for.
enum class EditDeed : std::uint8_t {
  add, remove, move, turn, face, swap, replace, resize, recolour, lock, unlock, rearrange, room, undo
};
inline constexpr std::size_t deed_count = 14;
inline constexpr std::array<std::string_view, deed_count> deed_names = {
    "add",    "remove",   "move", "turn",   "face",      "swap", "replace",
    "resize", "recolour", "lock", "unlock", "rearrange", "room", "undo"};

/// Where something shall go, in the words of data/words.json.
inline constexpr std::array<std::string_view, 17> place_names = {
    "next to", "near", "on", "under", "above", "between", "in front of", "behind", "against wall", "corner",
    "towards", "away from", "left of", "right of", "around", "opposite", "in"};
inline constexpr std::array<const char*, place_names.size()> place_words = {
    "next to", "near", "on", "under", "above", "between", "in front of", "behind", "against", "in",
    "closer to", "away from", "to the left of", "to the right of", "around", "opposite", "in"};

/// Of the labels that are learned: roles, then deeds, then places.
inline constexpr std::size_t first_deed = edit_role_count, first_place = first_deed + deed_count;
inline constexpr std::size_t role_label_count = first_place + place_names.size();

/// Words next to each other with the same role.
struct RoleStretch {
  EditRole role = EditRole::idle;
  std::size_t begin = 0, end = 0;  ///< tokens
};
std::vector<RoleStretch> stretches_of(const std::vector<EditRole>& roles);

/// One order of a text: its stretches from left to right, and those that ask nothing before it.
struct SpokenOrder {
  std::vector<RoleStretch> remarks, parts;
  bool has(EditRole role) const;
};
/// Where a text has several orders, a mark or "and" parts them.
std::vector<SpokenOrder> orders_of(const EditText& text, const std::vector<RoleStretch>& stretches);

}  // namespace roomgen
