#pragma once

#include <map>
#include <string>
#include <vector>

#include "database.h"
#include "library/looks.h"
#include "library/vocabulary.h"
#include "roomgen/library/library.h"

namespace roomgen::assets {

/// A query, understood: which kinds would do and how well, and which words tell the better ones.
struct SearchPlan {
  std::map<std::string, double> kinds;  ///< category to fit in (0, 1]
  std::string free_kind;                ///< instead of kinds: a phrase that the vocabulary lacks
  std::vector<std::string> words;       ///< of the description, singular
  AssetQuery query;
  WantedLooks looks;
  std::optional<double> formality;  ///< of the styles among the words
  const Kind* usual = nullptr;     ///< the kind that was asked for; null if unknown
  std::vector<std::string> named;  ///< kinds of which a thing must be one to be what was said
};

SearchPlan plan_search(const AssetQuery& query, const Vocabulary& vocabulary);

/// The assets of several catalogues that fit, best first, at most as many as the query wants.
Result<std::vector<AssetMatch>> run_search(const std::vector<const Database*>& databases,
                                           const SearchPlan& plan, const Vocabulary& vocabulary);

}  // namespace roomgen::assets
