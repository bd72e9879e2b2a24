// What names mean to plans and what they mean to libraries: docs/kinds.md says which kind a name means.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "base/resource.h"
#include "catch.h"
#include "library/vocabulary.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/kinds/kind_table.h"

using namespace roomgen;

namespace {

const KindTable& table() {
  return KindTable::built_in();
}

std::string meaning(std::string_view name) {
  const Kind* kind = table().find(name);
  return kind ? kind->name : std::string();
}

bool related(const std::string& a, const std::string& b) {
  return table().is_a(a, b) || table().is_a(b, a);
}

}  // namespace

TEST_CASE("Plans and libraries mean the same by a name") {
  const auto& vocabulary = Vocabulary::built_in();
  for (const auto& [name, kind] : table().all()) {
    auto names = kind.names;
    names.insert(names.end(), kind.loose_names.begin(), kind.loose_names.end());
    names.push_back(name);
    const std::string planned = table().planned(kind).name;
    for (const auto& one : names) {
      INFO(one << ", a name of " << name);
      const auto phrase = vocabulary.understand(one);
      CHECK(phrase.known);
      CHECK((related(meaning(phrase.kind), planned) ||
             related(phrase.kind, vocabulary.understand(planned).kind)));
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
    if (table().named(thing))
      ++found;
    else without += thing + " -> " + meaning(thing) + "\n";
  }
  WARN(found << " of " << things.size() << " have a name of their own; the others:\n" << without);
  CHECK(found * 10 > things.size() * 9);
}
