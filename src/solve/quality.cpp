#include "quality.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "propose.h"
#include "score.h"

namespace roomgen {

namespace {

constexpr double degree_gain = 1e-6;

int wishes_held(const ProposalContext& context, const Object& object) {
  const auto wishes = std::min(static_cast<std::size_t>(context.task.wishes),
                               context.relations.size());
  return count_held(std::span(context.relations).first(wishes), object, context.layout.room());
}

// A tenth of a metre more or less of what was moved is no difference between rough layouts.
std::tuple<int, int, int, double, int> counts(const LayoutQuality& quality) {
  return {quality.asked, quality.wishes, quality.placed, -std::round(10.0 * quality.displaced),
          quality.held};
}

}  // namespace

bool LayoutQuality::as_good_as(const LayoutQuality& other) const {
  return counts(*this) >= counts(other);
}

bool LayoutQuality::better_than(const LayoutQuality& other) const {
  if (counts(*this) != counts(other)) return counts(*this) > counts(other);
  return degree > other.degree + degree_gain;
}

LayoutQuality quality(const Layout& layout, const std::vector<PlacementTask>& tasks) {
  LayoutQuality result;
  for (const auto& task : tasks) {
    const Object* object = layout.find(task.object.id);
    if (!object) continue;
    const auto context = make_context(
        layout, task, resolve(*object, layout.room(), layout.objects(), layout.categories()),
        count_around(task.object, layout.objects()));
    const auto terms = score(context, footprint(*object), bottom(*object));
    result.asked += task.asked ? 1 : 0;
    result.wishes += wishes_held(context, *object);
    ++result.placed;
    result.held += terms.held;
    result.degree += total_degree(terms, layout.weights());
  }
  return result;
}

int count_held(std::span<const ResolvedRelation> relations, const Object& object,
               const Room& room) {
  const Subject subject{footprint(object), bottom(object), top(object)};
  return static_cast<int>(
      std::count_if(relations.begin(), relations.end(), [&](const ResolvedRelation& relation) {
        return judge(relation, subject, room).held;
      }));
}

}  // namespace roomgen
