#include "base/threads.h"

#include <atomic>
#include <stdexcept>

#include "catch.h"

using namespace roomgen;

TEST_CASE("Work is done by so many threads, and on this one where none are asked for") {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5}}) {
    std::atomic<std::size_t> runs = 0, sum = 0;
    on_threads(count, [&](std::size_t thread) { ++runs, sum += thread; });
    CHECK(runs == std::max<std::size_t>(count, 1));
    CHECK(sum == (count == 5 ? 10 : 0));
  }
}

TEST_CASE("What a thread throws is thrown where it was started, when all have ended") {
  std::atomic<int> ended = 0;
  const auto work = [&](std::size_t thread) {
    if (thread == 2) throw std::runtime_error("two");
    ++ended;
  };
  CHECK_THROWS_WITH(on_threads(4, work), "two");
  CHECK(ended == 3);
}
