// A disk that fails at any call while a scene is edited: nothing acknowledged is lost, nothing is half done.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "failing_calls.h"
#include "history.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "edit/small_scenes.h"
#include "short_of_memory.h"
#include "support/contains.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

namespace fs = std::filesystem;

/// What a person was told is done, and what the call that failed may have come to.
struct Told {
  std::string scene, under_way;
  std::size_t sequence = 0;
};

Result<History> open_history(const fs::path& scene, SceneAccess access) {
  auto files = open_scene_files(scene, access);
  if (!files) return files.error();
  return History::open(*std::move(files), access);
}

Status change(History& history, int x, Told& told) {
  Scene scene = *scene_from_json(history.state().document, "state");
  scene.objects.front().position.x() = 1.0 + x;
  told.under_way = dump_json(to_json(scene));
  if (auto status = history.commit(scene, {"change"}); !status) return status;
  told.scene = history.state().text;
  told.sequence = history.state().sequence;
  return history.save();
}

Status undo(History& history, const std::string& earlier, Told& told) {
  told.under_way = earlier;
  const auto taken = history.undo(1, "test");
  if (!taken) return taken.error();
  told.scene = history.state().text;
  told.sequence = history.state().sequence;
  return history.save();
}

Status edit_twice_and_undo(const fs::path& scene, Told& told) {
  auto history = open_history(scene, SceneAccess::edit);
  if (!history) return history.error();
  if (auto status = change(*history, 1, told); !status) return status;
  const std::string earlier = told.scene;
  if (auto status = change(*history, 2, told); !status) return status;
  return undo(*history, earlier, told);
}

// What stays after the call that failed is opened again, and a whole scene.
void check_what_is_left(const fs::path& scene, const Told& told) {
  const auto text = read_file(scene);
  REQUIRE(text);
  REQUIRE(parse_json(*text, "scene.json"));
  const auto history = open_history(scene, SceneAccess::edit);
  INFO((history ? "" : history.error().message));
  REQUIRE(history);
  CHECK((history->state().text == told.scene || history->state().text == told.under_way));
  if (told.sequence > 0) CHECK(history->timeline().entries().count(told.sequence) == 1);
}

bool try_call(Call call, std::size_t n, bool lasting) {
  const TemporaryFolder folder;
  const fs::path scene = folder / "scene.json";
  Told told;
  told.scene = dump_json(to_json(row_of_boxes(3)));
  REQUIRE(write_file(scene, told.scene));
  Status status;
  bool has_failed = false;
  {
    const FailingCalls failing(call, n, lasting);
    status = edit_twice_and_undo(scene, told);
    has_failed = failing.has_failed();
  }
  INFO(name(call) << " " << n << (lasting ? " lasting" : "") << ": " << (status ? "done" : status.error().message));
  if (!status) {
    CHECK(is_one_line(status.error().message));
    CHECK(contains_text(status.error().message, folder.path().string()));
  }
  check_what_is_left(scene, told);
  return has_failed;
}

}  // namespace

TEST_CASE("Whichever call fails, a session goes on from what it acknowledged") {
  std::size_t tried = 0;
  for (const Call call : all_file_calls) {
    std::size_t n = 0;
    while (try_call(call, n, false)) ++n;
    for (std::size_t k = 0; k < n; ++k) try_call(call, k, true);
    tried += n;
  }
  // Three steps, each of them written and synced in both files.
  CHECK(tried >= 15);
}

TEST_CASE("Wherever memory ends, the scene is that of one of the steps") {
  constexpr std::size_t stride = 29;  // there are thousands of allocations
  const std::string first = dump_json(to_json(row_of_boxes(1)));
  std::size_t tried = 0;
  for (bool has_failed = true; has_failed; ++tried) {
    const TemporaryFolder folder;
    const fs::path scene = folder / "scene.json";
    REQUIRE(write_file(scene, first));
    has_failed = run_short_of_memory(tried * stride, [&] {
      Told told;
      (void)edit_twice_and_undo(scene, told);
    });
    INFO("allocation " << tried * stride);
    const auto history = open_history(scene, SceneAccess::edit);
    INFO((history ? "" : history.error().message));
    REQUIRE(history);
    const auto left = scene_from_json(history->state().document, "scene.json");
    REQUIRE(left);
    const double x = left->objects.front().position.x();
    CHECK((x == row_of_boxes(1).objects.front().position.x() || x == 2.0 || x == 3.0));
  }
  CHECK(tried > 20);
}
