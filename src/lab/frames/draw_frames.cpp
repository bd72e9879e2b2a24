#include <algorithm>
#include <atomic>
#include <cstdio>
#include <mutex>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/sha256.h"
#include "base/threads.h"
#include "frame_labels.h"
#include "render/layer_pictures.h"
#include "roomgen/base/file.h"
#include "roomgen/base/text.h"
#include "roomgen/lab/draw_frames.h"
#include "roomgen/render/pictures.h"
#include "roomgen/lab/frames.h"
#include "video.h"
#include "view/camera.h"

namespace roomgen::lab {

namespace {

namespace fs = std::filesystem;
using namespace roomgen::detail;
using namespace lab::detail;

constexpr const char* frames_folder = "frames";
constexpr int most_threads = 64;
constexpr std::size_t most_side_file_bytes = 256u << 20;

struct FrameLayer {
  std::string name, extension;
  Result<std::string> (*encode)(const Layers&);  ///< null: the picture itself
};

const std::vector<FrameLayer>& layer_table() {
  static const std::vector<FrameLayer> table = {{"rgb", ".rgb.jpg", nullptr},
                                                {"depth", ".depth.png", encode_depths},
                                                {"instance", ".instance.png", encode_instances},
                                                {"category", ".category.png", encode_categories},
                                                {"normal", ".normal.png", encode_normals}};
  return table;
}

Error bad_frames(const std::string& what) { return {Error::Kind::invalid_input, "frames: " + what}; }

Status check_options(const FrameOptions& options) {
  for (const int side : {options.width, options.height})
    if (auto status = check_picture_side(side); !status) return with_context(status.error(), "frames");
  if (options.threads < 1 || options.threads > most_threads) return bad_frames("there must be 1 to 64 threads");
  if (options.quality < 1 || options.quality > 100) return bad_frames("the quality must be 1 to 100");
  if (options.layers.empty()) return bad_frames("there must be a layer: " + join(frame_layers(), ", "));
  for (const auto& layer : options.layers)
    if (std::count(frame_layers().begin(), frame_layers().end(), layer) == 0)
      return bad_frames("no layer is called " + layer + "; there are " + join(frame_layers(), ", "));
  return {};
}

std::string frame_name(std::size_t number) {
  char name[16];
  std::snprintf(name, sizeof name, "%06zu", number);
  return name;
}

// What all frames have in common, as a file beside them: frames of another job are of no use.
std::string job_text(const Scene& scene, const ModelTable& models, const Tour& tour, const FrameOptions& options) {
  Json missing = Json::array();
  for (const auto& object : scene.objects)
    if (!models.find(asset_key(object.asset))) missing.push_back(object.id);
  return dump_json({{"format", "roomgen-frames"},
                    {"version", 1},
                    {"scene", sha256_hex(dump_json(to_json(scene)))},
                    {"boxes", missing},
                    {"tour", sha256_hex(dump_json(to_json(tour)))},
                    {"size", {options.width, options.height}},
                    {"per_second", options.per_second},
                    {"quality", options.quality},
                    {"layers", options.layers}});
}

// NNNNNN.*
bool is_of_frames(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.size() > 7 && name[6] == '.' &&
         std::all_of(name.begin(), name.begin() + 6, [](char c) { return c >= '0' && c <= '9'; });
}

Status begin_job(const fs::path& folder, const std::string& job) {
  const fs::path frames = folder / frames_folder, file = frames / "job.json";
  if (auto status = make_folder(frames); !status) return status;
  if (const auto earlier = read_file(file); earlier && *earlier == job) return {};
  std::error_code code;
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(frames, code))
    if (entry.is_regular_file(code) && is_of_frames(entry.path())) old.push_back(entry.path());
  for (const auto& path : old) fs::remove(path, code);
  return write_file(file, job);
}

// Draws frame after frame, for several threads: one renderer for all, since two would not draw at once (GlTurn), and the files
// are made while others draw.
class FrameDrawer {
 public:
  FrameDrawer(const Scene& scene, const ModelTable& models, const TourIntrinsics& intrinsics,
              const FrameOptions& options, const fs::path& folder)
      : scene_(scene), models_(models), intrinsics_(intrinsics), options_(options), folder_(folder) {}

  Status draw(const TourFrame& frame) {
    const auto camera = tour_camera(frame.pose, intrinsics_);
    if (!camera) return camera.error();
    const auto layers = layers_of(*camera);
    if (!layers) return layers.error();
    return write(frame, *layers);
  }

 private:
  Result<Layers> layers_of(const Camera& camera) {
    const std::lock_guard lock(mutex_);
    if (!renderer_) {
      auto renderer = make_osmesa_renderer();
      if (!renderer) return renderer.error();
      renderer_ = std::move(*renderer);
    }
    Shot shot;
    shot.camera = camera;
    shot.color = wants("rgb");
    return renderer_->layers(scene_, models_, shot);
  }

  bool wants(const std::string& layer) const {
    return std::count(options_.layers.begin(), options_.layers.end(), layer) > 0;
  }

  Status write(const TourFrame& frame, const Layers& layers) const {
    const std::string stem = std::string(frames_folder) + "/" + frame_name(frame.number);
    Json files = Json::object();
    for (const auto& layer : layer_table()) {
      if (!wants(layer.name)) continue;
      const auto bytes = layer.encode ? layer.encode(layers) : encode_jpeg(layers.color, options_.quality);
      if (!bytes) return bytes.error();
      files[layer.name] = stem + layer.extension;
      if (auto status = write_file(folder_ / (stem + layer.extension), *bytes); !status) return status;
    }
    FrameRecord record{frame, layers.camera.width, layers.camera.height, "", seen_objects(layers, scene_.objects.size())};
    Json json = {{"record", to_json(record, scene_, layers.camera, files)},
                 {"segments", run_lengths(layers, record.objects)},
                 {"kitti", kitti_text(scene_, record, layers.camera)}};
    return write_file(folder_ / (stem + ".json"), json.dump() + "\n");
  }

  const Scene& scene_;
  const ModelTable& models_;
  const TourIntrinsics& intrinsics_;
  const FrameOptions& options_;
  const fs::path& folder_;
  std::mutex mutex_;  ///< of the renderer
  std::unique_ptr<Renderer> renderer_;
};

std::vector<TourFrame> missing_frames(const std::vector<TourFrame>& frames, const fs::path& folder) {
  std::vector<TourFrame> missing;
  std::error_code code;
  for (const auto& frame : frames)
    if (!fs::exists(folder / frames_folder / (frame_name(frame.number) + ".json"), code)) missing.push_back(frame);
  return missing;
}

// The threads take frame after frame; the first error stops all.
Status draw_in_parallel(const std::vector<TourFrame>& frames, const FrameOptions& options,
                        FrameDrawer& drawer) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  Status status;
  const auto work = [&](std::size_t) {
    for (std::size_t k = next++; k < frames.size(); k = next++) {
      Status done = options.cancel.cancelled() ? Status(Error{Error::Kind::cancelled, "frames: interrupted"})
                                               : drawer.draw(frames[k]);
      if (done) continue;
      const std::lock_guard lock(mutex);
      if (status) status = done;
      next = frames.size();
    }
  };
  on_threads(std::min(frames.size(), static_cast<std::size_t>(options.threads)), work);
  return status;
}

// The file of a frame, which may be of an earlier run: as this program writes it for a scene of so many things, or refused.
Result<Json> read_side_file(const fs::path& path, std::size_t things) {
  const auto text = read_file(path, most_side_file_bytes);
  if (!text) return text.error();
  auto json = parse_json(*text, path.string());
  if (!json) return json.error();
  JsonReader::Problems problems(path.string());
  const JsonReader root(*json, problems);
  root["kitti"].text(most_side_file_bytes);
  if (root["record"]["objects"].elements(things).size() != things) root["record"]["objects"].report("are not the scene's");
  for (const auto& run : root["segments"].elements(things)) {
    run["value"].number(1.0, static_cast<double>(things));
    if (!run["counts"].is_array()) run["counts"].report("must be an array");
  }
  if (const auto problem = problems.first()) return Error{problem->kind, problem->message + "; it is no frame of this scene: remove it and draw again"};
  return *std::move(json);
}

// Reads the frames' own files once more and puts them together.
Status put_together(const Scene& scene, const std::vector<TourFrame>& frames, const fs::path& folder) {
  std::string lines;
  std::vector<Json> runs;
  if (auto status = make_folder(folder / "kitti"); !status) return status;
  for (const auto& frame : frames) {
    const std::string name = frame_name(frame.number);
    const auto json = read_side_file(folder / frames_folder / (name + ".json"), scene.objects.size());
    if (!json) return json.error();
    lines += (*json)["record"].dump() + "\n";
    runs.push_back((*json)["segments"]);
    if (auto status = write_file(folder / "kitti" / (name + ".txt"), (*json)["kitti"].get<std::string>()); !status)
      return status;
  }
  if (auto status = write_file(folder / "frames.jsonl", lines); !status) return status;
  auto records = read_frames(folder / "frames.jsonl");
  if (!records) return records.error();
  std::vector<FrameLabels> labels;
  for (std::size_t k = 0; k < records->size(); ++k) labels.push_back({std::move((*records)[k]), std::move(runs[k])});
  return write_file(folder / "coco.json", coco_json(scene, labels).dump() + "\n");
}

void make_video(const std::vector<TourFrame>& frames, const FrameOptions& options, const fs::path& folder,
                FrameFigures& figures) {
  std::vector<fs::path> pictures;
  for (const auto& frame : frames) pictures.push_back(folder / frames_folder / (frame_name(frame.number) + ".rgb.jpg"));
  const fs::path video = folder / "tour.mp4";
  const auto made = write_video(video, pictures, options.per_second);
  (made ? figures.video : figures.no_video) = made ? video.string() : made.error().message;
}

}  // namespace

const std::vector<std::string>& frame_layers() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto& layer : layer_table()) list.push_back(layer.name);
    return list;
  }();
  return names;
}

Result<FrameFigures> draw_frames(const Scene& scene, const ModelTable& models, const Tour& tour,
                                 const FrameOptions& options, const std::filesystem::path& folder) {
  if (auto status = check_options(options); !status) return status.error();
  const auto frames = frames_of(tour, options.per_second);
  if (!frames) return frames.error();
  if (frames->empty()) return bad_frames("the tour has no keyframes and shows nothing; its `unseen` says why");
  if (auto status = begin_job(folder, job_text(scene, models, tour, options)); !status) return status.error();
  const auto missing = missing_frames(*frames, folder);
  const TourIntrinsics intrinsics{options.width, options.height, tour.intrinsics.field_of_view};
  FrameDrawer drawer(scene, models, intrinsics, options, folder);
  if (auto status = draw_in_parallel(missing, options, drawer); !status) return status.error();
  if (auto status = put_together(scene, *frames, folder); !status) return status.error();
  FrameFigures figures{frames->size(), missing.size(), "", ""};
  if (std::count(options.layers.begin(), options.layers.end(), "rgb") > 0) make_video(*frames, options, folder, figures);
  return figures;
}

}  // namespace roomgen::lab
