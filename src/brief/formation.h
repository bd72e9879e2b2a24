#pragma once

namespace roomgen::brief {

/// Things that stand in rows, one behind the other; 0: not said how many there are, or how many in each. Or around a
/// point: in a whole circle, or in an arc that is open on one side. Or in islands of `columns`, pushed together.
struct Formation {
  enum class Shape { rows, circle, arc, islands };

  int rows = 1;
  int columns = 0;
  Shape shape = Shape::rows;

  bool is_round() const { return shape == Shape::circle || shape == Shape::arc; }
};

/// What a word like "ring" or "triangle" means.
struct FormationWord {
  Formation::Shape shape = Formation::Shape::circle;
  int number = 0;  ///< of things that alone can stand so, or that an island usually has; 0: any
};

}  // namespace roomgen::brief
