#include "plan_text.h"

#include "print.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::cli {

namespace {

using Lines = std::vector<std::string>;

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.resize(width, ' ');
  return text;
}

std::string metres(double value) { return format_number(value, 2); }

void add_room(const Room& room, Lines& lines) {
  const Vec2 box = bounds(room.polygon).size();
  lines.push_back(room.type + ", " + metres(box.x()) + " x " + metres(box.y()) + " m, " + metres(area(room.polygon)) +
                  " m2, " + metres(room.height) + " m high");
  for (const auto& opening : room.openings)
    lines.push_back("  " + padded(opening.id, 10) + " " + padded(opening.kind, 18) + " wall " +
                    std::to_string(opening.wall) + ", from " + metres(opening.from) + " to " + metres(opening.to) +
                    " m");
}

void add_item(const PlanItem& item, Lines& lines) {
  const std::string quantity = std::to_string(item.quantity);
  lines.push_back(std::string(quantity.size() < 4 ? 4 - quantity.size() : 0, ' ') + quantity + "  " +
                  padded(item.category, 18) + " " + padded(item.size ? size_text(*item.size) : "", 20) + " " +
                  padded(std::string(name(item.mount)), 8) + " " + item.description + (item.asked ? " (asked)" : ""));
  if (!item.relations.empty()) lines.push_back("        " + to_text(item.relations));
}

void add_notes(const std::vector<std::string>& notes, Lines& lines) {
  for (const auto& note : notes) lines.push_back("note: " + note);
}

void add_plan(const Plan& plan, Lines& lines) {
  const std::size_t first = lines.size();
  add_room(plan.room, lines);
  if (!plan.room.id.empty()) lines[first] = plan.room.id + ": " + lines[first];
  for (const auto& item : plan.items) add_item(item, lines);
  if (!plan.excluded.empty()) lines.push_back("without " + join(plan.excluded, ", "));
  add_notes(plan.notes, lines);
}

void add_plan(const DwellingPlan& plan, Lines& lines) {
  for (const auto& room : plan.rooms) add_plan(room, lines);
  add_notes(plan.notes, lines);
}

std::vector<Requirement> all_requirements(const Plan& plan) { return plan.requirements; }

std::vector<Requirement> all_requirements(const DwellingPlan& plan) {
  auto all = plan.requirements;
  for (const auto& room : plan.rooms) all.insert(all.end(), room.requirements.begin(), room.requirements.end());
  return all;
}

std::string heard_line(const Heard& words, const std::vector<Requirement>& requirements) {
  std::vector<std::string> clauses;
  for (const auto& requirement : requirements)
    for (const auto& id : words.requirements)
      if (id == requirement.id) clauses.push_back(told(requirement));
  return "  [" + std::string(trim(one_line(words.text))) + "] " + std::string(name(words.as)) + (clauses.empty() ? "" : ": ") +
         join(clauses, "; ");
}

}  // namespace

std::vector<std::string> plan_lines(const AnyPlan& plan) {
  Lines lines;
  std::visit([&](const auto& each) { add_plan(each, lines); }, plan);
  return lines;
}

std::vector<std::string> heard_lines(const AnyPlan& plan) {
  Lines lines;
  const auto add = [&](const auto& each) {
    const auto requirements = all_requirements(each);
    std::size_t end = 0;
    for (const auto& words : each.heard) {
      if (words.begin > end) lines.emplace_back(trim(one_line(each.prompt.substr(end, words.begin - end))));
      lines.push_back(heard_line(words, requirements));
      end = words.end;
    }
  };
  std::visit(add, plan);
  return lines;
}

}  // namespace roomgen::cli
