#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "thing_phrase.h"

namespace roomgen::brief {

/// A kind of room by a noun that may be no kind's name: "The room is an observatory", "A post office with ...".
struct StatedRoom {
  std::string name;       ///< "post office"
  language::Run tokens;   ///< of the name
  bool is_told = false;   ///< said of the room, rather than merely what the prompt begins with
};

/// What a prompt calls its room; not where `is_named` says of its head that a kind of room is called so.
std::optional<StatedRoom> stated_room(const PromptText& text, const std::function<bool(std::uint32_t)>& is_named);

/// The kind of room of which that is one, by WordNet: a tearoom is a cafe; empty if it is none that is known.
std::string near_room(std::string_view name, const std::map<std::string, std::string, std::less<>>& names);

}  // namespace roomgen::brief
