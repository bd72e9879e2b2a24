#include "program_reply.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "program_repair.h"
#include "roomgen/base/text.h"
#include "roomgen/design/loose_json.h"
#include "roomgen/shape/evaluate.h"
#include "roomgen/shape/recipe.h"
#include "shape_checks.h"

namespace roomgen::create {

namespace {

constexpr double trial_tolerance = 0.004;  // metres; sizes and counts need no finer meshes
constexpr std::size_t most_complaints = 5;
constexpr double greatest_difference = 0.25;  // of a size, before the model is asked again

// How many times a part was made: joined copies are one body, so that components count as well.
std::map<std::string, int> parts_made(const shape::Shape& shape) {
  std::map<std::string, int> made;
  for (const auto& body : shape.bodies) {
    ++made[singular(lower(body.label))];
    const auto group = body.name.substr(0, body.name.find('.'));
    if (group != body.name) made.emplace(singular(lower(group)), 1);
  }
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

void compare_parts(const shape::Shape& shape, const Description& wanted,
                   std::vector<std::string>& complaints) {
  const auto made = parts_made(shape);
  for (const auto& part : wanted.parts) {
    const auto found = made.find(singular(lower(part.label)));
    const int count = found == made.end() ? 0 : found->second;
    const int least = part.count.value_or(1);
    // Parts of several solids have their label more than once.
    const bool fits = least == 0 ? count == 0 : count >= least && count % least == 0;
    if (!fits)
      complaints.push_back("there are " + std::to_string(count) + " parts labelled \"" +
                           part.label + "\", but " + std::to_string(least) + " were asked for");
  }
}

std::string complaint_about(const shape::Shape& shape, const Description& wanted) {
  std::vector<std::string> complaints;
  compare_size(shape, wanted, complaints);
  compare_parts(shape, wanted, complaints);
  if (complaints.size() > most_complaints) complaints.resize(most_complaints);
  return join(complaints, "; ");
}

}  // namespace

Result<Reading<shape::Program>> read_program_reply(const std::string& text,
                                                   const Description& wanted, std::uint64_t seed) {
  auto loose = design::find_json(text, {{"components"}, {"format", "parts"}});
  if (!loose) return loose.error();
  Reading<shape::Program> reading{{}, std::move(loose->repairs)};
  repair_program(loose->json, reading.repairs);
  auto program = shape::instantiate(loose->json, {}, seed, nullptr, "the program");
  if (!program) return program.error();
  const auto shape = shape::evaluate(*program, trial_tolerance);
  if (!shape) return with_context(shape.error(), "the program");
  if (auto status = check_extent(*shape); !status) return status.error();
  reading.complaint = complaint_about(*shape, wanted);
  reading.value = *std::move(program);
  if (reading.value.name.empty()) reading.value.name = wanted.noun;
  return reading;
}

}  // namespace roomgen::create
