#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "draft_changes.h"
#include "evaluate/attributes.h"
#include "evaluate/ledger.h"
#include "roomgen/base/text.h"
#include "scene/judgement.h"

namespace roomgen {

namespace {

using Verdicts = std::vector<RequirementVerdict>;

constexpr const char* by_an_edit = "by an edit";

bool has_any(const std::vector<std::string>& ids, const std::set<std::string>& set) {
  return std::any_of(ids.begin(), ids.end(), [&](const std::string& id) { return set.count(id) > 0; });
}

// One room of a dwelling.
Scene scene_about(const Scene& scene, const std::string& room) {
  for (auto& part : parts_of(scene))
    if (part.room.id == room) return part;
  return scene;
}

// Looks are dear to judge, and change with their things alone.
bool keeps_verdict(const Requirement& requirement, const Draft& draft) {
  return requirement.kind == Requirement::Kind::attribute && !requirement.subjects.empty() &&
         !has_any(requirement.subjects, draft.named);
}

bool is_to_check(const RequirementVerdict& verdict, const Draft& draft) {
  return verdict.compliance != Compliance::withdrawn && !keeps_verdict(verdict.requirement, draft);
}

Verdicts check_together(std::span<const Requirement> requirements, const Scene& scene, const Draft& draft) {
  Workshop& shop = draft.shop;
  return check_requirements(
      requirements, scene, shop.kinds(),
      [&](const Object& object, const std::string& word) {
        return judge_attribute(known_looks(object, shop.models()), word);
      },
      [&](const Object& object) {
        const auto own = shop.mesh_size(object.asset);
        return own ? std::cbrt(object.size.prod() / own->cwiseMax(1e-4).prod()) : 1.0;
      });
}

// Those of one room with each other: counts do not count what another count speaks of.
Verdicts checked(const Verdicts& verdicts, const Draft& draft) {
  std::map<std::string, std::vector<Requirement>> by_room;
  for (const auto& verdict : verdicts)
    if (is_to_check(verdict, draft)) by_room[verdict.requirement.room].push_back(verdict.requirement);
  std::map<std::string, Verdicts> found;
  for (const auto& [room, requirements] : by_room) {
    const bool is_part = !room.empty() && !draft.scene.rooms.empty();
    found[room] = check_together(requirements, is_part ? scene_about(draft.scene, room) : draft.scene, draft);
  }
  Verdicts result;
  std::map<std::string, std::size_t> next;
  for (const auto& verdict : verdicts) {
    const std::string& room = verdict.requirement.room;
    result.push_back(is_to_check(verdict, draft) ? found[room][next[room]++] : verdict);
  }
  return result;
}

// Is it about what the edit itself changed? Then it is the word that came later that counts.
bool is_overruled(const Requirement& requirement, const Draft& draft) {
  if (requirement.kind == Requirement::Kind::room) return draft.new_measures.count(requirement.attribute) > 0;
  if (requirement.kind == Requirement::Kind::count || requirement.kind == Requirement::Kind::absence)
    return std::any_of(draft.new_categories.begin(), draft.new_categories.end(), [&](const std::string& category) {
      return draft.shop.kinds().is_a(category, requirement.category);
    });
  // What an edit brings is no breach of what the prompt wanted alone.
  if (requirement.kind == Requirement::Kind::only)
    return std::any_of(draft.new_categories.begin(), draft.new_categories.end(), [&](const std::string& category) {
      return requirement.category.empty() || draft.shop.kinds().is_a(category, requirement.category);
    });
  if (requirement.kind == Requirement::Kind::attribute && requirement.subjects.empty())
    return draft.new_categories.count(requirement.category) > 0;
  return has_any(requirement.subjects, draft.named);
}

void withdraw(RequirementVerdict& verdict, const std::string& why) {
  verdict.compliance = Compliance::withdrawn;
  verdict.reason = why;
}

std::set<std::string> gone_ids(const Scene& before, const Scene& after) {
  std::set<std::string> gone;
  for (const auto& object : before.objects)
    if (!find_object(after, object.id)) gone.insert(object.id);
  const auto now = rooms_of(after);
  for (const auto& room : rooms_of(before))
    for (const auto& opening : room.openings)
      if (std::none_of(now.begin(), now.end(), [&](const Room& one) { return find_opening(one, opening.id); }))
        gone.insert(opening.id);
  return gone;
}

std::string counted(int count, const std::string& category) { return std::to_string(count) + " " + category; }

// Fewer of a kind than were asked for: the number is another one now.
Requirement fewer(const Requirement& requirement, const std::vector<std::string>& left) {
  Requirement now = requirement;
  now.source = Requirement::Source::edit;
  now.picture = 0;
  now.subjects = left;
  now.count = static_cast<int>(left.size());
  now.clause = counted(now.count, requirement.category);
  return now;
}

// What went is asked for no more. Comes back: what is asked for of those that are left, under the
// ids of the clauses of the prompt that had more.
std::vector<Requirement> forget(const std::set<std::string>& gone, Draft& draft) {
  std::vector<Requirement> less;
  for (auto& verdict : draft.scene.requirements) {
    Requirement& asked = verdict.requirement;
    if (verdict.compliance == Compliance::withdrawn) continue;
    std::vector<std::string> left = asked.subjects, targets = asked.targets;
    std::erase_if(left, [&](const std::string& id) { return gone.count(id) > 0; });
    std::erase_if(targets, [&](const std::string& id) { return gone.count(id) > 0; });
    const bool lost_some = left.size() < asked.subjects.size();
    if ((lost_some && left.empty()) || (targets.empty() && !asked.targets.empty())) {
      withdraw(verdict, by_an_edit);
    } else if (asked.kind == Requirement::Kind::count && lost_some &&
               static_cast<int>(left.size()) < asked.count) {
      if (asked.source == Requirement::Source::edit)
        asked = fewer(asked, left);
      else
        less.push_back(fewer(asked, left)), withdraw(verdict, by_an_edit);
    }
  }
  return less;
}

// Those that nobody has taken the place of.
void drop_gone(const std::set<std::string>& gone, Draft& draft) {
  for (auto& verdict : draft.scene.requirements)
    if (verdict.compliance != Compliance::withdrawn)
      for (auto* ids : {&verdict.requirement.subjects, &verdict.requirement.targets})
        std::erase_if(*ids, [&](const std::string& id) { return gone.count(id) > 0; });
}

std::string free_id(const Verdicts& verdicts) {
  for (std::size_t number = 1;; ++number) {
    const std::string id = "e" + std::to_string(number);
    if (std::none_of(verdicts.begin(), verdicts.end(),
                     [&](const RequirementVerdict& one) { return one.requirement.id == id; }))
      return id;
  }
}

bool is_about_gone(const Requirement& wish, const Scene& scene) {
  return std::any_of(wish.subjects.begin(), wish.subjects.end(),
                     [&](const std::string& id) { return !find_object(scene, id); });
}

bool went_by_an_edit(const RequirementVerdict& verdict) {
  return verdict.compliance == Compliance::withdrawn && verdict.reason == by_an_edit;
}

// New things take the places of those of their kind that went before, or never found one: by who
// is not there.
std::map<std::string, std::string> heirs_of(const Requirement& wish, const Draft& draft) {
  std::map<std::string, std::string> heirs;
  if (wish.kind != Requirement::Kind::count) return heirs;
  std::vector<std::string> fresh = wish.subjects;
  std::erase_if(fresh, [&](const std::string& id) {
    return std::count(draft.added.begin(), draft.added.end(), id) == 0;
  });
  for (const auto& verdict : draft.scene.requirements) {
    const Requirement& asked = verdict.requirement;
    const bool is_open = went_by_an_edit(verdict) || verdict.compliance == Compliance::not_met;
    if (!is_open || asked.kind != wish.kind || asked.room != wish.room ||
        !draft.shop.kinds().is_a(wish.category, asked.category))
      continue;
    for (const auto& id : asked.subjects)
      if (!find_object(draft.scene, id) && heirs.size() < fresh.size())
        heirs.try_emplace(id, fresh[heirs.size()]);
  }
  return heirs;
}

// Of the things that an edit spoke of, whoever exchanges them says anew what else shall be.
bool is_of_what_it_named(const Requirement& asked, const Requirement& renewed) {
  return asked.source == Requirement::Source::edit && asked.kind != Requirement::Kind::count &&
         asked.subjects != renewed.subjects;
}

Requirement asked_of_heirs(Requirement asked, const std::map<std::string, std::string>& heirs) {
  for (auto* ids : {&asked.subjects, &asked.targets})
    for (auto& id : *ids)
      if (const auto heir = heirs.find(id); heir != heirs.end()) id = heir->second;
  return asked;
}

// What was asked of those that are not there is asked of their heirs. The number that is met so.
const Requirement* ask_again(const Requirement& wish, const std::set<std::string>& gone,
                             Draft& draft, std::set<std::string>& again) {
  const auto heirs = heirs_of(wish, draft);
  const auto is_missing = [&](const std::string& id) { return !find_object(draft.scene, id); };
  const Requirement* number = nullptr;
  for (auto& verdict : draft.scene.requirements) {
    const bool is_withdrawn = verdict.compliance == Compliance::withdrawn;
    if (heirs.empty() || (is_withdrawn && !went_by_an_edit(verdict))) continue;
    Requirement renewed = asked_of_heirs(verdict.requirement, heirs);
    if (renewed == verdict.requirement || is_of_what_it_named(verdict.requirement, renewed))
      continue;
    const bool is_count = renewed.kind == Requirement::Kind::count;
    if (is_withdrawn &&
        (is_count ? is_about_gone(renewed, draft.scene) : has_any(renewed.targets, gone)))
      continue;
    if (is_withdrawn || renewed.source != Requirement::Source::edit) again.insert(renewed.id);
    if (is_withdrawn) std::erase_if(renewed.subjects, is_missing);
    verdict = {renewed, Compliance::not_met, ""};
    if (is_count && !number) number = &verdict.requirement;
  }
  std::erase_if(draft.scene.unplaced, [&](const auto& one) { return heirs.count(one.id) > 0; });
  return number;
}

// Numbers of edits that are part of one that is asked for again.
void drop_parts_of(const Requirement& whole, Verdicts& verdicts) {
  std::erase_if(verdicts, [whole](const RequirementVerdict& verdict) {
    const Requirement& part = verdict.requirement;
    return part.source == Requirement::Source::edit && part.kind == whole.kind &&
           part.id != whole.id && part.room == whole.room && !part.subjects.empty() &&
           std::all_of(part.subjects.begin(), part.subjects.end(), [&](const auto& id) {
             return std::count(whole.subjects.begin(), whole.subjects.end(), id) > 0;
           });
  });
}

// The ids of those that are asked of others now.
std::set<std::string> add_wishes(Draft& draft, const std::set<std::string>& gone,
                                 std::vector<Requirement> less) {
  std::set<std::string> again;
  less.insert(less.begin(), draft.wishes.begin(), draft.wishes.end());
  for (auto& wish : less) {
    if (again.count(wish.id) > 0 || is_about_gone(wish, draft.scene)) continue;
    if (const Requirement* number = ask_again(wish, gone, draft, again)) {
      drop_parts_of(*number, draft.scene.requirements);
      continue;
    }
    wish.id = free_id(draft.scene.requirements);
    draft.scene.requirements.push_back({wish, Compliance::met, ""});
  }
  draft.wishes.clear();
  return again;
}

const RequirementVerdict* verdict_of(const Verdicts& verdicts, const std::string& id) {
  for (const auto& verdict : verdicts)
    if (verdict.requirement.id == id) return &verdict;
  return nullptr;
}

std::vector<RelationVerdict> judged_by_room(const Scene& scene, const KindTable& kinds) {
  std::vector<RelationVerdict> verdicts;
  for (const auto& part : parts_of(scene))
    for (auto& verdict : judge_scene(part, kinds)) verdicts.push_back(std::move(verdict));
  return verdicts;
}

}  // namespace

std::vector<RequirementVerdict> ledger_of(const Draft& draft) { return checked(draft.scene.requirements, draft); }

std::vector<std::string> broken_requirements(const std::vector<RequirementVerdict>& before, const Draft& draft) {
  std::vector<std::string> broken;
  const auto now = ledger_of(draft);
  for (const auto& verdict : before) {
    const auto* later = verdict_of(now, verdict.requirement.id);
    if (verdict.met() && later && later->compliance == Compliance::not_met &&
        !is_overruled(verdict.requirement, draft))
      broken.push_back(verdict.requirement.clause);
  }
  return broken;
}

std::vector<std::string> broken_relations(const Scene& before, const Draft& draft) {
  std::vector<std::string> broken;
  const auto was = judged_by_room(before, draft.shop.kinds());
  const auto is = judged_by_room(draft.scene, draft.shop.kinds());
  for (const auto& verdict : was) {
    if (!verdict.judgement.held || !find_object(draft.scene, verdict.object)) continue;
    const bool lost = std::any_of(is.begin(), is.end(), [&](const RelationVerdict& now) {
      return now.object == verdict.object && now.relation == verdict.relation && !now.judgement.held;
    });
    if (lost) broken.push_back(verdict.object + " is no longer " + to_text(verdict.relation));
  }
  return broken;
}

std::vector<std::string> update_ledger(Draft& draft, const Scene& before) {
  Draft earlier(draft.shop, before, false, {});
  earlier.named = draft.named;
  const auto was = ledger_of(earlier);
  const auto gone = gone_ids(before, draft.scene);
  const auto again = add_wishes(draft, gone, forget(gone, draft));
  drop_gone(gone, draft);
  auto broken = broken_relations(before, draft);
  Verdicts now = ledger_of(draft);
  for (auto& verdict : now) {
    const auto* old = verdict_of(was, verdict.requirement.id);
    const bool is_again = again.count(verdict.requirement.id) > 0;
    // Of what was exchanged just now the prompt asks what it asked of the one before.
    const bool is_passed_on = is_again && old && old->compliance != Compliance::withdrawn &&
                              verdict.requirement.source != Requirement::Source::edit;
    if (is_again && !is_passed_on && !verdict.met()) withdraw(verdict, by_an_edit);
    if (!old || !old->met() || verdict.compliance != Compliance::not_met) continue;
    if (!is_passed_on && is_overruled(verdict.requirement, draft))
      withdraw(verdict, by_an_edit);
    else broken.push_back("no longer met: " + verdict.requirement.clause);
  }
  draft.scene.requirements = std::move(now);
  return broken;
}

}  // namespace roomgen
