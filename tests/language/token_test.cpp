#include "language/token.h"


#include "base/random.h"
#include "catch.h"

using namespace roomgen;
using namespace roomgen::language;

namespace {

std::string texts(std::string_view text) {
  std::string result;
  for (const auto& token : tokenize(text))
    result += (result.empty() ? "" : "|") + token.text + token.clitic;
  return result;
}

std::string random_bytes(Random& random, int length, bool is_ascii) {
  std::string text;
  for (int i = 0; i < length; ++i)
    text += static_cast<char>(random.integer(is_ascii ? 9 : 0, is_ascii ? 126 : 255));
  return text;
}

void check_spans(const std::string& text) {
  std::uint32_t end = 0;
  for (const auto& token : tokenize(text)) {
    REQUIRE(token.span.begin >= end);
    REQUIRE(token.span.end > token.span.begin);
    REQUIRE(token.span.end <= text.size());
    // Nothing but white space and hyphens is left out.
    for (std::uint32_t i = end; i < token.span.begin; ++i)
      REQUIRE((static_cast<unsigned char>(text[i]) > 127 ||
               std::string_view(" \t\r\f\v-").find(text[i]) != std::string_view::npos));
    end = token.span.end;
  }
}

}  // namespace

TEST_CASE("A text becomes words, numbers and marks") {
  CHECK(texts("A red, L-shaped sofa (4x5m).") == "a|red|,|l|shaped|sofa|(|4|x|5|m|)|.");
  CHECK(texts("2.5 m by 3,5m; 1,200 mm") == "2.5|m|by|3,5|m|;|1,200|mm");
  CHECK(texts("20 m², 5 m2 & 1970s") == "20|m2|,|5|m2|and|1970s");
  CHECK(texts("approx. 3 sq. m. of CAFÉ TÜREN") == "approx|3|sq|m|.|of|café|türen");
  CHECK(texts("").empty());
}

TEST_CASE("Numbers have their values") {
  const auto value = [](std::string_view text) { return tokenize(text).front().value; };
  CHECK(value("2.50") == 2.5);
  CHECK(value("3,5") == 3.5);
  CHECK(value("1,200") == 1200.0);
  CHECK(value("12,500,000") == 12500000.0);
  CHECK(value("2½") == 2.5);
  CHECK(value("¾") == 0.75);
  CHECK(value("3rd") == 3.0);
  CHECK(tokenize("3rd").front().kind == Token::Kind::ordinal);
  // A list without spaces is no decimal.
  CHECK(texts("1,2345") == "1|,|2345");
}

TEST_CASE("Marks behind a number are feet and inches, quotes are none") {
  CHECK(texts("6'2\" tall, 5′ 3″") == "6|ft|2|in|tall|,|5|ft|3|in");
  CHECK(texts("a sign saying \"room 6\"") == "a|sign|saying|\"|room|6|\"");
}

TEST_CASE("Clitics are parted from their words") {
  CHECK(texts("don't, kid's, kids', there's, we\u2019ll") ==
        "don't|,|kid's|,|kids'|,|there's|,|we'll");
  CHECK(tokenize("don't").front().text == "do");
  CHECK(tokenize("can\u2019t").front().clitic == "n't");
  CHECK(tokenize("kids' room").front().text == "kids");
}

TEST_CASE("Hyphens and figures are joints") {
  const auto tokens = tokenize("a twenty-one 3-seater - 4x");
  CHECK(tokens[2].joint == Token::Joint::hyphen);
  CHECK(tokens[4].joint == Token::Joint::hyphen);
  CHECK(tokens[5].kind == Token::Kind::symbol);
  CHECK(tokens[6].joint == Token::Joint::apart);
  CHECK(tokens[7].joint == Token::Joint::none);
}

TEST_CASE("Spans are in order and cover the text, whatever its bytes") {
  check_spans("Don\u2019t place 2½ “big” chairs \u2014 6'2\" each – near the café!");
  Random random(3);
  for (int i = 0; i < 400; ++i)
    check_spans(random_bytes(random, random.integer(0, 60), i % 2 == 0));
}

TEST_CASE("Of a word that is longer than any the start is kept, in whole characters") {
  const auto tokens = tokenize("a " + std::string(5000, 'x') + " bed");
  REQUIRE(tokens.size() == 3);
  CHECK(tokens[1].text == std::string(longest_word, 'x'));
  CHECK(tokens[1].span.size() == 5000);
  std::string accents = "x";  // so that the limit falls into a character
  for (int i = 0; i < 100; ++i) accents += "\xC3\xA9";
  const auto cut = tokenize(accents);
  CHECK(cut.front().text == accents.substr(0, longest_word + 1));
}

TEST_CASE("100,000 bytes of anything are read at once") {
  Random random(5);
  for (const bool is_ascii : {true, false})
    CHECK(tokenize(random_bytes(random, 100'000, is_ascii)).size() > 1000);
  CHECK(tokenize(std::string(100'000, '\'')).size() <= max_tokens);
}
