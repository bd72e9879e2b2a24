#pragma once

#include "catch.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/solve/solve.h"

/// A solution with boxes for meshes; the test stops if the problem is unsound.
inline roomgen::Solution solved(const roomgen::Problem& problem, std::uint64_t seed = 0,
                                int rounds = roomgen::SolveOptions{}.rounds) {
  roomgen::SolveOptions options;
  options.seed = seed;
  options.rounds = rounds;
  auto solution =
      roomgen::solve(problem, roomgen::ModelTable(), roomgen::KindTable::built_in(), options);
  if (!solution) FAIL(solution.error().message);
  return *std::move(solution);
}

/// The violations of a scene of boxes, in words.
inline std::vector<std::string> violations(const roomgen::Scene& scene) {
  std::vector<std::string> found;
  const auto report =
      roomgen::examine(scene, roomgen::ModelTable(), roomgen::KindTable::built_in());
  for (const auto& violation : report.violations)
    found.push_back(std::string(name(violation.fault)) + ": " + violation.object + " " +
                    violation.other);
  return found;
}

/// The Euclidean distance of two objects' centres over the floor.
inline double moved_by(const roomgen::Object& a, const roomgen::Object& b) {
  return (a.position - b.position).norm();
}
