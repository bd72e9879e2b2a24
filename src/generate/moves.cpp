#include "moves.h"

#include <algorithm>
#include <cmath>

namespace roomgen {

namespace {

// Less than a file tells apart.
constexpr double same_place = 5e-4, same_turn = 1e-4;

bool is_move(const Move& move) {
  return move.distance() > same_place || std::abs(move.turn) > same_turn;
}

}  // namespace

std::vector<Move> moves_between(std::span<const Object> before, std::span<const Object> after) {
  std::vector<Move> moves;
  for (const auto& old : before) {
    const Object* now = find_object(after, old.id);
    if (!now) continue;
    Move move{old.id, old.position, now->position, wrap_angle(now->yaw - old.yaw)};
    if (is_move(move)) moves.push_back(std::move(move));
  }
  return moves;
}

void add_moves(const std::vector<Move>& later, std::vector<Move>& moves) {
  for (const auto& move : later) {
    const auto known = std::find_if(moves.begin(), moves.end(), [&](const Move& other) {
      return other.object == move.object;
    });
    if (known == moves.end()) {
      moves.push_back(move);
    } else {
      known->to = move.to;
      known->turn = wrap_angle(known->turn + move.turn);
    }
  }
  std::erase_if(moves, [](const Move& move) { return !is_move(move); });
}

}  // namespace roomgen
