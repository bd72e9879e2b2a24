// What scripts/mingw runs under Wine: the half of base that is for Windows, the embedded data, and the floors
// above it as far as they need no furniture. Its argument is a problem to solve (docs/problem.schema.json).
#include <cstdio>
#include <filesystem>

#include "base/exchange.h"
#include "language/parse.h"
#include "roomgen/base/file.h"
#include "roomgen/geometry/polygon.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/scene/scene.h"
#include "roomgen/scene/problem.h"
#include "roomgen/solve/solve.h"

namespace fs = std::filesystem;
using namespace roomgen;

namespace {

int failures = 0;

void check(bool holds, const char* what) {
  std::printf("%s %s\n", holds ? "ok  " : "FAIL", what);
  if (!holds) ++failures;
}

bool has_only(const fs::path& folder, std::size_t count) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator())) == count;
}

void try_files() {
  const fs::path folder = "files";
  check(static_cast<bool>(make_folder(folder)), "a folder is made");
  check(write_file(folder / "a.txt", "one\n") && write_file(folder / "a.txt", "two\n"), "a file takes another's place");
  const auto read = read_file(folder / "a.txt", 100);
  check(read && *read == "two\n", "it holds what was written, line ends as they were");
  check(has_only(folder, 1), "nothing is left beside it");
  check(!write_file(folder, "x"), "a folder is no file");
  auto log = AppendedFile::open(folder / "log.txt");
  check(log && log->append("1\n") && log->append("2\n"), "lines are appended");
  const auto lines = read_file(folder / "log.txt", 100);
  check(lines && *lines == "1\n2\n", "and stand in their order");
}

void try_folders() {
  const fs::path folder = "results";
  const auto ours = [](const fs::path& name) { return name.extension() == ".json"; };
  for (const std::string text : {"first", "second"}) {
    auto output = OutputFolder::open(folder, ours);
    check(output && output->write("scene.json", text) && output->commit(), "results are put in place");
    if (text == "first") check(static_cast<bool>(write_file(folder / "mine.txt", "kept")), "others' files too");
  }
  const auto scene = read_file(folder / "scene.json", 100), mine = read_file(folder / "mine.txt", 100);
  check(scene && *scene == "second" && mine && *mine == "kept", "the new ones are there, and what is not ours");
  check(has_only(folder, 2), "nothing else is");
  const auto held = detail::lock_folder(folder);
  check(held && !detail::lock_folder(folder), "a folder is held by one");
}

void try_floors() {
  const auto parse = language::parse("A small lamp stands on the oak desk.");
  check(parse.phrases.size() == 2 && parse.head_of(parse.phrases[1]) == "desk", "a sentence is parsed");
  const KindTable& kinds = KindTable::built_in();
  check(kinds.all().size() > 500 && kinds.is_a("writing desks", "table"), "the kinds are known");
}

void try_solver(const fs::path& file) {
  const auto problem = read_problem(file);
  check(static_cast<bool>(problem), "a problem is read");
  if (!problem) return;
  const auto solution = solve(*problem, {}, KindTable::built_in());
  check(solution && solution->scene.unplaced.empty() && solution->held == solution->constraints,
        "everything finds a place, and all constraints hold");
}

}  // namespace

int main(int count, char** arguments) {
  try_files();
  try_folders();
  try_floors();
  if (count > 1) try_solver(arguments[1]);
  return failures == 0 ? 0 : 1;
}
