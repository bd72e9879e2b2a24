#include <unistd.h>

#include <random>

#include "catch.h"
#include "line_source.h"

using roomgen::cli::LineSource;

namespace {

/// What comes out of a pipe into which these bytes were written, all before the first is read.
std::vector<std::string> lines_of(const std::string& bytes, std::size_t max_bytes) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  REQUIRE(::write(ends[1], bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  ::close(ends[1]);
  LineSource source(ends[0], max_bytes);
  std::vector<std::string> lines;
  std::string line;
  for (auto event = source.next(line, {}); event != LineSource::Event::end; event = source.next(line, {}))
    lines.push_back(event == LineSource::Event::line ? line : "(too long)");
  ::close(ends[0]);
  return lines;
}

}  // namespace

TEST_CASE("Lines come one by one, the last without its newline too, and one too long is passed over") {
  using Lines = std::vector<std::string>;
  CHECK(lines_of("", 10).empty());
  CHECK(lines_of("a\n\nb", 10) == Lines{"a", "", "b"});
  CHECK(lines_of("a\n" + std::string(30'000, 'x') + "\nb\n", 10) == Lines{"a", "(too long)", "b"});
  CHECK(lines_of(std::string(30'000, 'x'), 10) == Lines{"(too long)"});
  CHECK(lines_of("0123456789\n", 10) == Lines{"0123456789"});
  CHECK(lines_of("01234567890\n", 10) == Lines{"(too long)"});
}

TEST_CASE("A line source that was stopped gives nothing more") {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  roomgen::CancelToken stopped;
  stopped.cancel();
  LineSource source(ends[0], 10);
  std::string line;
  CHECK(source.next(line, stopped) == LineSource::Event::end);
  ::close(ends[0]);
  ::close(ends[1]);
}
