#include "retry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "roomgen/base/text.h"
#include "wire.h"

namespace roomgen {

namespace {

using Seconds = RetryPolicy::Seconds;

bool is_transient_status(const HttpAnswer& answer) {
  // OpenAI says 429 also when an account has run dry, which no waiting mends.
  if (answer.status == 429) return answer.body.find("insufficient_quota") == std::string::npos;
  return answer.status == 408 || answer.status == 409 || answer.status >= 500;
}

bool is_transient_failure(HttpFailure::Kind kind) {
  using Kind = HttpFailure::Kind;
  return kind == Kind::refused || kind == Kind::not_taken || kind == Kind::timed_out || kind == Kind::broken;
}

std::optional<Seconds> parse_seconds(std::string_view text) {
  if (text.empty() || text.size() > 9) return std::nullopt;
  if (text.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  return Seconds(std::stod(std::string(text)));
}

// "Sun, 06 Nov 1994 08:49:37 GMT", read without the locale.
std::optional<std::chrono::sys_seconds> parse_http_date(std::string_view text) {
  static constexpr std::array months = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                        "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  unsigned day = 0;
  int year = 0, hour = 0, minute = 0, second = 0;
  char name[4] = {};
  if (std::sscanf(std::string(text).c_str(), "%*3s, %2u %3s %4d %2d:%2d:%2d GMT", &day, name, &year,
                  &hour, &minute, &second) != 6)
    return std::nullopt;
  const auto month = std::find(months.begin(), months.end(), std::string_view(name));
  const std::chrono::year_month_day date{
      std::chrono::year(year),
      std::chrono::month(static_cast<unsigned>(month - months.begin()) + 1), std::chrono::day(day)};
  if (!date.ok()) return std::nullopt;
  return std::chrono::sys_days(date) + std::chrono::hours(hour) + std::chrono::minutes(minute) +
         std::chrono::seconds(second);
}

}  // namespace

bool is_transient(const HttpOutcome& outcome) {
  if (const auto* failure = std::get_if<HttpFailure>(&outcome))
    return is_transient_failure(failure->kind);
  return is_transient_status(std::get<HttpAnswer>(outcome));
}

std::optional<Seconds> parse_retry_after(std::string_view text,
                                         std::chrono::system_clock::time_point now) {
  text = trim(text);
  if (auto seconds = parse_seconds(text)) return seconds;
  const auto date = parse_http_date(text);
  if (!date) return std::nullopt;
  return std::max(Seconds(0), std::chrono::duration_cast<Seconds>(*date - now));
}

Seconds backoff(const RetryPolicy& policy, int failures, Random& random) {
  const Seconds full = policy.first_wait * std::pow(2.0, std::min(failures, 60) - 1);
  return std::min(full, policy.longest_wait) * random.uniform(0.5, 1.0);
}

bool is_loading(const HttpOutcome& outcome) {
  const auto* answer = std::get_if<HttpAnswer>(&outcome);
  return answer && answer->status == 503 &&
         lower(complaint_in(answer->body)).find("loading") != std::string::npos;
}

}  // namespace roomgen
