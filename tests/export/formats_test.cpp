// The table of formats: each writes a file that holds the scene, whole or not at all.
#include <set>

#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/export/exporter.h"
#include "support/furnished_room.h"
#include "support/temporary_folder.h"

using namespace roomgen;

TEST_CASE("Every format is found by its name and writes equal scenes as equal files") {
  const TemporaryFolder folder;
  std::set<std::string_view> names;
  for (const auto& format : export_formats()) {
    INFO(format.name);
    CHECK(names.insert(format.name).second);
    CHECK(find_export_format(format.name) == &format);
    CHECK_FALSE(format.about.empty());
    const auto exporter = format.make({});
    const auto first = folder / ("first." + std::string(format.name)), second = folder / "second";
    REQUIRE(exporter->write(test::furnished_room(), {}, first));
    REQUIRE(exporter->write(test::furnished_room(), {}, second));
    const auto bytes = read_file(first);
    REQUIRE(bytes);
    CHECK_FALSE(bytes->empty());
    CHECK(*bytes == *read_file(second));
    CHECK_FALSE(exporter->write(test::furnished_room(), {}, folder / "missing" / "file"));
  }
  CHECK(names.count("glb") == 1);
  CHECK(find_export_format("nonsense") == nullptr);
}
