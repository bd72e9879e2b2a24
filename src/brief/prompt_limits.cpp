#include <algorithm>

#include "language/inflection.h"
#include "prompt_passes.h"
#include "scene/finish_words.h"

namespace roomgen::brief {

namespace {

using language::Attachment;
using language::none;
using language::NounPhrase;
using language::Run;

class LimitReader {
 public:
  explicit LimitReader(PromptReading& reading) : reading_(reading) {}

  void run() {
    for (std::uint32_t i = 0; i < reading_.text.plain.size(); ++i) {
      const auto match = longest(reading_.words.limits, reading_.text.plain, i);
      if (!match) continue;
      const Run words{i, i + static_cast<std::uint32_t>(match.length)};
      if (*match.value == "else") nothing_else(words);
      if (*match.value == "but") nothing_but(words);
      if (*match.value == "only") only(words);
      if (*match.value == "nothing") nothing(words);
      i = words.end - 1;
    }
    for (const auto& phrase : reading_.parse.phrases) {
      without_anything(phrase);
      bare_room(phrase);
    }
  }

 private:
  // "nothing else", "no other furniture", "no other chairs", "nothing else on the desk"
  void nothing_else(const Run& words) {
    Limit limit;
    Run run = words;
    const std::int32_t id = phrase_around(words);
    if (const Kind* named = class_behind(id, words.end)) {
      limit.category = named->name;
      ++run.end;
    } else if (id != none && !reading_.phrase(id).is_pronoun) {
      const NounPhrase& said = reading_.phrase(id);
      if (!names_anything(said)) {
        const KindMention& kind = reading_.thing(id).kind;
        if (kind.length == 0) return;
        limit.category = reading_.talk.category_name(kind);
      }
      run.end = std::max(run.end, said.head + 1);
    }
    find_place(id, words.begin, limit);
    if (limit.on != no_mention) limit.allowed = things_said_on(limit.on);
    add(std::move(limit), run);
  }

  // "no other seating"
  const Kind* class_behind(std::int32_t id, std::uint32_t token) const {
    if (id == none || !reading_.phrase(id).is_pronoun || token >= reading_.text.plain.size()) return nullptr;
    const auto verb = language::verb(reading_.word(token));
    return verb ? reading_.text.table.by_name(verb->base) : nullptr;
  }

  // "nothing but a bed and a lamp", "on the desk no more than a laptop, a lamp and a tray"
  void nothing_but(const Run& words) {
    Limit limit;
    const std::int32_t first = phrase_behind(words.end);
    if (first == none || is_number(first)) return;
    limit.allowed = mentions_listed(first);
    if (limit.allowed.empty()) return;
    find_place_of_list(first, limit);
    if (limit.on == no_mention) take_place_before(words.begin, limit);
    for (const std::size_t one : limit.allowed) reading_.brief.mentions[one].at_most = false;  // it shall be there
    add(std::move(limit), words);
  }

  // "with only a bed and a desk": before a number it only says that it is exact.
  void only(const Run& words) {
    static const WordSet holders = {"with", "containing", "contains", "has", "have", "holds", "so"};
    if (words.begin == 0 || !holders.count(reading_.word(words.begin - 1))) return;
    nothing_but(words);
  }

  // "nothing on the walls", "nothing hanging from the ceiling but one globe": up to the end of the clause.
  void nothing(const Run& words) {
    if (exclude_looks(words)) return;
    Limit limit;
    Run run = words;
    find_place(phrase_around(words), words.begin, limit);
    const auto end = clause_end(words.end);
    for (auto i = words.end; i < end; ++i) {
      const auto part = reading_.words.room_parts.find(reading_.word(i));
      if (part != reading_.words.room_parts.end() && limit.on == no_mention) {
        if (part->second == "ceiling") limit.mount = Mount::ceiling;
        if (part->second == "wall") limit.mount = Mount::wall;
      }
      const std::size_t exception = longest_in(reading_.words.exceptions, reading_.text.plain, i);
      if (exception == 0) continue;
      run.end = i + static_cast<std::uint32_t>(exception);
      if (const std::int32_t first = phrase_behind(run.end); first != none) limit.allowed = mentions_listed(first);
      if (limit.allowed.empty()) return;
      break;
    }
    if (limit.allowed.empty() && limit.is_of_room()) return;  // "nothing shouting"
    limit.is_nothing = limit.allowed.empty();
    if (limit.is_nothing) run.end = end;
    add(std::move(limit), run);
  }

  // "nothing purple", "nothing red or dark green": whether that is what is said.
  bool exclude_looks(const Run& words) {
    std::vector<std::pair<std::string, Run>> looks;
    bool is_joined = true;
    for (auto i = words.end; i < reading_.text.plain.size(); ++i) {
      if (reading_.is_word(i, "or") || reading_.is_word(i, "and") || reading_.text.plain[i].kind == Token::Kind::comma) {
        is_joined = true;
        continue;
      }
      if (!finish_words().describes(reading_.word(i))) break;
      if (is_joined) looks.push_back({reading_.word(i), {i, i + 1}});
      else looks.back().first += " " + reading_.word(i), looks.back().second.end = i + 1;
      is_joined = false;
    }
    for (std::size_t n = 0; n < looks.size(); ++n) {
      const Run run{n == 0 ? words.begin : looks[n].second.begin, looks[n].second.end};
      hear(reading_.brief, run, Heard::As::absence, looks[n].first);
      reading_.brief.excluded_looks.push_back({"", looks[n].first});
    }
    return !looks.empty();
  }

  // "almost without objects"
  void without_anything(const NounPhrase& said) {
    if (!said.is_denied || said.is_pronoun || !names_anything(said) || denies_others(reading_, said)) return;
    for (const Attachment& attachment : reading_.parse.attachments)
      if (attachment.from != none && &reading_.phrase(attachment.from) == &said) return;
    if (said.modifiers.empty()) add({}, {said.tokens.begin, said.head + 1});
  }

  // "a bare room": it says no more than that little is added.
  void bare_room(const NounPhrase& said) {
    if (!reading_.is_room(said)) return;
    for (auto i = said.tokens.begin; i < said.head; ++i)
      if (reading_.is_word(i, "bare") || reading_.is_word(i, "empty")) reading_.brief.bare = true;
  }

  void add(Limit limit, const Run& words) {
    if (limit.is_of_room()) reading_.brief.bare = true;
    limit.heard = hear(reading_.brief, words, Heard::As::absence, said_limit);
    if (limit.on != no_mention) put_on(limit);
    reading_.brief.limits.push_back(std::move(limit));
  }

  // What is nothing but there, is there.
  void put_on(const Limit& limit) {
    reading_.talk.told_by(limit.heard);
    for (const std::size_t one : limit.allowed)
      if (one != limit.on) reading_.talk.add(one, {RelationKind::on, limit.on, "", false});
    reading_.talk.told_by(HeardWords::none);
  }

  bool names_anything(const NounPhrase& said) const { return reading_.words.anything.count(reading_.word(said.head)) > 0; }
  bool is_number(std::int32_t id) const {
    const NounPhrase& said = reading_.phrase(id);
    return said.count > 0 && said.determiner != language::Determiner::indefinite;
  }
  std::int32_t phrase_around(const Run& words) const {
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const NounPhrase& said = reading_.parse.phrases[i];
      if (said.tokens.begin < words.end && said.head + 1 > words.begin) return static_cast<std::int32_t>(i);
    }
    return none;
  }
  // The one that begins there, or behind an article that it leaves out.
  std::int32_t phrase_behind(std::uint32_t token) const {
    constexpr std::uint32_t nearest = 2;
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const NounPhrase& said = reading_.parse.phrases[i];
      if (said.head >= token && said.tokens.begin <= token + nearest) return static_cast<std::int32_t>(i);
    }
    return none;
  }
  // The members of a list; of "a laptop, a green lamp and a tray" the first may stand before it.
  std::vector<std::int32_t> members_of(std::int32_t first) const {
    std::vector<std::int32_t> members;
    const auto add = [&](std::int32_t phrase) {
      for (const auto one : reading_.parse.with_list(static_cast<std::uint32_t>(phrase)))
        if (static_cast<std::int32_t>(one) >= phrase) members.push_back(static_cast<std::int32_t>(one));
    };
    add(first);
    const auto end = reading_.phrase(first).head + 1;
    const bool goes_on = reading_.phrase(first).list == none && first + 1 < std::ssize(reading_.parse.phrases) &&
                         end < reading_.text.plain.size() && reading_.text.plain[end].kind == Token::Kind::comma &&
                         reading_.phrase(first + 1).list != none && reading_.phrase(first + 1).tokens.begin == end + 1;
    if (goes_on) add(first + 1);
    return members;
  }
  Indices mentions_listed(std::int32_t first) const {
    Indices all;
    for (const auto one : members_of(first))
      for (const std::size_t mention : reading_.all_of(one))
        if (!is_among(all, mention)) all.push_back(mention);
    return all;
  }
  std::uint32_t clause_end(std::uint32_t token) const {
    while (token < reading_.text.plain.size() && reading_.text.plain[token].kind != Token::Kind::comma &&
           reading_.text.plain[token].kind != Token::Kind::stop)
      ++token;
    return token;
  }

  // The thing on which a phrase is, or, where "nothing" is no phrase, what stands behind a preposition there.
  void find_place(std::int32_t id, std::uint32_t token, Limit& limit) const {
    for (const Attachment& attachment : reading_.parse.attachments) {
      const bool is_here = id != none ? attachment.from == id
                                      : attachment.tokens.begin > token && attachment.tokens.begin < clause_end(token);
      if (is_here) take_place(attachment, limit);
    }
  }
  void find_place_of_list(std::int32_t first, Limit& limit) const {
    const auto members = members_of(first);
    for (const Attachment& attachment : reading_.parse.attachments)
      if (std::find(members.begin(), members.end(), attachment.from) != members.end()) take_place(attachment, limit);
  }
  // "On the desk no more than ..."
  void take_place_before(std::uint32_t token, Limit& limit) const {
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const NounPhrase& said = reading_.parse.phrases[i];
      const auto target = reading_.mention_of(static_cast<std::int32_t>(i));
      if (said.head + 1 != token || said.tokens.begin == 0 || !target) continue;
      const auto placement = reading_.words.placements.find(reading_.word(said.tokens.begin - 1));
      if (placement != reading_.words.placements.end() && placement->second.relations.front() == RelationKind::on &&
          !is_among(limit.allowed, *target))
        limit.on = *target;
    }
  }
  void take_place(const Attachment& attachment, Limit& limit) const {
    const auto& said = reading_.placement(attachment);
    if (!said || said->placement->inverse || said->placement->relations.front() != RelationKind::on) return;
    if (const auto target = reading_.mention_of(said->target); target && !is_among(limit.allowed, *target))
      limit.on = *target;
  }
  // What the prompt says is on a thing, before "nothing else".
  Indices things_said_on(std::size_t target) const {
    Indices all;
    for (const Attachment& attachment : reading_.parse.attachments) {
      const auto& said = reading_.placement(attachment);
      if (!said || said->placement->relations.front() != RelationKind::on) continue;
      const bool is_inverse = said->placement->inverse;
      if (reading_.mention_of(is_inverse ? attachment.from : said->target) != target) continue;
      for (const std::size_t one : is_inverse ? reading_.all_of(attachment.to) : reading_.subjects_of(attachment))
        if (one != target && !is_among(all, one)) all.push_back(one);
    }
    return all;
  }

  PromptReading& reading_;
};

}  // namespace

void read_limits(PromptReading& reading) { LimitReader(reading).run(); }

namespace {

// "each desk is white", "each other", "each 2 m high": of all of them, or said of what is read with the words around it.
bool says_nothing_more(const PromptReading& reading, std::uint32_t each, const std::vector<bool>& heard) {
  const auto next = each + 1;
  if (next >= heard.size() || heard[next] || reading.is_word(next, "other") || reading.is_word(next, "of")) return true;
  const std::string& word = reading.word(next);
  if (reading.words.portions.count(word) || reading.words.shares.count(word) || reading.words.room_parts.count(word)) return true;
  return std::any_of(reading.parse.phrases.begin(), reading.parse.phrases.end(), [&](const NounPhrase& said) {
    const auto mention = reading.mentions[static_cast<std::size_t>(&said - reading.parse.phrases.data())];
    return said.tokens.begin <= each && each < said.tokens.end && mention && reading.talk.mention(*mention).quantity != 1;
  });
}

}  // namespace

void note_lost_limits(PromptReading& reading) {
  static const WordSet sharing = {"each", "every", "per"};
  const std::vector<bool> heard = reading.heard_tokens();
  for (std::uint32_t i = 0; i < heard.size(); ++i) {
    if (heard[i]) continue;
    const auto match = longest(reading.words.limits, reading.text.plain, i, 1);
    const bool is_only = match && *match.value == "only" && !reading.is_word(i, "just") && !(i > 0 && reading.is_word(i - 1, "not"));
    if (is_only || (sharing.count(reading.word(i)) && !says_nothing_more(reading, i, heard)))
      hear(reading.brief, {i, i + 1}, Heard::As::not_understood);
  }
}

bool denies_others(const PromptReading& reading, const NounPhrase& phrase) {
  for (auto i = phrase.tokens.begin > 0 ? phrase.tokens.begin - 1 : 0; i <= phrase.head; ++i) {
    const auto match = longest(reading.words.limits, reading.text.plain, i);
    if (match && *match.value == "else") return true;
  }
  return false;
}

}  // namespace roomgen::brief
