#include "targets.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace roomgen::design {

namespace {

constexpr std::size_t max_choices = 8;
// Nearer than this, a thing is taken for the partner of another.
constexpr double partner_gap = 0.7;
// Length of a table's edge for one seat, ends included.
constexpr double place_width = 0.8;

// How many things like `self` the candidate has already.
int partners(const Sketch& sketch, const Object& self, const Standing& candidate) {
  return static_cast<int>(
      std::count_if(sketch.standing().begin(), sketch.standing().end(), [&](const Standing& other) {
        if (other.object == candidate.object) return false;
        if (!sketch.categories().is_a(other.object->category, self.category)) return false;
        if (!other.object->on.empty()) return depends_on(*other.object, candidate.object->id);
        return gap(other.footprint, candidate.footprint) <= partner_gap;
      }));
}

// How many such partners a thing has use for: places along the sides of a table, one seat at a
// desk, else one on either side.
double capacity(const Standing& one, bool seat) {
  if (one.object->traits.front) return seat ? 1.0 : 2.0;
  const Vec3& size = one.object->size;
  return std::max(1.0, std::floor(2.0 * (size.x() + size.y()) / place_width));
}

bool is_of(const KindTable& table, const std::string& category, const std::string& kind) {
  constexpr std::string_view exactly = "exactly ";
  if (!kind.starts_with(exactly)) return table.is_a(category, kind);
  const Kind* one = table.find(category);
  return one && one->name == kind.substr(exactly.size());
}

struct Member {
  std::string id;
  double burden = 0.0;
};

std::vector<Member> members(const Sketch& sketch, const Object& self, const std::string& kind) {
  std::vector<Member> found;
  if (kind == "door" || kind == "window") {
    for (const auto& opening : sketch.openings(kind == "door")) found.push_back({opening.id, 0.0});
    return found;
  }
  const bool seat = sketch.categories().is_a(self.category, "seat");
  for (const auto& one : sketch.standing()) {
    if (!is_of(sketch.categories(), one.object->category, kind) || one.object->id == self.id)
      continue;
    const double burden = partners(sketch, self, one) / capacity(one, seat);
    if (burden < 1.0) found.push_back({one.object->id, burden});
  }
  return found;
}

void put(std::vector<Relation>& relations, const std::string& kind, const std::string& id) {
  for (auto& relation : relations)
    if (relation.target == kind) relation.target = id;
}

}  // namespace

std::vector<Choice> resolve(const Sketch& sketch, const Object& self,
                            const std::vector<Relation>& way) {
  std::vector<Choice> choices{{way, 0.0}};
  std::set<std::string> kinds;
  for (const auto& relation : way)
    if (!relation.target.empty()) kinds.insert(relation.target);
  for (const auto& kind : kinds) {
    std::vector<Choice> next;
    for (const auto& member : members(sketch, self, kind))
      for (Choice choice : choices) {
        put(choice.relations, kind, member.id);
        choice.burden += member.burden;
        next.push_back(std::move(choice));
      }
    std::stable_sort(next.begin(), next.end(),
                     [](const Choice& a, const Choice& b) { return a.burden < b.burden; });
    if (next.size() > max_choices) next.resize(max_choices);
    choices = std::move(next);
  }
  return choices;
}

}  // namespace roomgen::design
