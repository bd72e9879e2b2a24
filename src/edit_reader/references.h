#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brief/kind_mention.h"
#include "edit_text.h"
#include "language/measure.h"

namespace roomgen {

/// Words that name things: "the left chair", "both armchairs", "it", "two more stools", "everything".
struct NamedThing {
  enum class Which {
    definite,    ///< the, my, no article at all
    indefinite,  ///< a, another, two more: may bring something new
    all,         ///< all, every, both
    pronoun,
    everything
  };

  Which which = Which::definite;
  bool bare = false;     ///< no article: "bin by the door"
  bool further = false;  ///< "another", "two more", "a second"
  bool any = false;      ///< "one of the armchairs": whichever
  bool other = false;    ///< "the other lamp": not the one spoken of
  bool plural = false;
  int count = 0;  ///< 0: not said
  brief::KindMention kind;
  bool middle = false;   ///< "the middle stool"
  bool by_meaning = false;  ///< the noun is no name of its kind: "the fire"
  std::vector<language::Measure> measures;  ///< "3 m long", of new things
  std::vector<std::string> looks;  ///< adjectives as said: "brass"
  std::string tail;                ///< of new things: "with a gold frame"
  std::optional<int> number;       ///< of an id: "chair-2"
  std::optional<int> place;        ///< "chair number two": which of them, from 1
  std::optional<int> nth;          ///< "the second from the left": counted from a side
  std::optional<Vec2> side;        ///< "left"
  double share = 0.0;              ///< "half of the chairs"
  double size = 0.0;               ///< EditVocabulary::sizes
  std::size_t begin = 0, end = 0;  ///< tokens

  std::optional<Vec3> told_size() const;
  /// "tall brass floor lamp with a linen shade"
  std::string description() const;
};

/// What measures make of the size of things of a kind; nothing without measures.
std::optional<Vec3> measured_size(const Kind& kind, const std::vector<language::Measure>& measures);

std::optional<NamedThing> named_thing_at(const EditText& text, std::size_t at);
/// "all six of the", "another", "two more": the token behind, and what they say.
std::size_t skip_determiners(const EditText& text, std::size_t at, NamedThing& thing);

/// "3 m", "1.2 x 0.6 m", "80 cm wide": how large a thing is.
std::optional<language::Measure> measure_of_thing(const EditText& text, std::size_t at);

/// The things of the scene that the words mean, one or several as they say. not_understood, with the choices,
/// where they may mean others as well; `among` narrows them down (null: all that the room has).
Result<std::vector<std::string>> meant(const EditText& text, const NamedThing& thing,
                                       const std::vector<std::string>* among = nullptr);
/// All that the name fits, whatever the number.
std::vector<std::string> fitting(const EditText& text, const NamedThing& thing);

}  // namespace roomgen
