#include <algorithm>

#include "moves.h"

namespace roomgen::lab::annealing {

namespace {

// What is missing is added before what is merely allowed.
constexpr double urgency = 20.0;
constexpr std::size_t most_deficits = 400;
// Of what comes along with a thing.
constexpr int most_company = 40, most_failures = 12;
// Things that make way for a missing one.
constexpr int most_evicted = 4;

}  // namespace

// Every bound for every value of its variables, with how many it lacks.
std::vector<Moves::Deficit> Moves::deficits() {
  std::vector<Deficit> result;
  for (std::size_t b = 0; b < bounds_.size(); ++b) {
    const Bound& bound = bounds_[b];
    if (bound.recipes.empty()) continue;
    std::vector<std::vector<Slot>> bindings{{}};
    for (const int set : bound.variables) {
      std::vector<std::vector<Slot>> longer;
      for (const auto& binding : bindings)
        evaluator_.members(set, binding).each([&](Slot slot) {
          longer.push_back(binding);
          longer.back().push_back(slot);
        });
      bindings = std::move(longer);
    }
    for (auto& binding : bindings) {
      const double count = evaluator_.members(bound.set, binding).size();
      if (count < bound.high && result.size() < most_deficits)
        result.push_back({&bound, static_cast<int>(b), std::move(binding), bound.low - count});
    }
  }
  return result;
}

std::optional<Slot> Moves::add_for(const Deficit& wanted) {
  const Recipe& recipe = random_.pick(wanted.bound->recipes);
  const auto& articles = articles_of_kind_[static_cast<std::size_t>(random_.pick(recipe.kinds))];
  if (articles.empty()) return std::nullopt;
  const int drawn = random_.pick(articles);
  const int article = recipe.one_design ? design_of(wanted.number).value_or(drawn) : drawn;
  const Kind& kind = *world_.articles()[static_cast<std::size_t>(article)].kind;
  const auto attachments = attach_all(recipe, wanted.variables, kind, std::nullopt);
  if (!attachments) return std::nullopt;
  const auto stance = settler_.anywhere(article, *attachments);
  return stance ? world_.add(article, *stance, wanted.number) : std::nullopt;
}

std::optional<SlotSet> Moves::add() {
  const auto open = deficits();
  if (open.empty()) return std::nullopt;
  std::vector<double> weights;
  for (const auto& deficit : open) weights.push_back(deficit.missing > 0 ? urgency : 1.0);
  const Deficit& wanted = open[random_.weighted(weights)];
  const auto slot = add_for(wanted);
  if (!slot) return std::nullopt;
  if (wanted.missing > 0) clear_place_of(*slot);
  SlotSet moved;
  moved.insert(*slot);
  if (!bounds_with_variables_ || !world_.admits(moved)) return moved;
  add_company(*slot, moved);
  return moved;
}

// What stands where a missing thing would stand goes, with all that stands on it: small things that came first would
// keep a bed out of its room for ever. Whether the room is the better for it is for the annealing to say.
void Moves::clear_place_of(Slot slot) {
  const SlotSet clashing = world_.clashing(slot);
  SlotSet gone;
  int roots = 0;
  bool is_fixed = false;
  clashing.each([&](Slot other) {
    ++roots;
    world_.cluster(other).each([&](Slot one) {
      is_fixed = is_fixed || world_.item(one).fixed || one == slot;
      gone.insert(one);
    });
  });
  if (is_fixed || roots > most_evicted) return;
  gone.each([&](Slot one) { world_.remove(one); });
}

// What the program wants of each such thing comes with it: a table without its six chairs would count as a step back.
void Moves::add_company(Slot root, SlotSet& moved) {
  int failures = 0;
  for (int tries = 0; tries < most_company && failures < most_failures; ++tries) {
    auto open = deficits();
    std::erase_if(open, [&](const Deficit& deficit) {
      return deficit.missing <= 0 || std::ranges::find(deficit.variables, root) == deficit.variables.end();
    });
    if (open.empty()) return;
    const auto slot = add_for(random_.pick(open));
    if (!slot) {
      ++failures;
      continue;
    }
    SlotSet alone;
    alone.insert(*slot);
    if (world_.admits(alone)) {
      moved.insert(*slot);
    } else {
      world_.remove(*slot);
      ++failures;
    }
  }
}

// What things that one count asks for look like: the chairs of a table.
std::optional<int> Moves::design_of(int bound) const {
  std::optional<int> article;
  world_.things().each([&](Slot slot) {
    if (!article && world_.item(slot).bound == bound) article = world_.item(slot).article;
  });
  return article;
}

// Whatever stands on it goes too.
std::optional<SlotSet> Moves::remove() {
  std::vector<Slot> all;
  world_.things().each([&](Slot slot) { all.push_back(slot); });
  if (all.empty()) return std::nullopt;
  const SlotSet gone = world_.cluster(random_.pick(all));
  bool fixed = false;
  gone.each([&](Slot slot) { fixed = fixed || world_.item(slot).fixed; });
  if (fixed) return std::nullopt;
  gone.each([&](Slot slot) { world_.remove(slot); });
  return SlotSet{};
}

}  // namespace roomgen::lab::annealing
