#pragma once

#include <vector>

#include "compiled.h"

namespace roomgen::lab::annealing {

/// One way to make a member of a set: a kind, and what it is put up against.
struct Recipe {
  std::vector<int> kinds;  ///< numbers of kinds that have articles
  bool one_design = false; ///< a factory makes them: all look alike
  struct PutUpAgainst {
    int relation = 0;
    int target = 0;        ///< a set of the compiled program
  };
  std::vector<PutUpAgainst> relations;
};

/// A count that the constraints bound, with how its set gets members.
struct Bound {
  int set = 0;
  double low = 0.0;
  double high = 0.0;
  std::vector<int> variables;  ///< the sets that the variables in force run over
  std::vector<Recipe> recipes;
};

/// The bounds of a program, in its order. What is bounded only from below is permitted up to a few.
std::vector<Bound> make_bounds(const ConstraintProgram& program, Compiler& compiler, const Compiled& compiled,
                               const std::vector<const Kind*>& kinds, const KindTable& table,
                               const ProgramVocabulary& vocabulary);

/// The kinds that bounds could add, of each bound a dozen at most: what a stock has to hold.
std::vector<const Kind*> kinds_of_bounds(const ConstraintProgram& program, const KindTable& table,
                                         const ProgramVocabulary& vocabulary, const Random& random);

}  // namespace roomgen::lab::annealing
