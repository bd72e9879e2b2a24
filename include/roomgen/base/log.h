#pragma once

#include <functional>
#include <string_view>

namespace roomgen {

enum class LogLevel { info, warning };

/// Where a library call reports what its result does not carry (an asset repaired, a file skipped).
/// Empty means silence; there is no global log.
using LogSink = std::function<void(LogLevel, std::string_view message)>;

inline void log(const LogSink& sink, LogLevel level, std::string_view message) {
  if (sink) sink(level, message);
}

}  // namespace roomgen
