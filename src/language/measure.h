#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "token.h"

namespace roomgen::language {

/// A length, several sides, or an area.
struct Measure {
  enum class Kind : std::uint8_t { length, sides, area, range };
  /// Which side a length is said of: "2 m long".
  enum class Side : std::uint8_t {
    unsaid,
    length,
    width,
    depth,
    height,
    thickness,
    diameter,
    distance
  };

  /// "at least 2 m", "no taller than 2 m"
  enum class Limit : std::uint8_t { exact, least, most };

  Kind kind = Kind::length;
  Limit limit = Limit::exact;
  Side side = Side::unsaid;
  int count = 1;                 ///< of values
  double values[3] = {0, 0, 0};  ///< metres or square metres; of a range the least and the most
  bool has_unit = true;          ///< "4 x 5": values as they are
  std::size_t length = 0;        ///< tokens
};

/// The measure that begins at a token: 1.8 m, two metres, half a metre, 6'2", 5 feet 10 inches,
/// 2.5 by 3 metres, 80 x 60 x 75 cm, 2-3 m, 20 m2, twelve square feet; with the side that it is
/// said of ("1.8 m wide", "2-metre-long"). Sides without units of their own have that of the last;
/// sides without any are measures too, single numbers are none. What is longer than 1 km is read as 1 km.
std::optional<Measure> measure_at(std::span<const Token> tokens, std::size_t at);

/// Words that bound what is measured or counted behind them: "at least", "no taller than".
struct Bound {
  Measure::Limit limit = Measure::Limit::exact;
  Measure::Side side = Measure::Side::unsaid;
  std::size_t length = 0;  ///< tokens; 0: there are none
};
Bound bound_at(std::span<const Token> tokens, std::size_t at);

/// A measure with what bounds it: "at least 80 cm", "up to 2 m long", "no taller than 2 m".
std::optional<Measure> bounded_measure_at(std::span<const Token> tokens, std::size_t at);

}  // namespace roomgen::language
