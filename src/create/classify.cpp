#include "classify.h"

#include <cctype>

#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

constexpr double least_side = 0.01, greatest_side = 5.0;

// "-3 legs", "minus two drawers".
bool has_negative_count(const std::string& prompt) {
  for (std::size_t i = 0; i + 1 < prompt.size(); ++i)
    if (prompt[i] == '-' && std::isdigit(static_cast<unsigned char>(prompt[i + 1])) &&
        (i == 0 || prompt[i - 1] == ' '))
      return true;
  return lower(prompt).find("minus ") != std::string::npos ||
         lower(prompt).find("negative ") != std::string::npos;
}

bool has_distance(const std::vector<std::string>& pieces) {
  for (std::size_t i = 1; i < pieces.size(); ++i)
    for (const char* unit : {"km", "kilometre", "kilometer", "kilometres", "kilometers", "mile", "miles"})
      if (pieces[i] == unit) return true;
  for (const auto& piece : pieces)
    if (piece.size() > 2 && piece.ends_with("km") &&
        std::isdigit(static_cast<unsigned char>(piece.front())))
      return true;
  return false;
}

std::string size_problem(const Description& object) {
  if (!object.size) return "";
  for (int axis = 0; axis < 3; ++axis) {
    const double side = (*object.size)[axis];
    if (side < least_side || side > greatest_side)
      return "a side of " + format_number(side) + " m; sides go from " + format_number(least_side) +
             " to " + format_number(greatest_side) + " m";
  }
  return "";
}

// The first word that names what stands in no room.
std::string foreign_word(const std::vector<std::string>& pieces, const Words& words) {
  for (const auto& piece : pieces)
    for (const auto* list : {&words.no_objects, &words.beings, &words.far_things})
      if (list->count(piece) || list->count(singular(piece))) return piece;
  return "";
}

}  // namespace

Verdict classify_phrase(const std::string& prompt, const std::vector<Description>& objects,
                        const Words& words) {
  const auto no = [](const std::string& why) { return Verdict{false, why}; };
  if (trim(prompt).empty()) return no("the description is empty; say what the object is, as in \"an oak stool\"");
  if (prompt.size() > longest_phrase)
    return no("the description is longer than " + std::to_string(longest_phrase) + " bytes");
  if (has_negative_count(prompt)) return no("there cannot be fewer than none of a part");
  const auto pieces = roomgen::words(prompt);
  if (has_distance(pieces))
    return no("an object in a room is at most " + format_number(greatest_side) + " m long");
  for (const auto& object : objects)
    if (const auto problem = size_problem(object); !problem.empty()) return no(problem);
  const std::string foreign = foreign_word(pieces, words);
  const bool known = !objects.empty() && !objects.front().approximate;
  if (known) return {true, objects.front().kind};
  if (!foreign.empty())
    return no("\"" + foreign + "\" is nothing that stands in a room; describe furniture, or a thing that "
              "people keep indoors");
  if (objects.empty() || (objects.front().noun.empty() && objects.front().parts.empty()))
    return no("the description names no thing; say what it is, as in \"an oak stool with three legs\"");
  const Description& object = objects.front();
  if (object.kind.empty() && object.parts.empty())
    return no("\"" + object.noun + "\" is no kind that is known; say of which parts it is made, as in \"" +
              object.noun + " with a round base and two arms\"");
  return {true, object.noun + ", which is no known kind" +
                    (object.kind.empty() ? "" : ", made like a " + object.kind)};
}

}  // namespace roomgen::create
