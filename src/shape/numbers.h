#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/json_reader.h"
#include "expression.h"
#include "roomgen/shape/primitives.h"

namespace roomgen::shape::detail {

inline constexpr std::size_t max_curve_points = 256;
inline constexpr double max_degrees = 36000.0;

/// Shared by a document and everything that it uses: what bounds the work of reading it, and the formulas that
/// were parsed, as all copies of a component have the same ones.
struct Reading {
  std::size_t components = 0;
  std::size_t work = 0;
  std::unordered_map<std::string, Expression> formulas;
};

/// Reads numbers of a document. With a scope they may be formulas; without, numbers only.
/// Everything is rounded to six decimals, so that the concrete program is short and reads back the
/// same.
class Numbers {
 public:
  /// `problems`: of the document that is read.
  Numbers(Scope* scope, Reading& reading, JsonReader::Problems& problems)
      : scope_(scope), reading_(&reading), problems_(&problems) {}

  Scope* scope() const { return scope_; }
  Reading& reading() const { return *reading_; }
  /// Was anything reported? Then the rest need not be read.
  bool failed() const { return problems_->first().has_value(); }
  /// Counts work; false, and a report, once there was too much of it.
  bool spend(const JsonReader& json, std::size_t work) const;

  double number(const JsonReader& json, double low, double high) const;
  double number_or(const JsonReader& json, double fallback, double low, double high) const;
  int whole(const JsonReader& json, int low, int high) const;
  int whole_or(const JsonReader& json, int fallback, int low, int high) const;
  /// A size within the limits of the format.
  double length(const JsonReader& json) const;
  /// A size that may also be 0 (a bevel, the tip of a cone).
  double length_or_zero(const JsonReader& json, double fallback) const;
  double angle_or(const JsonReader& json, double fallback_degrees, double low, double high) const;
  Vec2 vec2(const JsonReader& json, double low, double high) const;
  Vec3 vec3(const JsonReader& json, double low, double high) const;
  Vec2 size2(const JsonReader& json) const;
  Vec3 size3(const JsonReader& json) const;

  /// The value of a formula, a bare number or a word.
  Value value(const JsonReader& json) const;
  /// A text; "$name" is the parameter or let of that name, which must be a word.
  std::string word(const JsonReader& json, std::string fallback) const;
  /// A formula in the free names u and v with everything else put in.
  std::string height(const JsonReader& json) const;

  /// Which indices of copies the formulas said that were read since this was last cleared.
  struct Used {
    bool i = false, j = false;
  };
  mutable Used used;

 private:
  std::vector<JsonReader> tuple(const JsonReader& json, std::size_t count) const;
  /// Null, and a report, if it is no formula.
  const Expression* compiled(const JsonReader& json, std::size_t limit) const;
  std::optional<Value> evaluated(const JsonReader& json) const;

  Scope* scope_;
  Reading* reading_;
  JsonReader::Problems* problems_;
};

/// A curve of `json[points_key]` with its corners in `json[corners_key]`: indices or "all".
Curve<Vec2> read_curve2(const JsonReader& json, const Numbers& numbers,
                        const std::string& points_key, const std::string& corners_key, bool closed);
Curve<Vec3> read_curve3(const JsonReader& json, const Numbers& numbers,
                        const std::string& points_key, const std::string& corners_key, bool closed);

}  // namespace roomgen::shape::detail
