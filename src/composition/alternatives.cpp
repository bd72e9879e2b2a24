#include <algorithm>
#include <cmath>

#include "arrange.h"

namespace roomgen::composition {

namespace {

// Each value that may be tried with each of the others; what is asked for first.
std::vector<Values> variants(const Composition& composition, const Values& values,
                             const std::set<std::string>& fixed) {
  constexpr std::size_t most_variants = 12;
  std::vector<Values> all = {values};
  for (const auto& parameter : composition.parameters) {
    if (fixed.count(parameter.name) || parameter.others.empty()) continue;
    std::vector<Values> next = all;
    for (const auto& other : parameter.others)
      for (Values one : all) {
        shape::Scope scope;
        for (const auto& known : composition.parameters)
          scope.values[known.name] = one.count(known.name) ? one[known.name] : known.value;
        const auto value = other.value(scope);
        if (!value) continue;
        one[parameter.name] = *value;
        next.push_back(std::move(one));
      }
    if (next.size() > most_variants) next.resize(most_variants);
    all = std::move(next);
  }
  return all;
}

double value_of(const Parameter& parameter, const Values& values) {
  const auto given = values.find(parameter.name);
  const Value& value = given == values.end() ? parameter.value : given->second;
  const double* number = std::get_if<double>(&value);
  return number ? *number : 0.0;
}

// Smaller by one of each parameter that shrinks, while there is one above its least.
std::vector<Values> smaller(const Composition& composition, Values values,
                            const std::set<std::string>& fixed) {
  std::vector<Values> all;
  for (bool shrank = true; shrank && all.size() < most_alternatives;) {
    shrank = false;
    for (const auto& parameter : composition.parameters) {
      const double now = value_of(parameter, values);
      if (!parameter.shrinks || fixed.count(parameter.name) || now <= parameter.least) continue;
      values[parameter.name] = std::max(parameter.least, now - 1.0);
      shrank = true;
      all.push_back(values);
    }
  }
  return all;
}

// Without what may be left out up to a level, and what stands on that.
Arranged without_spare(const Arranged& arranged, int level) {
  Arranged kept;
  std::vector<std::size_t> now(arranged.members.size(), most_members);
  for (std::size_t i = 0; i < arranged.members.size(); ++i) {
    Member member = arranged.members[i];
    const bool carried = member.mount == Mount::surface;
    if (i > 0 && !carried && member.spare > 0 && member.spare <= level) continue;
    if (carried && now[member.on] == most_members) continue;
    if (carried) member.on = now[member.on];
    now[i] = kept.members.size();
    kept.members.push_back(std::move(member));
  }
  return kept;
}

std::set<int> spare_levels(const Arranged& arranged) {
  std::set<int> levels;
  for (const auto& member : arranged.members)
    if (member.spare > 0 && member.mount != Mount::surface) levels.insert(member.spare);
  return levels;
}

double back_of(const Member& member, const KindTable& kinds) {
  return Footprint(member.place.position, member.size.head<2>(), member.place.yaw,
                   kinds.get(member.category).traits.round)
      .bounds()
      .high.y();
}

}  // namespace

std::optional<Arranged> with_backs_in_line(Arranged arranged, const KindTable& kinds) {
  constexpr double slack = 0.01;  // metres
  auto& members = arranged.members;
  const double back = 0.5 * members.front().size.y();
  double behind = back;
  std::vector<double> forward(members.size(), 0.0);
  for (std::size_t i = 1; i < members.size(); ++i) {
    Member& member = members[i];
    if (member.mount == Mount::surface) forward[i] = forward[member.on];
    if (member.mount != Mount::floor || kinds.get(member.category).traits.flat) continue;
    const double reach = back_of(member, kinds);
    if (reach > back + slack && member.place.position.y() < back)
      forward[i] = reach - back;
    else
      behind = std::max(behind, reach);
  }
  for (std::size_t i = 1; i < members.size(); ++i)
    if (members[i].mount == Mount::wall && std::abs(back_of(members[i], kinds) - back) < slack)
      forward[i] = back - behind;
  if (std::all_of(forward.begin(), forward.end(), [](double one) { return std::abs(one) < slack; }))
    return std::nullopt;
  for (std::size_t i = 1; i < members.size(); ++i) members[i].place.position.y() -= forward[i];
  return arranged;
}

Result<std::vector<Arranged>> alternatives(const Composition& composition, const Values& values,
                                           const std::set<std::string>& fixed,
                                           const Making& making) {
  auto first = arrange(composition, values, making);
  if (!first) return first.error();
  std::vector<Arranged> all;
  const auto take = [&](const Arranged& one) {
    if (all.size() >= most_alternatives) return;
    all.push_back(one);
    if (composition.mirrors) all.push_back(mirrored(one));
  };
  std::vector<Arranged> whole = {*std::move(first)};
  const auto tried = variants(composition, values, fixed);
  for (std::size_t i = 1; i < tried.size(); ++i)
    if (auto made = arrange(composition, tried[i], making)) whole.push_back(*std::move(made));
  for (const auto& one : whole) take(one);
  if (const auto in_line = with_backs_in_line(whole.front(), making.kinds)) take(*in_line);
  const auto levels = spare_levels(whole.front());
  for (int level : levels)
    for (const auto& one : whole) take(without_spare(one, level));
  for (const auto& variant : smaller(composition, values, fixed)) {
    const auto made = arrange(composition, variant, making);
    if (!made) continue;
    take(*made);
    if (!levels.empty()) take(without_spare(*made, *levels.rbegin()));
  }
  return all;
}

}  // namespace roomgen::composition
