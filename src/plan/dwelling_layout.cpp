#include "dwelling_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "roomgen/scene/room.h"
#include "roomgen/scene/scene.h"

namespace roomgen::plan {

namespace {

constexpr double hall_width = 1.35;
constexpr double least_width = 1.6;       // of any room
constexpr double usual_width = 1.9;       // of a room in a row, at least
constexpr double hub_ratio = 1.3;         // long to short side of a living room with rooms around it
constexpr std::size_t most_around = 4;    // such a hub and rooms around it; more need a hall
constexpr std::size_t most_owned = 2;     // rooms that belong to one alone; more are everybody's
constexpr double longest_row_ratio = 1.35;
constexpr double least_hall = 2.0;        // long
constexpr double least_depth = 2.4, greatest_depth = 4.8;  // of a row of rooms
constexpr double least_stretched = 2.2;   // deep, of a row that is drawn out to the length of the other
constexpr double narrowest_share = 0.72;  // of the side of a square of the least usual area: what a room is wide at least
constexpr double too_narrow = 0.05;       // by so much of that in all, and a dwelling is laid out anew
const char* const hallway = "hallway";

double to_centimetres(double metres) {
  return std::round(100.0 * metres) / 100.0;
}

/// A room with those that only it gives access to.
struct Block {
  std::size_t room = 0;
  std::vector<std::size_t> owned;
  double area = 0.0;
};

/// A side of the hub: s along it, t outward from its inner face.
struct Side {
  Vec2 origin, along, outward;
  double length = 0.0;

  Bounds2 box(double s0, double s1, double t0, double t1) const {
    Bounds2 result;
    result.add(origin + s0 * along + t0 * outward);
    result.add(origin + s1 * along + t1 * outward);
    return result;
  }
};

double squareness(double a, double b, double least_side) {
  const double least = std::min(a, b);
  return std::log(std::max(a, b) / std::max(least, 0.01)) + (least < least_side ? 5.0 : 0.0);
}

// A bedroom 2 m wide has room for a bed and no way around it.
double least_side(const brief::DwellingRoom& kind) {
  return std::max(least_width, narrowest_share * std::sqrt(kind.area.low));
}

class Packer {
 public:
  Packer(std::vector<LaidRoom> rooms, const brief::DwellingKinds& kinds, bool with_hall)
      : rooms_(std::move(rooms)), kinds_(kinds), with_hall_(with_hall) {}

  std::vector<LaidRoom> run() {
    bound_owned();
    choose_hub();
    make_blocks();
    if (rooms_[hub_].type == hallway)
      lay_along_hall();
    else
      lay_around_room();
    return std::move(rooms_);
  }

 private:
  const brief::DwellingRoom& kind(std::size_t room) const {
    static const brief::DwellingRoom unknown;
    const auto found = kinds_.rooms.find(rooms_[room].type);
    return found == kinds_.rooms.end() ? unknown : found->second;
  }

  // --- The hub --------------------------------------------------------------------------------

  // What belongs to a room that itself belongs to another, or comes third, is entered from the hub.
  void bound_owned() {
    std::vector<std::size_t> owned(rooms_.size(), 0);
    for (auto& room : rooms_)
      if (room.parent != LaidRoom::none &&
          (rooms_[room.parent].parent != LaidRoom::none || owned[room.parent]++ >= most_owned))
        room.parent = LaidRoom::none;
  }

  void choose_hub() {
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      if (rooms_[i].parent == LaidRoom::none) free.push_back(i);
    hub_ = free.front();
    for (const std::size_t room : free)
      if (kind(room).hub > kind(hub_).hub) hub_ = room;
    const bool unfit = kind(hub_).hub == 0 && free.size() > 1;
    const bool crowded = free.size() > most_around || with_hall_;
    if (rooms_[hub_].type != hallway && (unfit || crowded) && rooms_.size() < max_rooms) {
      hub_ = rooms_.size();
      rooms_.push_back({hallway, 0.0, LaidRoom::none, {}});
    }
    for (const std::size_t room : free)
      if (room != hub_) rooms_[room].parent = hub_;
  }

  void make_blocks() {
    for (std::size_t i = 0; i < rooms_.size(); ++i)
      if (i != hub_ && rooms_[i].parent == hub_) blocks_.push_back({i, {}, rooms_[i].area});
    for (auto& block : blocks_)
      for (std::size_t i = 0; i < rooms_.size(); ++i)
        if (rooms_[i].parent == block.room) {
          block.owned.push_back(i);
          block.area += rooms_[i].area;
        }
    // What gives access to others, and what belongs to it, comes first.
    std::stable_sort(blocks_.begin(), blocks_.end(), [&](const Block& a, const Block& b) {
      return kind(a.room).hub > kind(b.room).hub;
    });
  }

  // --- Rows -----------------------------------------------------------------------------------

  static double total(const std::vector<Block>& blocks) {
    double sum = 0.0;
    for (const auto& block : blocks) sum += block.area;
    return sum;
  }

  static double walls(const std::vector<Block>& blocks) {
    return wall_thickness * static_cast<double>(blocks.size() - 1);
  }

  // One block after the other along a side, `depth` deep, `length` long in all.
  void lay_row(const std::vector<Block>& blocks, const Side& side, double length, double depth) {
    const double free = length - walls(blocks), sum = total(blocks);
    double done = 0.0, begin = 0.0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      done += blocks[i].area;
      const bool last = i + 1 == blocks.size();
      const double end = to_centimetres(
          last ? length : free * done / sum + wall_thickness * static_cast<double>(i));
      lay_block(blocks[i], side, begin, end, depth);
      begin = end + wall_thickness;
    }
  }

  // The room, and what belongs to it beside or behind it.
  void lay_block(const Block& block, const Side& side, double begin, double end, double depth) {
    const double front = wall_thickness, back = to_centimetres(wall_thickness + depth);
    if (block.owned.empty()) {
      rooms_[block.room].box = side.box(begin, end, front, back);
      return;
    }
    double owned = 0.0;
    for (const std::size_t room : block.owned) owned += rooms_[room].area;
    const double share = owned / block.area, width = end - begin;
    const auto count = static_cast<double>(block.owned.size());
    // Whichever leaves the narrowest of them wider.
    const double least_share = std::min(share, 1.0 - share);
    const bool beside = std::min(width * least_share, depth / count) >=
                        std::min(depth * least_share, width / count);
    if (beside) {
      const double split = to_centimetres(end - part(width, share));
      rooms_[block.room].box = side.box(begin, split, front, back);
      divide(block.owned, owned, front, back, [&](double from, double to) {
        return side.box(split + wall_thickness, end, from, to);
      });
    } else {
      const double split = to_centimetres(back - part(depth, share));
      rooms_[block.room].box = side.box(begin, end, front, split);
      divide(block.owned, owned, begin, end, [&](double from, double to) {
        return side.box(from, to, split + wall_thickness, back);
      });
    }
  }

  // A share of a length that leaves neither part too narrow.
  static double part(double length, double share) {
    const double least = std::min(least_width, 0.5 * length);
    return std::clamp(length * share, least, length - least);
  }

  // One room, or two behind each other.
  template <typename Box>
  void divide(const std::vector<std::size_t>& rooms, double sum, double low, double high,
              const Box& box) {
    if (rooms.size() < 2) {
      rooms_[rooms[0]].box = box(low, high);
      return;
    }
    const double free = high - low - wall_thickness;
    const double border = to_centimetres(low + part(free, rooms_[rooms[0]].area / sum));
    rooms_[rooms[0]].box = box(low, border);
    rooms_[rooms[1]].box = box(border + wall_thickness, high);
  }

  // --- Two rows along a hall ------------------------------------------------------------------

  void lay_along_hall() {
    std::vector<Block> day, night;
    for (const auto& block : blocks_) (kind(block.room).night ? night : day).push_back(block);
    balance(day, night);
    balance(night, day);
    double day_depth = depth_of(day), night_depth = depth_of(night);
    widen(day, day_depth);
    widen(night, night_depth);
    const double length = std::max(length_of(day, day_depth), length_of(night, night_depth));
    // The shorter row becomes shallower rather than larger.
    const double day_length = stretch(day, day_depth, length);
    const double night_length = stretch(night, night_depth, length);
    const double hall = to_centimetres(std::max({day_length, night_length, least_hall}));
    Bounds2& box = rooms_[hub_].box;
    box.low = {0.0, 0.0};
    box.high = {hall, hall_width};
    if (!day.empty())
      lay_row(day, {{0.0, hall_width}, {1, 0}, {0, 1}, hall}, std::min(day_length, hall), day_depth);
    if (!night.empty())
      lay_row(night, {{0.0, 0.0}, {1, 0}, {0, -1}, hall}, std::min(night_length, hall), night_depth);
  }

  // Moves blocks to the other row while that makes both more alike.
  void balance(std::vector<Block>& from, std::vector<Block>& to) const {
    for (;;) {
      const double difference = total(from) - total(to);
      std::size_t best = from.size();
      double least = difference - 1.0;  // not for next to nothing
      for (std::size_t i = 0; i < from.size(); ++i) {
        const double left = std::abs(difference - 2.0 * from[i].area);
        if (left < least) best = i, least = left;
      }
      if (best == from.size() || from.size() < 2) return;
      to.push_back(from[best]);
      from.erase(from.begin() + static_cast<std::ptrdiff_t>(best));
    }
  }

  static double depth_of(const std::vector<Block>& blocks) {
    if (blocks.empty()) return 0.0;
    double squares = 0.0;
    for (const auto& block : blocks) squares += block.area * block.area;
    return std::clamp(1.02 * std::sqrt(squares / total(blocks)), least_depth, greatest_depth);
  }

  // Small rooms in a deep row become larger rather than corridors.
  void widen(std::vector<Block>& blocks, double depth) const {
    for (auto& block : blocks) {
      const double least = std::max(usual_width, least_side(kind(block.room)));
      block.area = std::max(block.area, (least + (block.owned.empty() ? 0.0 : usual_width)) * depth);
    }
  }

  static double length_of(const std::vector<Block>& blocks, double depth) {
    return blocks.empty() ? 0.0 : total(blocks) / depth + walls(blocks);
  }

  static double stretch(const std::vector<Block>& blocks, double& depth, double length) {
    if (blocks.empty()) return 0.0;
    const double own = length_of(blocks, depth);
    if (length / own > longest_row_ratio) return own;
    depth = std::max(least_stretched, total(blocks) / (length - walls(blocks)));
    return length;
  }

  // --- Rows along the sides of a room ---------------------------------------------------------

  struct RowPlan {
    double depth = 0.0, length = 0.0, cost = 0.0;
  };

  // The whole side, or less of it where the row would become too shallow.
  RowPlan plan_row(const std::vector<Block>& blocks, double side) const {
    RowPlan row;
    if (blocks.empty()) return row;
    const double sum = total(blocks);
    row.length = side;
    row.depth = sum / (side - walls(blocks));
    double largest = 0.0;
    for (const auto& block : blocks) largest = std::max(largest, block.area);
    if (row.depth < 0.75 * std::sqrt(largest)) {
      row.depth = std::max(least_width, 0.9 * std::sqrt(largest));
      row.length = std::min(side, sum / row.depth + walls(blocks));
      row.cost += 0.1;
    }
    for (const auto& block : blocks) {
      const double width = (row.length - walls(blocks)) * block.area / sum;
      row.cost += squareness(width, row.depth, least_side(kind(block.room))) + (block.owned.empty() ? 0.0 : -0.5);
    }
    return row;
  }

  void lay_around_room() {
    const double depth = to_centimetres(std::sqrt(rooms_[hub_].area / hub_ratio));
    const double width = to_centimetres(rooms_[hub_].area / depth);
    rooms_[hub_].box.low = {0.0, 0.0};
    rooms_[hub_].box.high = {width, depth};
    const Side back{{0.0, depth}, {1, 0}, {0, 1}, width};
    const Side right{{width, 0.0}, {0, 1}, {1, 0}, depth};
    // Few enough to try every way of sharing them out between both sides.
    std::vector<Block> best_back, best_right;
    double least = std::numeric_limits<double>::max();
    const std::size_t ways = std::size_t{1} << std::min<std::size_t>(blocks_.size(), 11);
    for (std::size_t way = 0; way < ways; ++way) {
      std::vector<Block> at_back, at_right;
      for (std::size_t i = 0; i < blocks_.size(); ++i)
        ((way >> i) & 1 ? at_right : at_back).push_back(blocks_[i]);
      const double cost = plan_row(at_back, width).cost + plan_row(at_right, depth).cost;
      if (cost < least - 1e-9) {
        least = cost;
        best_back = std::move(at_back);
        best_right = std::move(at_right);
      }
    }
    lay_beside(best_back, back);
    lay_beside(best_right, right);
  }

  void lay_beside(const std::vector<Block>& blocks, const Side& side) {
    if (blocks.empty()) return;
    const RowPlan row = plan_row(blocks, side.length);
    lay_row(blocks, side, row.length, row.depth);
  }

  std::vector<LaidRoom> rooms_;
  const brief::DwellingKinds& kinds_;
  bool with_hall_;
  std::size_t hub_ = 0;
  std::vector<Block> blocks_;
};

// By how much of what they need the rooms are too narrow, all together.
double narrowness(const std::vector<LaidRoom>& laid, const brief::DwellingKinds& kinds) {
  double sum = 0.0;
  for (const auto& room : laid) {
    const auto kind = kinds.rooms.find(room.type);
    if (kind == kinds.rooms.end() || room.type == hallway) continue;
    const double least = least_side(kind->second);
    sum += std::max(0.0, 1.0 - room.box.size().minCoeff() / least);
  }
  return sum;
}

}  // namespace

std::vector<LaidRoom> lay_out(std::vector<LaidRoom> rooms, const brief::DwellingKinds& kinds) {
  if (rooms.empty()) return rooms;
  auto laid = Packer(rooms, kinds, false).run();
  const double narrow = narrowness(laid, kinds);
  if (narrow <= too_narrow) return laid;
  // Along a hall each room has the width that it needs.
  auto along_hall = Packer(std::move(rooms), kinds, true).run();
  return narrowness(along_hall, kinds) < narrow ? along_hall : laid;
}

}  // namespace roomgen::plan
