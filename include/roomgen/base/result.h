#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace roomgen {

/// Why an operation failed. The kind decides the exit code of the command-line tool and lets callers
/// react; the message is for people: what, where (file, line or JSON pointer) and what to do.
struct Error {
  enum class Kind {
    invalid_input,  ///< the caller's data is wrong: a file, an option, a polygon
    not_found,      ///< a file, an asset or an object that does not exist
    io,             ///< reading or writing failed
    limit,          ///< a bound on size, depth, time or money was reached
    cancelled,      ///< the caller asked to stop
    not_understood, ///< nothing in a text that is read by rules means anything to them
    unavailable,    ///< this build or machine lacks what was asked for
    too_small,      ///< a room has no place for what makes it what it is called
  };
  Kind kind = Kind::invalid_input;
  std::string message;
};

/// The same error with "context: " before its message.
inline Error with_context(const Error& error, const std::string& context) {
  return {error.kind, context + ": " + error.message};
}

/// A value or the reason why there is none. Expected failures travel this way; exceptions of
/// third-party libraries stop in the adapter that includes them.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// Precondition: ok().
  T& operator*() & { return std::get<0>(state_); }
  const T& operator*() const& { return std::get<0>(state_); }
  T&& operator*() && { return std::get<0>(std::move(state_)); }
  T* operator->() { return &std::get<0>(state_); }
  const T* operator->() const { return &std::get<0>(state_); }

  /// Precondition: !ok().
  const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// Success without a value, or an error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), ok_(false) {}

  bool ok() const { return ok_; }
  explicit operator bool() const { return ok_; }
  const Error& error() const { return error_; }

 private:
  Error error_;
  bool ok_ = true;
};

using Status = Result<void>;

enum class LogLevel { info, warning };

/// Where a library call reports what its result does not carry (an asset repaired, a file skipped).
/// Empty means silence; there is no global log.
using LogSink = std::function<void(LogLevel, std::string_view message)>;

inline void log(const LogSink& sink, LogLevel level, std::string_view message) {
  if (sink) sink(level, message);
}

}  // namespace roomgen
