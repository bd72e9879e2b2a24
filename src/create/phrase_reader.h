#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "language/parse.h"
#include "phrase_objects.h"
#include "phrase_text.h"

namespace roomgen::create {

/// Reads the parse of a sentence from its first word to its last: noun phrases name things and
/// parts, which the attachments join; what stands between them is said of what was named before, or
/// of the subject of its verb. What it reads of one sort stands in a file of its own:
/// phrase_names.cpp, phrase_reference.cpp, phrase_between.cpp.
class PhraseReader {
 public:
  PhraseReader(const std::string& prompt, const Words& words, const ShapeKinds& kinds)
      : words_(words),
        kinds_(kinds),
        text_(prompt, words, *built_in_parts(), kinds),
        parse_(text_.parse()),
        objects_(prompt, kinds),
        named_(parse_.phrases.size()) {}

  std::vector<Description> run();

 private:
  const language::NounPhrase& phrase(std::size_t i) const { return parse_.phrases[i]; }

  // What joins phrases.
  const language::Attachment* joins(std::size_t i) const;
  std::string relation_to(std::size_t i) const {
    const language::Attachment* joint = joins(i);
    return joint ? joint->relation : "";
  }
  bool is_owned(std::size_t i) const;
  Referent subject_at(std::size_t token) const;
  void read_phrase(std::size_t i);
  Attributes attributes(std::size_t i, std::size_t name_begin, std::size_t name_end,
                        std::vector<NamedPart>* owned);
  std::size_t read_owned(std::size_t at, std::size_t end, std::vector<NamedPart>* owned);
  void measure_of(const language::NounPhrase& said, const Referent& of);

  // Noun phrases that name something.
  std::size_t find_head() const;
  bool stands_alone(std::size_t i) const;
  bool says_nothing(const language::NounPhrase& said) const;
  bool is_arranged(std::size_t i) const;
  void name_thing(std::size_t i);
  std::size_t noun_begin(std::size_t i) const;
  void add_object(std::size_t i, const PhraseText::Match<const ShapeKind*>& kind);
  bool tells_use(std::size_t i) const;
  void name_other(std::size_t i);
  bool has_relation(std::size_t i) const;
  bool is_unknown_part(std::size_t i) const;
  void name_part(std::size_t i, const std::string& label, std::size_t begin, std::size_t end);
  bool is_left_out(std::size_t i) const;

  // Noun phrases that name nothing new.
  void stand_for(std::size_t i);
  void count_first(int count);
  void count_some(std::size_t i, int count);
  void read_likeness(std::size_t i);
  // "legs that are boards", "the seat is a wave": said of the subject.
  bool is_predicate(std::size_t i) const { return subject_of_being(i).has_value(); }
  std::optional<Referent> subject_of_being(std::size_t i) const;
  void read_predicate(std::size_t i);
  void specialise(std::size_t i);

  // Between noun phrases.
  bool arrange(std::size_t i);
  bool is_arrangement(std::size_t i) const;
  void arrange(Place place, const std::string& noun);
  void release();
  bool phrase_of_place();
  bool starts_phrase(std::size_t token) const;
  void relate(const std::string& relation);
  bool simile();
  bool measure();
  void read_between();

  const Words& words_;
  const ShapeKinds& kinds_;
  PhraseText text_;
  const language::Parse& parse_;
  PhraseObjects objects_;
  std::vector<Referent> named_;  ///< by noun phrase
  std::size_t head_ = 0;         ///< the noun phrase that names the thing itself
  std::size_t at_ = 0;
  std::size_t measured_ = 0;          ///< where the last measure ended
  Referent last_;                     ///< what was named last
  Referent target_;                   ///< of what is pending
  Attributes pending_;                ///< said, and not yet of anything
  const Placement* place_ = nullptr;  ///< says where the parts to come are
  Placement arranged_;                ///< of the last arrangement
  bool likeness_ = false;             ///< what comes is only compared with
};

}  // namespace roomgen::create
