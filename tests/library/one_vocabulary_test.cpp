// The files that name kinds, as one vocabulary: docs/vocabulary.md says which kind a name means.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/base/resource.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/library/vocabulary.h"

using namespace roomgen;

namespace {

const KindTable& table() {
  return KindTable::built_in();
}

std::vector<KindRecord> shapes() {
  const auto records = shape_kind_records();
  REQUIRE(records);
  return *records;
}

std::vector<KindRecord> named() {
  const auto records =
      read_kind_records(resource("data/vocabulary.json").value_or(""), "data/vocabulary.json");
  REQUIRE(records);
  return *records;
}

std::string meaning(std::string_view name) {
  const Kind* category = table().find(name);
  return category ? category->name : std::string();
}

bool related(const std::string& a, const std::string& b) {
  return table().is_a(a, b) || table().is_a(b, a);
}

// Is it a name itself, rather than understood by its ending?
bool is_name(const std::string& name) {
  const Kind* category = table().find(name);
  if (!category) return false;
  const auto key = words(name);
  return words(category->name) == key ||
         std::any_of(category->synonyms.begin(), category->synonyms.end(),
                     [&](const std::string& synonym) { return words(synonym) == key; });
}

}  // namespace

TEST_CASE("Whatever can be built and whatever libraries name is a category, under its own name") {
  for (const auto& records : {shapes(), named()})
    for (const auto& record : records) {
      INFO(record.name);
      CHECK(is_name(record.name));
    }
}

TEST_CASE("What a kind is said to be is a kind, and no circle") {
  for (const auto& record : shapes()) {
    if (record.parent.empty()) continue;
    INFO(record.name << " is " << record.parent);
    CHECK(is_name(record.parent));
    CHECK(meaning(record.parent) != meaning(record.name));
    CHECK(table().is_a(record.name, record.parent));
  }
}

TEST_CASE("Both tables know the same names, and mean the same by them") {
  const auto& vocabulary = Vocabulary::built_in();
  for (const auto& [name, category] : table().all()) {
    auto names = category.synonyms;
    names.push_back(name);
    for (const auto& one : names) {
      INFO(one << ", a name of " << name);
      const auto phrase = vocabulary.understand(one);
      CHECK(phrase.known);
      const std::string other = meaning(phrase.kind);
      if (!related(other, name)) UNSCOPED_INFO("the vocabulary says " << phrase.kind);
      CHECK((related(other, name) || related(phrase.kind, vocabulary.understand(name).kind)));
    }
  }
}

TEST_CASE("The longest name wins") {
  CHECK(meaning("a test tube rack") == "test tube rack");
  CHECK(meaning("glass coffee table") == "coffee table");
  CHECK(meaning("petri dish") == "petri dish");
  CHECK(meaning("calendar") == "calendar");
  CHECK(meaning("microscopes") == "microscope");
  CHECK(meaning("desktop") == "desk");
  CHECK(meaning("desktop computer") == "computer");
}

TEST_CASE("What is built knows its usual size and how it is put up") {
  const Kind* microscope = table().find("microscope");
  REQUIRE(microscope);
  CHECK(microscope->size.maxCoeff() < 0.7);
  CHECK(microscope->mount == Mount::surface);
  const Kind* calendar = table().find("calendar");
  REQUIRE(calendar);
  CHECK(calendar->mount == Mount::wall);
  CHECK(calendar->elevation > 0.5);
}

TEST_CASE("A special kind serves who asks for the general one, not the other way round") {
  const auto& vocabulary = Vocabulary::built_in();
  CHECK(vocabulary.fit("gaming chair", "office chair") > 0.0);
  CHECK(vocabulary.fit("office chair", "gaming chair") == 0.0);
  CHECK(vocabulary.fit("standing desk", "desk") > 0.0);
  CHECK(vocabulary.fit("desk", "standing desk") == 0.0);
  CHECK(vocabulary.fit("plate", "petri dish") == 0.0);
}

// Names that kinds of different lines claim, and what they mean. A kind's own name is not listed: it
// means that kind, whoever else has it among the others.
TEST_CASE("Names that several kinds claim are these") {
  const std::map<std::string, std::string> known = {
#include "collisions.inc"
  };
  std::set<std::string> own;
  for (const auto& [name, category] : table().all()) own.insert(name);
  std::map<std::string, std::set<std::string>> claims;
  for (const auto& records : {shapes(), named()})
    for (const auto& record : records)
      for (const auto& name : record.names) claims[name].insert(meaning(record.name));
  std::map<std::string, std::string> found;
  for (const auto& [name, kinds] : claims) {
    const std::string meant = meaning(name);
    const bool plural = singular(name) != name && is_name(singular(name));
    if (own.count(name) || plural) continue;
    if (std::any_of(kinds.begin(), kinds.end(),
                    [&](const std::string& kind) { return !related(kind, meant); }))
      found[name] = meant;
  }
  std::string listing;
  for (const auto& [name, meant] : found)
    if (!known.count(name) || known.at(name) != meant)
      listing += "    {\"" + name + "\", \"" + meant + "\"},\n";
  INFO("not listed:\n" << listing);
  CHECK(listing.empty());
  for (const auto& [name, meant] : known) {
    INFO(name << " is no longer claimed by several");
    CHECK(found.count(name));
  }
}

// ROOMGEN_SCENEEVAL is SceneEval's table of descriptions; without it there is nothing to count.
TEST_CASE("Nearly all things that SceneEval counts have a name", "[sceneeval]") {
  const char* path = std::getenv("ROOMGEN_SCENEEVAL");
  const auto text = path ? read_file(path) : Result<std::string>(std::string());
  if (!text || text->empty()) return;
  std::set<std::string> things;
  for (std::string_view left = *text; !left.empty();) {
    const std::size_t at = std::min({left.find("eq,"), left.find("ge,"), left.find("gt,"), left.find("le,")});
    if (at == std::string_view::npos) break;
    left.remove_prefix(at);
    const auto fields = split(left.substr(0, left.find_first_of(";\"\n")), ',');
    // A count, then what is counted, and nothing more: "eq,2,desk_lamp".
    if (fields.size() == 3 && !fields[1].empty() && fields[1].find_first_not_of("0123456789") == std::string::npos)
      things.insert(join(words(fields[2]), " "));
    left.remove_prefix(3);
  }
  std::string without;
  std::size_t found = 0;
  for (const auto& thing : things) {
    const auto pieces = words(thing);
    if (is_name(thing) || is_name(join({pieces.begin(), pieces.end() - 1}, " ") + " " + singular(pieces.back())))
      ++found;
    else without += thing + " -> " + meaning(thing) + "\n";
  }
  WARN(found << " of " << things.size() << " have a name of their own; the others:\n" << without);
  CHECK(found * 10 > things.size() * 9);
}
