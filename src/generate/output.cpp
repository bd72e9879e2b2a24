#include "roomgen/generate/output.h"

#include <algorithm>

#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"

namespace roomgen {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t max_name_words = 6;
constexpr std::size_t max_name_bytes = 60;

// What only an earlier run of ours leaves: a scene or plan that says so at its beginning.
bool is_earlier_output(const fs::path& folder) {
  for (const auto* name : {"scene.json", "plan.json"}) {
    const auto text = read_file(folder / name);
    if (text && text->substr(0, 200).find("\"roomgen-") != std::string::npos) return true;
  }
  return false;
}

}  // namespace

Status prepare_output_folder(const fs::path& folder, bool force) {
  const auto refuse = [&](const std::string& why) {
    return Error{Error::Kind::io, folder.string() + ": " + why};
  };
  std::error_code code;
  if (fs::exists(folder, code) && !fs::is_directory(folder, code))
    return refuse("exists and is not a folder");
  fs::create_directories(folder, code);
  if (code) return refuse("cannot create the folder: " + code.message());
  const bool empty = fs::is_empty(folder, code);
  if (code) return refuse("cannot read the folder: " + code.message());
  if (!empty && !force && !is_earlier_output(folder))
    return refuse("is not empty and no earlier output of roomgen; choose another folder or --force");
  // Known now rather than after the work.
  const fs::path probe = folder / ".roomgen-write-test";
  if (auto status = write_file(probe, ""); !status) return status;
  fs::remove(probe, code);
  return {};
}

std::string folder_name(const std::string& prompt) {
  auto pieces = words(prompt);
  pieces.resize(std::min(pieces.size(), max_name_words));
  std::string name;
  for (char c : join(pieces, "-"))
    if (static_cast<unsigned char>(c) < 128 && name.size() < max_name_bytes) name += c;
  return name.empty() ? "room" : name;
}

Status write_documents(const fs::path& folder, const Json& plan, const Generation& generation) {
  std::string trace;
  for (const auto& step : generation.trace)
    trace += step.record.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  if (auto s = write_file(folder / "plan.json", dump_json(plan)); !s) return s;
  if (auto s = write_file(folder / "trace.jsonl", trace); !s) return s;
  return write_file(folder / "scene.json", dump_json(to_json(generation.scene)));
}

}  // namespace roomgen
