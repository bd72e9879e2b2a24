#pragma once

#include <functional>
#include <map>
#include <vector>

#include "clause.h"

namespace roomgen {

/// Reads a clause of a text from a token on; it may order the words before the clause's end otherwise, or leave some out.
using ReadWithin = std::function<ReadClause(EditText& text, std::size_t at)>;

/// Whose walls, windows and things clauses about a dwelling speak of. A clause that says it ("paint the walls of the
/// kitchen", "the bathroom floor", "in both bedrooms, …") is read without these words in a scene of that room alone, and
/// so are those behind it in the sentence. Of walls and openings that no word places, the things that are named tell.
class RoomScopes {
 public:
  explicit RoomScopes(const Scene& scene);

  ReadClause read(EditText& text, std::size_t at, const ReadWithin& read);
  /// A new sentence begins.
  void forget() { standing_.clear(); }

 private:
  /// A text that speaks of rooms, in other words.
  struct Wording {
    EditText text;
    std::size_t begin = 0;  ///< of what is worded otherwise
    Ids rooms;
    bool plural = false;
    std::string named;
  };

  ReadClause read_in(const Ids& rooms, const EditText& text, std::size_t at, const ReadWithin& read) const;
  ReadClause read_as(const EditText& text, const Wording& wording, std::size_t at, const ReadWithin& read);
  ReadClause read_implied(const EditText& text, std::size_t at, const ReadWithin& read, const ReadClause& plain) const;
  ReadClause read_wordings(const EditText& text, std::size_t at, const std::vector<Wording>& wordings,
                           const ReadWithin& read, const ReadClause& plain);
  static std::vector<Wording> wordings(const EditText& text, std::size_t at);

  std::map<std::string, Scene> parts_;  ///< of a dwelling, by room
  Ids standing_;                        ///< rooms of the clause before
};

}  // namespace roomgen
