#include "judgement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "alignment.h"
#include "part_roles.h"
#include "roomgen/base/text.h"

namespace roomgen::create::detail {

namespace {

constexpr double level_tolerance = 0.001;

void number_pieces(Judgement& judgement) {
  const std::size_t count = judgement.contacts.size();
  judgement.piece.assign(count, -1);
  std::vector<int> sizes;
  for (std::size_t start = 0; start < count; ++start) {
    if (judgement.piece[start] >= 0) continue;
    const int number = static_cast<int>(sizes.size());
    std::vector<std::size_t> waiting = {start};
    judgement.piece[start] = number;
    sizes.push_back(0);
    while (!waiting.empty()) {
      const std::size_t part = waiting.back();
      waiting.pop_back();
      ++sizes.back();
      for (std::size_t next : judgement.contacts[part])
        if (judgement.piece[next] < 0) {
          judgement.piece[next] = number;
          waiting.push_back(next);
        }
    }
  }
  std::vector<int> order(sizes.size()), rank(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return sizes[a] > sizes[b]; });
  for (std::size_t k = 0; k < order.size(); ++k) rank[order[k]] = static_cast<int>(k);
  for (int& piece : judgement.piece) piece = rank[piece];
  judgement.pieces = static_cast<int>(sizes.size());
}

void find_levels(Judgement& judgement, const Assembly& assembly) {
  judgement.level.assign(assembly.parts().size(), -1);
  std::vector<std::size_t> wave;
  for (std::size_t k = 0; k < assembly.parts().size(); ++k)
    if (assembly.parts()[k].box().low.z() <= judgement.standing.low + assembly.contact()) {
      judgement.level[k] = 0;
      wave.push_back(k);
    }
  for (std::size_t at = 0; at < wave.size(); ++at)
    for (std::size_t next : judgement.contacts[wave[at]])
      if (judgement.level[next] < 0) {
        judgement.level[next] = judgement.level[wave[at]] + 1;
        wave.push_back(next);
      }
}

bool reaches(const Assembly& assembly, const std::vector<std::size_t>& parts, double low) {
  return std::any_of(parts.begin(), parts.end(), [&](std::size_t k) {
    return assembly.parts()[k].box().low.z() <= low + assembly.contact();
  });
}

// A leg on a castor reaches the floor by it.
bool on_floor(const Assembly& assembly, const Link& link, const Judgement& judgement) {
  if (reaches(assembly, link.one, judgement.standing.low)) return true;
  for (std::size_t k : link.one)
    for (std::size_t under : judgement.contacts[k])
      if (assembly.parts()[under].box().center().z() < assembly.parts()[k].box().low.z() + 0.01 &&
          reaches(assembly, {under}, judgement.standing.low))
        return true;
  return false;
}

bool closed(const Assembly& assembly, const Link& link) {
  for (std::size_t a : link.one)
    for (std::size_t b : link.other)
      if (assembly.touch(a, b) && !assembly.touch_in_a_point(a, b)) return true;
  return false;
}

double height_above_floor(const Assembly& assembly, const Link& link) {
  double low = 1e300;
  for (std::size_t k : link.one) low = std::min(low, assembly.parts()[k].box().low.z());
  return low;
}

std::string millimetres(double length) {
  return format_number(1000.0 * length, 0) + " mm";
}

// "leg-3" and "leg-0" are copies of a leg, made apart.
std::string family(const std::string& name) {
  const auto last = name.find_last_not_of("0123456789");
  const bool numbered = last != std::string::npos && last + 1 < name.size() && name[last] == '-';
  return numbered ? name.substr(0, last) : name;
}

bool feet_alike(const Assembly& assembly) {
  std::map<std::string, double> volumes;
  for (const auto& part : assembly.parts()) {
    if (!is_foot(part.label)) continue;
    const auto [known, is_new] = volumes.emplace(family(part.name), part.volume);
    if (!is_new && std::abs(known->second - part.volume) > 0.02 * known->second) return false;
  }
  return true;
}

}  // namespace

NearestPair nearest_pair(const Assembly& assembly, const Link& link) {
  NearestPair best;
  best.points.distance = 1e300;
  struct Pair {
    double least;
    std::size_t one, other;
  };
  std::vector<Pair> pairs;
  for (std::size_t a : link.one)
    for (std::size_t b : link.other)
      pairs.push_back({box_distance(assembly.parts()[a].box(), assembly.parts()[b].box()), a, b});
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.least, a.one, a.other) < std::tie(b.least, b.one, b.other);
  });
  for (const auto& pair : pairs) {
    if (pair.least >= best.points.distance) break;
    const NearestPoints points = assembly.nearest(pair.one, pair.other);
    if (points.distance < best.points.distance) best = {pair.one, pair.other, points};
    if (points.distance <= 0.0) break;
  }
  return best;
}

double gap(const Assembly& assembly, const Link& link) {
  if (link.floor) return std::abs(height_above_floor(assembly, link));
  if (closed(assembly, link)) return 0.0;
  return std::max(nearest_pair(assembly, link).points.distance, 0.001);
}

double Judgement::penalty() const {
  return 10.0 * (pieces - 1) + (grounded ? 0.0 : 10.0) + (stable ? 0.0 : 8.0) +
         3.0 * static_cast<double>(open.size()) + 2.0 * std::min(gaps, 20.0) + 0.5 * astray +
         2.0 * std::min(outside, 20.0);
}

bool Judgement::no_worse_than(const Judgement& other) const {
  return pieces <= other.pieces && grounded >= other.grounded && stable >= other.stable &&
         open.size() <= other.open.size();
}

Judgement judge(const Assembly& assembly, const std::vector<Link>& links,
                const ValidateOptions& options) {
  Judgement result;
  result.contacts = assembly.contacts();
  number_pieces(result);
  result.standing = standing(assembly.parts(), options.contact);
  find_levels(result, assembly);
  const bool on_ground = options.footing == Footing::ground;
  result.grounded =
      options.as_drawn || !on_ground || std::abs(result.standing.low) <= level_tolerance;
  result.stable = on_ground ? result.standing.stable() : result.pieces == 1;
  for (std::size_t k = 0; k < links.size(); ++k) {
    if (!links[k].firm) continue;
    if (links[k].floor ? on_floor(assembly, links[k], result) : closed(assembly, links[k]))
      continue;
    result.open.push_back(k);
    result.gaps += gap(assembly, links[k]);
  }
  for (const auto& foot : find_astray(assembly, links)) {
    ++result.astray;
    result.outside += foot.outside;
  }
  return result;
}

namespace {

// What does not hang together with the largest piece: "rosette-0 and 2 more (14 mm from the rest)".
std::string loose_parts(const Assembly& assembly, const Judgement& judgement) {
  constexpr int most_named = 8;
  std::vector<std::string> names;
  for (int piece = 1; piece < std::min(judgement.pieces, most_named + 1); ++piece) {
    Link away;
    for (std::size_t k = 0; k < judgement.piece.size(); ++k)
      (judgement.piece[k] == piece ? away.one : away.other).push_back(k);
    const std::size_t more = away.one.size() - 1;
    names.push_back(assembly.parts()[away.one.front()].name +
                    (more > 0 ? " and " + std::to_string(more) + " more (" : " (") +
                    millimetres(nearest_pair(assembly, away).points.distance) + " from the rest)");
  }
  return join(names, ", ");
}

}  // namespace

Soundness soundness(const Assembly& assembly, const std::vector<Link>& links,
                    const Judgement& judgement, const ValidateOptions& options) {
  Soundness result;
  result.bodies = static_cast<int>(assembly.parts().size());
  result.pieces = judgement.pieces;
  result.grounded = judgement.grounded;
  result.stable = judgement.stable;
  const bool on_ground = options.footing == Footing::ground;
  result.stability = on_ground ? judgement.standing.margin : 0.0;
  result.supported = on_ground ? std::none_of(judgement.level.begin(), judgement.level.end(),
                                              [](int level) { return level < 0; })
                               : judgement.pieces == 1;
  result.congruent = options.as_drawn || feet_alike(assembly);
  for (std::size_t k : judgement.open) {
    const double missing = gap(assembly, links[k]);
    const bool touching = missing <= options.contact && !links[k].floor;
    result.open_connections.push_back(
        links[k].text + ": " + (touching ? "only a point" : millimetres(missing) + " apart"));
  }
  result.problems = result.open_connections;
  if (result.pieces > 1)
    result.problems.push_back("falls into " + std::to_string(result.pieces) +
                              " pieces; loose: " + loose_parts(assembly, judgement));
  if (!result.grounded)
    result.problems.push_back("the lowest point is at " + millimetres(judgement.standing.low));
  if (!result.stable && on_ground)
    result.problems.push_back("tips over: the centre of mass is " +
                              millimetres(-judgement.standing.margin) + " outside its feet");
  if (!result.congruent) result.problems.push_back("its feet are of different sizes");
  return result;
}

}  // namespace roomgen::create::detail
