#pragma once

#include <string>
#include <vector>

#include "roomgen/lab/program.h"

namespace roomgen::lab {

/// Findings about a program, at most a screenful or two: who makes more mistakes reads the first ones.
class ProgramFindings {
 public:
  void error(const std::string& at, const std::string& message);
  void warn(const std::string& at, const std::string& message);

  bool full() const { return findings_.size() >= most; }
  bool has_errors() const { return errors_ > 0; }
  std::vector<ProgramFinding> take() { return std::move(findings_); }

 private:
  static constexpr std::size_t most = 100;

  void add(ProgramFinding::Severity severity, const std::string& at, const std::string& message);

  std::vector<ProgramFinding> findings_;
  std::size_t errors_ = 0;
};

}  // namespace roomgen::lab
