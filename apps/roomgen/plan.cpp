#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "options.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/design/designer.h"
#include "roomgen/import/import.h"

namespace roomgen::cli {

namespace {

struct PlanOptions {
  std::string prompt;
  std::uint64_t seed = 0;
  std::string size;
  std::string room;
  std::string output;
  bool explain = false;
};

// Line breaks as blanks, without those at the ends.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\t' || c == '\r') c = ' ';
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

void print_room(const Room& room) {
  const Vec2 box = bounds(room.polygon).size();
  std::printf("%s, %s x %s m, %s m2, %s m high\n", room.type.c_str(), format_number(box.x(), 2).c_str(),
              format_number(box.y(), 2).c_str(), format_number(area(room.polygon), 2).c_str(),
              format_number(room.height, 2).c_str());
  for (const auto& opening : room.openings)
    std::printf("  %-10s %-18s wall %zu, from %s to %s m\n", opening.id.c_str(),
                opening.kind.empty() ? "" : opening.kind.c_str(), opening.wall,
                format_number(opening.from, 2).c_str(), format_number(opening.to, 2).c_str());
}

// The prompt in pieces, each with what it was taken for and what checks it.
void print_heard(const std::string& prompt, const std::vector<Heard>& heard,
                 const std::vector<Requirement>& requirements) {
  std::size_t end = 0;
  for (const auto& words : heard) {
    if (words.begin > end) std::printf("%s\n", one_line(prompt.substr(end, words.begin - end)).c_str());
    std::vector<std::string> clauses;
    for (const auto& requirement : requirements)
      for (const auto& id : words.requirements)
        if (id == requirement.id) clauses.push_back(requirement.clause);
    std::printf("  [%s] %s%s%s\n", one_line(words.text).c_str(), std::string(name(words.as)).c_str(),
                clauses.empty() ? "" : ": ", join(clauses, "; ").c_str());
    end = words.end;
  }
}

std::vector<Requirement> all_requirements(const Plan& plan) {
  return plan.requirements;
}

std::vector<Requirement> all_requirements(const DwellingPlan& plan) {
  auto all = plan.requirements;
  for (const auto& room : plan.rooms)
    all.insert(all.end(), room.requirements.begin(), room.requirements.end());
  return all;
}

void print_item(const PlanItem& item) {
  std::printf("%4d  %-18s %-20s %-8s %s%s\n", item.quantity, item.category.c_str(),
              item.size ? size_text(*item.size).c_str() : "", std::string(name(item.mount)).c_str(),
              item.description.c_str(), item.asked ? " (asked)" : "");
  if (!item.relations.empty()) std::printf("        %s\n", to_text(item.relations).c_str());
}

void print_plan(const Plan& plan) {
  print_room(plan.room);
  for (const auto& item : plan.items) print_item(item);
  if (!plan.excluded.empty()) std::printf("without %s\n", join(plan.excluded, ", ").c_str());
  for (const auto& note : plan.notes) std::printf("note: %s\n", note.c_str());
}

Result<PlanRequest> request_of(const PlanOptions& options, const Context& context) {
  PlanRequest request;
  request.prompt = options.prompt;
  request.seed = options.seed;
  request.cancel = context.cancel;
  if (!options.size.empty()) {
    auto size = parse_size(options.size);
    if (!size) return size.error();
    request.size = *size;
  }
  if (!options.room.empty()) {
    auto room = read_floor_plan(options.room);
    if (!room) return room.error();
    request.room = *std::move(room);
  }
  return request;
}

void print_plan(const DwellingPlan& plan) {
  for (const auto& room : plan.rooms) {
    std::printf("%s: ", room.room.id.c_str());
    print_plan(room);
  }
  for (const auto& note : plan.notes) std::printf("note: %s\n", note.c_str());
}

template <typename AnyPlan>
Result<int> show(const AnyPlan& plan, const PlanOptions& options, const Context& context) {
  const std::string json = dump_json(to_json(plan));
  if (!options.output.empty()) {
    if (auto written = write_file(options.output, json); !written) return written.error();
  }
  if (context.json)
    std::fputs(json.c_str(), stdout);
  else if (options.explain)
    print_heard(plan.prompt, plan.heard, all_requirements(plan));
  else if (options.output.empty() || !context.quiet)
    print_plan(plan);
  return exit_ok;
}

Result<int> run_plan(const PlanOptions& options, const Context& context) {
  const auto request = request_of(options, context);
  if (!request) return request.error();
  const auto designer = make_rule_designer();
  const auto dwelling = plan_dwelling(*request, *designer);
  if (!dwelling) return dwelling.error();
  if (*dwelling) return show(**dwelling, options, context);
  const auto plan = designer->plan(*request);
  if (!plan) return plan.error();
  return show(*plan, options, context);
}

}  // namespace

void add_plan_command(CLI::App& app, Context& context) {
  const auto options = std::make_shared<PlanOptions>();
  auto* command = app.add_subcommand("plan", "Say what a room, or each room of a dwelling, shall hold, without furnishing it");
  command->add_option("prompt", options->prompt, "What the room shall be, in English")->required();
  command->add_option("--seed", options->seed, "Another number, another room")
      ->capture_default_str();
  command->add_option("--size", options->size, "Width and depth in metres, as in 4x5")
      ->check([](const std::string& text) {
        const auto size = parse_size(text);
        return size ? std::string() : size.error().message;
      });
  command->add_option("--room", options->room, "A floor plan of your own: room.json, SVG or DXF");
  command->add_option("-o,--output", options->output, "Write the plan here (plan.json)");
  command->add_flag("--explain", options->explain,
                    "Say what each word of the prompt was taken for, and what is checked by it");
  command->callback([options, &context] {
    context.run = [options, &context] { return run_plan(*options, context); };
  });
}

}  // namespace roomgen::cli
