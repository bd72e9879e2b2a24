#include "catch.h"
#include "roomgen/lab/questions.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

SpatialQuestion number(double truth, const std::string& unit = "m", double tolerance = 0.1) {
  SpatialQuestion question;
  question.unit = unit;
  question.number = truth;
  question.tolerance = tolerance;
  return question;
}

SpatialQuestion choice(std::vector<std::string> choices, std::size_t right) {
  SpatialQuestion question;
  question.choices = std::move(choices);
  question.right = right;
  return question;
}

}  // namespace

TEST_CASE("Numbers are scored by their relative error") {
  const auto question = number(2.0);
  CHECK(score_answer(question, "2.0").mean_relative == 1.0);
  // Off by 0.3: below 0.5, 0.45, 0.40, 0.35 and not below 0.30.
  CHECK(score_answer(question, "I think 2.6 m").mean_relative == Approx(0.4));
  CHECK(score_answer(question, "2.6").relative == Approx(0.7));
  CHECK(score_answer(question, "2.09").exact == 1.0);
  CHECK(score_answer(question, "2.2").exact == 0.0);
  CHECK(score_answer(question, "200").mean_relative == 0.0);
  CHECK(score_answer(question, "200").relative == 0.0);
  CHECK(score_answer(number(3, "", 0.0), "3").exact == 1.0);
  CHECK(score_answer(number(3, "", 0.0), "4 chairs").exact == 0.0);
}

TEST_CASE("The last line with an answer counts") {
  CHECK(score_answer(number(2.0), "It is 5 or 6 at most.\nThe answer: 2.0\n\n").exact == 1.0);
  CHECK(score_answer(number(1.5), "1,5").exact == 1.0);
  CHECK(!score_answer(number(1.5), "I cannot tell.").read);
  CHECK(!score_answer(number(1.5), "").read);
}

TEST_CASE("Choices are read by letter or by text") {
  const auto question = choice({"the sofa", "the table", "the coffee table"}, 1);
  for (const char* answer : {"B", "b", "(B)", "B. the table", "Answer: B", "The answer is B", "the table", "It is the table.",
                             "First I see the sofa.\nB"}) {
    INFO(answer);
    CHECK(score_answer(question, answer).exact == 1.0);
  }
  for (const char* answer : {"A", "C", "the coffee table", "the sofa"}) {
    INFO(answer);
    CHECK(score_answer(question, answer).read);
    CHECK(score_answer(question, answer).exact == 0.0);
  }
  CHECK(!score_answer(question, "neither").read);
  CHECK(!score_answer(question, "the sofa or the table").read);
  CHECK(!score_answer(question, "E").read);
}
