#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Whether an attachment says where something is not: "not next to the window", "none of them in
/// the corner".
bool denies_place(const PromptReading& reading, const language::Attachment& attachment);

/// Enters what it says into the brief: it is known where they are not.
void read_denied_place(PromptReading& reading, const language::Attachment& attachment);

/// "side by side", "back to back", "facing each other" of things: the last two of them, or the
/// halves of several. Of several that stand next to each other a row is made.
void relate_mutually(PromptReading& reading, const Indices& things, const Placement& placement);

/// The same said behind a list or a noun, at a token: "a desk and a shelf side by side". `heard`:
/// the words that say so.
void relate_listed(PromptReading& reading, std::size_t token, const Placement& placement, std::size_t heard);

/// "at opposite ends of the room", "along both long walls": whether an attachment names places that
/// there are two of.
std::optional<Discourse::Both> two_places(const PromptReading& reading, const language::Attachment& attachment,
                                          const SaidPlacement& said);

/// "on the left and right", "on the left and right walls", which the parse takes for two places:
/// the words from the first on.
std::optional<language::Run> left_and_right(const PromptReading& reading, const language::Attachment& attachment);

/// "the ends of the room": whether a noun phrase names a part of the room.
bool is_of_room(const PromptReading& reading, std::int32_t part);

/// Which of several things a noun phrase means, from 0: "the second bed", "the left armchair", "the
/// last one", "the other"; -1 if it does not say.
int which_of(const PromptReading& reading, std::int32_t phrase);

}  // namespace roomgen::brief
