#include "language/parse.h"

#include <ctime>
#include <iostream>

#include "base/random.h"
#include "catch.h"

using namespace roomgen;
using namespace roomgen::language;

namespace {

bool is_index(std::int32_t index, std::size_t size) {
  return index >= none && index < static_cast<std::int32_t>(size);
}

// Whatever is parsed: every index leads somewhere, every run lies in its vector, in the order of
// the text.
void check_whole(const Parse& parse, std::string_view text) {
  std::uint32_t last = 0;
  for (const auto& phrase : parse.phrases) {
    REQUIRE(phrase.tokens.begin < phrase.tokens.end);
    REQUIRE(phrase.tokens.end <= parse.tokens.size());
    REQUIRE(phrase.tokens.begin >= last);
    REQUIRE(phrase.head >= phrase.tokens.begin);
    REQUIRE(phrase.head < phrase.tokens.end);
    REQUIRE(phrase.modifiers.end <= parse.modifiers.size());
    REQUIRE(is_index(phrase.measure, parse.measures.size()));
    REQUIRE(is_index(phrase.list, parse.lists.size()));
    REQUIRE(parse.span_of(phrase.tokens).end <= text.size());
    last = phrase.tokens.end;
  }
  for (const auto& attachment : parse.attachments) {
    REQUIRE(attachment.from >= 0);
    REQUIRE(attachment.to >= 0);
    REQUIRE(is_index(attachment.from, parse.phrases.size()));
    REQUIRE(is_index(attachment.to, parse.phrases.size()));
    REQUIRE(is_index(attachment.verb, parse.verbs.size()));
    REQUIRE(attachment.tokens.end <= parse.tokens.size());
  }
  for (const auto& verb : parse.verbs) {
    REQUIRE(is_index(verb.subject, parse.phrases.size()));
    REQUIRE(is_index(verb.object, parse.phrases.size()));
    REQUIRE(verb.complement.end <= parse.modifiers.size());
  }
  for (const auto& list : parse.lists) REQUIRE(list.members.end <= parse.members.size());
  for (const auto member : parse.members) REQUIRE(member < parse.phrases.size());
}

std::string random_words(Random& random, int count) {
  const char* const words[] = {"a",   "the",   "chair", "with", "and",  ",",  "of",    "on",
                               "is",  "there", "that",  "two",  "each", "no", "place", "standing",
                               "red", "its",   "not",   ".",    "half", "m",  "3",     "x",
                               "to",  "one",   "other", "-",    "'s",   "has"};
  std::string text;
  for (int i = 0; i < count; ++i)
    text += std::string(words[random.integer(0, 29)]) + (random.integer(0, 9) ? " " : "");
  return text;
}

std::string random_bytes(Random& random, int length) {
  std::string text;
  for (int i = 0; i < length; ++i) text += static_cast<char>(random.integer(0, 255));
  return text;
}

double seconds_for(const std::string& text) {
  const std::clock_t start = std::clock();
  check_whole(parse(text), text);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

const Attachment* attachment_of(const Parse& parse, std::string_view relation) {
  for (const auto& attachment : parse.attachments)
    if (attachment.relation == relation) return &attachment;
  return nullptr;
}

}  // namespace

TEST_CASE("Anything is parsed, and all of the parse is sound") {
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    const std::string text = i % 4 ? random_words(random, random.integer(0, 40))
                                   : random_bytes(random, random.integer(0, 80));
    check_whole(parse(text), text);
  }
}

TEST_CASE("100,000 bytes of hostile text take no longer than others") {
  Random random(12);
  std::vector<std::string> texts{random_bytes(random, 100'000),
                                 random_words(random, 25'000).substr(0, 100'000)};
  for (const std::string_view piece : {"a,", "a and ", "a chair on a chair ", "on ", "a-", "x",
                                       "3 x ", "that is ", "chair ", "no ", "((", "'s ", "red, "}) {
    std::string text;
    while (text.size() < 100'000) text += piece;
    texts.push_back(text);
  }
  double most = 0.0;
  for (const auto& text : texts) most = std::max(most, seconds_for(text));
  std::cout << "parse: at most " << 1000 * most << " ms for 100,000 hostile bytes\n";
  CHECK(most < 10.0);  // about 0.3 s; whatever grows with the square takes minutes
}

TEST_CASE("A trailing place belongs to the whole list") {
  const auto parsed = parse("Put a jug, two cups and a plate on the counter.");
  const auto* on = attachment_of(parsed, "on");
  REQUIRE(on);
  CHECK(on->is_of_list);
  CHECK(parsed.with_list(static_cast<std::uint32_t>(on->from)).size() == 3);
}

TEST_CASE("What is denied says so") {
  for (const char* text :
       {"No rug.", "A room without a rug.", "Avoid rugs.", "Do not use a rug.", "There is no rug.",
        "The room should not have a rug.", "Don't add any rugs."}) {
    INFO(text);
    const auto parsed = parse(text);
    REQUIRE_FALSE(parsed.phrases.empty());
    CHECK(parsed.head_of(parsed.phrases.back()) == "rug");
    CHECK(parsed.phrases.back().is_denied);
  }
  for (const char* text : {"A rug.", "The lamp is not on the rug."})
    CHECK(parse(text).phrases.size() > 0);
  CHECK_FALSE(parse("A rug, not large.").phrases.front().is_denied);
}

TEST_CASE("A denial ends where something is described") {
  const Parse parsed = parse("Avoid glass tables, a living room with a sofa.");
  REQUIRE(parsed.phrases.size() == 3);
  CHECK(parsed.phrases[0].is_denied);
  CHECK_FALSE(parsed.phrases[1].is_denied);
  CHECK_FALSE(parsed.phrases[2].is_denied);
}

TEST_CASE("Spans lead back to the text") {
  const std::string text =
      "Please place two L-shaped sofas \u2014 red ones \u2014 beside the caf\u00e9 table.";
  const auto parsed = parse(text);
  CHECK(parsed.span_of(parsed.phrases.front().tokens).of(text) == "two L-shaped sofas");
  CHECK(parsed.span_of(parsed.phrases.back().tokens).of(text) == "the caf\u00e9 table");
}

TEST_CASE("Verbs are told apart by what they do") {
  const auto kind = [](const char* text) { return parse(text).verbs.at(0).kind; };
  CHECK(kind("Add a lamp.") == VerbPhrase::Kind::imperative);
  CHECK(kind("There are two lamps.") == VerbPhrase::Kind::existential);
  CHECK(kind("The lamp stands here.") == VerbPhrase::Kind::finite);
  CHECK(kind("A lamp hanging from the ceiling.") == VerbPhrase::Kind::participle);
  CHECK(kind("A shelf that holds books.") == VerbPhrase::Kind::relative);
}

TEST_CASE("A measure belongs to its noun") {
  const auto parsed = parse("A 2 m long desk and a 30 cm high box.");
  REQUIRE(parsed.phrases.size() == 2);
  REQUIRE(parsed.phrases[1].measure != none);
  CHECK(parsed.measures[static_cast<std::size_t>(parsed.phrases[0].measure)].values[0] == 2.0);
  CHECK(parsed.measures[static_cast<std::size_t>(parsed.phrases[1].measure)].side ==
        Measure::Side::height);
}

TEST_CASE("The same text gives the same parse") {
  const std::string text =
      "A room with a bed, a desk and two chairs by the window that faces the sea.";
  const auto a = parse(text), b = parse(text);
  REQUIRE(a.attachments.size() == b.attachments.size());
  for (std::size_t i = 0; i < a.attachments.size(); ++i) {
    CHECK(a.attachments[i].relation == b.attachments[i].relation);
    CHECK(a.attachments[i].tokens == b.attachments[i].tokens);
  }
}

TEST_CASE("What comes with an article behind a denied bare noun is there") {
  const auto parsed = parse("A bar with eight stools without backs, and a sofa in the corner.");
  REQUIRE(parsed.phrases.size() >= 4);
  CHECK(parsed.phrases[2].is_denied);
  CHECK(!parsed.phrases[3].is_denied);
}

TEST_CASE("A relative clause in the singular is of the last of a list") {
  const auto one = parse("A bench, a mirror and a plant that is near the door.");
  REQUIRE(!one.attachments.empty());
  CHECK(!one.attachments.back().is_of_list);
  CHECK(one.attachments.back().from == 2);
  CHECK(parse("A bench, a mirror and a plant that are near the door.").attachments.back().is_of_list);
  CHECK(!parse("A bench and a plant that stands by the door.").attachments.back().is_of_list);
}
