#include <cmath>
#include <string>

#include "catch.h"
#include "roomgen/lab/compose.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

constexpr double any = std::numeric_limits<double>::infinity();

struct Said {
  std::string text;
  std::optional<Range> objects = {}, seats = {}, shelves = {}, occupancy = {};
};

bool same(const std::optional<Range>& a, const std::optional<Range>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return std::abs(a->low - b->low) < 1e-9 &&
         ((std::isinf(a->high) && std::isinf(b->high)) || std::abs(a->high - b->high) < 1e-9);
}

}  // namespace

TEST_CASE("How much a room shall hold is read from its description", "[compose]") {
  const std::vector<Said> all = {
      {.text = "a dining room with seating for 12", .seats = Range{12, 12}},
      {.text = "Seats for exactly 14, one table", .seats = Range{14, 14}},
      {.text = "a lounge where nine people can sit", .seats = Range{9, 9}},
      {.text = "a dining hall where forty people can eat at once", .seats = Range{40, 40}},
      {.text = "a table for two and 8 to 12 comfortable seats", .seats = Range{8, 12}},
      {.text = "a room with few seats and many shelves", .seats = Range{1, 4}, .shelves = Range{9, any}},
      {.text = "twelve tall bookshelves", .shelves = Range{12, 12}},
      {.text = "no fewer than six bookcases", .shelves = Range{6, any}},
      {.text = "roughly 30 pieces of furniture", .objects = Range{24, 36}},
      {.text = "20 objects in total", .objects = Range{20, 20}},
      {.text = "no more than 10 pieces in all, please", .objects = Range{0, 10}},
      {.text = "an occupancy of 45 %", .occupancy = Range{0.42, 0.48}},
      {.text = "a floor that is 45 % covered", .occupancy = Range{0.42, 0.48}},
      {.text = "with about half of the floor covered", .occupancy = Range{0.45, 0.55}},
      {.text = "furniture covers between 30 and 40 per cent of the floor", .occupancy = Range{0.3, 0.4}},
      {.text = "occupancy between 0.3 and 0.4", .occupancy = Range{0.3, 0.4}},
      {.text = "a very cluttered workshop", .occupancy = Range{0.5, any}},
      {.text = "a sparse bedroom", .occupancy = Range{0.0, 0.1}},
  };
  for (const auto& said : all) {
    INFO(said.text);
    const Complexity read = complexity_of(said.text);
    CHECK(same(read.objects, said.objects));
    CHECK(same(read.seats, said.seats));
    CHECK(same(read.shelves, said.shelves));
    CHECK(same(read.occupancy, said.occupancy));
  }
}

TEST_CASE("What is said of one thing is not said of the room", "[compose]") {
  CHECK_FALSE(complexity_of("two tables, each seating four").seats);
  CHECK_FALSE(complexity_of("a two-seat sofa and three armchairs").seats);
  CHECK_FALSE(complexity_of("a 5 by 4 m bedroom with a bed").occupancy);
  CHECK(complexity_of("a cosy living room").empty());
  CHECK(complexity_of("").empty());
}

TEST_CASE("Ranges of options are read or refused", "[compose]") {
  const auto range = [](const char* text) { return range_from(text, "--seats"); };
  CHECK(same(*range("8..12"), Range{8, 12}));
  CHECK(same(*range("8.."), Range{8, any}));
  CHECK(same(*range("..12"), Range{0, 12}));
  CHECK(same(*range("12"), Range{12, 12}));
  CHECK(same(*range("40%..50%"), Range{0.4, 0.5}));
  for (const char* wrong : {"", "many", "12..8", "-3", "8...12", "nan", "1e99", "8..x"}) {
    INFO(wrong);
    const auto read = range(wrong);
    REQUIRE_FALSE(read);
    CHECK(read.error().message.find("--seats") != std::string::npos);
  }
}

TEST_CASE("More of the floor than there is cannot be asked for", "[compose]") {
  CHECK(range_from("100%", "--occupancy", most_of_measure("occupancy")));
  CHECK(range_from("0.4..", "--occupancy", most_of_measure("occupancy")));
  for (const char* text : {"1.4", "140%", "0.4..1.4", "1.2.."})
    CHECK_FALSE(range_from(text, "--occupancy", most_of_measure("occupancy")));
  CHECK(range_from("40", "--seats", most_of_measure("seats")));
}
