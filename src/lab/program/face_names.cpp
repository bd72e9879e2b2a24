#include "face_names.h"

#include <array>

namespace roomgen::lab {

namespace {

constexpr std::array<std::string_view, 10> face_names = {"front",  "back",    "left", "right", "top",
                                                         "bottom", "support", "wall", "floor", "ceiling"};

struct FaceGroup {
  std::string_view word;
  std::vector<Face> faces;
};

const std::vector<FaceGroup>& face_groups() {
  static const std::vector<FaceGroup> groups = {{"side", {Face::front, Face::left, Face::right}},
                                                {"leftright", {Face::left, Face::right}}};
  return groups;
}

struct Direction {
  std::string_view name, axis;
};
constexpr std::array<Direction, 7> directions = {{{"front", "+x"},
                                                  {"back", "-x"},
                                                  {"left", "+y"},
                                                  {"right", "-y"},
                                                  {"up", "+z"},
                                                  {"down", "-z"},
                                                  {"sides", "+-y"}}};

}  // namespace

std::string_view name(Face face) { return face_names[static_cast<std::size_t>(face)]; }

std::optional<Face> parse_face(std::string_view text) {
  for (std::size_t i = 0; i < face_names.size(); ++i)
    if (face_names[i] == text) return static_cast<Face>(i);
  return std::nullopt;
}

std::vector<Face> faces_named(std::string_view word) {
  if (const auto face = parse_face(word)) return {*face};
  for (const auto& group : face_groups())
    if (group.word == word) return group.faces;
  return {};
}

std::vector<std::string> face_words() {
  std::vector<std::string> words(face_names.begin(), face_names.end());
  for (const auto& group : face_groups()) words.emplace_back(group.word);
  return words;
}

bool is_of_room(Face face) { return face == Face::wall || face == Face::floor || face == Face::ceiling; }

std::string direction_named(std::string_view word) {
  for (const auto& direction : directions)
    if (direction.name == word || direction.axis == word) return std::string(direction.name);
  return {};
}

std::vector<std::string> direction_words() {
  std::vector<std::string> words;
  for (const auto& direction : directions) words.emplace_back(direction.name);
  return words;
}

}  // namespace roomgen::lab
