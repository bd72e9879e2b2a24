#include "attach.h"

#include <optional>
#include <utility>

#include "small_words.h"

namespace roomgen::language {

namespace {

// What opened a list, and so what further members are attached by.
enum class Opened { subject, object, with, clause, place, of };

struct OpenList {
  Opened by = Opened::subject;
  std::int32_t first = none, last = none;  ///< noun phrases
  std::int32_t attachment = none;          ///< that further members repeat
  bool has_own_place = false;              ///< a member before the last is somewhere already
};

class Attacher {
 public:
  Attacher(const std::vector<Chunk>& chunks, Parse& parse) : chunks_(chunks), parse_(parse) {}

  void run() {
    for (at_ = 0; at_ < chunks_.size(); ++at_) {
      read(chunks_[at_]);
      if (chunks_[at_].tag != Tag::adverb) before_ = chunks_[at_].tag;
    }
  }

 private:
  void read(const Chunk& chunk) {
    switch (chunk.tag) {
      case Tag::stop:
        return end_sentence();
      case Tag::comma:
      case Tag::conjunction:
        return join(chunk);
      case Tag::subordinator:
        return end_clause();
      case Tag::negation:
        is_denied_ = true;
        return;
      case Tag::relative:
        relative_ = last_;
        verb_ = participle_ = none;
        return;
      case Tag::there:
        return existential();
      case Tag::preposition:
        return preposition(*chunk.piece);
      case Tag::be:
      case Tag::auxiliary:
        return auxiliary(chunk);
      case Tag::verb:
        return verb(*chunk.piece);
      case Tag::participle:
        return participle(*chunk.piece);
      case Tag::adjective:
        return complement(chunk);
      case Tag::noun:
        return phrase(chunk.phrase);
      default:
        return;
    }
  }

  NounPhrase& at(std::int32_t phrase) { return parse_.phrases[static_cast<std::size_t>(phrase)]; }
  VerbPhrase& verb_at(std::int32_t verb) { return parse_.verbs[static_cast<std::size_t>(verb)]; }
  Tag ahead(std::size_t n = 1) const {
    return at_ + n < chunks_.size() ? chunks_[at_ + n].tag : Tag::stop;
  }

  void end_clause() {
    open_.clear();
    fronted_.clear();
    verb_ = relative_ = participle_ = auxiliary_ = outer_verb_ = none;
    last_ = main_ = pending_ = each_ = none;
    is_joined_ = is_denied_ = denies_list_ = is_auxiliary_denied_ = false;
  }
  void end_sentence() {
    end_clause();
    is_imperative_ = false;
  }

  // A comma or a conjunction: what comes may be a further member of a list, or another clause.
  void join(const Chunk& chunk) {
    pending_ = none;
    participle_ = none;
    if (chunk.tag == Tag::comma) has_comma_ = true;
    is_joined_ = true;
    // "At the foot of the bed, a rack ...": what was told beforehand is told.
    if (chunk.tag == Tag::comma && !fronted_.empty() && main_ == none && !has_verb()) open_.clear();
    const bool is_within_subject = relative_ != none && outer_verb_ == none;
    if (has_verb() && !is_within_subject && begins_clause(at_ + 1)) {
      end_clause();
    } else if (relative_ != none && chunk.tag == Tag::comma) {
      leave_relative();
    }
    if (chunk.tag == Tag::conjunction && chunk.piece->base == "nor") is_denied_ = true;
  }

  bool has_verb() const { return verb_ != none || has_existential_; }

  // "..., the other faces the door": a noun phrase with a verb of its own, prepositions between
  // them.
  bool begins_clause(std::size_t i) const {
    while (i < chunks_.size() &&
           (chunks_[i].tag == Tag::conjunction || chunks_[i].tag == Tag::adverb))
      ++i;
    if (i < chunks_.size() && (chunks_[i].tag == Tag::there || is_verb(chunks_[i], VerbForm::base)))
      return true;
    for (std::size_t n = 0; n < 8 && i < chunks_.size(); ++n, ++i) {
      const Tag tag = chunks_[i].tag;
      if (tag == Tag::verb || tag == Tag::be || tag == Tag::auxiliary) return n > 0;
      // "a vase and a mug sit ..."
      if (tag == Tag::conjunction && n > 0 && i + 1 < chunks_.size() &&
          chunks_[i + 1].tag == Tag::noun)
        continue;
      if (tag != Tag::noun && tag != Tag::preposition && tag != Tag::adverb && tag != Tag::negation)
        return false;
    }
    return false;
  }
  bool is_verb(const Chunk& chunk, VerbForm form) const {
    return chunk.tag == Tag::verb && chunk.piece->form == form && is_imperative_;
  }

  void leave_relative() {
    relative_ = none;
    verb_ = outer_verb_;
  }

  void existential() {
    if (has_existential_) end_clause();
    VerbPhrase& verb = add_verb(VerbPhrase::Kind::existential, chunks_[at_].piece->tokens, "be");
    verb_ = static_cast<std::int32_t>(&verb - parse_.verbs.data());
    has_existential_ = true;
    main_ = none;
  }

  VerbPhrase& add_verb(VerbPhrase::Kind kind, const Run& tokens, const std::string& base) {
    VerbPhrase verb;
    verb.kind = kind;
    verb.tokens = tokens;
    verb.base = base;
    verb.is_denied = is_denied_ || is_auxiliary_denied_;
    is_denied_ = is_auxiliary_denied_ = false;
    parse_.verbs.push_back(verb);
    return parse_.verbs.back();
  }

  void auxiliary(const Chunk& chunk) {
    is_auxiliary_denied_ = is_auxiliary_denied_ || chunk.piece->is_denied;
    if (verb_ != none && verb_at(verb_).kind == VerbPhrase::Kind::existential && main_ == none) {
      verb_at(verb_).is_denied = verb_at(verb_).is_denied || chunk.piece->is_denied;
      return;
    }
    if (chunk.tag == Tag::auxiliary) {
      auxiliary_ = 1;
      return;
    }
    begin_finite(chunk.piece->tokens, "be");
  }

  // A finite verb: of the relative clause that is open, or of the clause.
  void begin_finite(const Run& tokens, const std::string& base) {
    const bool is_relative = relative_ != none && (verb_ == none || verb_ == outer_verb_);
    if (relative_ != none && !is_relative) leave_relative();
    const auto kind = is_relative ? VerbPhrase::Kind::relative : VerbPhrase::Kind::finite;
    VerbPhrase& verb = add_verb(kind, tokens, base);
    verb.subject = is_relative ? relative_ : main_;
    if (is_relative) outer_verb_ = verb_;
    verb_ = static_cast<std::int32_t>(&verb - parse_.verbs.data());
    participle_ = none;
    if (!is_relative) close_lists();
    // "it faces the window" is said of what the pronoun stands for.
    if (verb.subject == none && last_ != none && fronted_.empty()) verb_at(verb_).subject = last_;
  }
  void close_lists() {
    open_.clear();
    is_joined_ = has_comma_ = false;
  }

  void verb(const Piece& piece) {
    // "is placed", "are standing", "should face": the verb that the auxiliary began.
    if (verb_ != none && verb_at(verb_).base == "be" && before_is_be() &&
        verb_at(verb_).kind != VerbPhrase::Kind::existential) {
      VerbPhrase& open = verb_at(verb_);
      open.base = piece.base;
      open.tokens.end = piece.tokens.end;
      open.is_passive = piece.form == VerbForm::past;
      open.is_denied = open.is_denied || is_denied_;
      is_denied_ = false;
      pending_ = open.is_passive ? none : verb_;
      auxiliary_ = none;
      return;
    }
    const bool is_imperative =
        piece.form == VerbForm::base && auxiliary_command() && main_ == none && relative_ == none;
    if (is_imperative) {
      if (has_verb()) end_clause();
      VerbPhrase& verb = add_verb(VerbPhrase::Kind::imperative, piece.tokens, piece.base);
      verb.is_denied =
          verb.is_denied || piece.is_denied || small_words().verbs_of_denial.count(piece.base) > 0;
      denies_list_ = verb.is_denied;
      verb_ = static_cast<std::int32_t>(&verb - parse_.verbs.data());
      is_imperative_ = true;
      auxiliary_ = none;
    } else {
      is_auxiliary_denied_ = is_auxiliary_denied_ || piece.is_denied;
      begin_finite(piece.tokens, piece.base);
      denies_list_ = verb_at(verb_).is_denied;
      auxiliary_ = none;
    }
    pending_ = verb_;
  }
  bool before_is_be() const {
    return before_ == Tag::be || before_ == Tag::negation || before_ == Tag::auxiliary;
  }
  // "don't put": the auxiliary is no sign of a subject.
  bool auxiliary_command() const { return last_ == none || is_imperative_ || !fronted_.empty(); }

  // Behind its noun: "facing the window", "made of oak", "each surrounded by".
  void participle(const Piece& piece) {
    if (last_ == none) return fronted_participle(piece);
    VerbPhrase& verb = add_verb(VerbPhrase::Kind::participle, piece.tokens, piece.base);
    // "beside the sofa holding a mug": what is known already is not described.
    const bool is_known = at(last_).determiner == Determiner::definite;
    if (each_ != none)
      verb.subject = std::exchange(each_, none);
    else
      verb.subject = before_ == Tag::comma || is_known ? what_is_told_of() : last_;
    verb.is_passive = piece.form == VerbForm::past;
    participle_ = static_cast<std::int32_t>(&verb - parse_.verbs.data());
    pending_ = verb.is_passive ? none : participle_;
  }

  // "Facing the bed, a desk ...": said of what comes.
  void fronted_participle(const Piece& piece) {
    VerbPhrase& verb = add_verb(VerbPhrase::Kind::participle, piece.tokens, piece.base);
    verb.is_passive = piece.form == VerbForm::past;
    if (!verb.is_passive) pending_ = static_cast<std::int32_t>(&verb - parse_.verbs.data());
  }

  // ", topped with a lamp": of the subject of the clause, or of what has been placed by now.
  std::int32_t what_is_told_of() {
    if (verb_ != none && verb_at(verb_).kind == VerbPhrase::Kind::finite &&
        verb_at(verb_).subject != none && verb_at(verb_).object == none)
      return verb_at(verb_).subject;
    std::int32_t told = last_;
    for (auto i = parse_.attachments.size(); i-- > 0;) {
      const Attachment& one = parse_.attachments[i];
      if (one.to != told) continue;
      if (is_with(one.relation) || one.is_verb) break;
      told = one.from;
    }
    return told == none ? last_ : told;
  }

  void complement(const Chunk& chunk) {
    if (verb_ == none || verb_at(verb_).subject == none) return;
    VerbPhrase& verb = verb_at(verb_);
    if (verb.complement.empty()) verb.complement.begin = chunk.complement.begin;
    verb.complement.end = chunk.complement.end;
    if (is_denied_ || verb.is_denied)
      for (auto i = chunk.complement.begin; i < chunk.complement.end; ++i)
        parse_.modifiers[i].is_denied = true;
    is_denied_ = false;
  }

  void preposition(const Piece& piece) {
    Attachment attachment;
    attachment.tokens = piece.tokens;
    attachment.relation = piece.base;
    attachment.is_denied = is_denied_ || small_words().denying_prepositions.count(piece.base) > 0;
    is_denied_ = false;
    set_from(attachment);
    preposition_ = attachment;
    is_joined_ = has_comma_ = false;
    pending_ = none;
  }

  bool is_with(const std::string& relation) const {
    return relation == "with" || relation == "without";
  }

  void set_from(Attachment& attachment) {
    if (attachment.relation == "of" && before_ == Tag::noun) {
      attachment.from = last_;
    } else if (each_ != none) {
      attachment.from = std::exchange(each_, none);
    } else if (participle_ != none) {
      attachment.verb = participle_;
      attachment.from = verb_at(participle_).subject;
      participle_ = none;
    } else if (governs_places()) {
      attachment.verb = verb_;
      attachment.from = verb_at(verb_).subject;
      attachment.is_of_list = true;
    } else if (is_joined_ && is_with(attachment.relation)) {
      attachment.from = main_ != none ? main_ : last_;
    } else if (is_joined_ && open_.empty()) {
      attachment.from = none;
    } else {
      from_nearest(attachment);
    }
  }

  // "stands in the corner beside the bed": all that follows the verb is said of its subject, until
  // the object of the verb comes.
  bool governs_places() {
    if (verb_ == none || verb_at(verb_).subject == none) return false;
    const auto kind = verb_at(verb_).kind;
    if (kind != VerbPhrase::Kind::finite && kind != VerbPhrase::Kind::relative) return false;
    if (before_ == Tag::noun && !open_.empty() && open_.back().by == Opened::with) return false;
    return verb_at(verb_).object == none;
  }

  void from_nearest(Attachment& attachment) {
    attachment.from = top_of(last_);
    const bool is_known = last_ != none && (at(last_).is_pronoun
                                                ? at(last_).determiner != Determiner::each
                                                : at(last_).determiner == Determiner::definite);
    if (is_with(attachment.relation) && is_known)
      attachment.from = what_is_told_of();
    if (main_ != none && small_words().exceptions.count(attachment.relation))
      attachment.from = main_;
    // "a room for twelve with a screen"; "under the desk, but not in front of it"
    const Attachment* last = parse_.attachments.empty() ? nullptr : &parse_.attachments.back();
    const bool goes_on = last && last->to == last_ && !last->is_verb && last->relation != "of" &&
                         ((is_with(attachment.relation) && last->relation == "for") ||
                          before_ == Tag::conjunction || before_ == Tag::negation);
    if (goes_on) {
      attachment.from = last->from;
      attachment.is_of_list = last->is_of_list;
      return;
    }
    if (open_.empty() || is_with(attachment.relation)) return;
    OpenList& list = open_.back();
    const bool is_whole = list.last == attachment.from && list.first != list.last &&
                          list.by != Opened::with && !list.has_own_place && ended_by_conjunction_;
    attachment.is_of_list = is_whole;
    if (!is_whole && list.last == attachment.from) list.has_own_place = true;
  }

  // Of "a vase of flowers" the vase.
  std::int32_t top_of(std::int32_t phrase) const {
    if (parse_.attachments.empty() || phrase == none) return phrase;
    const Attachment& last = parse_.attachments.back();
    return last.to == phrase && last.relation == "of" && !last.is_verb ? last.from : phrase;
  }

  // ", each with a lamp": the members of what was said before.
  bool is_floating(std::int32_t id) {
    return at(id).is_pronoun && at(id).determiner == Determiner::each && is_joined_ &&
           last_ != none;
  }

  // "A rack stands by the door, a safe inside the wardrobe": something new with a place of its own is
  // no member of a list that what is known began.
  bool is_clause_without_verb(std::int32_t id) {
    const auto is_new = [](const NounPhrase& one) {
      return one.determiner == Determiner::indefinite || one.determiner == Determiner::another ||
             (one.determiner == Determiner::absent && one.count > 0);
    };
    const auto first = at(open_.back().first).determiner;
    const bool is_known = first == Determiner::definite || first == Determiner::possessive ||
                          first == Determiner::each;
    const bool has_place = ahead() == Tag::preposition && !is_with(chunks_[at_ + 1].piece->base) &&
                           chunks_[at_ + 1].piece->base != "of";
    return has_verb() && relative_ == none && is_known && is_new(at(id)) && has_place;
  }

  // "avoid glass tables, a living room with a sofa": what has something is wanted.
  bool is_described() const {
    return ahead() == Tag::preposition && is_with(chunks_[at_ + 1].piece->base);
  }

  void phrase(std::uint32_t number) {
    const auto id = static_cast<std::int32_t>(number);
    each_ = none;
    if (is_floating(id)) {
      each_ = main_ != none && (at(main_).is_plural || !at(last_).is_plural) ? main_ : last_;
      is_joined_ = has_comma_ = false;
      return;
    }
    if (denies_list_ && has_comma_ && is_described()) end_clause();
    if (denies_list_ || is_denied_) at(id).is_denied = true;
    if (preposition_) {
      under_preposition(id);
    } else if (pending_ != none) {
      under_verb(id);
    } else if (is_joined_ && !open_.empty() && is_clause_without_verb(id)) {
      end_clause();
      begin_main(id);
    } else if (is_joined_ && !open_.empty()) {
      further_member(id);
    } else {
      begin_main(id);
    }
    is_denied_ = false;
    last_ = id;
  }

  void under_preposition(std::int32_t id) {
    Attachment attachment = *preposition_;
    preposition_.reset();
    attachment.to = id;
    if (attachment.is_denied) at(id).is_denied = true;
    if (attachment.from == none) {
      fronted_.push_back(attachment);
      return;
    }
    const auto by = is_with(attachment.relation)  ? Opened::with
                    : attachment.relation == "of" ? Opened::of
                                                  : Opened::place;
    open(by, id, add(attachment));
  }

  std::int32_t add(const Attachment& attachment) {
    parse_.attachments.push_back(attachment);
    return static_cast<std::int32_t>(parse_.attachments.size() - 1);
  }
  void open(Opened by, std::int32_t id, std::int32_t attachment) {
    open_.push_back({by, id, id, attachment, false});
    is_joined_ = has_comma_ = ended_by_conjunction_ = false;
  }

  void under_verb(std::int32_t id) {
    VerbPhrase& verb = verb_at(pending_);
    const std::int32_t subject = verb.subject;
    // "On the left stands a cabinet"
    if (subject == none && verb.kind == VerbPhrase::Kind::finite) {
      verb.subject = id;
      pending_ = none;
      return begin_main(id);
    }
    verb.object = id;
    std::int32_t attachment = none;
    if (subject == none && verb.kind == VerbPhrase::Kind::participle) {
      fronted_.push_back(between(verb, pending_, none, id));
      pending_ = none;
      return;
    }
    if (subject != none) attachment = add(between(verb, pending_, subject, id));
    const bool is_main = verb.kind == VerbPhrase::Kind::imperative;
    if (is_main) main_ = id;
    pending_ = none;
    const bool has = small_words().verbs_of_having.count(verb.base) > 0;
    const bool is_clause = !has && verb.kind == VerbPhrase::Kind::participle;
    open(is_main ? Opened::object : is_clause ? Opened::clause : Opened::with, id, attachment);
    if (is_main) flush_fronted(id);
  }

  Attachment between(const VerbPhrase& verb, std::int32_t number, std::int32_t from,
                     std::int32_t to) const {
    Attachment attachment;
    attachment.from = from;
    attachment.is_of_list = verb.kind == VerbPhrase::Kind::finite;
    attachment.to = to;
    attachment.verb = number;
    attachment.tokens = verb.tokens;
    attachment.relation = verb.base;
    attachment.is_verb = true;
    attachment.is_denied = verb.is_denied;
    return attachment;
  }

  void begin_main(std::int32_t id) {
    const bool is_said_of = verb_ != none && verb_at(verb_).base == "be" &&
                            verb_at(verb_).subject != none && verb_at(verb_).subject != id;
    if (is_said_of) {
      // "The room is a kitchen": said of the subject.
      verb_at(verb_).object = id;
      open(Opened::object, id, none);
      return;
    }
    if (verb_ != none && verb_at(verb_).subject == none) verb_at(verb_).subject = id;
    main_ = id;
    open(Opened::subject, id, none);
    flush_fronted(id);
  }

  void flush_fronted(std::int32_t id) {
    for (Attachment attachment : fronted_) {
      attachment.from = id;
      fronted_of_.push_back(add(attachment));
    }
    fronted_.clear();
  }

  void further_member(std::int32_t id) {
    ended_by_conjunction_ = before_ == Tag::conjunction;
    while (open_.size() > 1 && !takes(open_.back(), id)) open_.pop_back();
    OpenList& list = open_.back();
    // "no rug, desk or plant"
    if (at(list.last).is_denied && is_bare(id)) at(id).is_denied = true;
    link(list, id);
    if (list.attachment != none) {
      Attachment attachment = parse_.attachments[static_cast<std::size_t>(list.attachment)];
      attachment.to = id;
      if (attachment.is_denied && !attachment.is_verb) at(id).is_denied = true;
      list.attachment = add(attachment);
    }
    is_joined_ = has_comma_ = false;
  }

  // Whether the noun phrase is another member of the list, rather than of one around it.
  bool takes(const OpenList& list, std::int32_t id) {
    // "two chairs facing a sofa, a lamp and ...": the sofa ends the clause.
    if (list.by == Opened::clause) return !has_comma_;
    // "..., a table holding a mug, and a lamp": the last of the outer list.
    if (list.by == Opened::with && has_comma_ && ended_by_conjunction_ && list.first == list.last &&
        is_within_list())
      return false;
    // "holds a vase filled with flowers and a bowl"
    if (list.by == Opened::with && is_bare(list.last) && !is_bare(id) && open_.size() > 1 &&
        resembles(open_[open_.size() - 2], id))
      return false;
    if (list.by == Opened::subject || list.by == Opened::object || list.by == Opened::with)
      return true;
    const std::string& relation =
        parse_.attachments[static_cast<std::size_t>(list.attachment)].relation;
    if (relation == "between" && list.first == list.last && !at(list.first).is_plural) return true;
    if (ahead() == Tag::preposition || has_comma_)
      return list.by == Opened::of && open_.size() == 2 && is_bare(id) && is_adjectival(list);
    return at(id).determiner == at(list.last).determiner &&
           (at(id).count > 0) == (at(list.last).count > 0) &&
           !resembles(open_[open_.size() - 2], id);
  }
  // Whether a list around the innermost one has several members by now.
  bool is_within_list() const {
    for (std::size_t i = 0; i + 1 < open_.size(); ++i)
      if (open_[i].first != open_[i].last) return true;
    return false;
  }
  bool is_bare(std::int32_t id) {
    return at(id).determiner == Determiner::absent && at(id).count == 0.0;
  }
  // "full of boxes"
  bool is_adjectival(const OpenList& list) {
    const Attachment& attachment = parse_.attachments[static_cast<std::size_t>(list.attachment)];
    return at(attachment.from).head + 1 < attachment.tokens.begin;
  }
  bool resembles(const OpenList& list, std::int32_t id) {
    return list.by != Opened::subject && at(list.last).determiner == at(id).determiner &&
           (at(id).count > 0) == (at(list.last).count > 0);
  }

  void link(OpenList& list, std::int32_t id) {
    NounPhrase& first = at(list.first);
    if (first.list == none) {
      first.list = static_cast<std::int32_t>(parse_.lists.size());
      parse_.lists.push_back({});
      members_.push_back({static_cast<std::uint32_t>(list.first)});
    }
    members_[static_cast<std::size_t>(first.list)].push_back(static_cast<std::uint32_t>(id));
    at(id).list = first.list;
    list.last = id;
  }

 public:
  // Lists grow while others are open: their members become runs in the end.
  void finish() {
    for (std::size_t i = 0; i < members_.size(); ++i) {
      parse_.lists[i].members.begin = static_cast<std::uint32_t>(parse_.members.size());
      parse_.members.insert(parse_.members.end(), members_[i].begin(), members_[i].end());
      parse_.lists[i].members.end = static_cast<std::uint32_t>(parse_.members.size());
    }
    for (const auto attachment : fronted_of_)
      parse_.attachments[static_cast<std::size_t>(attachment)].is_of_list = true;
  }

 private:
  const std::vector<Chunk>& chunks_;
  Parse& parse_;
  std::size_t at_ = 0;
  Tag before_ = Tag::stop;
  std::vector<OpenList> open_;       ///< outer ones first
  std::vector<Attachment> fronted_;  ///< "On the shelf": what they belong to comes later
  std::vector<std::int32_t> fronted_of_;
  std::vector<std::vector<std::uint32_t>> members_;
  std::optional<Attachment> preposition_;   ///< that waits for its noun phrase
  std::int32_t main_ = none, last_ = none;  ///< noun phrases
  std::int32_t relative_ = none;            ///< what the open relative clause is about
  std::int32_t verb_ = none, outer_verb_ = none, participle_ = none;
  std::int32_t pending_ = none;  ///< the verb that waits for its object
  std::int32_t each_ = none;     ///< what an "each" that stands alone and has just been read means
  std::int32_t auxiliary_ = none;
  bool has_existential_ = false, is_imperative_ = false, is_joined_ = false, has_comma_ = false;
  bool ended_by_conjunction_ = false;
  bool is_denied_ = false, is_auxiliary_denied_ = false, denies_list_ = false;
};

}  // namespace

void attach(const std::vector<Chunk>& chunks, Parse& parse) {
  Attacher attacher(chunks, parse);
  attacher.run();
  attacher.finish();
}

}  // namespace roomgen::language
