#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "brief_json.h"
#include "kind_mention.h"
#include "prompt_words.h"
#include "quotes.h"

namespace roomgen::brief {

/// A member of a form, with the JSON pointer that tells where it stands.
struct FormNode {
  const Json* json = nullptr;
  std::string pointer;

  /// Null if there is none.
  FormNode operator[](const std::string& key) const;
  /// Those of a list, or the value alone; at most so many.
  std::vector<FormNode> elements(std::size_t most) const;
  /// Trimmed and bounded; of a number its digits; else empty.
  std::string text() const;
  std::optional<double> number() const;
  std::vector<double> numbers(std::size_t most) const;
  bool flag() const;
  explicit operator bool() const { return json != nullptr; }
};

/// What a form is read with.
struct FormContext {
  std::string_view prompt;
  const RoomKinds& kinds;
  const KindTable& table;
};

/// What the readers of a form's parts share.
struct Form {
  Form(FormNode root, const FormContext& context, BriefReading& result);

  /// The words that a clause quotes, as entries of Brief::heard. Tells of what is not in the wish.
  std::vector<std::size_t> hear(const FormNode& quotes, Heard::As as, const std::string& word,
                                std::uint32_t near);
  /// Those of a clause that one entry says; none if the wish does not.
  std::size_t hear_as_one(const FormNode& clause, Heard::As usual, std::uint32_t near);
  /// The tokens that name a thing: of the same words said again the next ones.
  std::vector<language::Run> next_words(const FormNode& quotes);
  std::size_t entry(const language::Run& tokens, Heard::As as, const std::string& word);

  /// What a clause says is kept in its own words, where no part of a brief can hold it; false if it
  /// quotes none.
  bool remark(const FormNode& clause, std::uint32_t near);

  void problem(const FormNode& node, const std::string& what);
  void repair(const std::string& what);

  const FormNode root;
  const Quotes quotes;
  const RoomKinds& kinds;
  const KindTable& table;
  BriefReading& result;
  Brief& brief;

 private:
  std::vector<std::string> quoted(const FormNode& node) const;
  /// From the first of the quotes to the last, as far as that is one clause.
  std::optional<language::Run> quoted_as_one(const FormNode& words, std::uint32_t near);

  std::map<std::string, std::uint32_t> read_up_to_;  ///< of quotes of things: behind the last place
};

/// The kind that a name means, with the words before it that say what sort it is: "coffee" of a
/// grinder.
struct FormName {
  KindMention kind;  ///< length 0: none is known
  std::vector<std::string> sort;
};
FormName name_in_form(const std::string& name, const KindTable& table);

/// "At least", "exact" ...
language::Measure::Limit bound_in_form(const FormNode& node);

/// What is said of things, and of how they stand.
void read_form_things(Form& form, const Vocabulary& words);

}  // namespace roomgen::brief
