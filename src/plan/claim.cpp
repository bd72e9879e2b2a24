#include "claim.h"

#include <algorithm>

#include "inventory.h"
#include "ledger.h"
#include "roomgen/base/text.h"

namespace roomgen::plan {

namespace {

constexpr double alike_in_size = 1.5;

bool is_wanted(const brief::Mention& mention) {
  return !mention.contradicts && mention.quantity > 0;
}

// Large things come first: before the first one that covers less of the floor.
std::ptrdiff_t turn_of(const PlanItem& item, const Plan& plan, const KindTable& table) {
  const double own = floor_area(item, table);
  return std::find_if(plan.items.begin(), plan.items.end(),
                      [&](const PlanItem& other) { return floor_area(other, table) < own; }) -
         plan.items.begin();
}

// A round table that is as large as a bistro table does for one: both are tables.
bool is_alike(const PlanItem& item, const std::string& asked, const KindTable& table) {
  const auto head = [](const std::string& name) { return name.substr(name.rfind(' ') + 1); };
  if (head(item.category) != head(asked)) return false;
  const Vec3 size = item.size.value_or(table.get(item.category).size), wanted = table.get(asked).size;
  return (size.array() < alike_in_size * wanted.array()).all() && (wanted.array() < alike_in_size * size.array()).all();
}

// Of no known kind, but called by the same noun: the "scent-organ" is the organ.
bool is_named_so(const PlanItem& item, const brief::Mention& mention, const KindTable& table) {
  if (table.find(item.category)) return false;
  const auto own = words(item.category), noun = words(mention.noun);
  return !own.empty() && !noun.empty() && singular(own.back()) == singular(noun.back());
}

std::string numbered(int count, const std::string& name) {
  return count == 1 ? "a " + name : std::to_string(count) + " " + name;
}

std::vector<Draft> drafts_of(const std::vector<std::size_t>& mentions) {
  std::vector<Draft> drafts(mentions.size());
  for (std::size_t i = 0; i < drafts.size(); ++i) drafts[i].mention = mentions[i];
  return drafts;
}

}  // namespace

Claim claim(const Plan& plan, const brief::Brief& brief, const KindTable& table) {
  Claim result;
  result.mention_of.assign(plan.items.size(), brief::Demand::none);
  std::vector<int> lacking;
  for (const auto& mention : brief.mentions)
    lacking.push_back(is_wanted(mention) ? mention.quantity : 0);
  const auto give = [&](auto fits) {
    for (std::size_t m = 0; m < lacking.size(); ++m)
      for (std::size_t i = 0; i < plan.items.size() && lacking[m] > 0; ++i)
        if (result.mention_of[i] == brief::Demand::none && fits(plan.items[i], brief.mentions[m])) {
          result.mention_of[i] = m;
          lacking[m] -= plan.items[i].quantity;
        }
  };
  // A record bin is rather what is called so than a bin of the known kind.
  give([&](const PlanItem& item, const brief::Mention& asked) {
    return is_named_so(item, asked, table) && words(item.category) == words(asked.description);
  });
  give([](const PlanItem& item, const brief::Mention& asked) {
    return item.category == asked.category;
  });
  give([&](const PlanItem& item, const brief::Mention& asked) {
    return table.is_a(item.category, asked.category) || table.is_a(asked.category, item.category);
  });
  give([&](const PlanItem& item, const brief::Mention& asked) {
    return is_alike(item, asked.category, table) || is_named_so(item, asked, table);
  });
  for (std::size_t m = 0; m < lacking.size(); ++m)
    if (lacking[m] > 0) result.forgotten.push_back({m, lacking[m]});
  return result;
}

std::vector<Requirement> clauses_of(const PlanRequest& request, const brief::Brief& brief,
                                    const KindTable& table) {
  const auto asked = asked_items(brief, table);
  Plan plan;
  for (const auto& draft : asked) plan.items.push_back(draft.item);
  return ledger_of(request, brief, asked, plan).requirements;
}

std::string objection(const PlanRequest& request, const Claim& claim, const brief::Brief& brief,
                      const Plan& plan) {
  if (claim.forgotten.empty()) return "";
  const auto requirements =
      ledger_of(request, brief, drafts_of(claim.mention_of), plan).requirements;
  std::vector<std::string> lacking;
  for (const auto& one : claim.forgotten) {
    const brief::Mention& mention = brief.mentions[one.mention];
    const auto clause =
        std::find_if(requirements.begin(), requirements.end(), [&](const Requirement& requirement) {
          return requirement.kind == Requirement::Kind::count &&
                 requirement.category == mention.category &&
                 (mention.most > mention.least || requirement.count == mention.quantity);
        });
    lacking.push_back((clause == requirements.end() ? "" : clause->id + ": ") +
                      numbered(mention.quantity, mention.description) + ": " +
                      std::to_string(mention.quantity - one.lacking) + " of " +
                      std::to_string(mention.quantity));
  }
  return "the wish asks for things that your plan lacks: " + join(lacking, "; ");
}

void fulfil(const PlanRequest& request, const Claim& claim, const brief::Brief& brief,
            const KindTable& table, Plan& plan) {
  const auto asked = asked_items(brief, table);
  std::vector<std::size_t> mention_of = claim.mention_of;
  for (std::size_t i = 0; i < plan.items.size(); ++i)
    plan.items[i].asked = mention_of[i] != brief::Demand::none;
  for (const auto& one : claim.forgotten) {
    const auto draft = std::find_if(asked.begin(), asked.end(), [&](const Draft& other) {
      return other.mention == one.mention;
    });
    if (draft == asked.end()) continue;
    PlanItem item = draft->item;
    item.quantity = one.lacking;
    item.relations.clear();
    const auto at = turn_of(item, plan, table);
    plan.items.insert(plan.items.begin() + at, std::move(item));
    mention_of.insert(mention_of.begin() + at, one.mention);
    plan.notes.push_back(numbered(one.lacking, draft->item.description) +
                         ": asked for and not planned; added by rules");
  }
  // What it is says who designed it: a counter need not be a kitchen's.
  brief::Brief designed = brief;
  for (std::size_t i = 0; i < plan.items.size(); ++i)
    if (const std::size_t m = mention_of[i]; m != brief::Demand::none)
      if (is_named_so(plan.items[i], brief.mentions[m], table))
        designed.mentions[m].category = plan.items[i].category;
  auto ledger = ledger_of(request, designed, drafts_of(mention_of), plan);
  plan.requirements = std::move(ledger.requirements);
  plan.heard = std::move(ledger.heard);
}

}  // namespace roomgen::plan
