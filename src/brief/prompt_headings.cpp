#include <algorithm>

#include "prompt_passes.h"

namespace roomgen::brief {

namespace {

using language::Run;

constexpr std::uint32_t words_before = 4;  ///< "Along the", "On the very", "Main room, "

/// A place, and the tokens of which it is said.
struct Heading {
  PlacePhrase place;
  Run tokens;
  Run body;
};

/// "On the desk:", "Beside the bed:"
struct ThingHeading {
  const Placement* placement = nullptr;
  std::size_t target = 0;  ///< mention
  Run tokens;
  Run body;
};

class HeadingReader {
 public:
  explicit HeadingReader(PromptReading& reading) : reading_(reading) {}

  void run() {
    for (std::size_t i = 0; i + 1 < reading_.parse.sentences.size(); ++i)
      if (const auto heading = heading_at(i))
        apply(*heading);
      else if (const auto of_thing = thing_heading_at(i))
        apply(*of_thing);
  }

 private:
  bool is_mark(std::uint32_t token, std::string_view mark) const {
    const auto& one = reading_.parse.tokens[token];
    return one.kind == language::Token::Kind::stop && one.text == mark;
  }

  std::optional<Heading> heading_at(std::size_t number) const {
    const Run& said = reading_.parse.sentences[number];
    if (!reading_.announces(said) || !new_things(said).empty()) return std::nullopt;
    for (auto i = said.begin; i < std::min(said.end, said.begin + words_before); ++i) {
      const auto place = read_place(reading_.text.plain, i, reading_.words);
      if (!place || place->place == Place::room) continue;
      return Heading{*place,
                     {said.begin, i + static_cast<std::uint32_t>(place->length)},
                     {said.end, end_of_body(number + 1)}};
    }
    return std::nullopt;
  }
  // A preposition and a thing that was spoken of, and no more.
  std::optional<ThingHeading> thing_heading_at(std::size_t number) const {
    const Run& said = reading_.parse.sentences[number];
    if (!reading_.announces(said)) return std::nullopt;
    const auto match = longest(reading_.words.placements, reading_.text.plain, said.begin);
    if (!match || match.value->inverse || match.value->pronoun) return std::nullopt;
    const auto begin = said.begin + static_cast<std::uint32_t>(match.length);
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const auto& phrase = reading_.parse.phrases[i];
      if (phrase.tokens.begin == begin && phrase.head + 2 == said.end && reading_.mentions[i])
        return ThingHeading{match.value, *reading_.mentions[i], {said.begin, phrase.head + 1},
                            {said.end, end_of_body(number + 1)}};
    }
    return std::nullopt;
  }
  // Behind a semicolon it goes on.
  std::uint32_t end_of_body(std::size_t number) const {
    const auto& sentences = reading_.parse.sentences;
    while (number + 1 < sentences.size() && is_mark(sentences[number].end - 1, ";")) ++number;
    return sentences[number].end;
  }

  // The mentions that are named first there.
  std::vector<std::size_t> new_things(const Run& tokens) const {
    std::vector<std::size_t> result;
    std::vector<bool> known(reading_.brief.mentions.size(), false);
    for (std::size_t i = 0; i < reading_.parse.phrases.size(); ++i) {
      const auto mention = reading_.mentions[i];
      const auto head = reading_.parse.phrases[i].head;
      if (!mention || known[*mention]) continue;
      known[*mention] = true;
      if (head >= tokens.begin && head < tokens.end) result.push_back(*mention);
    }
    return result;
  }

  // What is on, in or beside something follows that.
  bool has_place(const Mention& mention, const PlacePhrase& place) const {
    const bool is_region = place.place == Place::region;
    return std::any_of(mention.demands.begin(), mention.demands.end(), [&](const Demand& demand) {
      return demand.mention != Demand::none || demand.kind == RelationKind::in_part ||
             (!is_region && demand.kind != RelationKind::edge);
    });
  }

  void apply(const Heading& heading) {
    std::vector<std::size_t> things;
    for (const std::size_t mention : new_things(heading.body))
      if (!reading_.talk.is_small(mention) &&
          !has_place(reading_.talk.mention(mention), heading.place))
        things.push_back(mention);
    if (things.empty()) return;
    static const Placement there{{RelationKind::near}};
    reading_.talk.told_by(hear(reading_.brief, heading.tokens, Heard::As::relation));
    reading_.talk.locate(things, there, heading.place);
  }

  // Of what is on it the small things; what has a place of its own keeps it.
  void apply(const ThingHeading& heading) {
    const bool carries = heading.placement->relations.front() == RelationKind::on;
    std::vector<std::size_t> things;
    for (const std::size_t mention : new_things(heading.body))
      if (mention != heading.target && reading_.talk.mention(mention).demands.empty() &&
          (!carries || reading_.talk.is_small(mention)))
        things.push_back(mention);
    if (things.empty()) return;
    reading_.talk.told_by(hear(reading_.brief, heading.tokens, Heard::As::relation));
    for (const auto kind : heading.placement->relations)
      reading_.talk.demand(things, {kind, heading.target, "", heading.placement->flank});
  }

  PromptReading& reading_;
};

}  // namespace

void read_headings(PromptReading& reading) { HeadingReader(reading).run(); }

}  // namespace roomgen::brief
