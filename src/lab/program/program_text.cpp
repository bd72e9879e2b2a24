#include "program_text.h"

#include "face_names.h"
#include "roomgen/base/text.h"

namespace roomgen::lab {

namespace {

std::string range_text(const Range& range) {
  return format_number(range.low) + (range.low == range.high ? "" : " to " + format_number(range.high));
}

std::string room_text(const ProgramRoom& room) {
  std::string text = room.type;
  if (room.polygon)
    text += ", " + std::to_string(room.polygon->size()) + " walls around " + format_number(area(*room.polygon), 2) + " m2";
  if (room.width && room.depth) text += ", " + range_text(*room.width) + " by " + range_text(*room.depth) + " m";
  if (room.area) text += ", " + range_text(*room.area) + " m2";
  if (room.height) text += ", " + format_number(*room.height) + " m high";
  if (room.openings) text += ", with " + std::to_string(room.openings->size()) + " doors and windows";
  return text;
}

std::string to_text(const ProgramParameter& parameter) {
  if (parameter.uniform) return "from " + range_text(*parameter.uniform);
  std::vector<std::string> values;
  for (const double value : parameter.choice) values.push_back(format_number(value, 6));
  return join(values, " or ");
}

std::string faces_text(const std::vector<Face>& faces) {
  std::vector<std::string> names;
  for (const Face face : faces) names.emplace_back(name(face));
  return join(names, " or ");
}

std::string to_text(const PutUp& put_up) {
  const std::string how = put_up.type == PutUp::Type::coplanar ? " in one plane with " : " against ";
  return faces_text(put_up.child) + how + faces_text(put_up.parent) + ", " + format_number(put_up.margin) + " m apart" +
         (put_up.within_height ? "" : ", at any height");
}

template <typename Named>
void add_section(std::string& text, std::string_view title, const Named& named) {
  if (named.empty()) return;
  text += std::string(title) + "\n";
  for (const auto& [name, value] : named) text += "  " + name + ": " + to_text(value) + "\n";
}

}  // namespace

std::string to_text(const ConstraintProgram& program) {
  std::string text = "room: " + room_text(program.room) + "\n";
  add_section(text, "parameters", program.parameters);
  add_section(text, "relations", program.relations);
  add_section(text, "sets", program.sets);
  add_section(text, "constraints", program.constraints);
  add_section(text, "scores", program.scores);
  return text;
}

}  // namespace roomgen::lab
