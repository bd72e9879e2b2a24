#include <algorithm>
#include <cmath>

#include "compose_steps.h"
#include "put_up.h"
#include "roomgen/base/text.h"

namespace roomgen::lab::compose {

namespace {

using namespace programs;

constexpr double liked = 0.5;  // weight of having what such rooms usually hold
constexpr double straight = 2.0, middling = 0.5;

ProgramTerm bound(ProgramTerm value, const Range& range) {
  if (std::isinf(range.high)) return term(ProgramOp::at_least, {}, {std::move(value), number(range.low)});
  if (range.low == range.high) return term(ProgramOp::equal, {}, {std::move(value), number(range.low)});
  return within(std::move(value), range.low, range.high);
}

class Translator {
 public:
  Translator(const std::vector<Stand>& stands, double walls, const KindTable& kinds, const Arrangements& arrangements,
             ConstraintProgram& program, std::vector<std::string>& notes)
      : stands_(stands),
        walls_left_(walls),
        kinds_(kinds),
        arrangements_(arrangements),
        program_(program),
        notes_(notes) {}

  void run() {
    for (const auto& stand : stands_) describe(stand);
    for (const auto& stand : stands_) add_bounds(stand);
    count_kinds();
  }

 private:
  const Stand* stand_named(const std::string& name) const {
    const auto found = std::ranges::find(stands_, name, &Stand::name);
    return found == stands_.end() ? nullptr : &*found;
  }

  // The sets of a kind that a way of arranging is about; "exactly table" without its descendants.
  std::optional<TargetSet> sets_of_kind(const std::string& said, const Stand& own) const {
    constexpr std::string_view exactly = "exactly ";
    const bool alone = said.starts_with(exactly);
    const std::string kind = alone ? said.substr(exactly.size()) : said;
    std::vector<const Stand*> meant;
    for (const auto& stand : stands_)
      if (stand.name != own.name && (alone ? stand.kind == kind : kinds_.is_a(stand.kind, kind)))
        meant.push_back(&stand);
    if (meant.empty()) return std::nullopt;
    // Those before it rather than all, if there are any.
    if (std::ranges::any_of(meant, [&](const Stand* stand) { return stand < &own; }))
      std::erase_if(meant, [&](const Stand* stand) { return stand > &own; });
    std::vector<ProgramSet> sets;
    for (const Stand* stand : meant) sets.push_back(set(stand->name));
    return TargetSet{sets.size() == 1 ? sets.front() : either(std::move(sets)), &kinds_.get(meant.front()->kind),
                     meant.back() < &own};
  }

  // What a relation's target means: a set, a kind, or a part of the room.
  std::optional<TargetSet> target(const std::string& said, const Stand& own) const {
    if (const Stand* stand = stand_named(said); stand && stand != &own)
      return TargetSet{set(stand->name), &kinds_.get(stand->kind), stand < &own};
    if (said.starts_with("door")) return TargetSet{doors(), nullptr};
    if (said.starts_with("window")) return TargetSet{windows(), nullptr};
    return sets_of_kind(said, own);
  }

  Habits read(const std::vector<Relation>& relations, const Stand& stand, bool asked) const {
    return habits_of(relations, {kinds_.get(stand.kind), stand.mount, stand.name, stand.count.high <= 1.0},
                     [&](const std::string& said) { return target(said, stand); }, asked);
  }

  bool is_possible(const std::vector<Relation>& way, const Stand& stand) const {
    return std::ranges::all_of(way, [&](const Relation& relation) {
      return relation.target.empty() || target(relation.target, stand).has_value();
    });
  }

  // The first way of arranging such things whose targets are in the room.
  std::vector<Relation> usual_way(const Stand& stand) const {
    const auto& arrangement = arrangements_.get(kinds_, stand.kind, stand.mount);
    std::vector<Relation> chosen;
    for (const auto& way : arrangement.ways)
      if (is_possible(way, stand)) {
        chosen = way;
        break;
      }
    // What only prefers walls goes there in a program, which has no word for preferring.
    if (chosen.empty() && stand.mount == Mount::floor && prefers(stand, Preference::wall_near))
      chosen = {{RelationKind::edge, ""}};
    return chosen;
  }

  // Wishes come before habits; what is said of a place silences them.
  Habits habits(const Stand& stand) {
    Habits said = read(stand.wishes, stand, true);
    for (const auto& wish : said.unsaid) notes_.push_back(stand.name + " " + wish + ": programs have no word for this");
    if (!said.relations.empty() || (!stand.wishes.empty() && !said.truths.empty())) return said;
    Habits usual = read(usual_way(stand), stand, false);
    if (!stand.at_wall)
      std::erase_if(usual.relations,
                    [](const SetRelation& relation) { return relation.relation.ends_with("against_wall"); });
    usual.truths = said.truths;
    std::ranges::move(said.scores, std::back_inserter(usual.scores));
    return usual;
  }

  ProgramSet carriers(const Stand& stand) const {
    // Where nobody says on what an asked thing stands, anything will do.
    if (const Stand* below = stand_named(stand.on); below && below < &stand && !stand.asked) return set(below->name);
    std::vector<ProgramSet> sets;
    for (const auto& other : stands_)
      if (other.mount == Mount::floor && kinds_.get(other.kind).supports) sets.push_back(set(other.name));
    return sets.empty() ? things() : sets.size() == 1 ? sets.front() : either(std::move(sets));
  }

  // What is longer in a row than the walls that are left stands freely, in rows.
  bool leaves_walls(const Stand& stand, std::vector<SetRelation>& relations) {
    constexpr double beside = 0.1;
    const auto wall = [](const SetRelation& relation) { return relation.relation == "against_wall"; };
    if (!stand.asked || std::ranges::none_of(relations, wall)) return false;
    const double length = stand.count.low * (stand.size.x() + beside);
    if (length <= walls_left_ || stand.count.low < 2.0) return walls_left_ -= length, false;
    return std::erase_if(relations,
                         [](const SetRelation& relation) { return relation.relation.ends_with("against_wall"); }) > 0;
  }

  void describe(const Stand& stand) {
    Habits found = habits(stand);
    const bool is_in_rows = leaves_walls(stand, found.relations) || stand.in_rows;
    std::vector<SetRelation> relations;
    const auto is_put = [&](const char* name) {
      return std::ranges::find(found.relations, name, &SetRelation::relation) != found.relations.end();
    };
    if (!is_put("on")) relations.push_back(carried_by(stand.mount, carriers(stand)));
    for (auto& relation : found.relations)
      if (relations.size() < 3) relations.push_back(std::move(relation));
    ProgramSet members = of_kind(stand.kind);
    members.relations = std::move(relations);
    program_.sets.emplace_back(stand.name, std::move(members));
    for (auto& truth : found.truths) also(stand.name + " as asked", std::move(truth));
    for (auto& score : found.scores) add_score(stand.name, std::move(score));
    if (!stand.asked) add_score(stand.name, maximize(liked, count(set(stand.name))));
    // Only one thing can have the middle to itself.
    if (stand.count.high == 1.0 && prefers(stand, Preference::center))
      add_score(stand.name, minimize(middling, term(ProgramOp::center, {set(stand.name)})));
    if (!is_in_rows) return;
    add_score(stand.name, minimize(straight, term(ProgramOp::coplanarity, {set(stand.name)})));
    ProgramTerm askew = term(ProgramOp::angle, {set(stand.name), room()});
    askew.face = Face::wall;
    add_score(stand.name, minimize(straight, std::move(askew)));
  }

  bool prefers(const Stand& stand, Preference what) const {
    return std::ranges::any_of(
        arrangements_.get(kinds_, stand.kind, stand.mount).preferences,
        [&](const auto& preference) { return preference.what == what && preference.weight > 0.0; });
  }

  const ProgramSet& members_of(const Stand& stand) const {
    return std::ranges::find(program_.sets, stand.name, &NamedSets::value_type::first)->second;
  }

  // Are all that are put up as `special` says put up as `general` says?
  static bool implies(const ProgramSet& special, const ProgramSet& general) {
    return std::ranges::all_of(general.relations, [&](const SetRelation& relation) {
      return std::ranges::find(special.relations, relation) != special.relations.end();
    });
  }

  // A set counts what stands in narrower ones too, and may hold what is of its kind and counted elsewhere.
  Range range_of(const Stand& stand) const {
    Range range = stand.count;
    for (const auto& other : stands_) {
      if (&other == &stand || !kinds_.is_a(other.kind, stand.kind)) continue;
      const bool is_within = implies(members_of(other), members_of(stand));
      range.low += is_within ? other.count.low : 0.0;
      if (is_within || implies(members_of(stand), members_of(other))) range.high += other.count.high;
    }
    return range;
  }

  // Where the numbers divide, each of what they gather at has its share: four chairs a table, not sixteen at one.
  void add_bounds(const Stand& stand) {
    const ProgramSet& members = members_of(stand);
    ProgramTerm all = bound(count(set(stand.name)), range_of(stand));
    const auto host = std::ranges::find_if(members.relations, [&](const SetRelation& relation) {
      return relation.target.front().source == ProgramSet::Source::named && stand_named(relation.target.front().name);
    });
    if (host != members.relations.end() && stand.count.low == stand.count.high) {
      const Stand& at = *stand_named(host->target.front().name);
      const double each = stand.count.low / at.count.low;
      const Range hosts = range_of(at);
      if (hosts.low == hosts.high && hosts.low == at.count.low && at.count.low > 1.0 && each == std::floor(each) &&
          each > 0.0) {
        ProgramSet own = of_kind(stand.kind);
        own.relations = members.relations;
        own.relations[static_cast<std::size_t>(host - members.relations.begin())].target = {variable("h")};
        all = std::move(all) && for_all("h", set(at.name), bound(count(own), {each, each}));
      }
    }
    program_.constraints.emplace_back(stand.name, std::move(all));
  }

  // Several sets of one kind: how many of it there are in all.
  void count_kinds() {
    for (const auto& stand : stands_) {
      const auto first = std::ranges::find(stands_, stand.kind, &Stand::kind);
      if (&*first != &stand || std::ranges::count(stands_, stand.kind, &Stand::kind) == 1) continue;
      Range range;
      for (const auto& other : stands_)
        if (kinds_.is_a(other.kind, stand.kind)) range.low += other.count.low, range.high += other.count.high;
      program_.constraints.emplace_back("all " + stand.kind,
                                        bound(term(ProgramOp::add, {}, {count(of_kind(stand.kind))}), range));
    }
  }

  void also(const std::string& name, ProgramTerm truth) {
    for (auto& [known, term] : program_.constraints)
      if (known == name) {
        term = std::move(term) && std::move(truth);
        return;
      }
    program_.constraints.emplace_back(name, std::move(truth));
  }

  void add_score(const std::string& name, ProgramTerm score) {
    for (auto& [known, term] : program_.scores)
      if (known == name) {
        term = std::move(term) + std::move(score);
        return;
      }
    program_.scores.emplace_back(name, std::move(score));
  }

  const std::vector<Stand>& stands_;
  double walls_left_;  ///< metres
  const KindTable& kinds_;
  const Arrangements& arrangements_;
  ConstraintProgram& program_;
  std::vector<std::string>& notes_;
};

// Metres of wall along which things may stand.
double usable_walls(const Room& room) {
  constexpr double usable = 0.7;
  double length = 0.0;
  for (std::size_t k = 0; k < room.polygon.size(); ++k) length += usable * room.polygon.edge(k).length();
  for (const auto& opening : room.openings) length -= opening.is_entrance() ? opening.width() : 0.0;
  return length;
}

void ask_of_whole(const Complexity& asked, ConstraintProgram& program) {
  // As sums, for a bound on a count is a reason to add: these are reached by what the other bounds permit.
  const auto ask = [&](const char* name, ProgramTerm value, const std::optional<Range>& range) {
    if (range) program.constraints.emplace_back(name, bound(term(ProgramOp::add, {}, {std::move(value)}), *range));
  };
  ask("number of objects", count(things()), asked.objects);
  ask("number of seats", term(ProgramOp::seats, {things()}), asked.seats);
  ask("number of shelves", count(tagged("shelf")), asked.shelves);
  ask("share of the floor", term(ProgramOp::occupancy, {things()}), asked.occupancy);
}

}  // namespace

ConstraintProgram program_of(const std::vector<Stand>& stands, const Complexity& asked, const Plan& plan,
                             const KindTable& kinds, const Arrangements& arrangements,
                             std::vector<std::string>& notes) {
  ConstraintProgram program;
  program.prompt = plan.prompt;
  program.seed = plan.seed;
  program.room.type = plan.room.type;
  program.room.polygon = plan.room.polygon;
  program.room.height = plan.room.height;
  program.room.openings = plan.room.openings;
  Translator(stands, usable_walls(plan.room), kinds, arrangements, program, notes).run();
  ask_of_whole(asked, program);
  return program;
}

}  // namespace roomgen::lab::compose
