#include <algorithm>
#include <optional>

#include "mark_names.h"
#include "object_labels.h"

namespace roomgen::detail {

namespace {

constexpr double most_covered = 0.1;  // by names, of the floor

bool is_crowded(const std::vector<ObjectMark>& marks, double letter_height, double floor) {
  double covered = 0.0;
  for (const auto& mark : marks)
    if (!mark.text.empty()) covered += label_size(mark.text, letter_height).prod();
  return covered > most_covered * floor;
}

// Those of a kind whose labels would overlap, as far as one leads to the next.
std::vector<std::size_t> crowd_of(const std::vector<ObjectMark>& marks, std::size_t first,
                                  double letter_height, std::vector<bool>& taken) {
  std::vector<std::size_t> crowd = {first};
  const std::string kind = MarkNames::kind_of(marks[first].id);
  const Vec2 size = label_size(marks[first].text, letter_height);
  for (std::size_t next = 0; next < crowd.size(); ++next)
    for (std::size_t i = 0; i < marks.size(); ++i) {
      if (taken[i] || MarkNames::kind_of(marks[i].id) != kind) continue;
      const Vec2 apart = (marks[i].center - marks[crowd[next]].center).cwiseAbs() - size;
      if (apart.maxCoeff() < 0) taken[i] = true, crowd.push_back(i);
    }
  return crowd;
}

// One name for all of them at the one in their midst, and a line through all.
void share_name(const std::vector<std::size_t>& crowd, const MarkNames& names,
                std::vector<ObjectMark>& marks, std::vector<Drawing::Stroke>& strokes) {
  Vec2 middle = Vec2::Zero();
  Drawing::Stroke line{Drawing::Line::leader, {}};
  std::vector<std::string> ids;
  for (const auto i : crowd) {
    middle += marks[i].center / static_cast<double>(crowd.size());
    line.points.push_back(marks[i].center);
    ids.push_back(marks[i].id);
    marks[i].text.clear();
  }
  const auto midmost =
      std::min_element(crowd.begin(), crowd.end(), [&](std::size_t a, std::size_t b) {
        return (marks[a].center - middle).norm() < (marks[b].center - middle).norm();
      });
  marks[*midmost].text = names.of(ids);
  strokes.push_back(std::move(line));
}

// Along the lower edge of the picture in at most two rows; none if it needs more.
std::optional<std::vector<Drawing::Label>> lay_legend(const MarkNames& names, const Vec2& picture,
                                                      double letter_height) {
  std::vector<Drawing::Label> labels;
  Vec2 corner(letter_height, picture.y());  // lower left
  for (const auto& line : names.legend()) {
    const Vec2 size = label_size(line, letter_height);
    if (corner.x() > letter_height && corner.x() + size.x() > picture.x())
      corner = {letter_height, corner.y() - size.y()};
    const Vec2 center = corner + Vec2(0.5 * size.x(), -0.5 * size.y());
    labels.push_back({Drawing::Text::legend, line, center, size});
    corner.x() += size.x() + letter_height;
    if (corner.y() < picture.y() - 1.5 * size.y()) return std::nullopt;
  }
  return labels;
}

// Of those that shall be named; where the legend has no room for all kinds, not of the rarest.
MarkNames names_with_legend(const std::vector<ObjectMark>& marks, double letter_height,
                            LabelPlacer& placer) {
  std::vector<std::string> ids;
  for (const auto& mark : marks)
    if (!mark.text.empty()) ids.push_back(mark.id);
  MarkNames names(ids);
  for (;; names.spell_out_rarest())
    if (const auto legend = lay_legend(names, placer.picture(), letter_height)) {
      for (const auto& label : *legend) placer.place(label);
      return names;
    }
}

}  // namespace

void name_marks(std::vector<ObjectMark>& marks, double letter_height, double floor,
                LabelPlacer& placer, std::vector<Drawing::Stroke>& strokes) {
  if (!is_crowded(marks, letter_height, floor)) return;
  for (auto& mark : marks)
    if (mark.may_be_nameless) mark.text.clear();
  if (!is_crowded(marks, letter_height, floor)) return;
  const MarkNames names = names_with_legend(marks, letter_height, placer);
  std::vector<bool> taken;
  for (auto& mark : marks) {
    const bool is_brief = !mark.text.empty() && names.is_brief(mark.id);
    if (is_brief) mark.text.replace(0, mark.id.size(), names.of(mark.id));
    taken.push_back(!is_brief || mark.look != Drawing::Line::outline);
  }
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (taken[i]) continue;
    taken[i] = true;
    const auto crowd = crowd_of(marks, i, letter_height, taken);
    if (crowd.size() > 1) share_name(crowd, names, marks, strokes);
  }
}

}  // namespace roomgen::detail
