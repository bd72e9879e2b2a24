#include "inbox.h"

#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr std::size_t max_header_bytes = 64u << 10;

}  // namespace

bool Inbox::header(std::string_view line) {
  header_bytes_ += line.size();
  // The headers of an interim answer (100, 103) are not those of the answer.
  if (line.starts_with("HTTP/")) answer_ = {};
  const auto colon = line.find(':');
  if (colon != std::string_view::npos) {
    const std::string name = lower(line.substr(0, colon));
    if (name == "location") answer_.location = trim(line.substr(colon + 1));
    if (name == "retry-after") answer_.retry_after = trim(line.substr(colon + 1));
  }
  too_long_ = header_bytes_ > max_header_bytes;
  return !too_long_;
}

bool Inbox::body(std::string_view bytes) {
  too_long_ = answer_.body.size() + bytes.size() > limit_;
  if (!too_long_) answer_.body += bytes;
  return !too_long_;
}

void Inbox::moved(long long bytes) {
  if (bytes == bytes_moved_) return;
  bytes_moved_ = bytes;
  last_moved_ = Clock::now();
}

}  // namespace roomgen
