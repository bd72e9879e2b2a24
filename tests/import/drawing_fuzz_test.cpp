// Whatever a file holds, reading it ends, and a room that comes out of it is sound.
#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/import/import.h"
#include "support/damaged.h"

using namespace roomgen;

namespace {

const char* const drawings[] = {"l-room.svg", "bay.svg", "round-end.dxf", "lines-r12.dxf",
                                "polyline-r12.dxf"};

Result<Room> read(const std::string& text, bool svg) {
  return svg ? room_from_svg(text, "plan.svg") : room_from_dxf(text, "plan.dxf");
}

void check_sound(const Result<Room>& room) {
  if (!room) {
    CHECK_FALSE(room.error().message.empty());
    return;
  }
  CHECK(check(*room));
  CHECK(area(room->polygon) > 0);
  const Vec2 size = bounds(room->polygon).size();
  CHECK(size.minCoeff() >= least_drawn_side);
  CHECK(size.maxCoeff() <= greatest_drawn_side);
  // It is as good as any other polygon.
  CHECK(make_polygon(room->polygon.points));
}

}  // namespace

TEST_CASE("Damaged drawings are refused or give sound rooms") {
  Random random(11);
  int read_well = 0;
  for (const std::string name : drawings) {
    const auto text = read_file(std::string(ROOMGEN_TEST_DATA "/floor-plans/") + name);
    REQUIRE(text);
    for (int n = 0; n < 600; ++n) {
      const auto room = read(damaged(*text, random, 20), name.ends_with(".svg"));
      read_well += room ? 1 : 0;
      check_sound(room);
    }
  }
  // Some damage is harmless, as that to a comment.
  CHECK(read_well > 50);
  CHECK(read_well < 2900);
}

TEST_CASE("Random bytes and random tags are no floor plans") {
  Random random(12);
  const std::string alphabet = "<>/='\" svgrectpathMLZ0123456789.,-\n\r\t&;";
  for (int n = 0; n < 500; ++n) {
    std::string bytes, tags = "<svg ";
    for (int i = random.integer(0, 400); i > 0; --i) {
      bytes += static_cast<char>(random.integer(0, 255));
      tags += alphabet[static_cast<std::size_t>(random.integer(0, static_cast<int>(alphabet.size()) - 1))];
    }
    for (const bool svg : {true, false}) {
      check_sound(read(bytes, svg));
      check_sound(read(tags, svg));
    }
  }
}

TEST_CASE("Random numbers in a path and a polyline never break the reader") {
  Random random(13);
  for (int n = 0; n < 1500; ++n) {
    std::string path = "M0 0", dxf = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n70\n1\n";
    for (int i = random.integer(1, 12); i > 0; --i) {
      path += std::string(1, "LlHhVvCcSsQqTtAaZz"[random.integer(0, 17)]);
      for (int k = random.integer(0, 7); k > 0; --k)
        path += " " + std::to_string(random.integer(0, 3) ? random.integer(-3, 9) : random.integer(0, 1));
      dxf += "10\n" + std::to_string(random.uniform(-5, 5)) + "\n20\n" +
             std::to_string(random.uniform(-5, 5)) + "\n42\n" +
             std::to_string(random.chance(0.3) ? random.uniform(-3, 3) : 0.0) + "\n";
    }
    check_sound(room_from_svg("<svg><path d='" + path + "Z'/></svg>", "plan.svg"));
    check_sound(room_from_dxf(dxf + "0\nENDSEC\n0\nEOF\n", "plan.dxf"));
  }
}
