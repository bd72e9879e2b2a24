#pragma once

#include <cstddef>
#include <string>

#include "roomgen/base/cancel.h"

namespace roomgen::cli {

/// Lines of an open file or pipe. What is longer than the bound is passed over without being kept.
class LineSource {
 public:
  enum class Event { line, too_long, end };

  LineSource(int file, std::size_t max_bytes) : file_(file), max_bytes_(max_bytes) {}

  /// Waits for a line. The end is also that of what stops by a signal: `stopped` is set by its handler, which
  /// runs in this call only.
  Event next(std::string& line, const CancelToken& stopped);

 private:
  bool read_more(const CancelToken& stopped);

  int file_;
  std::size_t max_bytes_;
  std::string buffer_;        ///< read, and not yet given out
  std::size_t searched_ = 0;  ///< of the buffer, without a newline
  bool skipping_ = false;     ///< the rest of a line that is too long
};

}  // namespace roomgen::cli
