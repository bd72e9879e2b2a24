#include "roomgen/lab/scores.h"

#include "catch.h"
#include "support/error_of.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

Result<std::vector<Requirements>> read(const std::string& text) {
  return parse_requirements(text, "rows.csv");
}

std::string message(const std::string& text) {
  return error_of(read(text));
}

const std::string head = "ID,Description,ObjCount,ObjAttr,OORel,OARel,Difficulty\n";

}  // namespace

TEST_CASE("A row of requirements is read whole, quoted fields and several lines too") {
  const auto rows = read(head +
                         "7,\"A room, with\n\"\"two\"\" beds\",\"eq,2,bed;ge,1,lamp\",\"eq,1,bed,red,large\","
                         "\"eq,1,on,0,desk,lamp:1\",\"le,3,against,bed,wall\",Hard\n");
  REQUIRE(rows);
  REQUIRE(rows->size() == 1);
  const Requirements& row = rows->front();
  CHECK(row.id == "7");
  CHECK(row.description == "A room, with\n\"two\" beds");
  CHECK(row.difficulty == "hard");
  REQUIRE(row.counts.size() == 2);
  CHECK(row.counts[1].category == "lamp");
  CHECK(row.counts[1].wanted.holds(4));
  CHECK_FALSE(row.counts[0].wanted.holds(3));
  REQUIRE(row.attributes.size() == 1);
  CHECK(row.attributes[0].attributes == std::vector<std::string>{"red", "large"});
  REQUIRE(row.object_relations.size() == 1);
  CHECK(row.object_relations[0].anchor == 0);
  CHECK(row.object_relations[0].things == std::vector<std::string>{"desk", "lamp"});
  REQUIRE(row.room_relations.size() == 1);
  CHECK(row.room_relations[0].wanted.holds(0));
  CHECK(row.categories() == std::vector<std::string>{"bed", "lamp", "desk"});
}

TEST_CASE("A comparison may carry its quantity") {
  const auto rows = read("ID,Description,ObjCount\n1,x,\"eq1,chair\"\n");
  REQUIRE(rows);
  CHECK(rows->front().counts[0].wanted.holds(1));
  CHECK(rows->front().counts[0].category == "chair");
}

TEST_CASE("All comparisons against all small counts") {
  const auto rows = read("ID,Description,ObjCount\n1,x,\"eq,2,a;lt,2,a;gt,2,a;le,2,a;ge,2,a\"\n");
  REQUIRE(rows);
  const auto& counts = rows->front().counts;
  for (int n = 0; n < 5; ++n) {
    CHECK(counts[0].wanted.holds(n) == (n == 2));
    CHECK(counts[1].wanted.holds(n) == (n < 2));
    CHECK(counts[2].wanted.holds(n) == (n > 2));
    CHECK(counts[3].wanted.holds(n) == (n <= 2));
    CHECK(counts[4].wanted.holds(n) == (n >= 2));
  }
}

TEST_CASE("What is no requirement is refused with its line and column") {
  CHECK(message("").find("empty") != std::string::npos);
  CHECK(message("ID,Description\n1,x\n").find("ObjCount") != std::string::npos);
  for (const char* field : {"is,2,bed", "eq,two,bed", "eq,2", "eq,-1,bed", ",,"}) {
    const std::string told = message("ID,Description,ObjCount\n1,x,\"" + std::string(field) + "\"\n");
    INFO(field << " -> " << told);
    CHECK(told.find("rows.csv:2") != std::string::npos);
    CHECK(told.find("ObjCount") != std::string::npos);
  }
  CHECK(message(head + "1,x,,,\"eq,1,on,first,a,b\",,\n").find("anchor") != std::string::npos);
}

TEST_CASE("Tables of requirements are bounded in every direction") {
  const auto table = [](const std::string& counts) { return "ID,Description,ObjCount\n1,x,\"" + counts + "\"\n"; };
  const auto many = [](std::size_t count, const std::string& one) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += one;
    return text;
  };
  const auto refused = [](const std::string& text) { return error_of(parse_requirements(text, "rows.csv")); };
  CHECK(parse_requirements(table(many(2000, "eq,1,a;")), "rows.csv"));
  CHECK(refused(table(many(2002, "eq,1,a;"))).find("rows.csv:2: ObjCount: has more than 2000 requirements") == 0);
  CHECK(parse_requirements(table("eq,1," + std::string(490, 'a')), "rows.csv"));
  CHECK(refused(table("eq,1," + std::string(600, 'a'))).find("is too long") != std::string::npos);
  CHECK(refused("ID,Description,ObjCount" + many(1000, ",")).find("rows.csv:1: has more than 1000 columns") == 0);
  CHECK(refused("ID,Description,ObjCount\n" + many(100001, "1,x,\"eq,1,a\"\n")).find("rows.csv:100001: is beyond the 100000 records") == 0);
  CHECK(refused("ID,Description,ObjCount\n" + many(101, "1,x,\"" + many(2000, "eq,1,a;") + "\"\n")).find("is beyond the 200000 requirements") != std::string::npos);
}
