#pragma once

#include <string>
#include <vector>

#include "attributes.h"
#include "phrase_text.h"

namespace roomgen::create {

/// What words of a sentence stand for: a thing, or a part of one.
struct Referent {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t object = none;
  std::string label;  ///< of a part; empty: the whole

  explicit operator bool() const { return object != none; }
  bool is_part() const { return object != none && !label.empty(); }
};

/// How a part is named.
struct NamedPart {
  std::string label;
  Attributes said = {};
  bool is_denied = false;
  bool is_one = false;  ///< "a bucket"
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
  /// Null if it is none.
  PartWish* part(const Referent& referent);

  Referent add(Description object, Attributes said);
  /// A thing of no known kind: the nearest one stands for it, if any is near.
  Referent add_unknown(const std::string& noun, Attributes said);
  /// Of the head, or of the thing to come: "a two-drawer nightstand".
  Referent add_part(const NamedPart& named);
  void apply(const Attributes& said, const Referent& to);
  /// Of a thing or a part, or of the thing to come.
  void measure(const language::Measure& measure, const Referent& of);

  /// How another thing stands to the head.
  void relate(std::size_t object, const std::string& relation) {
    objects_[object].relation = relation;
  }

  /// All of them, and one if nothing was named.
  std::vector<Description> finish();

 private:
  void take_measures(Description& object);
  void doubt_kind(Description& object) const;

  const std::string& prompt_;
  const ShapeKinds& kinds_;
  std::vector<Description> objects_;
  std::vector<PartWish> early_;   ///< parts named before their object
  std::optional<Vec3> measured_;  ///< sides of the next object
};

}  // namespace roomgen::create
