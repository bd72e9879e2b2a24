#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/lab/suite.h"

namespace roomgen::lab {

namespace {

struct Share {
  int right = 0, of = 0;

  void add(bool is_right) {
    right += is_right;
    ++of;
  }
  double value() const { return of == 0 ? 0.0 : static_cast<double>(right) / of; }
  std::string percent() const {
    return of == 0 ? "-" : std::to_string(std::lround(100.0 * value())) + " %";
  }
};

struct Mean {
  double sum = 0.0;
  int of = 0;

  std::string text() const { return of == 0 ? "-" : format_number(sum / of, 2); }
};

/// The figures of several results.
struct Row {
  Share made, parts, whole, checks[check_count], perfect, by_rules;
  Mean structure, realism, alignment;

  void add(const SuiteResult& result) {
    const Assessment& found = result.assessment;
    made.add(found.made);
    parts.right += found.parts_right;
    parts.of += found.parts_asked;
    whole.add(found.made && found.parts_right == found.parts_asked);
    for (std::size_t k = 0; k < check_count; ++k)
      if (found.checks[k]) checks[k].add(*found.checks[k]);
    perfect.add(found.perfect());
    by_rules.add(result.fell_back);
    if (!result.scores) return;
    for (const auto& [mean, score] : {std::pair(&structure, &result.scores->structure),
                                      std::pair(&realism, &result.scores->realism),
                                      std::pair(&alignment, &result.scores->alignment)}) {
      mean->sum += score->points;
      ++mean->of;
    }
  }
};

// In the order in which they first come.
template <typename Key, typename Get>
std::vector<Key> distinct(const std::vector<SuiteResult>& results, Get get) {
  std::vector<Key> keys;
  for (const auto& result : results)
    if (std::find(keys.begin(), keys.end(), get(result)) == keys.end())
      keys.push_back(get(result));
  return keys;
}

std::vector<Variant> variants_of(const std::vector<SuiteResult>& results) {
  return distinct<Variant>(results, [](const SuiteResult& result) { return result.variant; });
}

std::vector<std::string> groups_of(const std::vector<SuiteResult>& results) {
  return distinct<std::string>(results, [](const SuiteResult& result) { return result.group; });
}

Row row_of(const std::vector<SuiteResult>& results, Variant variant, const std::string& group) {
  Row row;
  for (const auto& result : results)
    if (result.variant == variant && (group.empty() || result.group == group)) row.add(result);
  return row;
}

/// Columns that only some experiments have.
struct Columns {
  bool by_rules = false, scores = false;
};

std::string line(const std::vector<std::string>& cells) {
  return "| " + join(cells, " | ") + " |\n";
}

std::string header(const Columns& columns) {
  std::vector<std::string> cells = {"variant", "group", "sentences", "made", "parts right",
                                    "all parts"};
  for (std::size_t k = 0; k < check_count; ++k) cells.push_back(name(static_cast<Check>(k)));
  cells.push_back("everything");
  if (columns.by_rules) cells.push_back("by rules");
  if (columns.scores) cells.insert(cells.end(), {"structure", "realism", "alignment"});
  std::string rule = "|";
  for (std::size_t k = 0; k < cells.size(); ++k) rule += "---|";
  return line(cells) + rule + "\n";
}

std::string row_line(Variant variant, const std::string& group, const Row& row,
                     const Columns& columns) {
  std::vector<std::string> cells = {name(variant),        group.empty() ? "all" : group,
                                    std::to_string(row.made.of), row.made.percent(),
                                    row.parts.percent(),  row.whole.percent()};
  for (const auto& check : row.checks) cells.push_back(check.percent());
  cells.push_back(row.perfect.percent());
  if (columns.by_rules) cells.push_back(row.by_rules.percent());
  if (columns.scores)
    cells.insert(cells.end(),
                 {row.structure.text(), row.realism.text(), row.alignment.text()});
  return line(cells);
}

Json row_json(const Row& row) {
  const auto share = [](const Share& part) {
    return Json{{"right", part.right}, {"of", part.of}};
  };
  Json json = {{"made", share(row.made)},
               {"parts_right", share(row.parts)},
               {"all_parts", share(row.whole)}};
  for (std::size_t k = 0; k < check_count; ++k)
    json[name(static_cast<Check>(k))] = share(row.checks[k]);
  json["everything"] = share(row.perfect);
  json["by_rules"] = row.by_rules.right;
  if (row.structure.of > 0)
    json["scores"] = {{"judged", row.structure.of},
                      {"structure", rounded(row.structure.sum / row.structure.of)},
                      {"realism", rounded(row.realism.sum / row.realism.of)},
                      {"alignment", rounded(row.alignment.sum / row.alignment.of)}};
  return json;
}

std::string number_text(int number) {
  const std::string digits = std::to_string(number);
  return std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

}  // namespace

std::string suite_markdown(const std::vector<SuiteResult>& results) {
  Columns columns;
  for (const auto& result : results) {
    columns.by_rules = columns.by_rules || result.fell_back;
    columns.scores = columns.scores || result.scores;
  }
  std::string text = header(columns);
  auto groups = groups_of(results);
  if (groups.size() == 1) groups.clear();
  groups.push_back("");
  for (const Variant variant : variants_of(results))
    for (const auto& group : groups) {
      const Row row = row_of(results, variant, group);
      if (row.made.of > 0) text += row_line(variant, group, row, columns);
    }
  text += "\nFailures:\n\n";
  for (const auto& result : results)
    for (const auto& failure : result.assessment.failures)
      text += "- " + std::string(name(result.variant)) + " " + number_text(result.number) + " " +
              result.prompt + ": " + failure + "\n";
  return text;
}

Json suite_summary(const std::vector<SuiteResult>& results) {
  Json json = Json::object();
  for (const Variant variant : variants_of(results)) {
    for (const auto& group : groups_of(results)) {
      const Row row = row_of(results, variant, group);
      if (row.made.of > 0) json[name(variant)][group] = row_json(row);
    }
    json[name(variant)]["all"] = row_json(row_of(results, variant, ""));
  }
  return json;
}

}  // namespace roomgen::lab
