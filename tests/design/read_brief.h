#pragma once

#include <string>

#include "brief/brief.h"
#include "brief/prompt.h"
#include "brief/room_kinds.h"
#include "roomgen/kinds/kind_table.h"

/// What is read in a prompt, with the kinds of rooms and things that are built in.
inline roomgen::design::Brief read_brief(const std::string& prompt) {
  return roomgen::design::read_prompt(prompt, *roomgen::design::built_in_room_kinds(), roomgen::KindTable::built_in());
}
