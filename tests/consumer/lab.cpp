// A constraint program, read and checked.
#include <roomgen/lab/program.h>

#include <cstdio>
#include <nlohmann/json.hpp>

int main() {
  using namespace roomgen;
  const auto json = parse_json(R"({"format":"roomgen-program","version":1,"room":{"type":"study"},
                                   "sets":{},"constraints":{},"scores":{}})", "program.json");
  if (!json) return 1;
  const auto program = lab::program_from_json(*json, "program.json");
  std::puts(program ? to_text(*program).c_str() : program.error().message.c_str());
  return 0;
}
