#include "edit_words.h"

#include <algorithm>
#include <map>

#include "clause.h"
#include "corrections.h"
#include "edit_spelling.h"
#include "gaps.h"
#include "operations.h"
#include "roomgen/base/text.h"
#include "spoken_clause.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;
using Token = design::Token;

/// A sentence, clause by clause.
class EditReader {
 public:
  explicit EditReader(EditText text) : text_(std::move(text)) {}

  Result<Understanding> run() {
    for (skip_between(); at_ < text_.tokens.size(); skip_between()) {
      auto clause = read_clause();
      if (clause) clause->end = skip_reason(skip_closers(clause->end));
      if (!clause || !text_.ends(clause->end)) {
        if (skip_remark()) continue;
        if (!clause) return clause.error();
        return what_at(text_, clause->end, "not understood");
      }
      take(*std::move(clause));
    }
    if (understood_.operations.empty()) return not_understood("nothing in it says what to change");
    settle_places();
    return understood_;
  }

 private:
  // "now" ends a clause, but "now that" begins a reason.
  std::size_t skip_closers(std::size_t at) const {
    for (;;) {
      const auto length = longest_in(text_.edits.closers, text_.tokens, at);
      if (length == 0 || longest_in(text_.edits.reasons, text_.tokens, at) > length) return at;
      at += length;
    }
  }

  void skip_between() {
    for (;;) {
      if (at_ < text_.tokens.size() && text_.is_mark(at_)) {
        ++at_;
        continue;
      }
      if (const auto closer = longest_in(text_.edits.closers, text_.tokens, at_); closer > 0 && text_.is_mark(at_ + closer)) {
        at_ += closer;
        continue;
      }
      if (const auto question = begins_question(at_)) {
        at_ += question;
        continue;
      }
      // A verb that looks like an opener is a verb.
      const auto opener = longest_in(text_.edits.openers, text_.tokens, at_);
      const auto verb = verb_at(text_, at_);
      const auto substitute = longest_in(text_.edits.substitutes, text_.tokens, at_);
      if (is_no_of_thing(at_)) return;
      if (opener == 0 || substitute > opener || (verb && verb->length > opener)) return;
      at_ += opener;
    }
  }

  // "no rug please": nothing of it.
  bool is_no_of_thing(std::size_t at) const {
    if (!text_.is_word(at, "no")) return false;
    const auto thing = named_thing_at(text_, at + 1);
    return thing && thing->bare && thing->kind.category && !fitting(text_, *thing).empty() &&
           (text_.is_mark(thing->end) || longest_in(text_.edits.closers, text_.tokens, thing->end) > 0);
  }

  // "could the sofa go …": the question's verb before what it is about.
  std::size_t begins_question(std::size_t at) const {
    const auto length = longest_in(text_.edits.questions, text_.tokens, at);
    if (length == 0 || (at > 0 && !text_.is_mark(at - 1) && !text_.is_word(at - 1, "and"))) return 0;
    return named_thing_at(text_, at + length) || room_part_at(text_, at + length) ? length : 0;
  }

  // "it is draughty", "thanks a million"
  bool skip_remark() {
    const std::size_t end = end_of_remark(text_, at_, understood_.operations.empty());
    if (end == at_) return false;
    note_remark(at_, end);
    const std::size_t known = text_.mentioned.size();
    remember_names(end);
    if (text_.mentioned.size() > known) text_.latest = {text_.mentioned.back()};
    at_ = end;
    return true;
  }

  // "… now that we own a dryer": why, to the end of the sentence's part.
  std::size_t skip_reason(std::size_t at) {
    if (longest_in(text_.edits.reasons, text_.tokens, at) == 0) return at;
    std::size_t end = at;
    while (!text_.is_mark(end)) ++end;
    note_remark(at, end);
    return end;
  }

  void note_remark(std::size_t begin, std::size_t end) {
    understood_.remarks.push_back(text_.words_from(begin, end));
  }

  ReadClause read_order(const EditText& text, const SaidVerb& verb, std::size_t at) {
    last_meaning_ = verb.meaning;
    last_verb_ = verb.words;
    // "leaving the lamp where it is": what is not changed anyway.
    if (verb.inflected && verb.meaning == "keep") {
      auto kept = read_lock(text, at, true, true);
      if (kept) kept->operations.clear();
      return kept;
    }
    return read_verb(text, verb.meaning, verb.words, at);
  }

  ReadClause read_clause() {
    if (const auto reverse = longest_in(text_.edits.vice_versa, text_.tokens, at_); reverse > 0 && text_.ends(at_ + reverse))
      return read_vice_versa(reverse);
    if (longest_in(text_.edits.substitutes, text_.tokens, at_) > 0)
      if (auto instead = read_instead(text_, at_); goes_to_its_end(text_, instead)) return instead;
    if (auto likewise = read_likewise(); goes_to_its_end(text_, likewise)) return likewise;
    if (const auto verb = verb_at(text_, at_)) {
      auto clause = read_order(text_, *verb, at_ + verb->length);
      if (goes_to_its_end(text_, clause)) return clause;
      for (const auto& other : {read_with_particle(*verb), read_by_subject(), read_fragment(text_, at_)})
        if (goes_to_its_end(text_, other)) return other;
      return clause;
    }
    if (auto order = read_by_subject(); goes_to_its_end(text_, order)) return order;
    // "… and the dresser pale blue": the verb before goes on.
    if (!last_meaning_.empty())
      if (auto same = read_verb(text_, last_meaning_, last_verb_, at_); goes_to_its_end(text_, same)) return same;
    return read_fragment(text_, at_);
  }

  // "take the lamp down": the verb's other part behind what it is done to.
  // "… and the plant too": as it was done to the things before.
  ReadClause read_likewise() {
    const auto what = things(text_, at_, true);
    if (!what) return what.error();
    const auto too = longest_in(text_.edits.likewise, text_.tokens, what->end);
    if (too == 0 || understood_.operations.empty()) return what_at(text_, at_, "not understood");
    const auto& last = understood_.operations.back();
    const std::size_t end = what->end + too;
    if (const auto* move = std::get_if<edit::Move>(&last))
      return of_each(*what, end, [&](const std::string& id) { return edit::Move{id, move->relations}; });
    if (const auto* recolor = std::get_if<edit::Recolor>(&last))
      return of_each(*what, end, [&](const std::string& id) { return edit::Recolor{id, recolor->looks}; });
    if (const auto* face = std::get_if<edit::Face>(&last))
      return of_each(*what, end, [&](const std::string& id) { return edit::Face{id, face->target}; });
    if (std::holds_alternative<edit::Remove>(last)) return Clause{{edit::Remove{what->value, false}}, {}, {}, end, what->value};
    return what_at(text_, at_, "not understood");
  }

  ReadClause read_with_particle(const SaidVerb& verb) {
    const std::size_t begin = at_ + verb.length;
    for (const bool with_places : {false, true}) {
      const auto what = things(text_, begin, with_places);
      if (!what || longest_in(text_.edits.particles, text_.tokens, what->end) != 1) continue;
      const auto whole = text_.edits.verbs.find(verb.words + " " + text_.tokens[what->end].text);
      if (whole == text_.edits.verbs.end()) continue;
      auto clause = read_order(without(text_, what->end, what->end + 1), {whole->second, whole->first, verb.length, false}, begin);
      if (clause) ++clause->end;
      if (goes_to_its_end(text_, clause)) return clause;
    }
    return what_at(text_, at_, "not understood");
  }

  ReadClause read_by_subject() {
    auto order = clause_with_subject(text_, at_, [&](const EditText& text, const SaidVerb& verb, std::size_t at) {
      return read_order(text, verb, at);
    });
    return order ? *std::move(order) : what_at(text_, at_, "not understood");
  }

  // "take it off the stool and put it on the shelf" is one way.
  void drop_superseded(const Clause& clause) {
    for (const auto& later : clause.operations) {
      const auto* to = std::get_if<edit::Move>(&later);
      if (!to) continue;
      for (auto& earlier : understood_.operations)
        if (auto* gone = std::get_if<edit::Remove>(&earlier)) std::erase(gone->objects, to->object);
      std::erase_if(understood_.operations, [](const edit::Operation& earlier) {
        const auto* gone = std::get_if<edit::Remove>(&earlier);
        return gone && gone->objects.empty();
      });
      std::erase_if(understood_.operations, [&](const edit::Operation& earlier) {
        const auto* from = std::get_if<edit::Move>(&earlier);
        return from && from->object == to->object && from->relations.size() == 1 && from->relations.front().kind == RelationKind::far;
      });
    }
  }

  // "and vice versa", behind who goes where another stands
  ReadClause read_vice_versa(std::size_t length) {
    if (taken_over_.size() != 1) return what_at(text_, at_, "not understood");
    const auto [object, of] = *taken_over_.begin();
    const Object* there = text_.object(object);
    if (!there) return what_at(text_, at_, "not understood");
    Clause clause{{edit::Put{of, there->position.head<2>(), {}, there->on}}, {of}, {}, at_ + length};
    clause.in_place_of = object;
    return clause;
  }

  // All that the clause spoke of by name: "the table" behind it is one of these.
  void remember_names(std::size_t end) {
    for (std::size_t i = at_; i < end; ++i) {
      const auto thing = named_thing_at(text_, i);
      if (!thing || thing->which != Which::definite || thing->end > end) continue;
        if (const auto ids = things_at(text_, i, true); ids && *ids && (*ids)->value.size() == 1 && (*ids)->end <= end)
        text_.mentioned.push_back((*ids)->value.front());
    }
  }

  // "a round one that seats six, in pale ash": looks said behind what comes are those with which it comes.
  bool fold_looks(const Clause& clause) {
    auto& known = understood_.operations;
    if (known.empty() || clause.operations.empty() || clause.about != text_.latest) return false;
    for (const auto& operation : clause.operations)
      if (!std::holds_alternative<edit::Recolor>(operation)) return false;
    const std::string looks = std::get<edit::Recolor>(clause.operations.front()).looks;
    std::size_t folded = 0;
    for (auto& operation : known) {
      std::string* words = nullptr;
      if (auto* replace = std::get_if<edit::Replace>(&operation); replace && is_latest(replace->object)) words = &replace->description;
      if (auto* add = std::get_if<edit::Add>(&operation); add && &operation == &known.back()) words = &add->description;
      if (auto* recolor = std::get_if<edit::Recolor>(&operation); recolor && is_latest(recolor->object)) words = &recolor->looks;
      if (words) *words += " in " + looks, ++folded;
    }
    return folded > 0;
  }

  bool is_latest(const std::string& id) const { return std::count(text_.latest.begin(), text_.latest.end(), id) > 0; }

  // Who goes to a place that is taken waits until it is free; two that take each other's place swap.
  void settle_places() {
    for (const auto& [object, of] : taken_over_) {
      const bool is_mutual = taken_over_.count(of) && taken_over_.at(of) == object;
      std::erase_if(understood_.operations, [&](const edit::Operation& operation) {
        const auto* put = std::get_if<edit::Put>(&operation);
        return is_mutual && put && (put->object == object || put->object == of);
      });
      if (is_mutual && object < of) understood_.operations.push_back(edit::Swap{object, of});
    }
    std::stable_partition(understood_.operations.begin(), understood_.operations.end(), [&](const edit::Operation& operation) {
      const auto* put = std::get_if<edit::Put>(&operation);
      return !put || !taken_over_.count(put->object);
    });
  }

  void take(Clause clause) {
    remember_names(clause.end);
    at_ = clause.end;
    if (fold_looks(clause)) return;
    drop_superseded(clause);
    auto& operations = understood_.operations;
    operations.insert(operations.end(), clause.operations.begin(), clause.operations.end());
    if (!clause.in_place_of.empty()) taken_over_[clause.about.front()] = clause.in_place_of;
    if (!clause.gone.empty()) text_.gone = clause.gone;
    text_.mentioned.insert(text_.mentioned.end(), clause.about.begin(), clause.about.end());
    if (!clause.about.empty()) text_.latest = clause.about;
    text_.coming.insert(text_.coming.end(), clause.coming.begin(), clause.coming.end());
  }

  EditText text_;
  std::size_t at_ = 0;
  std::string last_meaning_, last_verb_;
  std::map<std::string, std::string> taken_over_;  ///< who goes where what stands
  Understanding understood_;
};

constexpr std::size_t most_bytes = 4000, most_words = 400;

bool says_in_remark(const Understanding& understood, const std::string& words) {
  return std::any_of(understood.remarks.begin(), understood.remarks.end(),
                     [&](const std::string& remark) { return remark.find(words) != std::string::npos; });
}

// What was taken back counts for nothing.
Result<Understanding> read_text(const EditText& text) {
  const auto correction = correction_in(text);
  if (!correction) return EditReader(text).run();
  const std::string instead = text.words_from(correction->end, correction->end + 2);
  for (const auto& shorter : corrected(text, *correction)) {
    auto understood = EditReader(shorter).run();
    if (understood && !says_in_remark(*understood, instead)) return understood;
  }
  return not_understood("it is not clear what \"" + text.words_from(correction->begin, correction->end) + "\" takes back");
}

// "20 %", "90°"
void spell_out(language::Token& token) {
  const std::pair<const char*, const char*> symbols[] = {{"%", "percent"}, {"°", "degrees"}, {"º", "degrees"}, {"&", "and"}};
  for (const auto& [symbol, word] : symbols)
    if (token.text == symbol) token.text = word, token.kind = language::Token::Kind::word;
}

// "-3 m wide"; not "chair-2", and not "2 - 3 m".
bool has_measure_below_zero(const std::vector<language::Token>& tokens) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool is_minus = tokens[i].text == "-" || tokens[i].text == "\u2212";
    const bool is_bound = tokens[i + 1].kind == language::Token::Kind::number &&
                          tokens[i].span.end == tokens[i + 1].span.begin;
    const bool is_free = i == 0 || (tokens[i - 1].span.end < tokens[i].span.begin &&
                                    tokens[i - 1].kind != language::Token::Kind::number);
    if (is_minus && is_bound && is_free) return true;
  }
  return false;
}

}  // namespace

Result<Understanding> read_edit(std::string_view sentence, const Scene& scene, const KindTable& kinds,
                                const Recall& recall) {
  const auto& edits = edit_vocabulary();
  if (!edits) return edits.error();
  const auto& words = design::built_in_vocabulary();
  if (!words) return words.error();
  if (sentence.size() > most_bytes)
    return Error{Error::Kind::limit, "an edit has " + std::to_string(most_bytes) + " bytes at most"};
  auto raw = language::tokenize(sentence, most_words);
  if (has_measure_below_zero(raw)) return not_understood("a number below 0 is no measure of things");
  for (auto& token : raw) spell_out(token);
  // "rug: navy" is as good as "rug navy".
  std::erase_if(raw, [](const language::Token& token) {
    return token.kind == language::Token::Kind::quote || token.kind == language::Token::Kind::symbol || token.text == ":";
  });
  auto tokens = design::plain_tokens(raw);
  EditText text{scene, kinds, *edits, *words, std::move(raw), std::move(tokens), {}, {}, {}, {}, recall};
  correct_spelling(text);
  return read_text(text);
}

}  // namespace roomgen
