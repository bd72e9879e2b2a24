#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen {

/// Reads a JSON value with located errors. All readers of one document share its first error, so a
/// parser reads straight through and asks once, at the end:
///
///     JsonReader::Problems problems{"scene.json"};
///     JsonReader root(json, problems);
///     scene.seed = root["seed"].integer_or(0, 0, max_seed);
///     if (auto error = problems.first()) return *error;
///
/// A value that is missing or of the wrong kind reads as a default (0, "", empty).
class JsonReader {
 public:
  class Problems {
   public:
    explicit Problems(std::string source) : source_(std::move(source)) {}
    /// Keeps the first: "scene.json: /objects/3/size: expected …".
    void add(const std::string& pointer, const std::string& what);
    const std::optional<Error>& first() const { return first_; }
    /// Keeps what does not stop the reading: "/light/hour: 31 is no hour; left open".
    void remark(const std::string& pointer, const std::string& what);
    const std::vector<std::string>& remarks() const { return remarks_; }
    /// The first error, else the first remark: of documents that must be taken as they are.
    Status all() const;

   private:
    std::string source_;
    std::optional<Error> first_;
    std::vector<std::string> remarks_;
  };

  JsonReader(const Json& value, Problems& problems) : value_(&value), problems_(&problems) {}

  bool exists() const { return value_ != nullptr; }
  bool is_object() const;
  bool is_array() const;
  bool is_string() const;
  const Json* raw() const { return value_; }

  /// A member; a reader of nothing if it is absent or null. Reports it if this is no object.
  JsonReader operator[](std::string_view key) const;
  /// The elements; none, and a report, if this is no array or has more than `limit` of them.
  std::vector<JsonReader> elements(std::size_t limit = 10000) const;
  std::vector<JsonReader> elements_or_none(std::size_t limit = 10000) const;
  std::vector<std::pair<std::string, JsonReader>> members() const;
  /// Reports keys that are not in the list: a misspelt option must not be silently ignored.
  void allow_only(std::initializer_list<std::string_view> keys) const;

  double number(double low, double high) const;
  double number_or(double fallback, double low, double high) const;
  long long integer_or(long long fallback, long long low, long long high) const;
  bool boolean_or(bool fallback) const;
  std::string text(std::size_t max_length = 4096) const;
  std::string text_or(std::string fallback, std::size_t max_length = 4096) const;
  /// `count` finite numbers within [low, high].
  std::vector<double> numbers(std::size_t count, double low, double high) const;

  void report(const std::string& what) const { problems_->add(pointer_, what); }
  void remark(const std::string& what) const { problems_->remark(pointer_, what); }
  /// The JSON pointer of the value.
  const std::string& pointer() const { return pointer_; }

 private:
  JsonReader(const Json* value, Problems& problems, std::string pointer)
      : value_(value), problems_(&problems), pointer_(std::move(pointer)) {}

  const Json* value_;
  Problems* problems_;
  std::string pointer_;
};

}  // namespace roomgen
