#include "deed_evidence.h"

#include <algorithm>
#include <map>

#include "clause_parts.h"
#include "language/inflection.h"
#include "spoken_clause.h"

namespace roomgen {

namespace {

constexpr int clear_lead = 4000;  // of the sums of weights, 256 for each mistake that was learned from

using Deeds = std::vector<EditDeed>;

// What verbs of data/edits.json that mean one thing only may be for.
const std::map<std::string, Deeds, std::less<>>& deeds_of_verbs() {
  static const std::map<std::string, Deeds, std::less<>> all = {
      {"turn", {EditDeed::turn, EditDeed::face}},       {"swap", {EditDeed::swap, EditDeed::replace}},
      {"lock", {EditDeed::lock}},                   {"unlock", {EditDeed::unlock}},
      {"replace", {EditDeed::replace, EditDeed::swap}}, {"paint", {EditDeed::recolour, EditDeed::room}},
      {"remove", {EditDeed::remove, EditDeed::room}},   {"resize", {EditDeed::resize, EditDeed::room}},
      {"rearrange", {EditDeed::rearrange}},         {"revert", {EditDeed::undo}}};
  return all;
}

enum class Evidence { none, against, for_it };

Evidence evidence_of_verbs(const EditText& text, const SpokenOrder& order, EditDeed deed) {
  Evidence evidence = Evidence::none;
  for (const auto& part : order.parts)
    for (std::size_t i = part.begin; part.role == EditRole::order && i < part.end; ++i) {
      const auto verb = verb_at(text, i);
      const auto known = verb ? deeds_of_verbs().find(verb->meaning) : deeds_of_verbs().end();
      if (known == deeds_of_verbs().end()) continue;
      const bool fits = std::count(known->second.begin(), known->second.end(), deed) > 0;
      if (fits) return Evidence::for_it;
      evidence = Evidence::against;
    }
  return evidence;
}

// The others need words that say where to, how much or what like, which an order by mistake does not have.
bool needs_no_more(EditDeed deed) {
  switch (deed) {
    case EditDeed::remove:
    case EditDeed::lock:
    case EditDeed::unlock:
    case EditDeed::swap:
    case EditDeed::rearrange:
    case EditDeed::undo: return true;
    default: return false;
  }
}

bool is_negative(const std::string& word) {
  static const design::WordSet words = {"not", "no", "never", "nobody", "nothing", "dont", "without", "cannot", "too"};
  return words.count(word) > 0 || (word.size() > 3 && word.ends_with("nt") && word != "want" && word != "front");
}

}  // namespace

namespace {

// "everything stays put", where "stays" is no move; "strip everything off", where everything is what it is about.
bool says_otherwise(const EditText& text, const SpokenOrder& order, EditDeed deed) {
  for (const auto& part : order.parts)
    for (std::size_t i = part.begin; part.role == EditRole::order && i < part.end; ++i) {
      const auto verb = language::verb(text.tokens[i].text);
      if (verb && verb->base == "stay" && deed != EditDeed::lock) return true;
      if (longest_in(text.edits.everything, text.tokens, i) > 0) return true;
    }
  return false;
}

}  // namespace

bool is_evident(const EditText& text, const SpokenOrder& order, const ReadDeed& read) {
  if (says_otherwise(text, order, read.deed)) return false;
  const auto verbs = evidence_of_verbs(text, order, read.deed);
  if (verbs == Evidence::for_it) return true;
  if (verbs == Evidence::against) return false;
  if (!order.has(EditRole::order) && needs_no_more(read.deed)) return false;
  return !needs_no_more(read.deed) || read.lead >= clear_lead;
}

bool is_denied(const EditText& text, const SpokenOrder& order) {
  for (const auto& part : order.parts)
    for (std::size_t i = part.begin; part.role == EditRole::order && i < part.end; ++i)
      if (is_negative(text.tokens[i].text)) return true;
  return false;
}

bool may_ask(const EditText& text, const RoleStretch& remark) {
  static const design::WordSet of_others = {"instead", "excepted", "same",   "too",  "rest",
                                            "other",   "others",   "except", "wait", "likewise"};
  for (std::size_t i = remark.begin; i < remark.end; ++i)
    if (of_others.count(text.tokens[i].text) > 0) return true;
  return false;
}

bool leaves_words_unread(const EditText& text, const std::vector<WordSigns>& signs,
                         const std::vector<RoleStretch>& stretches) {
  const auto contains = [&](const RoleStretch& stretch, const auto& is) {
    for (std::size_t i = stretch.begin; i < stretch.end; ++i)
      if (is(signs[i])) return true;
    return false;
  };
  const auto is_content = [](const WordSigns& sign) { return sign.tag.find_first_of("VGEJN") != std::string::npos; };
  const auto is_new_thing = [](const WordSigns& sign) { return sign.kinds.find('U') != std::string::npos; };
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const auto& stretch = stretches[i];
    const bool runs_on = i + 1 < stretches.size() && !text.is_mark(stretch.end - 1);
    if (stretch.role == EditRole::next && contains(stretch, is_content)) return true;
    if (stretch.role == EditRole::idle && runs_on && contains(stretch, is_new_thing)) return true;
  }
  return false;
}

}  // namespace roomgen
