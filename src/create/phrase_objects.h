#pragma once

#include <optional>
#include <string>
#include <vector>

#include "attributes.h"
#include "phrase_measure.h"
#include "words.h"

namespace roomgen::create {

/// What holds for the nouns to come.
struct PhraseContext {
  std::string boundary;              ///< the last word that ended a noun phrase
  bool negated = false;              ///< "without"
  bool indefinite = false;           ///< the last article was "a"
  const Placement* place = nullptr;  ///< says where the parts to come are
};

/// The things that a sentence has named so far, and what was said of them and their parts. The
/// first is the head: parts are its own.
class PhraseObjects {
 public:
  /// The kinds must outlive it.
  PhraseObjects(const std::string& prompt, const ShapeKinds& kinds)
      : prompt_(prompt), kinds_(kinds) {}

  bool empty() const { return objects_.empty(); }
  std::size_t size() const { return objects_.size(); }
  /// Null before it is named.
  Description* head() { return empty() ? nullptr : &objects_.front(); }
  /// What was named last, if that is a part of the head; else null.
  PartWish* last_part();

  /// Said, and not yet of anything.
  Attributes& pending() { return pending_; }
  /// Words of the noun phrase of which nothing is known.
  std::vector<std::string>& unknown() { return unknown_; }

  /// What was said since the last noun belongs to it; unknown words make a noun of their own.
  void flush(const PhraseContext& context);
  /// All that was said before an object was named is said of it.
  void add(Description object, int usual_count);
  /// A thing of no known kind: the nearest one stands for it, if any is near.
  void add_unknown();
  /// "a tower with four windows": no other thing is named, so the part is the thing.
  void add_early_part();
  /// `last_word`: with which it was named.
  void add_part(const std::string& label, const std::string& last_word, PhraseContext& context);
  void measure(const Measure& measure);
  /// How what was named last stands to the head.
  void relate(const std::string& relation);

  /// All of them, and one if nothing was named.
  std::vector<Description> finish(const PhraseContext& context);

 private:
  void add_unknown_noun(const PhraseContext& context);
  void take_measures(Description& object);
  void doubt_kind(Description& object) const;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const std::string& prompt_;
  const ShapeKinds& kinds_;
  std::vector<Description> objects_;
  std::vector<PartWish> early_;  ///< parts named before their object
  Attributes pending_;
  std::vector<std::string> unknown_;
  std::optional<Vec3> measured_;  ///< sides of the next object
  std::size_t part_ = none;       ///< of the head, what was named last
};

}  // namespace roomgen::create
