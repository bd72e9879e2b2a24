#include "search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

#include "index_file.h"
#include "library/asset_object.h"
#include "library/attribute_words.h"
#include "library/qualifiers.h"
#include "library/ranking.h"
#include "library/seen_assets.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen::assets {

namespace {

constexpr double general_kind = 0.8;  // a plain bed where the description says bunk bed
constexpr double family_match = 0.6;  // oak where walnut was wanted: both are wood
constexpr double usual_size_share = 0.25;
constexpr double least_kin = 0.75;   // a kind that serves less well is another thing
constexpr double loud_fit = 0.85;     // bright furniture where no colour was asked for
constexpr double flaw_loss = 0.02, formality_loss = 0.02;  // a flaw; a step of formality
constexpr double foreign_loss = 0.08;  // of what is at home elsewhere, where nobody asked for it
constexpr const char* furniture[] = {"seat", "table", "storage", "bed"};
// What comes in any size and is cut, framed or sewn to it.
constexpr const char* to_measure[] = {"rug", "curtain", "picture", "mirror", "pillow"};
constexpr std::size_t max_words = 16;

bool mentions(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Where a counter shall have a sink, sink units are such counters.
void add_kinds_with_parts(const std::string& kind, const WantedLooks& looks,
                          const Vocabulary& vocabulary, std::vector<std::string>& named) {
  const auto parent_of = [&](const std::string& name) {
    const Kind* one = vocabulary.kinds().by_name(name);
    return one ? one->parent : "";
  };
  for (const auto& [other, need] : AttributeWords::built_in().needs()) {
    const bool is_said = mentions(looks.making, need) || mentions(looks.making, singular(need));
    if (is_said && !parent_of(kind).empty() && parent_of(other) == parent_of(kind))
      named.push_back(other);
  }
}

std::map<std::string, double> fitting_kinds(const std::string& kind, const AssetQuery& query,
                                            const std::vector<std::string>& named,
                                            const Vocabulary& vocabulary) {
  const bool is_special = named.size() > 1 || named.front() != kind;
  std::map<std::string, double> result;
  for (const auto& [name, candidate] : vocabulary.kinds().all()) {
    if (query.asked && !vocabulary.is_a(name, kind) && !mentions(named, name)) continue;
    double fit = vocabulary.fit(name, kind);
    if (is_special) {
      fit *= general_kind;
      for (const auto& wanted : named) fit = std::max(fit, vocabulary.fit(name, wanted));
    }
    if (fit > 0.0) result[name] = fit;
  }
  return result;
}

// The words that say which thing of its kind is meant.
std::vector<std::string> telling_words(const AssetQuery& query, const KindPhrase& phrase,
                                       const Vocabulary& vocabulary) {
  const auto of_kind = words(phrase.kind + " " + phrase.name);
  std::vector<std::string> result;
  for (const auto& word : words(query.category + " " + query.description)) {
    const std::string one = singular(word);
    const bool skip = vocabulary.is_filler(one) || mentions(of_kind, one) || mentions(result, one);
    if (!skip && result.size() < max_words) result.push_back(one);
  }
  return result;
}

std::string in_quotes(const std::string& word) {
  return "\"" + word + "\"";
}

std::set<long long> matching_rows(const Database& database, const std::string& expression) {
  Statement statement = database.prepare("SELECT rowid FROM texts WHERE texts MATCH ?");
  statement.bind(1, expression);
  std::set<long long> rows;
  while (statement.step()) rows.insert(statement.integer(0));
  return rows;
}

// One word of the description in one catalogue's text index.
struct WordRows {
  std::set<long long> exact, family;

  double found_in(long long row) const {
    if (exact.count(row)) return 1.0;
    return family.count(row) ? family_match : 0.0;
  }
};

WordRows look_up(const Database& database, const std::string& word, const Vocabulary& vocabulary) {
  WordRows result;
  result.exact = matching_rows(database, in_quotes(word));
  result.family = result.exact;
  std::vector<std::string> family;
  for (const auto& other : vocabulary.family(word)) family.push_back(in_quotes(other));
  if (family.size() > 1) result.family = matching_rows(database, join(family, " OR "));
  return result;
}

// The words of a description in all catalogues. Rarer words tell more, and a word that no asset has
// cannot tell them apart; both are counted over all catalogues, so that their answers compare.
struct WordIndex {
  std::vector<double> weights;              ///< by word
  std::vector<std::vector<WordRows>> rows;  ///< by catalogue, by word

  std::vector<WeightedWord> found(std::size_t catalogue, long long row) const {
    std::vector<WeightedWord> result;
    for (std::size_t w = 0; w < weights.size(); ++w)
      result.push_back({weights[w], rows[catalogue][w].found_in(row)});
    return result;
  }
};

double count_assets(const Database& database) {
  Statement statement = database.prepare("SELECT count(*) FROM assets");
  return statement.step() ? statement.number(0) : 0.0;
}

WordIndex look_up_all(const std::vector<const Database*>& databases, const SearchPlan& plan,
                      const Vocabulary& vocabulary) {
  WordIndex index;
  std::vector<double> counts(plan.words.size(), 0.0);
  double assets = 0.0;
  for (const Database* database : databases) {
    assets += count_assets(*database);
    auto& rows = index.rows.emplace_back();
    for (std::size_t w = 0; w < plan.words.size(); ++w) {
      rows.push_back(look_up(*database, plan.words[w], vocabulary));
      counts[w] += static_cast<double>(rows.back().family.size());
    }
  }
  for (const double count : counts)
    index.weights.push_back(count > 0.0 ? std::max(0.1, std::log((assets + 1.0) / (count + 1.0)))
                                        : 0.0);
  return index;
}

// A thing without a front may as well stand the other way round.
double size_fit(const AssetInfo& asset, const Vec3& have, const Vec3& want) {
  const double as_is = size_similarity(have, want);
  if (asset.has_front) return as_is;
  return std::max(as_is, size_similarity({have.y(), have.x(), have.z()}, want));
}

// The size of the kind's usual thing tells a doll's chair from a chair when no size is wanted.
double size_term(const SearchPlan& plan, const AssetInfo& asset) {
  const auto& wanted = plan.query.size;
  if (wanted)
    return size_fit(asset, plan.usual ? fitted_size(asset, plan.usual->size, *wanted) : asset.size,
                    *wanted);
  if (!plan.usual) return 1.0;
  return 1.0 - usual_size_share + usual_size_share * size_fit(asset, asset.size, plan.usual->size);
}

// How stately things of the styles among the words are on the average; null if there is none.
std::optional<double> formality_of(const std::vector<std::string>& styles) {
  double sum = 0.0, count = 0.0;
  for (const auto& [name, asset] : seen_assets())
    for (const auto& style : asset.style)
      if (mentions(styles, style)) sum += asset.formality, ++count;
  return count > 0.0 ? std::optional(sum / count) : std::nullopt;
}

// What is ugly is the last choice. Of a style that was asked for is also what is as stately as its
// things are.
double beauty_term(const SearchPlan& plan, const AssetInfo& asset) {
  static constexpr std::array<double, 5> by_looks = {0.75, 0.84, 0.94, 1.0, 1.0};
  const SeenAsset* seen = seen_asset(asset.ref);
  if (!seen) return 1.0;
  double term = by_looks[static_cast<std::size_t>(seen->looks - 1)];
  if (seen->is_flawed) term -= flaw_loss;
  for (const char* style : {"outdoor", "kids", "novelty"})
    if (mentions(seen->style, style) && !mentions(plan.words, style)) term -= foreign_loss;
  const bool is_in_style = std::any_of(seen->style.begin(), seen->style.end(), [&](const auto& style) {
    return mentions(plan.words, style);
  });
  if (plan.formality && !is_in_style)
    term -= formality_loss * std::abs(seen->formality - *plan.formality);
  return term;
}

double mount_term(const SearchPlan& plan, const AssetInfo& asset, const Vocabulary& vocabulary) {
  if (!plan.query.mount) return 1.0;
  const Kind* kind = vocabulary.find(asset.category);
  return mount_fit(asset.mount, *plan.query.mount, kind ? kind->also : std::vector<Mount>{},
                   asset.size.z());
}

// Where no colour is asked for, quiet furniture goes with whatever else is in the room.
double quiet_term(const SearchPlan& plan, const AssetInfo& asset, const Vocabulary& vocabulary) {
  static const std::set<std::string> loud = {"red", "orange", "yellow", "green", "blue", "purple", "pink"};
  if (!plan.looks.colors.empty() || asset.colors.empty() || !loud.count(asset.colors.front())) return 1.0;
  const bool is_furniture = std::any_of(std::begin(furniture), std::end(furniture),
                                        [&](const char* kind) { return vocabulary.is_a(asset.category, kind); });
  return is_furniture ? loud_fit : 1.0;
}

double kind_term(const SearchPlan& plan, const AssetInfo& asset, const Vocabulary& vocabulary) {
  if (!plan.free_kind.empty()) return vocabulary.fit(asset.category, plan.free_kind);
  const auto found = plan.kinds.find(asset.category);
  return found == plan.kinds.end() ? 0.0 : found->second;
}

// What is said to be round is so, whatever its box.
double most_off_of(const SearchPlan& plan, const AssetInfo& asset, const Vocabulary& vocabulary) {
  const bool is_measured =
      plan.looks.outline != "round" &&
      std::any_of(std::begin(to_measure), std::end(to_measure),
                  [&](const char* kind) { return vocabulary.is_a(asset.category, kind); });
  return is_measured ? most_off_measure : most_off;
}

Contradiction contradiction_of(const SearchPlan& plan, const AssetInfo& asset,
                               const std::vector<WeightedWord>& found, const Vocabulary& vocabulary) {
  const auto is_kin = [&](const std::string& kind) {
    return vocabulary.fit(asset.category, kind) >= least_kin;
  };
  if (!plan.named.empty() && std::none_of(plan.named.begin(), plan.named.end(), is_kin))
    return Contradiction::form;
  if (plan.query.sized && plan.query.size && plan.usual &&
      contradicts_size(asset, plan.usual->size, *plan.query.size,
                       most_off_of(plan, asset, vocabulary)))
    return Contradiction::form;
  return contradiction(asset, plan.looks, vocabulary, [&](const std::string& word) {
    const auto at = std::find(plan.words.begin(), plan.words.end(), singular(word));
    const auto index = static_cast<std::size_t>(at - plan.words.begin());
    return at != plan.words.end() && found[index].found > 0.0;
  });
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

}  // namespace

SearchPlan plan_search(const AssetQuery& query, const Vocabulary& vocabulary) {
  SearchPlan plan;
  plan.query = query;
  const std::string& asked = query.category.empty() ? query.description : query.category;
  const KindPhrase phrase = own_name(query.category, query.description, vocabulary);
  plan.looks = wanted_looks(query.description.empty() ? asked : query.description);
  for (const auto& kind : {phrase.kind, asked})
    if (const auto need = AttributeWords::built_in().need_of(kind); !need.empty())
      plan.looks.making.push_back(need);
  if (phrase.known) {
    const KindPhrase general = vocabulary.understand(asked);
    const bool serves = vocabulary.fit(phrase.kind, general.kind) > 0.0;
    const std::string& kind = serves ? general.kind : phrase.kind;
    plan.named = {phrase.kind};
    add_kinds_with_parts(kind, plan.looks, vocabulary, plan.named);
    plan.kinds = fitting_kinds(kind, query, plan.named, vocabulary);
  } else if (!words(phrase.kind).empty()) {
    plan.free_kind = phrase.kind;
  }
  plan.words = telling_words(query, phrase, vocabulary);
  plan.formality = formality_of(plan.words);
  plan.usual = KindTable::built_in().find(query.category.empty() ? phrase.kind : query.category);
  return plan;
}

Result<std::vector<AssetMatch>> run_search(const std::vector<const Database*>& databases,
                                           const SearchPlan& plan, const Vocabulary& vocabulary) {
  std::vector<AssetMatch> matches;
  if (plan.kinds.empty() && plan.free_kind.empty()) return matches;
  const WordIndex words = look_up_all(databases, plan, vocabulary);
  for (std::size_t i = 0; i < databases.size(); ++i) {
    Statement rows = candidates(*databases[i], plan);
    while (rows.step()) {
      AssetMatch match{row_of(rows).info, 0.0};
      const long long row = rows.integer(22);
      match.score =
          match_score({kind_term(plan, match.asset, vocabulary),
                       text_relevance(words.found(i, row)),
                       size_term(plan, match.asset), mount_term(plan, match.asset, vocabulary)}) *
          quiet_term(plan, match.asset, vocabulary) * beauty_term(plan, match.asset);
      if (match.score <= 0.0) continue;
      match.contradicts = contradiction_of(plan, match.asset, words.found(i, row), vocabulary);
      match.asset.mount = plan.query.mount.value_or(match.asset.mount);
      matches.push_back(std::move(match));
    }
    if (auto status = rows.status(); !status) return status.error();
  }
  rank(matches, plan.query.limit);
  return matches;
}

}  // namespace roomgen::assets
