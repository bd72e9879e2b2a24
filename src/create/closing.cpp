#include <Eigen/Core>
#include <algorithm>
#include <set>

#include "handles.h"
#include "search.h"

namespace roomgen::create::detail {

namespace {

constexpr int steps = 3;
// Links that are considered together; hundreds of loose parts are taken by and by.
constexpr std::size_t most_links = 48;

// One side of a link, which shall go to the other.
struct Desire {
  const Link* link = nullptr;
  bool other_side = false;
};

struct Aim {
  Wish wish;
  std::optional<std::size_t> partner;  ///< none: the floor
};

// Nothing when the link is closed.
std::optional<Aim> aim(const Assembly& assembly, const Desire& desire, double sink) {
  const double missing = gap(assembly, *desire.link);
  if (missing <= (desire.link->floor ? 0.0005 : 0.0)) return std::nullopt;
  const auto& parts = assembly.parts();
  if (desire.link->floor) {
    const auto lowest = std::min_element(desire.link->one.begin(), desire.link->one.end(),
                                         [&](std::size_t a, std::size_t b) {
                                           return parts[a].box().low.z() < parts[b].box().low.z();
                                         });
    const Bounds3& box = parts[*lowest].box();
    Vec3 bottom = box.center();
    bottom.z() = box.low.z() - box.size().norm();  // the lowest vertex is the nearest
    return Aim{{*lowest, nearest_vertex(parts[*lowest], bottom), Vec3(0, 0, -box.low.z())}, {}};
  }
  NearestPair pair = nearest_pair(assembly, *desire.link);
  if (desire.other_side) {
    std::swap(pair.one, pair.other);
    std::swap(pair.points.on_a, pair.points.on_b);
  }
  Vec3 way = pair.points.on_b - pair.points.on_a;
  if (way.norm() < 1e-6) way = parts[pair.other].box().center() - parts[pair.one].box().center();
  if (way.norm() < 1e-6) way = -Vec3::UnitZ();
  way = way.normalized() * (pair.points.distance + sink);
  const std::size_t vertex = nearest_vertex(parts[pair.one], pair.points.on_a);
  return Aim{{pair.one, vertex, way}, pair.other};
}

bool belongs(const Assembly& assembly, const Aim& aim, const ComponentPath& path) {
  const auto& parts = assembly.parts();
  return starts_with(parts[aim.wish.part].source, path) &&
         !(aim.partner && starts_with(parts[*aim.partner].source, path));
}

class Closing {
 public:
  Closing(Trials& trials, const std::vector<Link>& to_close, const Link& link)
      : trials_(trials), link_(link), assembly_(trials.from().assembly) {
    for (const auto& each : to_close) {
      desires_.push_back({&each, false});
      if (!each.floor) desires_.push_back({&each, true});
    }
  }

  void try_all() {
    for (bool other_side : {false, true})
      if (!(link_.floor && other_side)) try_side({&link_, other_side});
  }

 private:
  double sink() const { return trials_.options().sink; }

  void try_side(const Desire& desire) {
    const auto wanted = aim(assembly_, desire, sink());
    if (!wanted) return;
    const ComponentPath& source = assembly_.parts()[wanted->wish.part].source;
    for (std::size_t length = source.size(); length > 0; --length) {
      const ComponentPath path(source.begin(), source.begin() + length);
      if (!belongs(assembly_, *wanted, path)) continue;
      const auto together = desires_of(path);
      for (const auto& handle : handles(path)) {
        if (trials_.exhausted()) return;
        if (together.size() > 1) follow(assembly_, handle, together);
        follow(assembly_, handle, {desire});
      }
      if (wanted->partner) centre(path, *wanted, desire);
    }
    carry_all(*wanted, desire);
  }

  std::vector<Desire> desires_of(const ComponentPath& path) const {
    std::vector<Desire> result;
    for (const auto& desire : desires_)
      if (const auto wanted = aim(assembly_, desire, sink()))
        if (belongs(assembly_, *wanted, path)) result.push_back(desire);
    return result;
  }

  std::vector<Handle> handles(const ComponentPath& path) const {
    std::vector<Handle> result = {{Handle::Kind::move, path}};
    for (int axis : {2, 0, 1})
      for (double anchor : {0.0, 1.0, 0.5})
        result.push_back({Handle::Kind::stretch, path, axis, anchor});
    const auto& solid = component_at(assembly_.program(), path).solid;
    if (std::holds_alternative<shape::SweptPart>(solid))
      for (bool first : {true, false})
        result.push_back({Handle::Kind::path_end, path, 0, 0.0, first});
    return result;
  }

  // Pulls until the links are closed: curved surfaces meet after a few steps only.
  void follow(Assembly trial, const Handle& handle, const std::vector<Desire>& desires) {
    for (int step = 0; step < steps; ++step) {
      std::vector<Wish> wishes;
      for (const auto& desire : desires)
        if (const auto wanted = aim(trial, desire, sink()))
          if (belongs(trial, *wanted, handle.path)) wishes.push_back(wanted->wish);
      if (wishes.empty()) return;
      const auto amounts = solve(trial, handle, wishes);
      if (!amounts || !pull(trial, handle, *amounts)) return;
      const bool stretched = handle.kind != Handle::Kind::move;
      trials_.consider(trial, link_.text + (stretched ? ": stretched" : ": moved"));
    }
  }

  // Over or under the middle of what it belongs to, then there.
  void centre(const ComponentPath& path, const Aim& wanted, const Desire& desire) {
    const std::string& label = assembly_.parts()[*wanted.partner].label;
    Bounds3 own, others;
    for (const auto& part : assembly_.parts()) {
      Bounds3* box = starts_with(part.source, path) ? &own
                     : part.label == label          ? &others
                                                    : nullptr;
      if (!box) continue;
      box->add(part.box().low);
      box->add(part.box().high);
    }
    if (own.empty() || others.empty()) return;
    Wish wish = wanted.wish;
    wish.move = others.center() - own.center();
    wish.move.z() = 0;
    if (wish.move.norm() < 0.001) return;
    const Handle handle{Handle::Kind::move, path};
    Assembly trial = assembly_;
    const auto amounts = solve(trial, handle, {wish});
    if (!amounts || !pull(trial, handle, *amounts)) return;
    trials_.consider(trial, link_.text + ": centred");
    follow(std::move(trial), handle, {desire});
  }

  // The whole piece goes, as it is.
  void carry_all(const Aim& wanted, const Desire& desire) {
    const auto& piece = trials_.from().judgement.piece;
    const int own = piece[wanted.wish.part];
    if (wanted.partner && piece[*wanted.partner] == own) return;
    std::set<std::size_t> tops;
    for (std::size_t k = 0; k < piece.size(); ++k)
      if (piece[k] == own) tops.insert(assembly_.parts()[k].source.front());
    if (tops.size() < 2) return;
    Assembly trial = assembly_;
    for (int step = 0; step < steps; ++step) {
      const auto next = aim(trial, desire, sink());
      if (!next) return;
      for (std::size_t top : tops) carry(trial, top, own, next->wish.move);
      trials_.consider(trial, link_.text + ": moved with what hangs on it");
    }
  }

  void carry(Assembly& trial, std::size_t top, int own, const Vec3& way) const {
    std::vector<Wish> wishes;
    for (std::size_t k = 0; k < trial.parts().size(); ++k)
      if (trial.parts()[k].source.front() == top && trials_.from().judgement.piece[k] == own)
        wishes.push_back({k, 0, way});
    const Handle handle{Handle::Kind::move, {top}};
    if (const auto amounts = solve(trial, handle, wishes)) pull(trial, handle, *amounts);
  }

  Trials& trials_;
  const Link& link_;
  const Assembly& assembly_;
  std::vector<Desire> desires_;
};

using Parts = std::vector<std::size_t>;

// The side of the link in the piece, and what of the other side is not.
Link across(const Link& link, const std::vector<int>& piece, int own, bool turned) {
  Link result = link;
  result.one.clear();
  result.other.clear();
  for (std::size_t k : turned ? link.other : link.one)
    if (piece[k] == own) result.one.push_back(k);
  for (std::size_t k : turned ? link.one : link.other)
    if (piece[k] != own) result.other.push_back(k);
  return result;
}

// To where a loose piece belongs by the map; to anything where the map says nothing.
Link way_out(const State& state, const std::vector<Link>& links, int own) {
  const auto& piece = state.judgement.piece;
  std::optional<Link> best;
  double least = 1e300;
  for (const auto& link : links) {
    if (link.floor) continue;
    for (bool turned : {false, true}) {
      Link candidate = across(link, piece, own, turned);
      if (candidate.one.empty() || candidate.other.empty()) continue;
      const double missing = nearest_pair(state.assembly, candidate).points.distance;
      if (missing >= least) continue;
      least = missing;
      best = std::move(candidate);
    }
  }
  if (best) return *best;
  Link any;
  for (std::size_t k = 0; k < piece.size(); ++k)
    (piece[k] == own ? any.one : any.other).push_back(k);
  any.text = state.assembly.parts()[any.one.front()].name;
  return any;
}

double height(const Assembly& assembly, const Link& link) {
  double low = 1e300;
  for (std::size_t k : link.one) low = std::min(low, assembly.parts()[k].box().low.z());
  return link.floor ? -1e300 : low;
}

}  // namespace

std::vector<Link> links_to_close(const State& state, const std::vector<Link>& links) {
  std::vector<Link> result;
  for (std::size_t k : state.judgement.open)
    if (result.size() < most_links) result.push_back(links[k]);
  std::stable_sort(result.begin(), result.end(), [&](const Link& a, const Link& b) {
    return height(state.assembly, a) < height(state.assembly, b);
  });
  const int pieces = std::min<int>(state.judgement.pieces, most_links);
  for (int own = state.judgement.pieces > 1 ? 0 : 1; own < pieces; ++own)
    if (result.size() < 2 * most_links) result.push_back(way_out(state, links, own));
  return result;
}

void try_closing(Trials& trials, const std::vector<Link>& to_close, std::size_t which) {
  if (!trials.exhausted()) Closing(trials, to_close, to_close[which]).try_all();
}

}  // namespace roomgen::create::detail
