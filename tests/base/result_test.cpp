#include "roomgen/base/result.h"

#include "catch.h"
#include "roomgen/base/cancel.h"

using namespace roomgen;

TEST_CASE("A result holds its value or its error") {
  const Result<int> good = 3;
  REQUIRE(good.ok());
  CHECK(*good == 3);
  const Result<int> bad = Error{Error::Kind::io, "no disk"};
  REQUIRE_FALSE(bad);
  CHECK(bad.error().kind == Error::Kind::io);
  CHECK(bad.error().message == "no disk");
}

TEST_CASE("Context goes before the message and leaves the kind") {
  const auto error = with_context({Error::Kind::limit, "too long"}, "a.json");
  CHECK(error.kind == Error::Kind::limit);
  CHECK(error.message == "a.json: too long");
}

TEST_CASE("All copies of a cancel token are one flag") {
  CancelToken token;
  const CancelToken copy = token;
  const CancelToken other;
  CHECK_FALSE(copy.cancelled());
  token.cancel();
  CHECK(copy.cancelled());
  CHECK_FALSE(other.cancelled());
}

TEST_CASE("A time that no clock counts is a long one") {
  CancelToken token;
  CHECK_FALSE(token.within(std::chrono::duration<double>(1e300)).cancelled());
  CHECK_FALSE(token.within(std::chrono::duration<double>(std::numeric_limits<double>::infinity())).cancelled());
  CHECK(token.within(std::chrono::duration<double>(0.0)).cancelled());
}
