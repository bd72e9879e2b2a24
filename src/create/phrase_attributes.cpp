#include "phrase_attributes.h"

namespace roomgen::create {

namespace {

bool ends_phrase(const PhraseText& text, std::size_t at, const Words& words) {
  return at >= text.size() || text[at] == "," || words.boundaries.count(text[at]) > 0;
}

// One word may say several things of a form: "splayed" is a way to build legs and a lean.
std::size_t read_form(const PhraseText& text, std::size_t at, const Words& words, Attributes& to) {
  const auto construction = text.longest(words.constructions, at);
  const auto lean = text.longest(words.leans, at);
  const auto course = text.longest(words.courses, at);
  const auto shape = text.longest(words.shapes, at);
  if (construction) to.construction = *construction.meaning;
  if (lean) to.lean = *lean.meaning;
  if (course) to.course = *course.meaning;
  if (shape) to.shape = *shape.meaning;
  // The last that is known says how far it goes.
  for (const std::size_t length : {shape.length, course.length, lean.length})
    if (length > 0) return length;
  return construction.length;
}

std::size_t read_degree(const PhraseText& text, std::size_t at, const Words& words,
                        Attributes& to) {
  if (const auto count = text.count(at)) {
    to.count = count.meaning;
    to.article = true;
    return count.length;
  }
  if (const auto strength = text.longest(words.strengths, at)) {
    to.strength = *strength.meaning;
    return strength.length;
  }
  const auto style = text.longest(words.styles, at);
  if (style) to.style = *style.meaning;
  return style.length;
}

std::size_t read_look(const PhraseText& text, std::size_t at, const Words& words, Attributes& to) {
  if (const auto material = text.longest(words.materials, at)) {
    to.material = material.meaning->name;
    return material.length;
  }
  if (const auto scale = text.longest(words.scales, at); scale && !text.part(at)) {
    to.scale = to.scale.cwiseProduct(*scale.meaning);
    return scale.length;
  }
  if (words.directions.count(text[at])) {
    to.direction = text[at];
    return 1;
  }
  const auto color = text.color(at);
  if (!color || text.kind(at)) return 0;
  to.color = color.meaning;
  return color.length;
}

}  // namespace

ReadAttribute read_attribute(const PhraseText& text, std::size_t at, const Words& words,
                             Attributes& to) {
  ReadAttribute read{read_degree(text, at, words, to)};
  if (read.length == 0) {
    read.length = read_form(text, at, words, to);
    read.of_form = read.length > 0;
  }
  if (read.length == 0) read.length = read_look(text, at, words, to);
  if (read.length > 0) to.any = true;
  return read;
}

bool names_thing(const PhraseText& text, std::size_t at, const Words& words, bool first) {
  const auto kind = text.kind(at);
  // The name of a kind goes before its first word's other meanings: "wine rack", "round table".
  if (kind.length > 1 && !words.shapes.count(text[at]) && !words.styles.count(text[at]))
    return true;
  // "a ladder": not the way to build one.
  return kind && first && words.constructions.count(text[at]) &&
         ends_phrase(text, at + kind.length, words);
}

}  // namespace roomgen::create
