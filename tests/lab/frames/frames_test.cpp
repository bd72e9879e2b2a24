// Frames of a tour against projections by hand, and against themselves with other threads.
#include "roomgen/lab/draw_frames.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "support/json_of.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/render/pictures.h"
#include "roomgen/lab/frames.h"
#include "support/rooms.h"
#include "support/temporary_folder.h"

using namespace roomgen;
using namespace roomgen::lab;

namespace {

Scene small_room() {
  Scene scene = rooms::scene(rooms::box(4, 4), {rooms::thing("wardrobe-0", "wardrobe", {1.0, 0.5, 1.8}, {2, 3.5}),
                                                rooms::thing("chair-0", "chair", {0.5, 0.5, 0.9}, {1.4, 2.5}, 30)});
  scene.room.openings = {rooms::door("door-0", 0, 0.5, 1.4)};
  return scene;
}

// Two stops and a turn, without a search.
Tour small_tour() {
  Tour tour;
  tour.intrinsics = {64, 48, radians(90.0)};
  for (int k = 0; k < 8; ++k) tour.keyframes.push_back({0.25 * k, {{1.0 + 0.1 * k, 0.8, 1.5}, radians(180.0 - 5.0 * k), 0.0}});
  tour.views = {{"wardrobe-0", tour.keyframes[3].pose, 100, 100, 0.0, 0.0, 3}};
  return tour;
}

FrameOptions small_frames(int threads) {
  FrameOptions options;
  options.width = 96, options.height = 72;
  options.threads = threads;
  return options;
}

std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[std::filesystem::relative(entry.path(), folder).string()] = *read_file(entry.path());
  return files;
}

FrameFigures drawn(const std::filesystem::path& folder, int threads = 1, const Tour& tour = small_tour()) {
  const auto figures = draw_frames(small_room(), {}, tour, small_frames(threads), folder);
  if (!figures) FAIL(figures.error().message);
  return *figures;
}

}  // namespace

TEST_CASE("Frames are the same on any number of threads, and are drawn once") {
  const TemporaryFolder one, three;
  CHECK(drawn(one.path()).drawn == 8);
  CHECK(drawn(three.path(), 3).frames == 8);
  const auto files = contents(one.path());
  CHECK(files == contents(three.path()));
  CHECK(files.count("frames/000000.rgb.jpg") == 1);
  CHECK(drawn(one.path()).drawn == 0);
  // What is lost is drawn again, and only that.
  std::filesystem::remove(one / "frames/000002.json");
  std::filesystem::remove(one / "frames/000002.depth.png");
  CHECK(drawn(one.path()).drawn == 1);
  CHECK(files == contents(one.path()));
  // Frames of another tour go.
  Tour shorter = small_tour();
  shorter.keyframes.resize(5);
  CHECK(drawn(one.path(), 1, shorter).drawn == 5);
  CHECK(contents(one.path()).count("frames/000007.json") == 0);
}

TEST_CASE("Files of frames that somebody changed are refused by name") {
  const TemporaryFolder folder;
  drawn(folder.path());
  const auto path = folder / "frames/000002.json";
  const Json whole = *parse_json(*read_file(path), "frame");
  const std::pair<const char*, const char*> changes[] = {{"/kitti", "5"}, {"/segments", R"([{"value":99,"counts":[0]}])"},
                                                         {"/segments", R"([{"value":"x"}])"}, {"/segments", R"([{"value":1}])"}, {"/segments", "[7]"},
                                                         {"/record", R"("none")"}, {"/record/objects", "[]"}};
  for (const auto& [place, value] : changes) {
    INFO(place << " " << value);
    Json changed = whole;
    changed[Json::json_pointer(place)] = *parse_json(value, "value");
    REQUIRE(write_file(path, changed.dump()));
    const auto figures = draw_frames(small_room(), {}, small_tour(), small_frames(1), folder.path());
    REQUIRE_FALSE(figures);
    CHECK(figures.error().kind == Error::Kind::invalid_input);
    CHECK(figures.error().message.find("000002.json") != std::string::npos);
    CHECK(figures.error().message.find("remove it and draw again") != std::string::npos);
  }
}

TEST_CASE("Boxes of frames.jsonl project around the pixels that are counted") {
  const TemporaryFolder folder;
  drawn(folder.path());
  const Scene scene = small_room();
  const auto records = read_frames(folder / "frames.jsonl");
  REQUIRE(records);
  CHECK((*records)[3].frame.target == "wardrobe-0");
  int seen = 0;
  for (const auto& line : split(*read_file(folder / "frames.jsonl"), '\n')) {
    if (line.empty()) continue;
    const Json frame = *parse_json(line, "frames.jsonl");
    const double focal = frame["camera"]["focal_length_px"][0];
    for (const auto& object : frame["objects"]) {
      if (object["pixels"] == 0) continue;
      ++seen;
      double low_u = 1e9, high_u = -1e9, low_v = 1e9, high_v = -1e9;
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
          for (const double z : {0.0, 1.0}) {
            const double local[] = {x * object["size"][0].get<double>(), y * object["size"][1].get<double>(), z * object["size"][2].get<double>(), 1.0};
            double p[3] = {};
            for (int row = 0; row < 3; ++row)
              for (int column = 0; column < 4; ++column) p[row] += object["camera_from_object"][row][column].get<double>() * local[column];
            REQUIRE(p[2] > 0);
            low_u = std::min(low_u, 48 + focal * p[0] / p[2]), high_u = std::max(high_u, 48 + focal * p[0] / p[2]);
            low_v = std::min(low_v, 36 + focal * p[1] / p[2]), high_v = std::max(high_v, 36 + focal * p[1] / p[2]);
          }
      const auto box = object["box_px"].get<std::vector<double>>();
      CHECK((box[0] >= low_u - 1 && box[2] <= high_u + 1 && box[1] >= low_v - 1 && box[3] <= high_v + 1));
      // Boxes are drawn as they are: what is not hidden reaches the edges of its projection.
      if (object["id"] == "chair-0" && low_u > 0 && high_u < 96) CHECK((box[0] <= low_u + 1.5 && box[2] >= high_u - 1.5));
    }
  }
  CHECK(seen > 8);
}

TEST_CASE("COCO's run lengths cover what is counted") {
  const TemporaryFolder folder;
  drawn(folder.path());
  const Json coco = json_of(folder / "coco.json");
  CHECK(coco["images"].size() == 8);
  REQUIRE(coco["annotations"].size() > 8);
  for (const auto& one : coco["annotations"]) {
    std::size_t inside = 0, all = 0;
    bool counts_inside = false;
    for (const std::size_t count : one["segmentation"]["counts"]) {
      if (counts_inside) inside += count;
      all += count;
      counts_inside = !counts_inside;
    }
    CHECK(inside == one["area"].get<std::size_t>());
    CHECK(all == 96u * 72u);
  }
  CHECK(std::filesystem::exists(folder / "kitti/000003.txt"));
}

TEST_CASE("Frames that make no sense are refused") {
  const TemporaryFolder folder;
  FrameOptions options = small_frames(1);
  options.layers = {"heat"};
  CHECK(!draw_frames(small_room(), {}, small_tour(), options, folder.path()));
  options = small_frames(0);
  CHECK(!draw_frames(small_room(), {}, small_tour(), options, folder.path()));
  CHECK(!draw_frames(small_room(), {}, Tour{}, small_frames(1), folder.path()));
}
