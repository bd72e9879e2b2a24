#include "prompt.h"

#include <algorithm>

#include "absence.h"
#include "kind_names.h"
#include "measures.h"
#include "noun_phrase.h"
#include "placement_phrase.h"
#include "room_type.h"
#include "roomgen/base/text.h"
#include "settle.h"
#include "tokens.h"
#include "vocabulary.h"

namespace roomgen::design {

namespace {

constexpr std::size_t max_mentions = 120;

/// Reads a prompt from left to right, remembering what it speaks of.
class PromptReader {
 public:
  PromptReader(std::vector<Token> tokens, const Vocabulary& words, const KindNames& names,
               const CategoryTable& table, const RoomKind& kind, Brief& brief)
      : tokens_(std::move(tokens)),
        words_(words),
        names_(names),
        table_(table),
        kind_(kind),
        brief_(brief) {}

  void run() {
    while (at_ < tokens_.size()) {
      const Token& token = tokens_[at_];
      if (token.kind == Token::Kind::stop)
        end_sentence();
      else if (token.kind == Token::Kind::room)
        subject_.reset();
      else if (read_bare() || read_some_of() || read_negation() || read_openings() ||
               read_placement() || read_thing())
        continue;
      ++at_;
    }
  }

 private:
  bool ended(std::size_t i) const { return i >= tokens_.size(); }
  bool is_word(std::size_t i, std::string_view word) const {
    return !ended(i) && tokens_[i].is_word(word);
  }

  void end_sentence() {
    leading_.clear();
    sentence_start_ = at_ + 1;
    leading_mount_.reset();
  }

  // --- Things ---------------------------------------------------------------------------------

  bool lists(std::size_t i) const {
    if (i == sentence_start_) return true;
    const Token& before = tokens_[i - 1];
    static const WordSet words = {
        "with",     "and",       "has",       "have",     "contains", "containing", "include",
        "includes", "including", "featuring", "features", "plus",     "add",        "is",
        "are",      "stands",    "sits",      "hangs",    "want",     "need",       "also"};
    return before.kind == Token::Kind::comma || words.count(before.text) > 0;
  }

  bool read_thing() {
    const auto phrase = read_noun_phrase(tokens_, at_, words_, names_, lists(at_));
    if (!phrase) return false;
    const bool is_part = describes_owner(*phrase);
    at_ = phrase->end;
    if (is_part) {
      owner_end_ = at_;
      return true;
    }
    subject_ = mention_of(*phrase);
    owner_end_ = at_;
    if (subject_) apply_leading(*subject_);
    return true;
  }

  // "a desk with drawers": drawers are no thing of their own.
  bool describes_owner(const NounPhrase& phrase) const {
    if (!subject_ || phrase.begin == 0 || phrase.begin - 1 < owner_end_) return false;
    const Token& before = tokens_[phrase.begin - 1];
    const bool attached =
        phrase.begin - 1 == owner_end_ &&
        (before.is_word("with") || before.is_word("and") || before.is_word("featuring") ||
         before.is_word("has") || before.kind == Token::Kind::comma);
    const std::string& last = tokens_[phrase.end - 1].text;
    return attached && words_.parts.count(last) > 0;
  }

  std::optional<std::size_t> known_mention(const NounPhrase& phrase) const {
    for (std::size_t i = brief_.mentions.size(); i-- > 0;) {
      const Mention& mention = brief_.mentions[i];
      if (phrase.kind.length == 0) {
        if (mention.category == phrase.noun) return i;
        continue;
      }
      const std::string name = category_name(phrase.kind);
      if (mention.known &&
          (table_.is_a(mention.category, name) || table_.is_a(name, mention.category)))
        return i;
    }
    return std::nullopt;
  }

  // In a kitchen a "sink" is a kitchen sink.
  std::string category_name(const KindMatch& kind) const {
    const auto meant = kind_.means.find(kind.name);
    return meant == kind_.means.end() ? kind.category->name : meant->second;
  }

  std::optional<std::size_t> mention_of(const NounPhrase& phrase) {
    if (!phrase.article || phrase.definite)
      if (const auto known = known_mention(phrase)) return known;
    if (brief_.mentions.size() >= max_mentions) return std::nullopt;
    brief_.mentions.push_back(new_mention(phrase));
    if (for_each(phrase))
      brief_.mentions.back().quantity *= brief_.mentions[brief_.mentions.size() - 2].quantity;
    if (!continues_list(phrase.begin)) group_.clear();
    group_.push_back(brief_.mentions.size() - 1);
    return group_.back();
  }

  // "a desk, a chair and a lamp": after a comma or an "and" that follows a thing.
  bool continues_list(std::size_t begin) const {
    return begin > 0 && begin <= owner_end_ + 2 &&
           (is_word(begin - 1, "and") || tokens_[begin - 1].kind == Token::Kind::comma);
  }

  // "two nightstands, each with a lamp"
  bool for_each(const NounPhrase& phrase) const {
    return brief_.mentions.size() > 1 && phrase.begin >= 2 && is_word(phrase.begin - 2, "each") &&
           brief_.mentions[brief_.mentions.size() - 2].quantity <= 40;
  }

  Mention new_mention(const NounPhrase& phrase) const {
    Mention mention;
    mention.quantity = phrase.count;
    mention.counted = phrase.counted;
    std::vector<std::string> description = phrase.modifiers;
    if (phrase.kind.length > 0) {
      mention.category = category_name(phrase.kind);
      description.push_back(phrase.kind.name);
      const bool open = phrase.kind.plural && !phrase.article;
      if (open) mention.quantity = 0;  // to be settled
    } else {
      mention.known = false;
      mention.category = phrase.noun;
      description.push_back(phrase.noun);
    }
    mention.description = join(description, " ");
    shape(mention, phrase, words_, table_, names_);
    return mention;
  }

  // --- Placements -----------------------------------------------------------------------------

  // What "it" means: the last floor thing that is not the subject.
  std::optional<std::size_t> antecedent() const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < brief_.mentions.size(); ++i)
      if (i != subject_.value_or(brief_.mentions.size()) &&
          (brief_.mentions[i].mount == Mount::floor || !best))
        best = i;
    return best;
  }

  std::vector<std::size_t> subjects() const {
    if (!subject_) return {};
    const bool all =
        owner_end_ < tokens_.size() &&
        (is_word(owner_end_, "are") || is_word(owner_end_, "both") || is_word(owner_end_, "all"));
    if (all && group_.size() > 1 &&
        std::find(group_.begin(), group_.end(), *subject_) != group_.end())
      return group_;
    return {*subject_};
  }

  bool read_placement() {
    const auto placement = longest(words_.placements, tokens_, at_, 6);
    if (!placement) return false;
    const std::size_t after = at_ + placement.length;
    const bool leads = leads_sentence();
    if (placement.value->inverse) return read_inverse(*placement.value, after);
    if (placement.value->pronoun) return read_implied_target(*placement.value, after);
    if (read_place_target(*placement.value, after, leads)) return true;
    return read_thing_target(*placement.value, after, leads);
  }

  // "Next to the bed is a lamp": before any thing of the sentence.
  bool leads_sentence() const {
    return at_ == sentence_start_ ||
           (at_ == sentence_start_ + 1 && is_word(sentence_start_, "and"));
  }

  void demand(const Demand& what, bool leads) {
    if (leads)
      leading_.push_back(what);
    else
      for (std::size_t subject : subjects()) add_demand(subject, what);
  }

  void add_demand(std::size_t subject, const Demand& what) {
    if (what.mention == subject) return;
    Mention& mention = brief_.mentions[subject];
    mention.demands.push_back(what);
    // "a lamp on each side" is two.
    if (what.flank) mention.quantity = std::max(2, mention.quantity);
  }

  void apply_leading(std::size_t subject) {
    bool used = false;
    if (leading_mount_) hang(brief_.mentions[subject], *leading_mount_, table_, names_);
    leading_mount_.reset();
    for (const auto& what : leading_) {
      if (what.mention == subject) continue;
      add_demand(subject, what);
      used = true;
    }
    if (used) leading_.clear();
  }

  bool read_place_target(const Placement& placement, std::size_t after, bool leads) {
    const auto place = read_place(tokens_, after, words_);
    if (!place) return false;
    const std::size_t end = after + place->length;
    // "the middle of the table" is on the table.
    if (place->place == Place::middle && is_word(end, "of")) {
      const std::size_t end_of = end + 1;
      return read_thing_target({{RelationKind::on}, false, false}, end_of, leads);
    }
    if (!subject_ && !leads) {
      at_ = end;
      return true;
    }
    place_demands(placement, *place, leads);
    at_ = end;
    // "the wall opposite the bed" goes on with a placement of its own.
    return true;
  }

  void place_demands(const Placement& placement, const PlacePhrase& place, bool leads) {
    const RelationKind first = placement.relations.front();
    const auto say = [&](RelationKind kind, std::string part) {
      demand({kind, Demand::none, std::move(part), false}, leads);
    };
    switch (place.place) {
      case Place::window:
        if (!brief_.windows) brief_.windows = 1;
        if (first == RelationKind::under || first == RelationKind::on ||
            first == RelationKind::in_front_of) {
          say(RelationKind::near, "window-0");
          say(RelationKind::in_front_of, "window-0");
        } else {
          for (auto kind : placement.relations)
            if (kind != RelationKind::side_of) say(kind, "window-0");
        }
        return;
      case Place::door:
        for (auto kind : placement.relations)
          if (kind != RelationKind::side_of && kind != RelationKind::on) say(kind, "door-0");
        return;
      case Place::corner:
        if (first == RelationKind::on || first == RelationKind::near) say(RelationKind::corner, "");
        return;
      case Place::middle:
        say(RelationKind::middle, "");
        return;
      case Place::wall:
        wall_demands(first, place, leads);
        return;
      case Place::ceiling:
        mount(Mount::ceiling, leads);
        return;
      case Place::room:
      case Place::floor:
        return;
    }
  }

  void wall_demands(RelationKind first, const PlacePhrase& place, bool leads) {
    if (first == RelationKind::far || first == RelationKind::face_to) return;
    if (first == RelationKind::on) mount(Mount::wall, leads);
    demand({RelationKind::edge, Demand::none, "", false}, leads);
    if (place.wall >= 0) {
      const std::string id = "wall-" + std::to_string(place.wall);
      demand({RelationKind::near, Demand::none, id, false}, leads);
      demand({RelationKind::face_same_as, Demand::none, id, false}, leads);
    } else if (place.opposite) {
      if (const auto other = antecedent())
        demand({RelationKind::in_front_of, *other, "", false}, leads);
    }
  }

  void mount(Mount where, bool leads) {
    if (leads)
      leading_mount_ = where;
    else
      for (std::size_t subject : subjects()) hang(brief_.mentions[subject], where, table_, names_);
  }

  // "to its left", "on top": of what was spoken of before.
  bool read_implied_target(const Placement& placement, std::size_t after) {
    const auto target = antecedent();
    if (!subject_ || !target || *target == *subject_) return false;
    for (auto kind : placement.relations) demand({kind, *target, "", placement.flank}, false);
    at_ = after;
    return true;
  }

  // The things after a placement: "between the sofa and the window" has two.
  bool read_thing_target(const Placement& placement, std::size_t after, bool leads) {
    if (!subject_ && !leads) return false;
    const auto speaker = subject_;
    std::size_t end = after;
    auto target = target_at(after, end);
    if (!target || (speaker && *target == *speaker && !leads)) return false;
    const bool between = tokens_[after - 1].is_word("between");
    subject_ = speaker;
    for (auto kind : placement.relations) demand({kind, *target, "", placement.flank}, leads);
    if (between && is_word(end, "and")) {
      const std::size_t second = end + 1;
      if (const auto place = read_place(tokens_, second, words_)) {
        place_demands(placement, *place, leads);
        end = second + place->length;
      } else if (const auto other = target_at(second, end)) {
        subject_ = speaker;
        demand({RelationKind::near, *other, "", false}, leads);
      }
    }
    at_ = end;
    owner_end_ = at_;
    if (leads)
      subject_.reset();
    else if (brief_.mentions.size() > 0 && *target == brief_.mentions.size() - 1 && target_new_)
      subject_ = *target;
    return true;
  }

  std::optional<std::size_t> target_at(std::size_t from, std::size_t& end) {
    target_new_ = false;
    if (ended(from)) return std::nullopt;
    if (tokens_[from].kind == Token::Kind::word && words_.pronouns.count(tokens_[from].text)) {
      end = from + 1;
      return antecedent();
    }
    if (tokens_[from].is_word("each") && is_word(from + 1, "other")) return std::nullopt;
    const auto phrase = read_noun_phrase(tokens_, from, words_, names_, false);
    if (!phrase) return std::nullopt;
    const std::size_t before = brief_.mentions.size();
    const auto group = group_;
    // "on a nightstand" means one of those that are there.
    const auto known =
        phrase->count == 1 && !phrase->another ? known_mention(*phrase) : std::nullopt;
    const auto target = known ? known : mention_of(*phrase);
    group_ = group;
    target_new_ = brief_.mentions.size() > before;
    end = phrase->end;
    return target;
  }

  // "flanked by two lamps", "surrounded by chairs": the subject is the target.
  bool read_inverse(const Placement& placement, std::size_t after) {
    if (!subject_) return false;
    const std::size_t target = *subject_;
    const auto phrase = read_noun_phrase(tokens_, after, words_, names_, true);
    if (!phrase) return false;
    const auto other = mention_of(*phrase);
    at_ = phrase->end;
    owner_end_ = at_;
    if (!other || *other == target) return true;
    for (auto kind : placement.relations) add_demand(*other, {kind, target, "", placement.flank});
    subject_ = other;
    return true;
  }

  // "one of them", "the other": some of what was spoken of; what is said of them is not followed.
  bool read_some_of() {
    const bool one = is_word(at_, "one") && is_word(at_ + 1, "of") && !ended(at_ + 2) &&
                     (words_.pronouns.count(tokens_[at_ + 2].text) ||
                      words_.definite.count(tokens_[at_ + 2].text));
    const bool other = is_word(at_, "the") &&
                       (is_word(at_ + 1, "other") || is_word(at_ + 1, "others")) &&
                       names_.match(tokens_, at_ + 2).length == 0 && !is_word(at_ + 2, "wall") &&
                       !is_word(at_ + 2, "side");
    if (!one && !other) return false;
    subject_.reset();
    at_ += one ? 3 : 2;
    return true;
  }

  // --- What is forbidden ----------------------------------------------------------------------

  bool read_bare() {
    const std::size_t end = read_only(tokens_, at_, words_);
    if (end == at_) return false;
    brief_.bare = true;
    at_ = end;
    return true;
  }

  bool read_negation() {
    const auto absence = read_absence(tokens_, at_, words_, names_);
    if (!absence) return false;
    if (absence->windows) brief_.windows = 0;
    for (const auto& kind : absence->kinds) {
      const std::string category = category_name(kind);
      auto& excluded = brief_.excluded;
      if (std::find(excluded.begin(), excluded.end(), category) == excluded.end())
        excluded.push_back(category);
    }
    at_ = absence->end;
    return true;
  }

  bool read_openings() {
    const auto windows = read_windows(tokens_, at_, words_, names_);
    if (!windows) return false;
    if (windows->counted)
      brief_.windows = windows->count;
    else if (!brief_.windows)
      brief_.windows = windows->plural ? 2 : 1;
    brief_.wide_windows = brief_.wide_windows || windows->wide;
    at_ = windows->end;
    return true;
  }

  std::vector<Token> tokens_;
  const Vocabulary& words_;
  const KindNames& names_;
  const CategoryTable& table_;
  const RoomKind& kind_;
  Brief& brief_;

  std::size_t at_ = 0;
  std::size_t sentence_start_ = 0;
  std::size_t owner_end_ = 0;           ///< behind the last phrase about a thing
  std::optional<std::size_t> subject_;  ///< the last thing spoken of
  std::vector<std::size_t> group_;      ///< things listed together
  bool target_new_ = false;             ///< the last target was a new mention
  std::vector<Demand> leading_;         ///< for the thing that is yet to come
  std::optional<Mount> leading_mount_;
};

}  // namespace

Brief read_prompt(std::string_view prompt, const RoomKinds& kinds, const CategoryTable& table) {
  Brief brief;
  const auto& words = built_in_vocabulary();
  if (!words) return brief;
  const KindNames names(table);
  auto tokens = tokenize(prompt);
  if (tokens.size() >= max_tokens)
    brief.notes.push_back("only the first " + std::to_string(max_tokens) +
                          " words of the prompt were read");
  read_measures(tokens, *words, names, brief);
  read_people(tokens, *words, names, brief);
  read_room_type(tokens, *words, names, kinds, brief);
  PromptReader reader(std::move(tokens), *words, names, table, kinds.get(brief.type), brief);
  reader.run();
  settle(brief, table, names);
  if (brief.type.empty()) {
    brief.type = guess_room_type(brief, kinds, table);
    if (!brief.type.empty()) {
      brief.type_known = true;
      brief.notes.push_back("the prompt names no kind of room; taken for a " + brief.type);
    }
  }
  return brief;
}

}  // namespace roomgen::design
