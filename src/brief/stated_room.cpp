#include "stated_room.h"

#include <algorithm>

#include "kind_mention.h"
#include "language/lexicon.h"

namespace roomgen::brief {

namespace {

using language::lexicon;
using language::NounPhrase;
using language::PartOfSpeech;
using language::WordClass;

constexpr int most_steps = 2;  // up in WordNet

class Finder {
 public:
  Finder(const PromptText& text, const std::function<bool(std::uint32_t)>& is_named)
      : text_(text), parse_(text.parse), is_named_(is_named) {}

  std::optional<StatedRoom> run() const {
    for (const auto& verb : parse_.verbs)
      if (verb.base == "be" && !verb.is_denied && verb.subject != language::none && verb.object != language::none &&
          is_the_room(parse_.phrases[static_cast<std::size_t>(verb.subject)]))
        if (auto found = room(parse_.phrases[static_cast<std::size_t>(verb.object)], true)) return found;
    const bool begins = !parse_.phrases.empty() && parse_.phrases.front().list == language::none &&
                        parse_.phrases.front().tokens.begin == 0;
    return begins ? room(parse_.phrases.front(), false) : std::nullopt;
  }

 private:
  const std::string& word(std::uint32_t token) const { return text_.plain[token].text; }

  // "the room", "this"
  bool is_the_room(const NounPhrase& phrase) const {
    const std::string& noun = word(phrase.head);
    return phrase.is_pronoun ? noun == "this" || (noun == "it" && phrase.head == 0)
                             : text_.words.generic_rooms.count(noun) > 0;
  }

  std::optional<StatedRoom> room(const NounPhrase& phrase, bool is_told) const {
    if (phrase.is_pronoun || phrase.is_denied || phrase.is_plural || phrase.count > 1.0 ||
        text_.words.generic_rooms.count(word(phrase.head)) || text_.words.room_parts.count(word(phrase.head)) ||
        is_named_(phrase.head))
      return std::nullopt;
    std::uint32_t first = phrase.head;
    while (first > phrase.tokens.begin && is_noun_before(phrase, first - 1)) --first;
    for (auto i = first; i <= phrase.head; ++i)
      if (mention_at(text_.table, text_.plain, i).length > 0) return std::nullopt;
    if (!may_be_room(first, phrase.head)) return std::nullopt;
    return StatedRoom{text_between(first, phrase.head), {first, phrase.head + 1}, is_told};
  }
  bool is_noun_before(const NounPhrase& phrase, std::uint32_t token) const {
    for (auto i = phrase.modifiers.begin; i < phrase.modifiers.end; ++i)
      if (parse_.modifiers[i].kind == language::Modifier::Kind::noun && parse_.modifiers[i].tokens.begin <= token &&
          token < parse_.modifiers[i].tokens.end)
        return true;
    return false;
  }
  bool may_be_room(std::uint32_t first, std::uint32_t head) const {
    const auto is_one = [](const std::string& noun) {
      return lexicon().may_be(noun, WordClass::room) || lexicon().may_be(noun, WordClass::building);
    };
    return is_one(text_between(first, head)) || is_one(word(head));
  }
  std::string text_between(std::uint32_t first, std::uint32_t last) const {
    std::string text = word(first);
    for (auto i = first + 1; i <= last; ++i) text += " " + word(i);
    return text;
  }

  const PromptText& text_;
  const language::Parse& parse_;
  const std::function<bool(std::uint32_t)>& is_named_;
};

}  // namespace

std::optional<StatedRoom> stated_room(const PromptText& text, const std::function<bool(std::uint32_t)>& is_named) {
  return Finder(text, is_named).run();
}

std::string near_room(std::string_view name, const std::map<std::string, std::string, std::less<>>& names) {
  for (const auto& sense : lexicon().common_senses(name, PartOfSpeech::noun)) {
    if (!sense.is(WordClass::room) && !sense.is(WordClass::building)) continue;
    std::vector<std::uint32_t> level{sense.synset};
    for (int steps = 0; steps <= most_steps; ++steps) {
      std::vector<std::uint32_t> above;
      for (const auto synset : level) {
        for (const auto member : lexicon().members(synset))
          if (const auto found = names.find(member); found != names.end()) return found->second;
        for (const auto general : lexicon().more_general(synset)) above.push_back(general);
      }
      level = std::move(above);
    }
  }
  return "";
}

}  // namespace roomgen::brief
