#pragma once

#include "edit_text.h"

namespace roomgen {

/// Words that no one knows, and that are one letter away from just one word that edits are made of,
/// or a name of what is there, become that word: "chnage", "teh", "microwve".
void correct_spelling(EditText& text);

/// The same said plainly: what is written short is written out ("I'd", "the sofa's too big",
/// "gimme"), and courtesies that may stand anywhere are left out ("delete please the rug").
void word_plainly(EditText& text);

/// Words that take back what was said just before them: ", sorry, no, …".
struct Correction {
  std::size_t begin = 0, end = 0;  ///< tokens, with the marks around the words
};
std::optional<Correction> correction_in(const EditText& text);

/// Texts in which what stands behind the correction takes the place of more and more of the words
/// before it.
std::vector<EditText> corrected(const EditText& text, const Correction& correction);

/// The token behind words that ask for nothing: "our toddler keeps bumping his head on it"; `at` if
/// they may ask for something. Before anything is asked for (`at_first`) these may be words of
/// which nothing is known.
std::size_t end_of_remark(const EditText& text, std::size_t at, bool at_first);

/// Where words behind a clause end that ask for nothing themselves: "please", "so the kids can see
/// it", "not the desk", "for my daughter"; `at` if there are none.
std::size_t end_of_tail(const EditText& text, std::size_t at);

void cut(EditText& text, std::size_t begin, std::size_t end);
/// The text without some of its words.
EditText without(const EditText& text, std::size_t begin, std::size_t end);
void insert_word(EditText& text, std::size_t at, const std::string& word);

/// The same with the place of a clause behind it: "on the desk, put a lamp" is "put a lamp on the
/// desk". Nothing where the clause does not begin with a place.
std::optional<EditText> with_place_last(const EditText& text, std::size_t at);

/// "half a metre further left with the desk" as "the desk half a metre further left".
std::optional<EditText> with_way_last(const EditText& text, std::size_t at);

/// The same with `X with Y` as `Y` on both sides of `X`, from `at` on: "flank the sofa with two
/// lamps".
std::optional<EditText> with_flanks(const EditText& text, std::size_t at);

}  // namespace roomgen
