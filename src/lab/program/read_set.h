#pragma once

#include "base/json_reader.h"
#include "limits.h"
#include "roomgen/lab/program.h"

namespace roomgen::lab {

/// How much of a program may still be read.
class ReadingBudget {
 public:
  /// One more set or term, so deep; false, and reported, if that is too much.
  bool admits(const JsonReader& json, int depth, int most_depth);

 private:
  std::size_t left_ = program_limits::nodes;
};

ProgramSet read_set(const JsonReader& json, ReadingBudget& budget, int depth = 0);

ProgramTerm read_term(const JsonReader& json, ReadingBudget& budget, int depth = 0);

/// "room": what room the program asks for.
ProgramRoom read_room_wish(const JsonReader& json);
/// A number is a range of one.
Range read_program_range(const JsonReader& json, double low, double high);

}  // namespace roomgen::lab
