// Rooms with a known solution (tests/data/rooms, made by tests/checker/make_rooms.py), and impossible ones.
#include <filesystem>

#include "support/brute_force.h"
#include "support/solved.h"

using namespace roomgen;

namespace {

std::vector<std::filesystem::path> room_files(bool impossible) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(ROOMGEN_TEST_DATA) / "rooms"))
    if (entry.path().extension() == ".json" &&
        (entry.path().filename().string().front() == '9') == impossible)
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("Rooms that have a solution are furnished nearly whole, and nothing in them is invalid") {
  std::size_t objects = 0, placed = 0, rooms = 0;
  int constraints = 0, held = 0;
  for (const auto& file : room_files(false)) {
    const auto problem = read_problem(file);
    REQUIRE(problem);
    const auto solution = solved(*problem);
    INFO(file.filename());
    CHECK(violations(solution.scene).empty());
    CHECK(brute_force::faults(solution.scene).empty());
    CHECK(solution.scene.objects.size() + solution.scene.unplaced.size() == problem->tasks.size());
    ++rooms;
    objects += problem->tasks.size();
    placed += solution.scene.objects.size();
    constraints += solution.constraints;
    held += solution.held;
  }
  REQUIRE(rooms >= 63);
  WARN(placed << " of " << objects << " objects placed, " << held << " of " << constraints
              << " constraints held");
  CHECK(static_cast<double>(placed) >= 0.995 * static_cast<double>(objects));
  CHECK(held >= 0.99 * constraints);
}

TEST_CASE("Rooms without a solution come back with what fits, and a reason for what does not") {
  for (const auto& file : room_files(true)) {
    const auto problem = read_problem(file);
    REQUIRE(problem);
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const auto solution = solved(*problem, seed);
      INFO(file.filename());
      CHECK(solution.held < solution.constraints);
      CHECK_FALSE(solution.scene.objects.empty());
      CHECK(violations(solution.scene).empty());
      CHECK(brute_force::faults(solution.scene).empty());
      for (const auto& missing : solution.scene.unplaced)
        CHECK(missing.reason.find(missing.id) != std::string::npos);
    }
  }
}

TEST_CASE("What cannot fit is left out alone") {
  const auto unplaced = [](const char* name) {
    const auto problem =
        read_problem(std::filesystem::path(ROOMGEN_TEST_DATA) / "rooms" / name);
    REQUIRE(problem);
    std::vector<std::string> ids;
    for (const auto& missing : solved(*problem).scene.unplaced) ids.push_back(missing.id);
    return ids;
  };
  CHECK(unplaced("90-too-large.json") == std::vector<std::string>{"piano-0"});
  CHECK(unplaced("91-contradiction.json").empty());
  CHECK(unplaced("92-only-the-door.json") == std::vector<std::string>{"wardrobe-0"});
  CHECK(unplaced("93-too-tall.json") == std::vector<std::string>{"bookshelf-0"});
  CHECK(unplaced("94-windows-all-around.json").empty());
}
