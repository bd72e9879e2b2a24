#include "search.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "index_file.h"
#include "roomgen/base/text.h"
#include "roomgen/library/ranking.h"
#include "roomgen/scene/category.h"

namespace roomgen::assets {

namespace {

constexpr double general_kind = 0.8;     // a plain bed where the description says bunk bed
constexpr double family_match = 0.6;     // oak where walnut was wanted: both are wood
constexpr double usual_size_share = 0.25;
constexpr std::size_t max_words = 16;

bool mentions(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Kinds below the asked one that the description names: "bunk bed for two" where a bed is asked.
std::vector<std::string> special_kinds(const std::string& kind, const std::string& description,
                                       const Vocabulary& vocabulary) {
  std::vector<std::string> result;
  for (const auto& mentioned : vocabulary.mentioned(description))
    if (mentioned != kind && vocabulary.is_a(mentioned, kind) && !mentions(result, mentioned))
      result.push_back(mentioned);
  return result;
}

std::map<std::string, double> fitting_kinds(const std::string& kind, const std::string& description,
                                            const Vocabulary& vocabulary) {
  const auto special = special_kinds(kind, description, vocabulary);
  std::map<std::string, double> result;
  for (const auto& [name, candidate] : vocabulary.kinds()) {
    double fit = vocabulary.fit(name, kind);
    if (!special.empty()) {
      fit *= general_kind;
      for (const auto& wanted : special) fit = std::max(fit, vocabulary.fit(name, wanted));
    }
    if (fit > 0.0) result[name] = fit;
  }
  return result;
}

// The words that say which thing of its kind is meant.
std::vector<std::string> telling_words(const AssetQuery& query, const std::string& kind,
                                       const Vocabulary& vocabulary) {
  const auto of_kind = words(kind);
  std::vector<std::string> result;
  for (const auto& word : words(query.category + " " + query.description)) {
    const std::string one = singular(word);
    const bool skip = vocabulary.is_filler(one) || mentions(of_kind, one) || mentions(result, one);
    if (!skip && result.size() < max_words) result.push_back(one);
  }
  return result;
}

std::string in_quotes(const std::string& word) { return "\"" + word + "\""; }

std::set<long long> matching_rows(const Database& database, const std::string& expression) {
  Statement statement = database.prepare("SELECT rowid FROM texts WHERE texts MATCH ?");
  statement.bind(1, expression);
  std::set<long long> rows;
  while (statement.step()) rows.insert(statement.integer(0));
  return rows;
}

// One word of the description against the text index. Rarer words tell more.
struct WordRows {
  double weight = 0.0;
  std::set<long long> exact, family;

  double found_in(long long row) const {
    if (exact.count(row)) return 1.0;
    return family.count(row) ? family_match : 0.0;
  }
};

WordRows look_up(const Database& database, const std::string& word, double asset_count,
                 const Vocabulary& vocabulary) {
  WordRows result;
  result.exact = matching_rows(database, in_quotes(word));
  result.family = result.exact;
  std::vector<std::string> family;
  for (const auto& other : vocabulary.family(word)) family.push_back(in_quotes(other));
  if (family.size() > 1) result.family = matching_rows(database, join(family, " OR "));
  const double frequency = static_cast<double>(result.family.size());
  const double rarity = std::log((asset_count + 1.0) / (frequency + 1.0));
  // A word that no asset has cannot tell them apart.
  result.weight = result.family.empty() ? 0.0 : std::max(0.1, rarity);
  return result;
}

// The size of the kind's usual thing tells a doll's chair from a chair when no size is wanted.
double size_term(const SearchPlan& plan, const AssetInfo& asset) {
  if (plan.query.size) return size_similarity(asset.size, *plan.query.size);
  if (!plan.usual_size) return 1.0;
  return 1.0 - usual_size_share + usual_size_share * size_similarity(asset.size, *plan.usual_size);
}

double mount_term(const SearchPlan& plan, const AssetInfo& asset, const Vocabulary& vocabulary) {
  if (!plan.query.mount) return 1.0;
  const Kind* kind = vocabulary.find(asset.category);
  return mount_fit(asset.mount, *plan.query.mount, kind ? kind->also : std::vector<Mount>{},
                   asset.size.z());
}

double kind_term(const SearchPlan& plan, const AssetInfo& asset, const Vocabulary& vocabulary) {
  if (!plan.free_kind.empty()) return vocabulary.fit(asset.category, plan.free_kind);
  const auto found = plan.kinds.find(asset.category);
  return found == plan.kinds.end() ? 0.0 : found->second;
}

Statement candidates(const Database& database, const SearchPlan& plan) {
  const std::string columns = std::string(row_columns) + ", id";
  if (!plan.free_kind.empty()) {
    Statement statement = database.prepare("SELECT " + columns + " FROM assets WHERE id IN " +
                                           "(SELECT rowid FROM texts WHERE texts MATCH ?)");
    statement.bind(1, "category : " + in_quotes(words(plan.free_kind).back()));
    return statement;
  }
  std::string holes;
  for (std::size_t i = 0; i < plan.kinds.size(); ++i) holes += i ? ",?" : "?";
  Statement statement =
      database.prepare("SELECT " + columns + " FROM assets WHERE category IN (" + holes + ")");
  int index = 0;
  for (const auto& [kind, fit] : plan.kinds) statement.bind(++index, kind);
  return statement;
}

double count_assets(const Database& database) {
  Statement statement = database.prepare("SELECT count(*) FROM assets");
  return statement.step() ? statement.number(0) : 0.0;
}

}  // namespace

SearchPlan plan_search(const AssetQuery& query, const Vocabulary& vocabulary) {
  SearchPlan plan;
  plan.query = query;
  const std::string& asked = query.category.empty() ? query.description : query.category;
  const KindPhrase phrase = vocabulary.understand(asked);
  if (phrase.known) plan.kinds = fitting_kinds(phrase.kind, query.description, vocabulary);
  else if (!words(phrase.kind).empty()) plan.free_kind = phrase.kind;
  plan.words = telling_words(query, phrase.kind, vocabulary);
  if (const Category* category = CategoryTable::built_in().find(phrase.kind))
    plan.usual_size = category->size;
  return plan;
}

Result<std::vector<AssetMatch>> run_search(const Database& database, const SearchPlan& plan,
                                           const Vocabulary& vocabulary) {
  std::vector<AssetMatch> matches;
  if (plan.kinds.empty() && plan.free_kind.empty()) return matches;
  const double count = count_assets(database);
  std::vector<WordRows> wanted;
  for (const auto& word : plan.words) wanted.push_back(look_up(database, word, count, vocabulary));

  Statement rows = candidates(database, plan);
  while (rows.step()) {
    AssetMatch match{row_of(rows).info, 0.0};
    const long long id = rows.integer(21);
    std::vector<WeightedWord> found;
    for (const auto& word : wanted) found.push_back({word.weight, word.found_in(id)});
    match.score = match_score({kind_term(plan, match.asset, vocabulary), text_relevance(found),
                               size_term(plan, match.asset),
                               mount_term(plan, match.asset, vocabulary)});
    if (match.score <= 0.0) continue;
    match.asset.mount = plan.query.mount.value_or(match.asset.mount);
    matches.push_back(std::move(match));
  }
  if (auto status = rows.status(); !status) return status.error();
  return matches;
}

}  // namespace roomgen::assets
