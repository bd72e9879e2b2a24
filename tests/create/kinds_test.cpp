#include <nlohmann/json.hpp>

#include "create/kinds.h"

#include "catch.h"
#include "library/vocabulary.h"
#include "roomgen/base/json.h"
#include "roomgen/create/create.h"
#include "roomgen/create/maker.h"

using namespace roomgen;
using namespace roomgen::create;

TEST_CASE("Every kind is made in its usual, least and largest size") {
  const auto& kinds = ShapeKinds::built_in();
  REQUIRE(kinds);
  CHECK(kinds->all().size() >= 150);
  for (const auto& [name, kind] : kinds->all()) {
    const Json* recipe = kinds->recipe(kind.recipe);
    REQUIRE(recipe);
    const auto parameters = shape::describe_parameters(*recipe, kind.recipe);
    INFO(name);
    REQUIRE(parameters);
    for (const Vec3& size : {kind.size, kind.least, kind.most}) {
      shape::Values values = kind.set;
      values["width"] = size.x(), values["depth"] = size.y(), values["height"] = size.z();
      const auto program =
          shape::instantiate(*recipe, shape::clamped(*parameters, values), 3, kinds->recipes());
      if (!program) FAIL_CHECK(program.error().message);
    }
  }
}

TEST_CASE("What kinds set are parameters of their recipes") {
  const auto& kinds = ShapeKinds::built_in();
  REQUIRE(kinds);
  for (const auto& [name, kind] : kinds->all()) {
    INFO(name);
    const auto parameters = shape::describe_parameters(*kinds->recipe(kind.recipe));
    REQUIRE(parameters);
    const auto known = [&](const std::string& parameter) {
      return std::any_of(parameters->begin(), parameters->end(),
                         [&](const auto& one) { return one.name == parameter; });
    };
    for (const auto& [parameter, value] : kind.set) {
      INFO(parameter);
      CHECK(known(parameter));
    }
    for (const auto& [parameter, choices] : kind.vary) {
      INFO(parameter);
      CHECK(known(parameter));
    }
    if (!kind.main.empty()) CHECK(known(kind.main));
    CHECK((kind.least.array() <= kind.size.array() + 1e-9).all());
    CHECK((kind.size.array() <= kind.most.array() + 1e-9).all());
  }
}

TEST_CASE("Equal words and seeds make equal programs, other seeds other ones") {
  const auto maker = make_rule_maker();
  int different = 0;
  for (const char* prompt : {"a nightstand", "an oak chair", "a floor lamp", "a bookshelf"}) {
    CreateOptions options;
    options.seed = 5;
    const auto first = create::create(prompt, *maker, options),
               again = create::create(prompt, *maker, options);
    REQUIRE(first);
    REQUIRE(again);
    const auto text = [](const Creation& creation) {
      return dump_json(shape::write_program(creation.objects.at(0).program));
    };
    CHECK(text(*first) == text(*again));
    options.seed = 6;
    different += text(*first) != text(*create::create(prompt, *maker, options));
  }
  CHECK(different == 4);
}

TEST_CASE("The library builds what it is asked for in exactly the wanted size") {
  const auto library = make_created_library();
  for (const char* category : {"nightstand", "mirror", "bookshelf", "floor lamp", "rug"}) {
    INFO(category);
    AssetQuery query;
    query.category = category;
    query.description = std::string("a white ") + category;
    const auto matches = library->search(query);
    REQUIRE(matches);
    REQUIRE(matches->size() == 1);
    const AssetInfo& info = matches->front().asset;
    const auto model = library->load(info.ref);
    REQUIRE(model);
    CHECK((bounds(**model).size() - info.size).norm() < 1e-4);
    CHECK(std::abs(bounds(**model).low.z()) < 1e-4);
  }
  AssetQuery unknown;
  unknown.category = "frobnicator";
  CHECK(library->search(unknown)->empty());
}

TEST_CASE("What nobody knows gets a plain stand-in in the size and the colour that were asked for") {
  const auto library = make_created_library();
  AssetQuery query;
  query.category = "tuba";
  query.description = "a red tuba";
  query.size = Vec3(0.7, 0.3, 1.1);
  CHECK(library->search(query)->empty());  // of its own accord nobody adds one
  query.asked = true;
  const auto matches = library->search(query);
  REQUIRE(matches);
  REQUIRE(matches->size() == 1);
  const AssetInfo& info = matches->front().asset;
  CHECK(info.stand_in);
  CHECK(info.size.isApprox(*query.size));
  CHECK(info.colors == std::vector<std::string>{"red"});
  const auto model = library->load(info.ref);
  REQUIRE(model);
  CHECK((bounds(**model).size() - info.size).norm() < 1e-4);
}

TEST_CASE("Every stand-in is built in its usual size") {
  const auto library = make_created_library();
  for (const auto& [name, kind] : KindTable::built_in().all()) {
    if (!kind.is_stand_in()) continue;
    INFO(name);
    REQUIRE(ShapeKinds::built_in()->find(kind.built_as));
    AssetQuery query;
    query.category = name;
    query.asked = true;
    const auto matches = library->search(query);
    REQUIRE(matches->size() == 1);
    const auto model = library->load(matches->front().asset.ref);
    REQUIRE(model);
    CHECK((bounds(**model).size() - kind.size).norm() < 1e-3);
  }
}

TEST_CASE("The kind that the words name is built, and not its more general one") {
  const auto library = make_created_library();
  AssetQuery query;
  query.category = "wardrobe";
  query.description = "an oak armoire";
  CHECK(library->search(query)->front().asset.name == "armoire");
  query.category = "microscope";
  query.description = "a black microscope";
  query.mount = Mount::surface;
  CHECK(library->search(query)->front().asset.category == "microscope");
}

TEST_CASE("A thing of no known kind is put together when it was asked for, and marked") {
  const auto library = make_created_library();
  AssetQuery query;
  query.category = "frobnicator";
  query.description = "a frobnicator with a round base and two arms";
  query.size = Vec3(0.5, 0.5, 0.8);
  CHECK(library->search(query)->empty());
  query.asked = true;
  const auto matches = library->search(query);
  REQUIRE(matches);
  REQUIRE(matches->size() == 1);
  CHECK(matches->front().asset.approximate);
  CHECK(matches->front().asset.category == "frobnicator");
  const auto model = library->load(matches->front().asset.ref);
  REQUIRE(model);
  CHECK(bounds(**model).size().isApprox(matches->front().asset.size, 1e-3));
  query.description = "a frobnicator";
  CHECK(library->search(query)->empty());
}
