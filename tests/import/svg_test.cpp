#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/import/import.h"
#include "support/contains.h"
#include "support/error_of.h"

using namespace roomgen;

namespace {

const std::string svg_files = ROOMGEN_TEST_DATA "/floor-plans/";

std::string svg(const std::string& body, const std::string& head = "width='6m' viewBox='0 0 600 600'") {
  return "<svg " + head + ">\n" + body + "\n</svg>\n";
}

std::string refusal_of_svg(const std::string& text) {
  return error_of(room_from_svg(text, "plan.svg"));
}

}  // namespace

TEST_CASE("An SVG in millimetres is a room with its doors and windows") {
  const auto room = read_floor_plan(svg_files + "l-room.svg");
  REQUIRE(room);
  CHECK(check(*room));
  CHECK(room->polygon.size() == 6);
  CHECK(area(room->polygon) == Approx(5.4 * 4.8 - 2.6 * 2.0));
  const Bounds2 box = bounds(room->polygon);
  CHECK(box.low.norm() == Approx(0.0).margin(1e-9));
  CHECK((box.high - Vec2(5.4, 4.8)).norm() == Approx(0.0).margin(1e-9));
  REQUIRE(room->openings.size() == 3);
  // The page counts downwards: its lower edge is the front of the room.
  const Opening& door = *find_opening(*room, "door-0");
  const Segment at = segment(*room, door);
  CHECK(at.a.y() == Approx(0.0).margin(1e-9));
  CHECK(at.middle().x() == Approx(0.57));
  CHECK(door.width() == Approx(0.9));
  CHECK(segment(*room, *find_opening(*room, "window-0")).middle().y() == Approx(4.8));
  const Opening& right = *find_opening(*room, "window-1");
  CHECK(segment(*room, right).middle().x() == Approx(5.4));
  CHECK(right.width() == Approx(1.4));
}

TEST_CASE("Groups may move, turn and mirror what they hold") {
  const auto room = read_floor_plan(svg_files + "bay.svg");
  REQUIRE(room);
  CHECK(room->polygon.size() == 8);
  CHECK(bounds(room->polygon).size().y() == Approx(4.1));
  CHECK(room->openings.size() == 4);
  // Mirrored twice, the door is in front again.
  CHECK(segment(*room, *find_opening(*room, "door-0")).middle().y() == Approx(0.0).margin(1e-9));
  for (const auto& opening : room->openings)
    if (opening.type == OpeningType::window)
      CHECK(segment(*room, opening).middle().y() > 3.5);
}

TEST_CASE("The scale of an SVG follows its width, height and viewBox") {
  const std::string box = "<rect width='400' height='300'/>";
  const auto size = [&](const std::string& head) {
    const auto room = room_from_svg(svg(box, head), "plan.svg");
    return room ? bounds(room->polygon).size().x() : 0.0;
  };
  CHECK(size("width='6m' viewBox='0 0 600 600'") == Approx(4.0));
  CHECK(size("height='3000mm' viewBox='0 0 600 600'") == Approx(2.0));
  CHECK(size("width='6000mm' height='900cm' viewBox='0 0 600 900'") == Approx(4.0));
  CHECK(size("width='500cm'") == Approx(4.0));
  CHECK(size("width='500mm'") == 0.0);  // 0.4 m wide: no room
  CHECK(room_from_svg(svg("<rect width='4' height='3'/>", ""), "plan.svg"));
  CHECK(contains_text(refusal_of_svg(svg(box, "")), "400 x 300 m"));
  CHECK(contains_text(refusal_of_svg(svg(box, "")), "width="));
}

TEST_CASE("Curves of a path become walls") {
  const auto round = room_from_svg(svg("<path d='M0 200 A200 200 0 1 1 400 200 A200 200 0 0 1 0 200'/>"), "plan.svg");
  REQUIRE(round);
  CHECK(area(round->polygon) == Approx(pi * 4.0).epsilon(0.02));
  CHECK(area(round->polygon) < pi * 4.0);
  const auto circle = room_from_svg(svg("<circle cx='9' cy='9' r='200'/>"), "plan.svg");
  REQUIRE(circle);
  CHECK(area(circle->polygon) == Approx(pi * 4.0).epsilon(0.02));
  const auto oval = room_from_svg(svg("<path d='M0 0 a200 100 0 0 1 400 0 a200 100 0 0 1 -400 0'/>"), "plan.svg");
  REQUIRE(oval);
  CHECK(bounds(oval->polygon).size().y() == Approx(2.0));
  const auto bow = room_from_svg(svg("<path d='m0,0 400,0 v300 C300,400 100,400 0,300 z'/>"), "plan.svg");
  REQUIRE(bow);
  // Under a cubic with its controls at 1/4 and 3/4, as high as 3/4 of theirs: 3/5 of 1 x 4, 0.6 x 4.
  CHECK(area(bow->polygon) > 12.0);
  CHECK(bounds(bow->polygon).size().y() == Approx(3.75));
}

TEST_CASE("What is wrong with an SVG is told with its line and the way out") {
  CHECK(contains_text(refusal_of_svg(svg("<path d='M0 0 H400 V300 H0'/>")), "plan.svg:2: the outline is open"));
  CHECK(contains_text(refusal_of_svg(svg("<polygon points='0,0 400,300 400,0 0,300'/>")), "plan.svg:2: polygon"));
  CHECK(contains_text(refusal_of_svg(svg("<polygon points='0,0 400,0 400,300 400,500 400,300 0,300'/>")), "spike"));
  CHECK(contains_text(refusal_of_svg(svg("<polygon points='0,0 400,0 200,3'/>")), "a room"));
  CHECK(contains_text(refusal_of_svg(svg("<rect width='400000' height='300000'/>")), "4000 x 3000 m"));
  CHECK(contains_text(refusal_of_svg(svg("<rect width='400' height='300'/><rect x='500' width='90' height='90'/>")),
                      "second outline"));
  CHECK(contains_text(refusal_of_svg(svg("<rect width='400' height='300'/>\n"
                                  "<line id='door' x1='100' y1='100' x2='190' y2='100'/>")),
                      "plan.svg:3: \"door\" lies along no wall"));
  CHECK(contains_text(refusal_of_svg(svg("<rect width='400' height='300'/><line id='door' x1='0' x2='90'/>"
                                  "<line id='door' x1='50' x2='150'/>")),
                      "overlaps"));
  CHECK(contains_text(refusal_of_svg(svg("<text>room</text>")), "draws no outline"));
  CHECK(contains_text(refusal_of_svg(svg("<rect width='4x' height='300'/><path d='M0 0 L 5'/>")), "plan.svg:2"));
  CHECK(contains_text(refusal_of_svg("<svg><g></svg>"), "closes nothing"));
  CHECK(contains_text(refusal_of_svg("<svg>\n<rect width='1'"), "plan.svg:2"));
  CHECK(contains_text(refusal_of_svg("<html></html>"), "no SVG"));
  CHECK(contains_text(refusal_of_svg("<!DOCTYPE svg [<!ENTITY a 'aaaa'>]><svg/>"), "document type"));
  std::string corners;
  for (int i = 0; i < 2000; ++i)
    corners += std::to_string(300 + 200 * std::cos(i * pi / 1000)) + "," +
               std::to_string(300 + 200 * std::sin(i * pi / 1000)) + " ";
  CHECK(contains_text(refusal_of_svg(svg("<polygon points='" + corners + "'/>")), "at most 500"));
}

TEST_CASE("Numbered entities and other encodings are read, foreign files are not") {
  const std::string head = "<svg width='6m' viewBox='0 0 600 600'><rect width='400' height='300'/>";
  const auto named = room_from_svg(head + "<line id='&#100;&#x6F;or' x1='50' x2='150'/></svg>", "plan.svg");
  REQUIRE(named);
  CHECK(named->openings.size() == 1);
  const std::string latin = "<?xml version='1.0' encoding='ISO-8859-1'?>" + head + "<text id='T\xFCr'/></svg>";
  CHECK(room_from_svg(latin, "plan.svg"));
  std::string wide = "\xFF\xFE";
  for (const char c : head + "</svg>") wide += {c, '\0'};
  CHECK(room_from_svg(wide, "plan.svg"));
  CHECK(contains_text(refusal_of_svg("<!DOCTYPE svg [<!ENTITY a SYSTEM 'file:///etc/passwd'>]><svg id='&a;'/>"),
                      "document type"));
  CHECK(contains_text(refusal_of_svg("<svg>\n<g a='1' a='2'/></svg>"), "plan.svg:2: attribute \"a\" is there twice"));
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "<g>";
  CHECK(error_of(room_from_svg("<svg>" + deep, "plan.svg")) != "");
  for (int i = 0; i < 100; ++i) deep += "</g>";
  CHECK(contains_text(refusal_of_svg("<svg>" + deep + "</svg>"), "nested too deeply"));
}

TEST_CASE("A file of JSON is still a room") {
  const auto room = read_floor_plan(ROOMGEN_TEST_DATA "/floor-plans/alcove.json");
  REQUIRE(room);
  CHECK(room->polygon.size() == 8);
  CHECK_FALSE(read_floor_plan(svg_files + "missing.svg"));
}

TEST_CASE("What a group says holds for all in it, the nearest before those around it") {
  const std::string walls = "<rect width='400' height='300'/>";
  const auto openings = [&](const std::string& body) {
    const auto room = room_from_svg(svg(walls + body), "plan.svg");
    INFO((room ? "" : room.error().message));
    REQUIRE(room);
    return room->openings;
  };
  const std::string line = "<line x1='100' x2='190'/>";
  CHECK(openings("<g id='door'><g class='of oak'>" + line + "</g></g>").at(0).type == OpeningType::door);
  CHECK(openings("<g id='door'><g class='window'>" + line + "</g></g>").at(0).type == OpeningType::window);
  CHECK(openings("<g id='window'>" + line + "</g><g><line x1='200' x2='290' id='door'/></g>").size() == 2);
  CHECK(openings("<g display='none'><g id='door'>" + line + "</g></g>").empty());
  CHECK(openings("<g style='a:b;display:none'>" + line + "</g><defs><g>" + line + "</g></defs>").empty());
  // What is beside a group is not of it. The wall at the top runs from the right to the left.
  CHECK(openings("<g id='door' transform='translate(10)'/><g id='window' transform='translate(20)'>" + line + "</g>").at(0).from == Approx(4.0 - 2.1));
  // Transforms that are not read do no harm where nothing is drawn.
  CHECK(openings("<g transform='skewX(3)'><text>oak</text></g><g id='door'>" + line + "</g>").size() == 1);
  CHECK(contains_text(refusal_of_svg(svg(walls + "\n<g transform='skewX(3)'>" + line + "</g>")), "plan.svg:3: \"skewX\" is no transform"));
}
