#include "ways.h"

#include <algorithm>
#include <cmath>
#include <set>


namespace roomgen {

namespace {

constexpr std::size_t max_choices = 8;
// Length of a table's edge for one seat, ends included.
constexpr double place_width = 0.8;
// What is lower has no chairs around it.
constexpr double least_table_height = 0.6;

bool is_a(const Kind& category, const Kind* kind) {
  return kind && is_of(category, kind->name);
}

// A chair that was drawn up to another desk, however close it stands to this one.
bool belongs_to_another(const Layout& layout, const FloorThing& thing, const FloorThing& candidate) {
  const auto& relations = thing.object->relations;
  const auto gathers_at = [&](const FloorThing& one) {
    return std::any_of(relations.begin(), relations.end(), [&](const Relation& relation) {
      return relation.kind == RelationKind::around && relation.target == one.object->id;
    });
  };
  const auto things = layout.things();
  return !gathers_at(candidate) && std::any_of(things.begin(), things.end(), gathers_at);
}

// How many things like `self` the candidate has already.
int partners(const Layout& layout, const Object& self, const Kind* own,
             const FloorThing& candidate) {
  const auto things = layout.things();
  return static_cast<int>(std::count_if(things.begin(), things.end(), [&](const FloorThing& other) {
    if (other.object == candidate.object || other.object->id == self.id) return false;
    if (!is_a(*other.category, own)) return false;
    if (!other.object->on.empty()) return depends_on(*other.object, candidate.object->id);
    return gap(other.footprint, candidate.footprint) <= partner_gap && !belongs_to_another(layout, other, candidate);
  }));
}

// How many such partners a thing has use for: places along the sides of a table, one seat at a
// desk, else one on either side.
double capacity(const Object& object, bool seat) {
  if (object.traits.front) return seat ? 1.0 : 2.0;
  return std::max(1.0, std::floor(2.0 * (object.size.x() + object.size.y()) / place_width));
}

/// The things that a way's target means: a kind, "exactly" a kind without its descendants.
class TargetKind {
 public:
  TargetKind(const KindTable& table, const std::string& text)
      : exact_(text.starts_with(exactly)),
        kind_(table.find(exact_ ? text.substr(exactly.size()) : text)) {}

  bool includes(const Kind& category) const {
    return exact_ ? kind_ && category.name == kind_->name : is_a(category, kind_);
  }

 private:
  static constexpr std::string_view exactly = "exactly ";
  bool exact_;
  const Kind* kind_;
};

struct Member {
  std::string id;
  double burden = 0.0;
};

std::vector<Member> members(const Layout& layout, const Object& self, const std::string& kind) {
  std::vector<Member> found;
  if (kind == "door" || kind == "window") {
    for (const auto& opening : layout.room().openings)
      if (opening.is_entrance() == (kind == "door")) found.push_back({opening.id});
    return found;
  }
  const TargetKind wanted(layout.categories(), kind);
  const Kind* own = layout.categories().find(self.category);
  const bool seat = layout.categories().is_a(self.category, "seat");
  for (const auto& thing : layout.things()) {
    if (!wanted.includes(*thing.category) || thing.object->id == self.id) continue;
    const double burden = partners(layout, self, own, thing) / capacity(*thing.object, seat);
    if (burden < 1.0) found.push_back({thing.object->id, burden});
  }
  return found;
}

void put(std::vector<Relation>& relations, const std::string& kind, const std::string& id) {
  for (auto& relation : relations)
    if (relation.target == kind) relation.target = id;
}

}  // namespace

std::vector<NamedWay> name_targets(const Layout& layout, const Object& self,
                                   const std::vector<Relation>& way) {
  std::vector<NamedWay> named{{way, 0.0}};
  std::set<std::string> kinds;
  for (const auto& relation : way)
    if (!relation.target.empty()) kinds.insert(relation.target);
  for (const auto& kind : kinds) {
    std::vector<NamedWay> next;
    for (const auto& member : members(layout, self, kind))
      for (NamedWay one : named) {
        put(one.relations, kind, member.id);
        one.burden += member.burden;
        next.push_back(std::move(one));
      }
    std::stable_sort(next.begin(), next.end(),
                     [](const NamedWay& a, const NamedWay& b) { return a.burden < b.burden; });
    if (next.size() > max_choices) next.resize(max_choices);
    named = std::move(next);
  }
  return named;
}

int company_at_table(const Layout& layout, int of_its_kind) {
  const Kind* table = layout.categories().find("table");
  const auto things = layout.things();
  const int tables = static_cast<int>(std::count_if(things.begin(), things.end(), [&](const FloorThing& one) {
    return one.object->mount == Mount::floor && one.object->size.z() > least_table_height &&
           !one.object->traits.front && is_a(*one.category, table);
  }));
  return (of_its_kind + std::max(1, tables) - 1) / std::max(1, tables);
}

std::vector<Relation> ways_to(const Arrangement& arrangement, const KindTable& kinds, const Object& host) {
  const auto is_host = [&](const Relation& one) {
    return TargetKind(kinds, one.target).includes(kinds.get(host.category));
  };
  for (const auto* ways : {&arrangement.ways, &arrangement.otherwise})
    for (auto way : *ways) {
      std::erase_if(way, [](const Relation& one) { return one.target.empty(); });
      if (way.empty() || !std::all_of(way.begin(), way.end(), is_host)) continue;
      for (auto& relation : way) relation.target = host.id;
      return way;
    }
  return {};
}

}  // namespace roomgen
