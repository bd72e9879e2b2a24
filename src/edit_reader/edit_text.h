#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "brief/tokens.h"
#include "edit/edit_vocabulary.h"
#include "language/token.h"
#include "roomgen/edit/session.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"

namespace roomgen {

/// A sentence with all that is needed to read it. `mentioned` grows while it is read.
struct EditText {
  using Token = brief::Token;

  const Scene& scene;
  const KindTable& kinds;
  const EditVocabulary& edits;
  const brief::Vocabulary& words;
  std::vector<language::Token> raw;
  std::vector<Token> tokens;             ///< one for each of `raw`
  std::vector<std::string> mentioned;    ///< ids spoken of so far, the last one last
  std::vector<std::string> latest;       ///< those of the last clause: "it", "them"
  std::vector<Object> coming;            ///< things that earlier clauses add, without a place
  std::vector<std::string> gone;         ///< ids of what the last clause that removed something removed
  Recall recall;
  int depth = 0;                         ///< of words that tell what other such words are about

  /// The one room; in a dwelling of several none is meant before words say which (RoomScopes), and this one has no
  /// walls.
  const Room& room() const { return scene.rooms.size() > 1 ? scene.room : rooms_of(scene).front(); }
  bool is_comma(std::size_t at) const { return at < tokens.size() && tokens[at].kind == Token::Kind::comma; }
  /// A comma, or the end of a sentence or of all.
  bool is_mark(std::size_t at) const {
    return at >= tokens.size() || is_comma(at) || tokens[at].kind == Token::Kind::stop;
  }
  /// A comma that may stand there is passed over.
  std::size_t behind_comma(std::size_t at) const { return is_comma(at) ? at + 1 : at; }
  bool is_word(std::size_t at, std::string_view word) const { return at < tokens.size() && tokens[at].is_word(word); }
  /// Ends here what belongs together: a mark, "and", "then", or the end.
  bool ends(std::size_t at) const;
  /// Is the "so" there one of degree?
  bool says_how_much(std::size_t at) const;
  /// Behind "as possible", "as you can", where that follows.
  std::size_t end_of_most(std::size_t at) const;
  /// As written.
  std::string words_from(std::size_t begin, std::size_t end) const;
  const Object* object(std::string_view id) const;
};

/// The same words, said of another scene: a part of the one before. What was spoken of and is not there is forgotten.
EditText in_scene(const EditText& text, const Scene& scene);

/// not_understood, for people.
Error not_understood(const std::string& what);

}  // namespace roomgen
