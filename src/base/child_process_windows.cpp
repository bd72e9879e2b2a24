#include "child_process.h"

namespace roomgen::detail {

Result<ChildProcess> ChildProcess::start(const std::filesystem::path& program) {
  return Error{Error::Kind::unavailable, program.string() + " cannot be run on this system"};
}

ChildProcess::~ChildProcess() = default;

std::optional<std::size_t> ChildProcess::send(std::string_view, std::chrono::milliseconds) const {
  return std::nullopt;
}

std::optional<std::size_t> ChildProcess::receive(char*, std::size_t, std::chrono::milliseconds) const {
  return std::nullopt;
}

std::chrono::nanoseconds ChildProcess::processor_time() const { return {}; }

void ChildProcess::allow_memory(std::size_t) const {}

std::string ChildProcess::end(std::chrono::milliseconds) { return {}; }

}  // namespace roomgen::detail
