#include "qualifiers.h"

#include <algorithm>

#include "attribute_words.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace {

using WordList = std::vector<std::string>;

bool is_listed(const std::string& word, std::string_view list) {
  return list.find(" " + word + " ") != std::string_view::npos;
}

// What follows says of what the thing is made or what it has, what is about other things, and parts
// that stand for the whole: "an oak desk with a white top" is white.
constexpr const char* leads_on =
    " with and plus having has both including featuring of in made painted upholstered clad ";
constexpr const char* leads_away =
    " for on beside near under above below over to at by from behind next before between around "
    "against along after inside full holding hanging standing leaning lying without no instead "
    "matching that which is where ";
constexpr const char* whole = " top tabletop shape seat body cover upholstery front outline ";

struct Clause {
  std::string lead;  ///< "with"; empty for the first, "," behind a comma
  WordList words;

  bool may_name() const { return lead.empty() || lead == ","; }
};

std::vector<Clause> clauses_of(std::string_view description, const Vocabulary& vocabulary) {
  std::vector<Clause> clauses(1);
  std::string text;
  for (const char c : description)
    text += std::string_view(",;()").find(c) == std::string_view::npos ? std::string(1, c) : " , ";
  for (const auto& piece : split(text, ' ')) {
    if (piece == ",") clauses.push_back({piece, {}});
    for (auto& word : words(piece)) {
      if (is_listed(word, leads_on) || is_listed(word, leads_away))
        clauses.push_back({word, {}});
      else if (!vocabulary.is_filler(word))
        clauses.back().words.push_back(std::move(word));
    }
  }
  std::erase_if(clauses, [](const Clause& clause) { return clause.words.empty(); });
  return clauses;
}

// Words that are about a thing of this noun, and not about one of its parts.
bool is_about_it(const Clause& clause, const std::string& noun, const Vocabulary& vocabulary) {
  const std::string last = singular(clause.words.back());
  if (last == singular(noun) || is_listed(last, whole)) return true;
  const auto* meaning = AttributeWords::built_in().find(clause.words.back());
  // "armchair, forest green wool"
  if (clause.lead == "," && meaning && meaning->of_looks()) return true;
  const bool is_part = !clause.lead.empty() && meaning && meaning->of_making();
  return !is_part && vocabulary.is_modifier(last);
}

// The name is in the singular.
WordList leave_out_name(WordList all, const WordList& name) {
  const auto found = std::search(all.begin(), all.end(), name.begin(), name.end(),
                                 [](const auto& word, const auto& one) { return singular(word) == one; });
  if (!name.empty() && found != all.end())
    all.erase(found, found + static_cast<std::ptrdiff_t>(name.size()));
  return all;
}

// "a toy triceratops from the museum": of what is asked for, the sort that the words name last.
KindPhrase sort_named_in(const std::string& head, const KindPhrase& asked,
                         const Vocabulary& vocabulary) {
  KindPhrase sort = asked;
  for (const auto& kind : vocabulary.mentioned(head))
    if (kind != asked.kind && vocabulary.is_a(kind, asked.kind)) sort = {kind, kind, true};
  return sort;
}

// "a pile of old books", if that is the name of a kind. A "statue of a horse" may be what its category says.
KindPhrase described_kind(const std::vector<Clause>& clauses, const std::string& head,
                          const Vocabulary& vocabulary) {
  if (clauses.size() < 2 || clauses[1].lead != "of") return vocabulary.understand(head);
  const Kind* pair =
      vocabulary.find(clauses[0].words.back() + " of " + clauses[1].words.back());
  return pair ? KindPhrase{pair->name, pair->name, true} : KindPhrase{};
}

}  // namespace

Qualifiers qualify(std::string_view description, const Vocabulary& vocabulary) {
  Qualifiers result;
  std::string noun;
  bool is_away = false;
  for (const auto& clause : clauses_of(description, vocabulary)) {
    const bool goes_on = is_away && is_listed(clause.lead, " and of ");
    const bool is_place = clause.words == WordList{"front"};
    is_away = !clause.may_name() && (goes_on || is_listed(clause.lead, leads_away) || is_place);
    if (is_away) continue;
    const bool is_first = noun.empty() && clause.may_name();
    auto& about = is_first || is_about_it(clause, noun, vocabulary) ? result.own : result.parts;
    about.insert(about.end(), clause.words.begin(), clause.words.end());
    if (!is_first) continue;
    result.head += (result.head.empty() ? "" : " ") + join(clause.words, " ");
    const bool is_named = vocabulary.understand(result.head).known;
    if (is_named || !vocabulary.is_modifier(clause.words.back())) noun = clause.words.back();
  }
  const KindPhrase name = vocabulary.understand(result.head);
  result.own = leave_out_name(result.own, words(name.known ? name.name : singular(noun)));
  return result;
}

KindPhrase own_name(std::string_view category, std::string_view description,
                    const Vocabulary& vocabulary) {
  const std::string head = qualify(description, vocabulary).head;
  const auto described = described_kind(clauses_of(description, vocabulary), head, vocabulary);
  if (category.empty()) return described.known ? described : vocabulary.understand(description);
  const KindPhrase asked = vocabulary.understand(category);
  if (!asked.known || (described.known && category.ends_with(described.name))) return asked;
  if (!described.known) return sort_named_in(head, asked, vocabulary);
  if (vocabulary.is_a(described.kind, asked.kind)) return described;
  // Not what is more general, nor a stuff; a "base cabinet with a sink" is the sink unit that is asked for.
  const bool is_less = vocabulary.fit(asked.kind, described.kind) > 0.0 ||
                       vocabulary.is_modifier(described.name) || described.name.ends_with(category);
  return is_less || !AttributeWords::built_in().need_of(asked.kind).empty() ? asked : described;
}

}  // namespace roomgen
