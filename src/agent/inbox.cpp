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
  too_long_ = answer_.body.size() + bytes.size() > limits_.answer_bytes;
  if (!too_long_) answer_.body += bytes;
  return !too_long_;
}

// How long it took to the first byte of an answer says nothing of how fast the rest comes.
void Inbox::moved(long long sent, long long received, Seconds now) {
  const long long bytes = sent + received - bytes_then_;
  const bool begins = received > 0 && !has_begun_;
  const Seconds since = now - last_alive_;
  const bool fast_enough = bytes > 0 && static_cast<double>(bytes) >= limits_.least_speed * since.count();
  if (!begins && !fast_enough) return;
  has_begun_ = has_begun_ || begins;
  bytes_then_ += bytes;
  last_alive_ = now;
}

}  // namespace roomgen
