#include <algorithm>

#include "clause.h"
#include "edit_words.h"
#include "gathered_edits.h"
#include "room_scopes.h"
#include "spoken_clause.h"
#include "wording.h"

namespace roomgen {

namespace {

using Which = NamedThing::Which;

class EditReader {
 public:
  explicit EditReader(EditText text) : text_(std::move(text)), scopes_(text_.scene) {}

  Result<Understanding> run() {
    for (skip_between(); at_ < text_.tokens.size(); skip_between()) {
      if (take_complaint()) continue;
      auto clause = scopes_.read(text_, at_, [&](EditText& text, std::size_t at) { return read_other(text, at); });
      if (clause) leave_out_exceptions(text_, *clause);
      if (clause) clause->end = skip_tail(clause->end);
      if (!clause || !text_.ends(clause->end)) {
        if (skip_remark()) continue;
        return clause ? what_at(text_, clause->end, "not understood") : clause.error();
      }
      take(*std::move(clause));
    }
    // What is wrong is put right by what is asked for; where nothing is, by its opposite.
    if (gathered_.operations.empty() && complaint_) gathered_.add(*complaint_);
    if (gathered_.operations.empty()) return not_understood("nothing in it says what to change");
    return Understanding{gathered_.settled(), std::move(remarks_)};
  }

 private:
  // ---- Between clauses -------------------------------------------------------------------------

  void skip_between() {
    while (const auto length = length_between()) {
      // "remove the rug ... nah, the lamp": nothing of what was said before.
      if (longest_in(text_.edits.denials, text_.tokens, at_) == length) gathered_ = {};
      if (text_.tokens[at_].kind == brief::Token::Kind::stop) scopes_.forget();
      at_ += length;
    }
  }

  std::size_t length_between() const {
    if (at_ >= text_.tokens.size()) return 0;
    if (text_.is_mark(at_)) return 1;
    if (const auto closer = longest_in(text_.edits.closers, text_.tokens, at_);
        closer > 0 && text_.is_mark(at_ + closer))
      return closer;
    if (const auto question = begins_question(at_)) return question;
    // A verb that looks like an opener is a verb.
    const auto opener = longest_in(text_.edits.openers, text_.tokens, at_);
    const auto verb = verb_at(text_, at_);
    const auto substitute = longest_in(text_.edits.substitutes, text_.tokens, at_);
    if (is_no_of_thing(at_) || substitute > opener || (verb && verb->length > opener)) return 0;
    return opener;
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
    const bool is_first = at == 0 || text_.is_mark(at - 1) || text_.is_word(at - 1, "and") ||
                          longest_in(text_.edits.openers, text_.tokens, at - 1) > 0;
    if (length == 0 || !is_first) return 0;
    return named_thing_at(text_, at + length) || !ends_of_subject(text_, at + length).empty() ? length : 0;
  }

  void note_remark(std::size_t begin, std::size_t end) { remarks_.push_back(text_.words_from(begin, end)); }

  // "now that we own a dryer" is told, "please" is not.
  std::size_t skip_tail(std::size_t at) {
    const std::size_t end = end_of_tail(text_, at);
    for (std::size_t i = at; i < end;) {
      const auto closer = longest_in(text_.edits.closers, text_.tokens, i);
      if (closer > 0 && longest_in(text_.edits.substitutes, text_.tokens, i) == 0) i += closer;
      else return note_remark(i, end), end;
    }
    return end;
  }

  // "it is draughty", "thanks a million"
  bool skip_remark() {
    const std::size_t end = end_of_remark(text_, at_, gathered_.operations.empty());
    if (end == at_) return false;
    note_remark(at_, end);
    speak_of(at_, end);
    at_ = end;
    return true;
  }

  // "our toddler bumps his head on the table": it is the table. Of several things it is the one that comes first, if
  // all is about that; else it may be any.
  void speak_of(std::size_t begin, std::size_t end) {
    const std::size_t known = text_.mentioned.size();
    const auto first = named_thing_at(text_, begin);
    remember_names(end);
    Ids named(text_.mentioned.begin() + static_cast<std::ptrdiff_t>(known), text_.mentioned.end());
    std::sort(named.begin(), named.end());
    named.erase(std::unique(named.begin(), named.end()), named.end());
    if (named.empty()) return;
    const bool is_about_first = first && first->kind.category && first->which == Which::definite;
    text_.latest = is_about_first ? Ids{text_.mentioned[known]} : named;
  }

  // "the sofa is too close to the TV": what is said of it then comes first.
  bool take_complaint() {
    const auto complaint = complaint_at(text_, at_);
    if (!complaint || !*complaint) return false;
    const std::size_t end = end_of_tail(text_, (*complaint)->end);
    note_remark(at_, end);
    remember_names(end);
    if (!complaint_) complaint_ = **complaint;
    else
      complaint_->operations.insert(complaint_->operations.end(), (*complaint)->operations.begin(),
                                    (*complaint)->operations.end());
    text_.latest = (*complaint)->about;
    at_ = end;
    return true;
  }

  // ---- Clauses ---------------------------------------------------------------------------------

  ReadClause read_order(const EditText& text, const SaidVerb& verb, std::size_t at) {
    last_meaning_ = verb.meaning;
    last_verb_ = verb.words;
    // "leaving the lamp where it is": what is not changed anyway.
    const auto kept_thing = named_thing_at(text, at);
    const bool is_all = kept_thing && kept_thing->which == Which::everything;
    const bool is_aside = verb.meaning == "keep" &&
                          (verb.inflected || is_all || (verb.words == "leave" && !gathered_.operations.empty()));
    if (is_aside) {
      auto kept = read_lock(text, at, true, true);
      if (kept) kept->operations.clear();
      return kept;
    }
    return read_verb(text, verb.meaning, verb.words, at);
  }

  // The clause in these words, of this scene; in the order in which they were understood.
  ReadClause read_other(EditText& text, std::size_t at) {
    EditReader other(text, at, *this);
    auto clause = other.read_clause();
    text.raw = std::move(other.text_.raw);
    text.tokens = std::move(other.text_.tokens);
    last_meaning_ = other.last_meaning_, last_verb_ = other.last_verb_;
    return clause;
  }

  ReadClause read_clause() {
    auto plain = read_in_order();
    if (goes_to_its_end(text_, plain) || is_excepted(plain)) return plain;
    for (auto turned : {with_place_last(text_, at_), with_way_last(text_, at_)}) {
      if (!turned) continue;
      exchange_words(*turned);
      auto clause = read_in_order();
      if (goes_to_its_end(text_, clause)) return clause;
      exchange_words(*turned);
    }
    return plain;
  }

  bool is_excepted(const ReadClause& clause) const {
    return clause && clause->operations.size() > 1 &&
           longest_in(text_.edits.except, text_.tokens, text_.behind_comma(clause->end)) > 0;
  }

  void exchange_words(EditText& other) {
    std::swap(text_.raw, other.raw);
    std::swap(text_.tokens, other.tokens);
  }

  ReadClause read_in_order() {
    if (const auto reverse = longest_in(text_.edits.vice_versa, text_.tokens, at_);
        reverse > 0 && text_.ends(at_ + reverse))
      return gathered_.vice_versa(text_, at_ + reverse);
    if (longest_in(text_.edits.substitutes, text_.tokens, at_) > 0)
      if (auto instead = read_instead(text_, at_); goes_to_its_end(text_, instead)) return instead;
    if (auto likewise = read_likewise(); goes_to_its_end(text_, likewise)) return likewise;
    if (const auto verb = verb_at(text_, at_)) return read_with_verb(*verb);
    if (auto order = read_by_subject(); goes_to_its_end(text_, order)) return order;
    if (const auto wish = wish_of_somebody(text_, at_))
      if (auto wished = read_wish(text_, at_ + wish); goes_to_its_end(text_, wished)) return wished;
    // "… and the dresser pale blue": the verb before goes on.
    if (!last_meaning_.empty())
      if (auto same = read_verb(text_, last_meaning_, last_verb_, at_); goes_to_its_end(text_, same)) return same;
    return read_fragment(text_, at_);
  }

  ReadClause read_with_verb(const SaidVerb& verb) {
    auto clause = read_order(text_, verb, at_ + verb.length);
    if (goes_to_its_end(text_, clause)) return clause;
    if (auto whole = read_with_particle(verb); goes_to_its_end(text_, whole)) return whole;
    if (auto order = read_by_subject(); goes_to_its_end(text_, order)) return order;
    if (auto fragment = read_fragment(text_, at_); goes_to_its_end(text_, fragment)) return fragment;
    if (auto of_it = read_of_it(verb); goes_to_its_end(text_, of_it)) return of_it;
    if (auto other = text_.latest.empty() ? clause : read_another(text_, at_ + verb.length);
        goes_to_its_end(text_, other))
      return other;
    return bare_order(verb, std::move(clause));
  }

  // "then rotate 90 degrees": what was spoken of last.
  ReadClause read_of_it(const SaidVerb& verb) {
    const std::size_t at = at_ + verb.length;
    const auto thing = named_thing_at(text_, at);
    if (text_.latest.empty() || text_.ends(at) || (thing && thing->which != Which::indefinite))
      return what_at(text_, at, "not understood");
    EditText longer = text_;
    insert_word(longer, at, text_.latest.size() > 1 ? "them" : "it");
    auto clause = read_order(longer, verb, at);
    if (!clause || clause->end == at) return what_at(text_, at, "not understood");
    --clause->end;
    return clause;
  }

  // "shift it": as the complaint before has it.
  ReadClause bare_order(const SaidVerb& verb, ReadClause failed) {
    const bool may_be =
        verb.meaning == "move" || verb.meaning == "put" || verb.meaning == "turn" || verb.meaning == "change";
    const auto what =
        complaint_ && may_be ? things(text_, at_ + verb.length, false) : Result<Read<Ids>>(not_understood(""));
    if (!what || what->value != complaint_->about || !text_.ends(end_of_tail(text_, what->end))) return failed;
    Clause clause = *complaint_;
    clause.end = what->end;
    return clause;
  }

  // "… and the plant too": as it was done to the things before.
  ReadClause read_likewise() {
    const auto what = things(text_, at_, true);
    if (!what) return what.error();
    const auto too = longest_in(text_.edits.likewise, text_.tokens, what->end);
    if (too == 0) return what_at(text_, at_, "not understood");
    return gathered_.likewise(text_, {what->value, what->end + too});
  }

  // "take the lamp down": the verb's other part behind what it is done to.
  ReadClause read_with_particle(const SaidVerb& verb) {
    const std::size_t begin = at_ + verb.length;
    for (const bool with_places : {false, true}) {
      const auto what = things(text_, begin, with_places);
      if (!what || longest_in(text_.edits.particles, text_.tokens, what->end) != 1) continue;
      const auto whole = text_.edits.verbs.find(verb.words + " " + text_.tokens[what->end].text);
      if (whole == text_.edits.verbs.end()) continue;
      auto clause = read_order(without(text_, what->end, what->end + 1),
                               {whole->second, whole->first, verb.length, false}, begin);
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

  // ---- What was read ---------------------------------------------------------------------------

  // All that the clause spoke of by name: "the table" behind it is one of these.
  void remember_names(std::size_t end) {
    for (std::size_t i = at_; i < end; ++i) {
      const auto thing = named_thing_at(text_, i);
      if (!thing || thing->which != Which::definite || thing->end > end) continue;
      for (const bool with_places : {true, false}) {
        const auto ids = things_at(text_, i, with_places);
        if (!ids || !*ids || (*ids)->value.size() != 1 || (*ids)->end > end) continue;
        text_.mentioned.push_back((*ids)->value.front());
        break;
      }
    }
  }

  void take(Clause clause) {
    remember_names(clause.end);
    at_ = clause.end;
    if (gathered_.fold_looks(clause, text_) || gathered_.fold_place(clause, text_)) return;
    gathered_.add(clause);
    if (!clause.gone.empty()) text_.gone = clause.gone;
    text_.mentioned.insert(text_.mentioned.end(), clause.about.begin(), clause.about.end());
    if (!clause.about.empty()) text_.latest = clause.about;
    text_.coming.insert(text_.coming.end(), clause.coming.begin(), clause.coming.end());
  }

  EditReader(const EditText& text, std::size_t at, const EditReader& before)
      : text_(text), scopes_(Scene()), at_(at), last_meaning_(before.last_meaning_), last_verb_(before.last_verb_),
        complaint_(before.complaint_), gathered_(before.gathered_) {}

  EditText text_;
  RoomScopes scopes_;
  std::size_t at_ = 0;
  std::string last_meaning_, last_verb_;
  std::optional<Clause> complaint_;
  GatheredEdits gathered_;
  std::vector<std::string> remarks_;
};

}  // namespace

Result<Understanding> read_clauses(EditText text) { return EditReader(std::move(text)).run(); }

}  // namespace roomgen
