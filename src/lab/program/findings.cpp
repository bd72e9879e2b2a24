#include "findings.h"

namespace roomgen::lab {

void ProgramFindings::error(const std::string& at, const std::string& message) {
  ++errors_;
  add(ProgramFinding::Severity::error, at, message);
}

void ProgramFindings::warn(const std::string& at, const std::string& message) {
  add(ProgramFinding::Severity::warning, at, message);
}

void ProgramFindings::add(ProgramFinding::Severity severity, const std::string& at, const std::string& message) {
  if (!full()) findings_.push_back({severity, at, message});
}

}  // namespace roomgen::lab
