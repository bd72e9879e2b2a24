#include "kinds/noun_kind.h"

#include "catch.h"

using namespace roomgen;

namespace {

NounKind inferred(const char* noun) {
  return inferred_kind(KindTable::built_in(), noun);
}

std::string kind_inferred(const char* noun) {
  const NounKind found = inferred(noun);
  return found.kind ? found.kind->name : "nothing";
}

std::string kind_misspelt(const char* noun) {
  const NounKind found = misspelt_kind(KindTable::built_in(), noun);
  return found.kind ? found.kind->name : "nothing";
}

}  // namespace

TEST_CASE("Another word for a kind is that kind") {
  CHECK(kind_inferred("hatrack") == "coat rack");
  CHECK(kind_inferred("fishbowl") == "fish bowl");
  CHECK(inferred("fishbowl").basis == NounBasis::synonym);
}

TEST_CASE("A word for something more special is the kind nearest above it") {
  CHECK(kind_inferred("bonnet") == "hat");
  CHECK(kind_inferred("tabouret") == "stool");
  CHECK(kind_inferred("streetlight") == "street lamp");
  CHECK(inferred("bonnet").basis == NounBasis::hyponym);
}

TEST_CASE("A name of several meanings names its kind in that of the kind only") {
  CHECK(kind_inferred("underpants") != "dresser");  // drawers
  CHECK(kind_inferred("handcuff") != "laundry basket");  // a hamper
}

TEST_CASE("Other things get a stand-in of their class") {
  for (const char* noun : {"tuba", "catamaran", "furnace", "turban", "generator", "truck", "rack"}) {
    INFO(noun);
    REQUIRE(inferred(noun).kind);
    CHECK(inferred(noun).basis == NounBasis::stand_in);
    CHECK(inferred(noun).kind->is_stand_in());
  }
  CHECK(kind_inferred("catamaran") == "stand-in boat");
  CHECK(kind_inferred("truck") == "stand-in car");
}

TEST_CASE("A table without stand-ins has none") {
  const auto table = KindTable::parse(R"({"kinds": {"hat": {}}})", "c.json");
  REQUIRE(table);
  CHECK_FALSE(inferred_kind(*table, "tuba").kind);
  CHECK(inferred_kind(*table, "bonnet").kind);
}

TEST_CASE("Who lives, what happens and what is felt is no thing") {
  for (const char* noun : {"wolf", "grandmother", "dentist", "party", "sadness", "autumn", "meeting", "homework", "ceiling",
                           "water", "mile", "xyzzy", ""}) {
    INFO(noun);
    CHECK(kind_inferred(noun) == "nothing");
  }
}

TEST_CASE("What is asked of the table for a stand-in's noun is answered by the stand-in") {
  const auto& table = KindTable::built_in();
  CHECK(table.get("tuba").size == inferred("tuba").kind->size);
  CHECK_FALSE(table.find("tuba"));
  CHECK(table.get("sadness").lineage.empty());
}

TEST_CASE("A misspelt name is read as the one that is meant") {
  CHECK(kind_misspelt("bokshelf") == "bookshelf");
  CHECK(kind_misspelt("wardrob") == "wardrobe");
  CHECK(kind_misspelt("armchiar") == "armchair");
  CHECK(kind_misspelt("nighstand") == "nightstand");
  CHECK(kind_misspelt("refridgerator") == "refrigerator");
  CHECK(kind_misspelt("cofee table") == "coffee table");
  CHECK(kind_misspelt("dinning table") == "dining table");
  CHECK(kind_misspelt("bokshelves") == "bookshelf");
  CHECK(misspelt_kind(KindTable::built_in(), "cofee table").name == "coffee table");
}

TEST_CASE("English words, short ones and those near to several kinds stay as they are") {
  CHECK(kind_misspelt("fable") == "nothing");
  CHECK(kind_misspelt("hair") == "nothing");
  CHECK(kind_misspelt("bax") == "nothing");
  CHECK(kind_misspelt("qwertyuiop") == "nothing");
  CHECK(kind_misspelt("") == "nothing");
}
