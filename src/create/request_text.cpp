#include <nlohmann/json.hpp>

#include "maker_questions.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen::create {

namespace {

// Small models lose the question behind long examples.
constexpr std::size_t most_examples = 3, most_example_bytes = 12000;

}  // namespace

std::string description_text(const Description& description) {
  if (description.parts.empty() && !description.size) return "";
  Json json = to_json(description);
  // The words stand above it, and how many of it there are is not the program's matter.
  for (const char* key : {"prompt", "kind", "approximate", "count"}) json.erase(key);
  return "What it consists of, sizes in centimetres:\n\n" + dump_json(json);
}

std::string examples_text(const std::vector<shape::Program>& examples) {
  std::string text;
  std::size_t shown = 0;
  for (const auto& program : examples) {
    const std::string one = program_text(program);
    if (shown == most_examples || text.size() + one.size() > most_example_bytes) continue;
    text += one + "\n\n";
    ++shown;
  }
  if (text.empty()) return "";
  return "Sound programs of things that are near. Learn from them how parts are built and meet, "
         "but "
         "make what is wished for:\n\n" +
         text;
}

std::string kinds_text(const std::vector<std::string>& kinds) {
  return kinds.empty() ? "(none; leave it empty)" : join(kinds, ", ");
}

std::string program_text(const shape::Program& program) {
  return json_line(write_program(program));
}

}  // namespace roomgen::create
