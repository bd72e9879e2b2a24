#pragma once

#include <string>

#include "brief/brief.h"
#include "brief/prompt.h"
#include "brief/room_kinds.h"
#include "roomgen/kinds/kind_table.h"

/// What is read in a prompt, with the kinds of rooms and things that are built in.
inline roomgen::brief::Brief read_brief(const std::string& prompt) {
  return roomgen::brief::read_prompt(prompt, *roomgen::brief::built_in_room_kinds(), roomgen::KindTable::built_in());
}

// "2 chair, 1 table"
inline std::string things(const roomgen::brief::Brief& brief) {
  std::string text;
  for (const auto& mention : brief.mentions)
    text += (text.empty() ? "" : ", ") + std::to_string(mention.quantity) + " " + mention.category;
  return text;
}

// "near table | edge": by the categories of the targets.
inline std::string places(const roomgen::brief::Brief& brief, std::size_t mention) {
  std::string text;
  for (const auto& demand : brief.mentions.at(mention).demands) {
    text += text.empty() ? "" : " | ";
    text += name(demand.kind);
    if (demand.mention != roomgen::brief::Demand::none)
      text += ", " + brief.mentions[demand.mention].category;
    else if (!demand.part.empty())
      text += ", " + demand.part;
  }
  return text;
}
