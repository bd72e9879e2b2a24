#pragma once

#include <array>
#include <string>
#include <vector>

#include "candidates.h"
#include "parse.h"
#include "units.h"
#include "word_tag.h"

namespace roomgen::language {

/// What is known of a unit whatever is around it.
struct UnitFacts {
  std::string word;  ///< of a hyphened one its last part
  std::string key;   ///< a small word itself, of others what they may be: coarse
  std::string rate;  ///< key, and what it is mostly
  Candidates may_be;
  bool is_plural_number = false;
  bool is_hyphened = false;
  bool begins_compound = false;  ///< with the next word a known noun: "writing desk"
  bool ends_name = false;        ///< of a thing, and a phrase: "..., and a plant stand."
  bool ends_compound = false;    ///< a small word that is the head of a known noun: "watering can"
};

/// `is_name` as parse() has it; it may be empty.
std::vector<UnitFacts> facts_of(const std::vector<Token>& tokens, const std::vector<Unit>& units,
                                const IsName& is_name = {});

/// What was read before a unit: the noun phrase and the clause that are open.
class TagContext {
 public:
  void add(const Unit& unit, const UnitFacts& facts, WordTag tag);

  enum class Number : char { unsaid = '0', one = '1', several = '2', definite = '3' };
  char number() const { return static_cast<char>(number_); }
  char nouns() const { return nouns_; }
  char verbs() const { return verbs_; }
  char last() const { return last_; }
  char before_last() const { return before_last_; }
  /// Whether the phrase is of one thing alone, none of a list.
  bool is_singular() const {
    return (number_ == Number::one || number_ == Number::definite) && nouns_ == '1' &&
           opener_ != 'C';
  }
  /// Whether the phrase has a number of several, but no plural yet.
  bool is_short_of_plural() const { return number_ == Number::several && nouns_ == '1'; }
  bool awaits_noun() const { return awaits_noun_; }

 private:
  void end_phrase();

  Number number_ = Number::unsaid;
  char nouns_ = '0';  ///< of the phrase: 0 none, 1 singular, 2 plural
  char verbs_ = '0';  ///< of the clause: 0 none, 1 one, 2 one and a comma or conjunction since
  char last_ = '.', before_last_ = '.';
  char opener_ = '.';  ///< what stands before the phrase
  bool awaits_noun_ = false;
};

/// Hashes of what the choice of a tag is made by.
using TagFeatures = std::array<std::uint32_t, 26>;

TagFeatures tag_features(const std::vector<UnitFacts>& facts, std::size_t at,
                         const TagContext& context);

}  // namespace roomgen::language
