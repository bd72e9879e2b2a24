#pragma once

#include <optional>
#include <string>
#include <vector>

#include "attributes.h"
#include "kinds.h"
#include "language/parse.h"
#include "part_forms.h"

namespace roomgen::create {

/// A sentence that was parsed, and what its words are to objects. Places beyond the end hold
/// nothing.
class PhraseText {
 public:
  /// All must outlive it.
  PhraseText(const std::string& prompt, const Words& words, const PartForms& parts,
             const ShapeKinds& kinds);

  const language::Parse& parse() const { return parse_; }
  std::size_t size() const { return texts_.size(); }
  /// In lower case; "," stands for every mark.
  const std::string& operator[](std::size_t at) const;
  bool is(std::size_t at, std::string_view word) const { return (*this)[at] == word; }
  bool starts(std::size_t at, const std::vector<std::string>& phrase) const;
  std::string joined(std::size_t begin, std::size_t end) const;

  /// Words that mean something.
  template <typename T>
  struct Match {
    std::size_t begin = 0, end = 0;  ///< tokens
    T meaning{};

    explicit operator bool() const { return end > begin; }
    std::size_t length() const { return end - begin; }
  };
  /// The longest run from a place on that is in the map.
  template <typename T>
  Match<const T*> longest(const WordMap<T>& map, std::size_t at, std::size_t end) const {
    for (std::size_t last = std::min({end, at + most_run, size()}); last > at; --last)
      if (const auto found = map.find(joined(at, last)); found != map.end())
        return {at, last, &found->second};
    return {};
  }

  /// The longest name of a kind that ends with the phrase's head, or goes on behind it: "chest of
  /// drawers".
  Match<const ShapeKind*> kind(const language::NounPhrase& phrase) const;
  /// The label of a part that the phrase names: one that the thing (null: none yet) has, if its
  /// words may mean several. "A back panel" is the back of what has no panels.
  Match<std::string> part(const language::NounPhrase& phrase, const Description* head) const;
  /// A modifier's part: "three-legged", "glass-topped".
  Match<std::string> owned_part(std::size_t at, std::size_t end) const;
  bool has_part(const Description* head, const std::string& label) const;

  /// Adds what the words say of a thing: how it is shaped and built, how strongly, a style, a
  /// material, a size, a direction or a colour. How many words that are; 0 if none.
  std::size_t read_attribute(std::size_t at, std::size_t end, Attributes& to) const;
  /// Nothing but attributes: "dark green velvet".
  bool is_attribute(const language::NounPhrase& phrase) const;
  /// Where the words of a phrase begin, behind its article and its number.
  std::size_t content(const language::NounPhrase& phrase) const;
  /// The head, or the word behind it where that is the part: "ladder back".
  std::size_t last_word(const language::NounPhrase& phrase) const;

 private:
  static constexpr std::size_t most_run = 3;

  Match<std::vector<std::string>> labels(std::size_t begin, std::size_t end) const;
  std::size_t read_form(std::size_t at, std::size_t end, Attributes& to) const;

  const Words& words_;
  const PartForms& parts_;
  const ShapeKinds& kinds_;
  language::Parse parse_;
  std::vector<std::string> texts_;
};

/// The number of things that a phrase says: nothing for articles, vague numbers and more than can
/// be.
std::optional<int> count_of(const language::NounPhrase& phrase);
/// Whether what a noun names can be a part: not people, times, measures or feelings.
bool may_be_part(const std::string& noun);

inline constexpr int most_count = 50;

/// The lengths that begin there, with the side that a word before them says: "height 50 cm".
/// Nothing if there are none with a unit.
std::optional<language::Measure> read_measure(const PhraseText& text, std::size_t at);

/// What a measure says of width, depth and height; NaN where it says nothing.
Vec3 sides(const language::Measure& measure);

/// "a top 2 cm thick", "legs 5 cm thick", "a back two metres tall".
void apply(const language::Measure& measure, PartWish& part);

/// The longest phrase of place that begins there: "hanging from"; null if none does.
const Placement* placement_at(const PhraseText& text, std::size_t at, const Words& words);

/// What it says of the part before it and of the part after it.
void place_before(const Placement& placement, PartWish& part);
void place_after(const Placement& placement, PartWish& part);

/// Where a part is that stands so to the thing itself: "a lamp on it".
Place place_of(const std::string& relation);

/// "forty-five degrees against the one below" from `at`, which moves behind it; 0 if it is none.
double read_turn(const PhraseText& text, std::size_t& at);

}  // namespace roomgen::create
