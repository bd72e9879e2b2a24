#pragma once

#include "prompt_reading.h"

namespace roomgen::brief {

/// Reads the doors and windows that a prompt asks for; where things stand at one ("under the
/// window"), it is their place.
void read_openings(PromptReading& reading);

/// Reads what the noun phrases of a prompt name or exclude: reading.mentions says of each which
/// thing it means.
void read_things(PromptReading& reading);

/// Reads what there shall be nothing but: "nothing else", "no other chairs", "no more than a laptop
/// and a tray on the desk", "nothing on the walls except a clock". Things were read before.
void read_limits(PromptReading& reading);

/// "Only", "each" and "every" of which nothing came were not understood.
void note_lost_limits(PromptReading& reading);

/// Whether a noun phrase says "no other", "nothing else": it denies none of the things that are
/// named.
bool denies_others(const PromptReading& reading, const language::NounPhrase& phrase);

/// What is added to a thing behind it, between marks: "racks, 2 m tall, anthracite", "chairs: ten",
/// "a mat (blue)", "cabinets, four in number". Needs the things of the prompt; what is no addition
/// as a whole is left.
void read_additions(PromptReading& reading);

/// Gives each of several things its own where as many colours are said of them: "four bins (red,
/// blue, green, yellow)", or they are said to alternate. Of two other things both may be of both
/// colours.
void share_colours(PromptReading& reading);

/// "Five tables, three along the left wall and two along the right", "two of the chairs face the
/// window": those of several things of which something of their own is said become mentions of
/// their own, and what the phrases mean.
void read_partitions(PromptReading& reading);

/// How several things stand to each other: "eight desks in two rows of four", "lockers in a line",
/// "nine plinths in a 3 by 3 grid". Needs the things of the prompt.
void read_formations(PromptReading& reading);

/// How high things hang: "a television at 1.8 m", "two shelves 1.5 m above the floor". Needs the
/// things of the prompt; what is said so tells no other place.
void read_heights(PromptReading& reading);

/// How far apart things are: "a chair 0.5 m from the desk", "two beds 60 cm apart", "at least 1.5 m
/// from every wall", "within 1 m of the door", "2 m in front of the screen". Needs the things of
/// the prompt, and comes before their places.
void read_distances(PromptReading& reading);

/// Reads where the things of a prompt are said to be.
void read_places(PromptReading& reading);

/// Reads headings that say where what follows is, up to the end of the sentence: "North wall: two
/// bookcases and a desk." Things of which another place was said keep that.
void read_headings(PromptReading& reading);

/// "a reading corner with two armchairs, a lamp and a side table", "in the play area a tent and a
/// toy chest": what is told of one area of the room stands together. Those of whose place nothing
/// is said are near the largest of them.
void read_groups(PromptReading& reading);

/// Colours and stuffs that are said of no thing: "Milk, oatmeal, verdigris.", "raw brick, bare
/// cedar", "persimmon accents". They are the room's palette. Comes when all that names or describes
/// things is heard.
void read_palette(PromptReading& reading);

/// The word of what is heard as a remark.
inline constexpr const char* said_remark = "remark";

/// What is said of the room as a whole ("a rented flat", "a hall in a mountain village") and of
/// what people do in it ("farmers argue"), where nothing else was made of the words: it is heard
/// and shows in the ledger, but nothing in a room can be judged by it. Comes after all other
/// readers.
void read_remarks(PromptReading& reading);

}  // namespace roomgen::brief
