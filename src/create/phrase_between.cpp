// What stands between noun phrases: places, arrangements, measures, and what is like something else.
#include <algorithm>
#include <utility>

#include "phrase_reader.h"
#include "phrase_text.h"

namespace roomgen::create {

using language::NounPhrase;

// "a ring of twelve stones", "stack twenty rings": the word is no thing beside them.
bool PhraseReader::arrange(std::size_t i) {
  const NounPhrase& said = phrase(i);
  const auto found = words_.arrangements.find(text_[said.head]);
  const std::size_t next = i + 1;
  if (found == words_.arrangements.end()) return false;
  if (relation_to(i) == "in") return true;  // "in a row"
  if (next >= parse_.phrases.size() || relation_to(next) != "of" ||
      !(count_of(phrase(next)) || text_.part(phrase(next), nullptr)))
    return false;
  arrange(found->second, text_[said.head]);
  named_[i] = last_;
  at_ = said.tokens.end + 1;
  return true;
}

bool PhraseReader::is_arrangement(std::size_t i) const {
  return words_.arrangements.count(text_[phrase(i).head]) > 0;
}

void PhraseReader::arrange(Place place, const std::string& noun) {
  arranged_ = Placement{};
  arranged_.after = place;
  place_ = &arranged_;
  if (!objects_.empty()) return;
  last_ = objects_.add_unknown(noun, std::exchange(pending_, {}));
  objects_.head()->kind.clear();
}

// What was said between phrases belongs to what was named before.
void PhraseReader::release() {
  if (PartWish* part = objects_.part(target_); part && pending_.count && part->count == 0)
    pending_.count.reset();
  if (target_) objects_.apply(std::exchange(pending_, {}), target_);
  target_ = last_;
}

// "on three stones", "a handle at each end", "each smaller than the one below", "around it".
bool PhraseReader::phrase_of_place() {
  for (const auto& [relation, meaning] : words_.relations)
    if (text_.starts(at_, relation)) {
      relate(meaning);
      at_ += relation.size();
      return true;
    }
  const Placement* placement = placement_at(text_, at_, words_);
  if (!placement || (objects_.empty() && !placement->opens())) return false;
  if (placement->opens() && !starts_phrase(at_ + placement->words.size())) return false;
  target_ = subject_at(at_);
  if (pending_.article) target_ = last_;
  release();
  const Referent before = subject_at(at_);
  at_ += placement->words.size();
  place_ = placement->opens() ? placement : nullptr;
  PartWish* part = objects_.part(before);
  if (!part) part = objects_.part(last_);
  if (!part) return true;
  place_before(*placement, *part);
  if (placement->series.turn > 0)
    if (const double turn = read_turn(text_, at_); turn > 0) part->series.turn = turn;
  return true;
}

bool PhraseReader::starts_phrase(std::size_t token) const {
  return std::any_of(parse_.phrases.begin(), parse_.phrases.end(),
                     [&](const NounPhrase& phrase) { return phrase.tokens.begin == token; });
}

void PhraseReader::relate(const std::string& relation) {
  const Referent of = subject_at(at_);
  if (of && of.object > 0)
    objects_.relate(of.object, relation);
  else if (PartWish* part = objects_.part(of))
    part->place = place_of(relation);
}

// "shaped like a tree": no tree is there.
bool PhraseReader::simile() {
  for (const auto& phrase : words_.similes) {
    if (!text_.starts(at_, phrase)) continue;
    release();
    target_ = subject_at(at_);
    at_ += phrase.size();
    likeness_ = true;
    return true;
  }
  return false;
}

bool PhraseReader::measure() {
  const auto measure = read_measure(text_, at_);
  if (!measure) return false;
  // Behind a comma it is said of the thing, unless it goes on.
  const bool is_of_whole =
      at_ > 0 && text_.is(at_ - 1, ",") && at_ != measured_ + 1 && objects_.head();
  objects_.measure(*measure, is_of_whole ? Referent{0, ""} : subject_at(at_));
  measured_ = at_ += measure->length;
  return true;
}

void PhraseReader::read_between() {
  if (measure()) return;
  if (const auto stacked = words_.arrangements.find(text_[at_]);
      stacked != words_.arrangements.end() && objects_.empty()) {
    arrange(stacked->second, text_[at_++]);
    return;
  }
  if (const auto part = text_.owned_part(at_, at_ + 1);
      part && pending_.count && !objects_.empty()) {
    last_ = objects_.add_part({part.meaning, std::exchange(pending_, {})});
    ++at_;
    return;
  }
  if (!pending_.article) target_ = subject_at(at_);
  if (const std::size_t length = text_.read_attribute(at_, text_.size(), pending_)) {
    at_ += length;
    if (target_ && !pending_.article) objects_.apply(std::exchange(pending_, {}), target_);
    return;
  }
  if (words_.absences.count(text_[at_]))
    if (PartWish* part = objects_.part(last_)) part->count = 0;
  const bool goes_on = text_.is(at_, "and") || text_.is(at_, "of");
  if (!goes_on) release();
  if (!goes_on && !text_.is(at_, ",")) place_ = nullptr;
  ++at_;
}

}  // namespace roomgen::create
