#include "comparison.h"

#include <algorithm>

#include "new_size.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

constexpr double clearly_other = 1.03;  // factor of a side

bool is_degree(const EditVocabulary& edits, const std::string& word) { return edits.degrees.count(word) > 0; }

bool differs(double is, double was, bool larger) { return larger ? is >= clearly_other * was : was >= clearly_other * is; }

double largest_face(const Vec3& size) { return size.prod() / size.minCoeff(); }

double side_of(const Vec3& size, const std::string& side) {
  const NewSize unit{side, 2.0, {}, {}};
  const Vec3 changed = resized(size, unit) - size;
  return changed.maxCoeff();
}

}  // namespace

Comparison comparison_in(const std::string& description) {
  Comparison comparison;
  const auto& edits = edit_vocabulary();
  std::vector<std::string> rest, said;
  for (const auto& word : split(description, ' ')) {
    const auto growth = edits ? edits->growth.find(word) : decltype(edits->growth.end())();
    if (!edits || growth == edits->growth.end()) {
      rest.push_back(word);
      continue;
    }
    if (!rest.empty() && is_degree(*edits, rest.back())) rest.pop_back();
    if (!rest.empty() && rest.back() == "and") rest.pop_back();
    comparison.ways.push_back(growth->second);
    said.push_back(word);
  }
  comparison.description = join(rest, " ");
  comparison.words = join(said, " and ");
  return comparison;
}

Vec3 compared_size(const Comparison& comparison, const Vec3& size, bool keeps_height) {
  Vec3 wanted = size;
  for (const auto& way : comparison.ways) {
    const double height = wanted.z();
    wanted = resized(wanted, {way.side, way.factor, {}, {}});
    if (keeps_height && way.side == "all") wanted.z() = height;
  }
  return wanted;
}

bool holds(const Comparison& comparison, const Vec3& is, const Vec3& was) {
  return std::all_of(comparison.ways.begin(), comparison.ways.end(), [&](const Growth& way) {
    const bool larger = way.factor > 1.0;
    if (way.side == "all")
      return differs(largest_face(is), largest_face(was), larger) && differs(is.prod(), was.prod(), larger);
    return differs(side_of(is, way.side), side_of(was, way.side), larger);
  });
}

}  // namespace roomgen
