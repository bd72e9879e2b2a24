#include "bounds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "kinds/mounting.h"

namespace roomgen::lab::annealing {

namespace {

constexpr std::size_t most_kinds = 12;  // in stock for one bound
constexpr int most_nested = 32;
constexpr std::size_t most_drafts = 64;  // for one set: unions of unions multiply

// A recipe before its relations are numbered.
struct Draft {
  std::set<const Kind*> kinds;
  std::vector<const SetRelation*> relations;
  bool one_design = false;
  const Kind* kind = nullptr;  ///< that its factory is called by, if it is one
};

class RecipeFinder {
 public:
  RecipeFinder(const ConstraintProgram& program, const std::vector<const Kind*>& kinds, const KindTable& table,
               const ProgramVocabulary& vocabulary)
      : program_(program), kinds_(kinds), table_(table), vocabulary_(vocabulary) {}

  /// The kind of exactly a factory's name; null if there is none.
  const Kind* kind_called(std::string factory) const {
    std::ranges::replace(factory, '_', ' ');
    return table_.by_name(factory);
  }

  std::vector<Draft> find(const ProgramSet& set, int depth = 0) {
    using Source = ProgramSet::Source;
    if (depth > most_nested) return {};
    if (set.source == Source::objects) return {{{kinds_.begin(), kinds_.end()}, {}, false, nullptr}};
    if (set.source == Source::named) return find_named(set.name, depth);
    if (set.source == Source::united) {
      std::vector<Draft> all;
      for (const auto& part : set.from)
        for (auto& draft : find(part, depth + 1))
          if (all.size() < most_drafts) all.push_back(std::move(draft));
      return all;
    }
    if (set.source != Source::described) return {};
    auto drafts = set.from.empty() ? find({ProgramSet::Source::objects}, depth + 1) : find(set.from.front(), depth + 1);
    for (auto& draft : drafts) {
      std::erase_if(draft.kinds, [&](const Kind* kind) { return !suits(*kind, set); });
      for (const auto& relation : set.relations)
        if (!relation.absent && relation.relation != "any") draft.relations.push_back(&relation);
      draft.one_design = draft.one_design || !set.factory.empty();
      if (const Kind* kind = kind_called(set.factory)) draft.kind = kind;
    }
    std::erase_if(drafts, [](const Draft& draft) { return draft.kinds.empty(); });
    return drafts;
  }

 private:
  // Each name once, however many sets are made of it. In a circle it stands for nothing.
  const std::vector<Draft>& find_named(const std::string& name, int depth) {
    const auto [known, is_new] = named_.try_emplace(name);
    const auto set = std::ranges::find(program_.sets, name, &NamedSets::value_type::first);
    if (is_new && set != program_.sets.end()) known->second = find(set->second, depth + 1);
    return known->second;
  }

  bool suits(const Kind& kind, const ProgramSet& set) const {
    const auto has = [&](const std::string& tag) { return has_tag(vocabulary_, kind, tag); };
    return std::ranges::all_of(set.tags, has) && std::ranges::none_of(set.without, has) &&
           (set.factory.empty() || is_made_by(vocabulary_, table_, kind, set.factory));
  }

  const ConstraintProgram& program_;
  const std::vector<const Kind*>& kinds_;
  const KindTable& table_;
  const ProgramVocabulary& vocabulary_;
  std::map<std::string, std::vector<Draft>> named_;
};

Face level_face(Mount mount) {
  switch (mount) {
    case Mount::floor: return Face::floor;
    case Mount::ceiling: return Face::ceiling;
    case Mount::wall: return Face::wall;
    default: return Face::support;
  }
}

// Can things of the kind be put up so? What goes only against a wall may stand there as well.
bool may_be_put(const Kind& kind, const std::vector<const PutUp*>& relations) {
  for (const PutUp* how : relations)
    for (const Mount mount : {Mount::floor, Mount::ceiling, Mount::surface})
      if (std::ranges::find(how->parent, level_face(mount)) != how->parent.end()) return may_be_put_up(kind, mount);
  return true;
}

}  // namespace

std::vector<Bound> make_bounds(const ConstraintProgram& program, Compiler& compiler, const Compiled& compiled,
                               const std::vector<const Kind*>& kinds, const KindTable& table,
                               const ProgramVocabulary& vocabulary) {
  RecipeFinder finder(program, kinds, table, vocabulary);
  // What has a set of its own is not added for one of wider kind: "a dresser" brings no changing table.
  std::set<const Kind*> with_sets;
  for (const auto& [name, set] : program.sets)
    if (const Kind* kind = finder.kind_called(set.factory)) with_sets.insert(kind);
  std::vector<Bound> bounds;
  for (const auto& counted : count_bounds(program)) {
    Bound bound;
    bound.low = counted.low;
    bound.high = std::isinf(counted.high) ? counted.low + program_limits::permitted : counted.high;
    std::vector<std::string> scope;
    for (const auto& [name, set] : counted.variables) {
      bound.variables.push_back(compiler.set(*set, scope));
      scope.push_back(name);
    }
    bound.set = compiler.set(*counted.set, scope);
    for (const auto& draft : finder.find(*counted.set)) {
      const auto is_counted_elsewhere = [&](const Kind* kind) {
        return draft.kind && kind != draft.kind && with_sets.contains(kind);
      };
      Recipe recipe;
      recipe.one_design = draft.one_design;
      std::vector<const PutUp*> ways;
      for (const SetRelation* relation : draft.relations) {
        const int number = compiled.language.number_of(relation->relation);
        if (number < 0) continue;
        recipe.relations.push_back({number, compiler.set(relation->target.front(), scope)});
        ways.push_back(&compiled.language.relations[static_cast<std::size_t>(number)]);
      }
      for (std::size_t k = 0; k < kinds.size(); ++k)
        if (draft.kinds.contains(kinds[k]) && !is_counted_elsewhere(kinds[k]) && may_be_put(*kinds[k], ways))
          recipe.kinds.push_back(static_cast<int>(k));
      if (!recipe.kinds.empty()) bound.recipes.push_back(std::move(recipe));
    }
    bounds.push_back(std::move(bound));
  }
  return bounds;
}

std::vector<const Kind*> kinds_of_bounds(const ConstraintProgram& program, const KindTable& table,
                                         const ProgramVocabulary& vocabulary, const Random& random) {
  std::vector<const Kind*> all;  // in the table's order, not that of addresses
  for (const auto& [name, kind] : table.all())
    if (!kind.variant && !kind.is_stand_in()) all.push_back(&kind);
  RecipeFinder finder(program, all, table, vocabulary);
  std::set<const Kind*> wanted;
  int number = 0;
  for (const auto& bound : count_bounds(program))
    for (const auto& draft : finder.find(*bound.set)) {
      std::vector<const Kind*> kinds;
      std::ranges::copy_if(all, std::back_inserter(kinds),
                           [&](const Kind* kind) { return draft.kinds.contains(kind); });
      random.fork(std::to_string(number++)).shuffle(kinds);
      if (kinds.size() > most_kinds) kinds.resize(most_kinds);
      wanted.insert(kinds.begin(), kinds.end());
    }
  std::erase_if(all, [&](const Kind* kind) { return !wanted.contains(kind); });
  return all;
}

}  // namespace roomgen::lab::annealing
