#include <algorithm>
#include <cmath>
#include <map>

#include "chat/loose_json.h"
#include "maker_replies.h"
#include "program_repair.h"
#include "roomgen/base/text.h"
#include "roomgen/shape/evaluate.h"

namespace roomgen::create {

namespace {

constexpr double trial_tolerance = 0.004;  // metres; sizes and counts need no finer meshes
constexpr std::size_t most_complaints = 5;
constexpr double greatest_difference = 0.25;  // of a size, before the model is asked again

using Counts = std::map<std::string, int>;

constexpr int most_counted = 1'000'000;

int copies_of(const shape::Component& component) {
  int made = 1;
  for (const auto& operation : component.operations) {
    int times = 1;
    if (std::holds_alternative<shape::Mirror>(operation)) times = 2;
    if (const auto* array = std::get_if<shape::Array>(&operation)) times = array->count;
    if (const auto* radial = std::get_if<shape::Radial>(&operation)) times = radial->count;
    made = std::min(made * times, most_counted / static_cast<int>(shape::max_components));
  }
  return made;
}

// "Front-Legs" is "front leg".
std::string plain_label(const std::string& text) {
  auto pieces = words(text);
  if (!pieces.empty()) pieces.back() = singular(pieces.back());
  return join(pieces, " ");
}

// How many times each part is made. What has no label in a group is a piece of the group.
void tally_parts(const std::vector<shape::Component>& components, int times, bool inside,
                 Counts& counts) {
  for (const auto& component : components) {
    const int made = std::min(times * copies_of(component), most_counted);
    std::string label = plain_label(component.label);
    if (label.empty() && !inside) label = plain_label(component.name);
    if (!label.empty()) counts[label] = std::min(counts[label] + made, most_counted);
    if (const auto* group = std::get_if<shape::Group>(&component.solid))
      tally_parts(group->components, std::min(made, most_counted / 1000), true, counts);
  }
}

// A front leg is a leg.
int count_of(const Counts& counts, const std::string& label) {
  int made = 0;
  for (const auto& [name, count] : counts)
    if (name == label || name.ends_with(" " + label)) made = std::min(made + count, most_counted);
  return made;
}

std::string size_text(const Vec3& size) {
  std::vector<std::string> sides;
  for (const double side : size)
    sides.push_back(std::isnan(side) ? "any" : format_number(100.0 * side, 1));
  return join(sides, " x ");
}

void compare_size(const shape::Shape& shape, const Description& wanted,
                  std::vector<std::string>& complaints) {
  if (!wanted.size) return;
  const Vec3 made = shape::bounds(shape).size();
  for (int axis = 0; axis < 3; ++axis) {
    const double side = (*wanted.size)[axis];
    if (std::isnan(side) || std::abs(made[axis] - side) <= greatest_difference * side) continue;
    return complaints.push_back("the whole measures " + size_text(made) + " cm, but " +
                                size_text(*wanted.size) + " cm were asked for");
  }
}

void compare_parts(const shape::Program& program, const Description& wanted,
                   std::vector<std::string>& complaints) {
  Counts counts;
  tally_parts(program.components, 1, false, counts);
  for (const auto& part : wanted.parts) {
    const int made = count_of(counts, plain_label(part.label));
    const int asked = part.count.value_or(1);
    // A part of several solids has its label more than once.
    const bool fits = asked == 0 ? made == 0 : made >= asked && made % asked == 0;
    if (!fits)
      complaints.push_back("there are " + std::to_string(made) + " parts labelled \"" + part.label +
                           "\", but " + std::to_string(asked) + " were asked for");
  }
}

std::string complaint_about(const shape::Program& program, const shape::Shape& shape,
                            const Description& wanted) {
  std::vector<std::string> complaints;
  compare_size(shape, wanted, complaints);
  compare_parts(program, wanted, complaints);
  if (complaints.size() > most_complaints) complaints.resize(most_complaints);
  return join(complaints, "; ");
}

}  // namespace

Result<Reading<shape::Program>> read_program_reply(const std::string& text,
                                                   const Description& wanted, std::uint64_t seed) {
  auto loose = find_json(text, {{"components"}, {"format", "parts"}});
  if (!loose) return loose.error();
  Reading<shape::Program> reading{{}, std::move(loose->repairs)};
  repair_program(loose->json, reading.repairs);
  auto program = shape::instantiate(loose->json, {}, seed, nullptr, "the program");
  if (!program) return program.error();
  const auto shape = shape::evaluate(*program, {.tolerance = trial_tolerance, .paint = false});
  if (!shape) return with_context(shape.error(), "the program");
  if (auto status = check_extent(*shape); !status) return status.error();
  reading.complaint = complaint_about(*program, *shape, wanted);
  reading.value = *std::move(program);
  if (reading.value.name.empty()) reading.value.name = wanted.noun;
  return reading;
}

}  // namespace roomgen::create
