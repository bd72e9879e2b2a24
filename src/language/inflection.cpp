#include "inflection.h"

#include <algorithm>
#include <array>

#include "lexicon.h"

namespace roomgen::language {

namespace {

// With something before it: "movies" ends in "s", "is" does not.
bool ends(std::string_view word, std::string_view ending) {
  return word.size() > ending.size() + 1 && word.ends_with(ending);
}

std::string replaced(std::string_view word, std::size_t ending, std::string_view by) {
  return std::string(word.substr(0, word.size() - ending)) + std::string(by);
}

bool is_vowel(char c) {
  return std::string_view("aeiou").find(c) != std::string_view::npos;
}

bool is_noun(std::string_view word) {
  return lexicon().has(word, PartOfSpeech::noun);
}

// What an ending may be made of.
struct Rule {
  std::string_view ending, by;
};

constexpr std::array<Rule, 10> noun_rules = {{{"ves", "f"},
                                              {"ves", "fe"},
                                              {"ies", "y"},
                                              {"men", "man"},
                                              {"ches", "ch"},
                                              {"shes", "sh"},
                                              {"sses", "ss"},
                                              {"xes", "x"},
                                              {"zes", "z"},
                                              {"oes", "o"}}};

void add(std::vector<std::string>& list, std::string word) {
  if (std::find(list.begin(), list.end(), word) == list.end()) list.push_back(std::move(word));
}

// By the ending alone, the likeliest first: what English does with words that nobody knows.
std::vector<std::string> by_ending(std::string_view word) {
  std::vector<std::string> forms;
  for (const auto& rule : noun_rules)
    if (ends(word, rule.ending) && rule.by != "f" && rule.by != "fe" && rule.by != "man")
      forms.push_back(replaced(word, rule.ending.size(), rule.by));
  if (ends(word, "s") && !ends(word, "ss") && !ends(word, "us") && !ends(word, "is"))
    add(forms, replaced(word, 1, ""));
  return forms;
}

std::vector<std::string> known_singulars(std::string_view word) {
  std::vector<std::string> forms;
  for (const auto base : lexicon().irregular_bases(word, PartOfSpeech::noun))
    add(forms, std::string(base));
  if (!forms.empty()) return forms;
  if (ends(word, "s") && !ends(word, "ss"))
    if (auto form = replaced(word, 1, ""); is_noun(form)) add(forms, std::move(form));
  for (const auto& rule : noun_rules)
    if (ends(word, rule.ending))
      if (auto form = replaced(word, rule.ending.size(), rule.by); is_noun(form))
        add(forms, std::move(form));
  if (ends(word, "es"))
    if (auto form = replaced(word, 2, ""); ends(form, "s") && is_noun(form))
      add(forms, std::move(form));
  return forms;
}

// "glasses" are mostly what one drinks from, a "lens" is nothing but a lens: of two nouns the one
// that is met more often.
bool is_own_noun(std::string_view word, const std::vector<std::string>& forms) {
  if (!is_noun(word)) return false;
  const auto tagged = [](std::string_view noun) {
    return lexicon().tagged(noun, PartOfSpeech::noun);
  };
  return forms.empty() || std::all_of(forms.begin(), forms.end(), [&](const auto& form) {
           return tagged(form) < tagged(word);
         });
}

std::vector<std::string> forms_of_word(std::string_view word) {
  auto forms = known_singulars(word);
  if (is_own_noun(word, forms)) {
    forms.insert(forms.begin(), std::string(word));
    return forms;
  }
  if (forms.empty()) forms = by_ending(word);
  // Nothing is in the plural that has no singular.
  if (forms.empty() || is_noun(word)) add(forms, std::string(word));
  return forms;
}

// "dining chairs": all but the last word, and the last.
std::pair<std::string_view, std::string_view> parts_of(std::string_view noun) {
  const auto space = noun.rfind(' ');
  if (space == std::string_view::npos) return {"", noun};
  return {noun.substr(0, space + 1), noun.substr(space + 1)};
}

std::string regular_plural(std::string_view word) {
  if (ends(word, "y") && !is_vowel(word[word.size() - 2])) return replaced(word, 1, "ies");
  if (word.ends_with("woman")) return replaced(word, 3, "men");
  for (const std::string_view ending : {"s", "x", "z", "ch", "sh"})
    if (ends(word, ending)) return std::string(word) + "es";
  return std::string(word) + "s";
}

// The ways in which a regular verb form is made, and what it is then.
struct VerbRule {
  std::string_view ending, by;
  VerbForm form;
};

constexpr std::array<VerbRule, 8> verb_rules = {{{"s", "", VerbForm::third_person},
                                                 {"ies", "y", VerbForm::third_person},
                                                 {"es", "", VerbForm::third_person},
                                                 {"ied", "y", VerbForm::past},
                                                 {"ed", "e", VerbForm::past},
                                                 {"ed", "", VerbForm::past},
                                                 {"ing", "e", VerbForm::gerund},
                                                 {"ing", "", VerbForm::gerund}}};

bool is_verb(std::string_view word) {
  return lexicon().has(word, PartOfSpeech::verb);
}

// "fitted" is made of "fit".
std::string undoubled(std::string_view stem) {
  const std::size_t n = stem.size();
  return n > 2 && stem[n - 1] == stem[n - 2] && !is_vowel(stem[n - 1])
             ? std::string(stem.substr(0, n - 1))
             : "";
}

VerbForm irregular_form(std::string_view word) {
  if (ends(word, "ing")) return VerbForm::gerund;
  return word.ends_with('s') ? VerbForm::third_person : VerbForm::past;
}

}  // namespace

std::vector<std::string> singulars(std::string_view noun) {
  const auto [before, last] = parts_of(noun);
  auto forms = forms_of_word(last);
  for (auto& form : forms) form.insert(0, before);
  return forms;
}

std::string singular(std::string_view noun) {
  const auto [before, last] = parts_of(noun);
  return std::string(before) + forms_of_word(last).front();
}

std::string plural(std::string_view noun) {
  const auto [before, last] = parts_of(noun);
  const auto irregular = lexicon().irregular_forms(last, PartOfSpeech::noun);
  const auto form = irregular.empty() ? regular_plural(last) : std::string(irregular.front());
  return std::string(before) + form;
}

bool is_plural(std::string_view noun) {
  return singular(noun) != noun;
}

std::optional<Verb> verb(std::string_view word) {
  const auto irregular = lexicon().irregular_bases(word, PartOfSpeech::verb);
  if (!irregular.empty()) return Verb{std::string(irregular.front()), irregular_form(word)};
  if (is_verb(word)) return Verb{std::string(word), VerbForm::base};
  std::optional<Verb> best;
  double most = -1.0;
  for (const auto& rule : verb_rules) {
    if (!ends(word, rule.ending)) continue;
    const std::string stem = replaced(word, rule.ending.size(), rule.by);
    for (const std::string& base : {stem, rule.by.empty() ? undoubled(stem) : std::string()}) {
      if (!is_verb(base)) continue;
      if (const double tagged = lexicon().tagged(base, PartOfSpeech::verb); tagged > most) {
        most = tagged;
        best = Verb{base, rule.form};
      }
    }
  }
  return best;
}

std::optional<std::string> positive(std::string_view adjective) {
  const auto irregular = lexicon().irregular_bases(adjective, PartOfSpeech::adjective);
  if (!irregular.empty()) return std::string(irregular.front());
  for (const std::string_view ending : {"iest", "ier", "est", "er"}) {
    if (!ends(adjective, ending)) continue;
    const std::string_view by = ending[0] == 'i' ? "y" : "";
    const std::string stem = replaced(adjective, ending.size(), by);
    for (const std::string& base : {stem, stem + "e", undoubled(stem)})
      if (!base.empty() && lexicon().has(base, PartOfSpeech::adjective)) return base;
  }
  return std::nullopt;
}

}  // namespace roomgen::language
