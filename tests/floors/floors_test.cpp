// Includes point down only, modules of one floor do not include each other, third-party headers stay in
// the adapters that are made for them, and what is public is small and closed.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "catch.h"

namespace {

namespace fs = std::filesystem;

const std::map<std::string, double> floors = {
    {"base", 0},          {"language", 0.5},  {"geometry", 1},      {"shape", 1.5},    {"kinds", 1.75},
    {"scene", 2},         {"library", 3},     {"collision", 3},     {"export", 3},     {"import", 3},
    {"view", 3},          {"chat", 3},        {"composition", 3.5}, {"brief", 4},         {"evaluate", 4},   {"solve", 4},
    {"plan", 4.25},       {"design", 4.5},    {"book", 4.6},      {"create", 5},        {"generate", 6},   {"edit", 6.5},
    {"edit_reader", 6.6}, {"decode", 6.75},   {"assets", 7},        {"render", 7},     {"agent", 7},
    // The laboratory stands on all of it.
    {"lab/program", 8},   {"lab/tour", 8},    {"lab/sceneeval", 8}, {"lab/suite", 8},  {"lab/annealing", 8.1},
    {"lab/frames", 8.1},  {"lab/questions", 8.1}, {"lab/compose", 8.2}};

// The laboratory's headers for users, by its parts.
const std::map<std::string, std::string> lab_headers = {
    {"compose.h", "lab/compose"},     {"draw_frames.h", "lab/frames"}, {"frames.h", "lab/tour"},
    {"optimise.h", "lab/annealing"},  {"program.h", "lab/program"},    {"questions.h", "lab/questions"},
    {"scores.h", "lab/sceneeval"},    {"suite.h", "lab/suite"},        {"tour.h", "lab/tour"}};

// Headers of libraries that a user of the core must not need, and the modules that may include them.
const std::map<std::string, std::vector<std::string>> adapters = {
    {"fcl/", {"collision"}}, {"polyclipping/", {"geometry"}}, {"meshoptimizer.h", {"geometry"}},
    {"assimp/", {"decode"}}, {"sqlite3.h", {"assets"}}, {"zip.h", {"assets"}},
    {"png.h", {"decode", "render"}}, {"jpeglib.h", {"decode", "render"}}, {"GL/", {"render"}},
    {"opencv2/", {"render", "assets"}}, {"pugixml", {"import"}}, {"cpr/", {"agent"}}, {"curl/", {"agent"}}, {"CLI/", {}}};

const fs::path source = ROOMGEN_SOURCE_DIR;
const fs::path headers = source / "include" / "roomgen";
const std::string contents = "roomgen.h";  // the table of contents, of no module
constexpr std::size_t most_headers = 49, most_without_lab = 38;

struct Include {
  std::string file, module, target;
  bool is_public = false;
};

std::vector<std::string> targets_in(const fs::path& file) {
  std::vector<std::string> targets;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const auto start = line.find_first_not_of(" \t");
    if (start == std::string::npos || line.compare(start, 8, "#include") != 0) continue;
    const auto open = line.find_first_of("\"<"), close = line.find_first_of("\">", open + 1);
    if (close != std::string::npos) targets.push_back(line.substr(open + 1, close - open - 1));
  }
  return targets;
}

// Relative to the root.
std::vector<fs::path> files_in(const fs::path& root) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), root));
  return files;
}

// The module of a file below src or include/roomgen: its folder; in the laboratory the part.
std::string home_of(const fs::path& file, bool is_public) {
  const std::string folder = file.begin()->string();
  if (folder != "lab") return folder;
  const std::string inner = std::next(file.begin())->string();
  if (!is_public) return folder + "/" + inner;
  const auto found = lab_headers.find(inner);
  return found == lab_headers.end() ? "" : found->second;
}

void collect(const fs::path& root, bool is_public, std::vector<Include>& includes) {
  for (const auto& file : files_in(root)) {
    if (file == contents) continue;
    for (const auto& target : targets_in(root / file))
      includes.push_back({file.string(), home_of(file, is_public), target, is_public});
  }
}

std::vector<Include> all_includes() {
  std::vector<Include> includes;
  collect(headers, true, includes);
  collect(source / "src", false, includes);
  return includes;
}

// The module that an include names, empty for the standard library and others.
std::string module_of(const std::string& target) {
  constexpr std::string_view prefix = "roomgen/";
  if (target.rfind(prefix, 0) == 0) return home_of(target.substr(prefix.size()), true);
  // What modules show each other, but not users.
  if (target.find('/') == std::string::npos) return "";
  const std::string home = home_of(target, false);
  return floors.count(home) ? home : "";
}

// What is for users: a header of include/roomgen, or nothing of ours at all.
bool is_for_users(const std::string& target) {
  if (target.rfind("roomgen/", 0) == 0) return fs::exists(source / "include" / target);
  return module_of(target).empty() && target.find("..") == std::string::npos;
}

// The types that a header defines at the outermost level, with their namespace: after the house's style a
// definition begins its line, and a namespace is opened on a line of its own.
std::vector<std::string> types_in(const fs::path& header) {
  static const std::regex opened(R"(namespace ([\w:]+) \{)");
  static const std::regex defined(R"((?:struct|class|enum class) (\w+)(?: final)?(?: :[^;]*)?(?: \{.*)?)");
  std::ifstream stream(header);
  std::vector<std::string> types;
  std::string space;
  std::smatch found;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("}  // namespace", 0) == 0)
      space.clear();
    else if (std::regex_match(line, found, opened))
      space += "::" + found[1].str();
    else if (std::regex_match(line, found, defined) && line.find('{') != std::string::npos)
      types.push_back(space + "::" + found[1].str());
  }
  return types;
}

std::string verdict(const Include& include) {
  const std::string target = module_of(include.target);
  if (!floors.count(include.module)) return "is in no known module";
  if (include.target.find("..") != std::string::npos) return "leaves its folder";
  if (!target.empty()) {
    if (!floors.count(target)) return "includes no known module";
    if (target != include.module && floors.at(target) >= floors.at(include.module))
      return "points to the same floor or up";
    if (include.is_public && include.target.rfind("roomgen/", 0) != 0)
      return "shows a private header in a public one";
  }
  for (const auto& [header, allowed] : adapters) {
    if (include.target.rfind(header, 0) != 0) continue;
    if (include.is_public) return "shows a third-party library in a public header";
    if (std::find(allowed.begin(), allowed.end(), include.module) == allowed.end())
      return "uses a third-party library outside its adapter";
  }
  return "";
}

}  // namespace

TEST_CASE("Every include points to a lower floor or stays in its module") {
  const auto includes = all_includes();
  REQUIRE(includes.size() > 300);
  for (const auto& include : includes) {
    INFO(include.file << " includes " << include.target);
    CHECK(verdict(include) == "");
  }
}

TEST_CASE("Public headers are few, include each other only, and stand in the table of contents") {
  const auto public_headers = files_in(headers);
  CHECK(public_headers.size() <= most_headers);
  CHECK(public_headers.size() - lab_headers.size() <= most_without_lab);
  const auto listed = targets_in(headers / contents);
  for (const auto& header : public_headers) {
    const std::string target = "roomgen/" + header.generic_string();
    INFO(target);
    CHECK((header == contents || std::count(listed.begin(), listed.end(), target) == 1));
    for (const auto& included : targets_in(headers / header)) {
      INFO("includes " << included);
      CHECK(is_for_users(included));
    }
  }
}

TEST_CASE("Programs and examples include public headers only") {
  // The validator timed by itself, every pose that the inside would allow, and draws that any machine repeats.
  const std::set<fs::path> look_inside = {"bench/create.cpp", "bench/exhaustive.cpp", "bench/occupancy.cpp",
                                          "bench/random_edits.h"};
  for (const fs::path root : {"apps", "bench", "tests/consumer"})
    for (const auto& file : files_in(source / root)) {
      if (look_inside.count(root / file)) continue;
      for (const auto& target : targets_in(source / root / file)) {
        INFO(root / file << " includes " << target);
        CHECK(is_for_users(target));
      }
    }
  for (const auto& target : targets_in(source / "README.md")) {
    INFO("README.md includes " << target);
    CHECK(is_for_users(target));
  }
}

TEST_CASE("A type's name belongs to one header") {
  // Two types of one name in one namespace share their destructors, whichever the linker keeps.
  std::map<std::string, std::string> homes;
  for (const auto& root : {fs::path("include") / "roomgen", fs::path("src")})
    for (const auto& entry : fs::recursive_directory_iterator(source / root)) {
      // A tool of the build is a program of its own.
      if (entry.path().extension() != ".h" || entry.path().parent_path().filename() == "compile") continue;
      const std::string file = fs::relative(entry.path(), source).string();
      for (const auto& type : types_in(entry.path())) {
        INFO(type << " in " << file << " and " << homes[type]);
        CHECK(homes[type] == "");
        homes[type] = file;
      }
    }
  REQUIRE(homes.size() > 300);
}

TEST_CASE("A namespace is that of its module") {
  static const std::regex opened(R"(namespace (roomgen(?:::\w+)*) \{)");
  for (const auto& file : files_in(source / "src")) {
    const std::string home = home_of(file, false);
    const bool is_lab = home.rfind("lab/", 0) == 0;
    const std::string outer = is_lab ? "roomgen::lab" : "roomgen";
    const std::string own = outer + "::" + (is_lab ? home.substr(4) : home);
    std::ifstream stream(source / "src" / file);
    std::smatch found;
    for (std::string line; std::getline(stream, line);) {
      if (!std::regex_match(line, found, opened)) continue;
      const std::string space = found[1];
      INFO(file << " opens " << space);
      CHECK((space == outer || space.rfind(outer + "::detail", 0) == 0 || space.rfind(own, 0) == 0));
    }
  }
}

TEST_CASE("No name of a test has a semicolon, at which CTest would part it") {
  std::size_t names = 0;
  for (const auto& file : files_in(source / "tests")) {
    std::ifstream stream(source / "tests" / file);
    for (std::string line; std::getline(stream, line);) {
      if (!line.starts_with("TEST_CASE(")) continue;
      ++names;
      INFO(file << ": " << line);
      CHECK(line.find("; ") == std::string::npos);
    }
  }
  CHECK(names > 300);
}

TEST_CASE("The check of floors finds what it looks for") {
  CHECK(verdict({"scene/a.h", "scene", "roomgen/geometry/vec.h", true}) == "");
  CHECK(verdict({"scene/a.h", "scene", "roomgen/scene/room.h", true}) == "");
  CHECK(verdict({"scene/a.h", "scene", "roomgen/solve/solve.h", true}) != "");
  CHECK(verdict({"scene/a.cpp", "scene", "solve/score.h", false}) != "");
  CHECK(verdict({"scene/a.h", "scene", "geometry/private.h", true}) != "");
  CHECK(verdict({"library/a.cpp", "library", "roomgen/view/view.h", false}) != "");
  CHECK(verdict({"scene/a.cpp", "scene", "../solve/score.h", false}) != "");
  CHECK(verdict({"collision/a.h", "collision", "fcl/fcl.h", true}) != "");
  CHECK(verdict({"collision/a.cpp", "collision", "fcl/fcl.h", false}) == "");
  CHECK(verdict({"scene/a.cpp", "scene", "fcl/fcl.h", false}) != "");
  CHECK(verdict({"new/a.cpp", "new", "vector", false}) != "");
  CHECK(verdict({"render/a.cpp", "render", "roomgen/lab/tour.h", false}) != "");
  CHECK(verdict({"generate/a.cpp", "generate", "lab/program/names.h", false}) != "");
  CHECK(verdict({"lab/program/a.cpp", "lab/program", "lab/annealing/moves.h", false}) != "");
  CHECK(verdict({"lab/compose/a.cpp", "lab/compose", "roomgen/lab/optimise.h", false}) == "");
  CHECK(is_for_users("roomgen/scene/scene.h"));
  CHECK(is_for_users("vector"));
  CHECK(is_for_users("options.h"));
  CHECK(!is_for_users("roomgen/scene/judgement.h"));
  CHECK(!is_for_users("scene/judgement.h"));
  CHECK(!is_for_users("../src/scene/judgement.h"));
}
