#include <algorithm>
#include <cctype>

#include "language/inflection.h"
#include "language/measure.h"
#include "part_forms.h"
#include "roomgen/base/text.h"
#include "rule_steps.h"
#include "sizing.h"

namespace roomgen::create {

namespace {

// "-3 legs", "minus two drawers".
bool has_negative_count(const std::string& prompt) {
  for (std::size_t i = 0; i + 1 < prompt.size(); ++i)
    if (prompt[i] == '-' && std::isdigit(static_cast<unsigned char>(prompt[i + 1])) &&
        (i == 0 || prompt[i - 1] == ' '))
      return true;
  return lower(prompt).find("minus ") != std::string::npos ||
         lower(prompt).find("negative ") != std::string::npos;
}

// "without a top, without legs and without anything".
bool nothing_is_left(const Description& object) {
  const auto gone = std::count_if(object.parts.begin(), object.parts.end(),
                                  [](const PartWish& part) { return part.count == 0; });
  return gone > 1 && gone == static_cast<std::ptrdiff_t>(object.parts.size());
}

bool names_a_part(const Description& object) {
  return std::any_of(object.parts.begin(), object.parts.end(), [](const PartWish& part) {
    return !part.label.empty() && part.count.value_or(1) > 0;
  });
}

bool has_distance(const std::vector<std::string>& pieces, const Words& words) {
  for (std::size_t i = 1; i < pieces.size(); ++i)
    if (words.distances.count(pieces[i])) return true;
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

constexpr int most_of_a_part = 50;

// "100000 legs", "two and a half legs", "3 drawers and no drawers".
std::string count_problem(const std::string& prompt, const std::vector<Description>& objects) {
  long long number = 0;
  const auto tokens = language::tokenize(prompt);
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (const auto measure = language::measure_at(tokens, i)) i += measure->length - 1;
    else if (tokens[i].kind == language::Token::Kind::number)
      number = std::max(number, static_cast<long long>(std::min(tokens[i].value, 1e12)));
  if (number > most_of_a_part)
    return "there may be at most " + std::to_string(most_of_a_part) + " of a part, not " + std::to_string(number);
  const std::string text = lower(prompt);
  if (text.find(" and a half ") != std::string::npos)
    return "there is no half of a part: say how many whole ones";
  for (const auto& object : objects)
    if (object.contradicted) return "the sentence contradicts itself: it says two numbers of one part, or two lengths of one "
             "side (width, depth or height); say one of both";
  return "";
}

// What a whole room is called, and the things in it are another command's work.
bool names_a_room(const Description& object, const Words& words) {
  return std::any_of(words.rooms.begin(), words.rooms.end(), [&](const std::string& room) {
    return object.noun == room || object.noun.ends_with(" " + room);
  });
}

// The first word that names what stands in no room.
std::string foreign_word(const std::vector<std::string>& pieces, const Words& words) {
  for (const auto& piece : pieces)
    for (const auto* list : {&words.no_objects, &words.beings, &words.far_things})
      if (list->count(piece) || list->count(language::singular(piece))) return piece;
  return "";
}

// The words that say what is to be made. A tower may be a part of a thing, and a windmill a model.
std::vector<std::string> naming_words(const std::vector<std::string>& pieces,
                                      const std::vector<Description>& objects) {
  if (objects.empty()) return pieces;
  const Description& object = objects.front();
  const auto noun = roomgen::words(object.noun);
  const auto is_likeness = [](const std::string& word) {
    return built_in_words()->likenesses.count(word) > 0;
  };
  if (std::any_of(noun.begin(), noun.end(), is_likeness)) return {};
  const bool parted = std::any_of(object.parts.begin(), object.parts.end(), [](const auto& part) {
    return built_in_parts()->parts.count(part.label) > 0;
  });
  return parted ? noun : pieces;
}

}  // namespace

Verdict classify_phrase(const std::string& prompt, const std::vector<Description>& objects,
                        const Words& words) {
  const auto no = [](const std::string& why) { return Verdict{false, why}; };
  if (trim(prompt).empty()) return no("the description is empty; say what the object is, as in \"an oak stool\"");
  if (prompt.size() > longest_phrase)
    return no("the description is longer than " + std::to_string(longest_phrase) + " bytes");
  if (has_negative_count(prompt)) return no("a number of parts cannot be negative");
  const auto pieces = roomgen::words(prompt);
  if (!pieces.empty() && words.orders.count(pieces.front()))
    return no("this is no description of an object but an order; only the object can be described");
  if (has_distance(pieces, words))
    return no("an object in a room is at most " + format_number(greatest_side) + " m long");
  for (const auto& object : objects)
    if (const auto problem = size_problem(object); !problem.empty()) return no(problem);
  if (const auto problem = count_problem(prompt, objects); !problem.empty()) return no(problem);
  if (!objects.empty() && objects.front().approximate && names_a_room(objects.front(), words))
    return no("\"" + objects.front().noun + "\" is a room, not one object; rooms are made by `roomgen generate`");
  if (!objects.empty() && nothing_is_left(objects.front()))
    return no("all its parts are taken away; nothing is left to make");
  const std::string foreign = foreign_word(naming_words(pieces, objects), words);
  const bool known = !objects.empty() && !objects.front().approximate;
  if (known) return {true, objects.front().kind};
  if (!foreign.empty())
    return no("\"" + foreign + "\" is nothing that stands in a room; describe furniture, or a thing that "
              "people keep indoors");
  if (objects.empty() || (objects.front().noun.empty() && objects.front().parts.empty()))
    return no("no object can be understood from this; say what it is, as in \"an oak stool with three legs\"");
  const Description& object = objects.front();
  if (object.kind.empty() && !names_a_part(object))
    return no("\"" + object.noun + "\" is no kind that is known; say of which parts it is made, as in \"" +
              object.noun + " with a round base and two arms\"");
  return {true, object.noun + ", which is no known kind" +
                    (object.kind.empty() ? "" : ", made like a " + object.kind)};
}

}  // namespace roomgen::create
