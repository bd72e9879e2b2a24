#include <algorithm>
#include <array>
#include <cassert>

#include "face_names.h"
#include "program_text.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

// How tightly a phrase holds together; a looser one is put in brackets inside a tighter one.
enum Level { sentence, alternative, conjunction, comparison, sum_level, product, power_level, atom };

// %A %B the sets, %x %y the operands, %v the variable, %l %h the literals, %w the weight, %f "the wall of ", %d
// "in front of", %m the depth. Without any, what stands between all operands.
struct Phrase {
  ProgramOp op;
  std::string_view text;
  Level level = atom;
  Level operands = sentence;
};

constexpr std::array<Phrase, 41> phrases = {{
    {ProgramOp::count, "the number of %A"},
    {ProgramOp::footprint, "the footprint of %A"},
    {ProgramOp::volume, "the volume of %A"},
    {ProgramOp::area, "the area of %A"},
    {ProgramOp::occupancy, "the share of the floor under %A"},
    {ProgramOp::distance, "the distance from %A to %f%B"},
    {ProgramOp::seats, "the number of people who can sit on %A"},
    {ProgramOp::gap, "the least gap among %A"},
    {ProgramOp::access, "how deep %B reach into the %m m %d %A"},
    {ProgramOp::angle, "how far %A are turned from %f%B"},
    {ProgramOp::focus, "how far %A look away from %B"},
    {ProgramOp::center, "how far %A are from the middle of what carries them"},
    {ProgramOp::reflection, "how far %A are from symmetry about %B"},
    {ProgramOp::rotation, "how unevenly %A stand around their middle"},
    {ProgramOp::coplanarity, "how far %A are from one plane"},
    {ProgramOp::add, " + ", sum_level, product},
    {ProgramOp::multiply, " * ", product, power_level},
    {ProgramOp::subtract, "%x - %y", sum_level, product},
    {ProgramOp::divide, "%x / %y", product, power_level},
    {ProgramOp::power, "%x ^ %y", power_level, atom},
    {ProgramOp::absolute, "|%x|"},
    {ProgramOp::logarithm, "log(%x)"},
    {ProgramOp::least, "min(%n)"},
    {ProgramOp::greatest, "max(%n)"},
    {ProgramOp::clamp, "clamp(%x, %l, %h)"},
    {ProgramOp::hinge, "how far %x is outside %l to %h", comparison, atom},
    {ProgramOp::mean, "the mean over %v in %A of %x", sentence, power_level},
    {ProgramOp::sum, "the sum over %v in %A of %x", sentence, power_level},
    {ProgramOp::minimize, "minimise %w * %x", product, power_level},
    {ProgramOp::maximize, "maximise %w * %x", product, power_level},
    {ProgramOp::all_of, " and ", conjunction, comparison},
    {ProgramOp::any_of, " or ", alternative, comparison},
    {ProgramOp::not_of, "not %x", comparison, atom},
    {ProgramOp::for_all, "for every %v in %A: %x", sentence, sentence},
    {ProgramOp::within, "%x is from %l to %h", comparison, sum_level},
    {ProgramOp::equal, "%x = %y", comparison, sum_level},
    {ProgramOp::unequal, "%x != %y", comparison, sum_level},
    {ProgramOp::at_least, "%x >= %y", comparison, sum_level},
    {ProgramOp::at_most, "%x <= %y", comparison, sum_level},
    {ProgramOp::more, "%x > %y", comparison, sum_level},
    {ProgramOp::less, "%x < %y", comparison, sum_level},
}};

const Phrase& phrase_of(ProgramOp op) {
  const auto found = std::find_if(phrases.begin(), phrases.end(), [&](const auto& phrase) { return phrase.op == op; });
  assert(found != phrases.end());
  return *found;
}

std::string figure(double value) { return format_number(value, 6); }

std::string place_before(const std::string& direction) {
  if (direction == "front") return "in front of";
  if (direction == "back") return "behind";
  if (direction == "up") return "above";
  if (direction == "down") return "below";
  return direction == "sides" ? "beside" : direction + " of";
}

bool is_plain(const ProgramTerm& term) { return term.op == ProgramOp::constant || term.op == ProgramOp::parameter; }

std::string bracketed(const ProgramTerm& term, Level least) {
  const std::string text = to_text(term);
  return is_plain(term) || phrase_of(term.op).level >= least ? text : "(" + text + ")";
}

std::string joined(const ProgramTerm& term, std::string_view separator, Level least) {
  std::vector<std::string> parts;
  for (const auto& operand : term.operands) parts.push_back(bracketed(operand, term.operands.size() > 1 ? least : sentence));
  return join(parts, separator);
}

// What stands for a letter; "?" where the term lacks it.
std::string part_text(char letter, const ProgramTerm& term, Level least) {
  const auto set = [&](std::size_t i) { return i < term.sets.size() ? operand_text(term.sets[i]) : "?"; };
  const auto operand = [&](std::size_t i) { return i < term.operands.size() ? bracketed(term.operands[i], least) : "?"; };
  const auto literal = [&](std::size_t i) { return i < term.literals.size() ? figure(term.literals[i]) : "?"; };
  switch (letter) {
    case 'A': return set(0);
    case 'B': return set(1);
    case 'x': return operand(0);
    case 'y': return operand(1);
    case 'n': return joined(term, ", ", sentence);
    case 'v': return term.name;
    case 'l': return literal(0);
    case 'h': return literal(1);
    case 'w': return figure(term.number);
    case 'f': return term.face ? "the " + std::string(name(*term.face)) + " of " : "";
    case 'd': return place_before(term.direction);
    default: return figure(term.depth);
  }
}

}  // namespace

std::string to_text(const ProgramTerm& term) {
  if (term.op == ProgramOp::constant) return figure(term.number);
  if (term.op == ProgramOp::parameter) return term.name;
  const Phrase& phrase = phrase_of(term.op);
  if (phrase.text.find('%') == std::string_view::npos) return joined(term, phrase.text, phrase.operands);
  std::string text;
  for (std::size_t i = 0; i < phrase.text.size(); ++i)
    if (phrase.text[i] == '%') text += part_text(phrase.text[++i], term, phrase.operands);
    else text += phrase.text[i];
  return text;
}

}  // namespace roomgen::lab
