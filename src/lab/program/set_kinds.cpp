#include "set_kinds.h"

#include <algorithm>

#include "kinds/mounting.h"

namespace roomgen::lab {

namespace {

using Source = ProgramSet::Source;

void keep_common(SetKinds::Mask& mask, const SetKinds::Mask& other) {
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = mask[i] && other[i];
}

}  // namespace

SetKinds::SetKinds(const ConstraintProgram& program, const KindTable& kinds, const ProgramVocabulary& vocabulary)
    : program_(program), table_(kinds), vocabulary_(vocabulary) {
  for (const auto& [name, kind] : kinds.all())
    if (!kind.is_stand_in()) kinds_.push_back(&kind);
  for (const auto& [name, set] : program.sets) sets_.emplace(name, &set);
}

SetKinds::Mask SetKinds::nothing() const { return Mask(kinds_.size() + 1, false); }

SetKinds::Mask SetKinds::all_things() const {
  Mask mask(kinds_.size() + 1, true);
  mask.back() = false;
  return mask;
}

const ProgramSet* SetKinds::named(const std::string& name) const {
  const auto found = sets_.find(name);
  return found == sets_.end() ? nullptr : found->second;
}

const SetKinds::Variable* SetKinds::bound(const std::string& variable) const {
  const auto found = std::find_if(variables_.rbegin(), variables_.rend(),
                                  [&](const Variable& entry) { return entry.name == variable; });
  return found == variables_.rend() ? nullptr : &*found;
}

template <typename Test>
const SetKinds::Mask& SetKinds::remembered(Memo& memo, const std::string& word, Test test) {
  const auto [entry, is_new] = memo.try_emplace(word);
  if (is_new) {
    for (const Kind* kind : kinds_) entry->second.push_back(test(*kind));
    entry->second.push_back(false);
  }
  return entry->second;
}

const SetKinds::Mask& SetKinds::tagged(const std::string& tag) {
  return remembered(tags_, tag, [&](const Kind& kind) { return has_tag(vocabulary_, kind, tag); });
}

const SetKinds::Mask& SetKinds::made_by(const std::string& factory) {
  return remembered(factories_, factory,
                    [&](const Kind& kind) { return is_made_by(vocabulary_, table_, kind, factory); });
}

const SetKinds::Mask& SetKinds::mounted(Mount mount) {
  return remembered(mounts_, std::string(name(mount)), [&](const Kind& kind) { return may_be_put_up(kind, mount); });
}

const PutUp* SetKinds::relation(const std::string& name) const {
  if (const auto own = program_.relations.find(name); own != program_.relations.end()) return &own->second;
  const auto& built_in = built_in_relations();
  const auto found = built_in.find(name);
  return found == built_in.end() ? nullptr : &found->second;
}

// What stands on the floor is made to stand there, and what hangs from the ceiling to hang.
void SetKinds::keep_mountable(const SetRelation& put_up, Mask& mask) {
  const PutUp* how = relation(put_up.relation);
  if (put_up.absent || !how || how->type != PutUp::Type::stable_against) return;
  if (how->parent == std::vector{Face::floor}) keep_common(mask, mounted(Mount::floor));
  if (how->parent == std::vector{Face::ceiling}) keep_common(mask, mounted(Mount::ceiling));
}

SetKinds::Mask SetKinds::described(const ProgramSet& set) {
  Mask mask = set.from.empty() ? all_things() : of(set.from[0]);
  for (const auto& tag : set.tags) keep_common(mask, tagged(tag));
  for (const auto& tag : set.without) {
    const Mask& taken_out = tagged(tag);
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = mask[i] && !taken_out[i];
  }
  if (!set.factory.empty()) keep_common(mask, made_by(set.factory));
  for (const auto& put_up : set.relations) keep_mountable(put_up, mask);
  return mask;
}

SetKinds::Mask SetKinds::united(const ProgramSet& set) {
  Mask mask = nothing();
  for (const auto& member : set.from) {
    const Mask other = of(member);
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = mask[i] || other[i];
  }
  return mask;
}

SetKinds::Mask SetKinds::of_name(const std::string& name) {
  if (const auto found = names_.find(name); found != names_.end()) return found->second;
  const ProgramSet* set = named(name);
  return names_[name] = set ? of(*set) : nothing();
}

SetKinds::Mask SetKinds::of(const ProgramSet& set) {
  switch (set.source) {
    case Source::objects: return all_things();
    case Source::named: return of_name(set.name);
    case Source::variable: {
      const Variable* variable = bound(set.name);
      return variable ? variable->kinds : nothing();
    }
    case Source::described: return described(set);
    case Source::united: return united(set);
    default: {
      Mask mask = nothing();
      mask.back() = true;
      return mask;
    }
  }
}

bool SetKinds::is_room(const ProgramSet& set) const {
  if (set.source == Source::room) return true;
  if (set.source == Source::variable) {
    const Variable* variable = bound(set.name);
    return variable && is_room(*variable->set);
  }
  const ProgramSet* other = set.source == Source::named ? named(set.name) : nullptr;
  return other && is_room(*other);
}

bool SetKinds::is_empty(const ProgramSet& set) {
  const Mask mask = of(set);
  return std::find(mask.begin(), mask.end(), true) == mask.end();
}

}  // namespace roomgen::lab
