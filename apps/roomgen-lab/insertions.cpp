#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "experiments.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "roomgen/render/pictures.h"
#include "roomgen/edit/session.h"
#include "roomgen/edit_reader/understand.h"

namespace roomgen::cli {

using namespace lab;

namespace {

namespace fs = std::filesystem;

constexpr int pixels = 512;
constexpr std::size_t most_rooms = 100, most_sentences = 100, longest_text = 10'000;

struct RoomToEdit {
  std::string prompt;
  std::uint64_t seed = 0;
  std::vector<std::string> sentences;
};

Result<std::vector<RoomToEdit>> read_suite(const std::string& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  const auto json = parse_json(*text, file);
  if (!json) return json.error();
  const auto misread = [&](const std::string& what) { return Error{Error::Kind::invalid_input, file + ": " + what}; };
  if (!json->is_array() || json->size() > most_rooms) return misread("is no list of rooms");
  std::vector<RoomToEdit> rooms;
  for (const auto& one : *json) {
    const Json prompt = one.is_object() ? one.value("prompt", Json()) : Json();
    const Json seed = one.is_object() ? one.value("seed", Json()) : Json();
    const Json sentences = one.is_object() ? one.value("sentences", Json()) : Json();
    const std::string at = "room " + std::to_string(rooms.size() + 1) + ": ";
    if (!prompt.is_string() || !seed.is_number_unsigned()) return misread(at + "has no prompt, or no seed");
    if (!sentences.is_array() || sentences.size() > most_sentences) return misread(at + "has no list of sentences");
    RoomToEdit room{prompt.get<std::string>(), seed.get<std::uint64_t>(), {}};
    for (const auto& sentence : sentences) {
      if (!sentence.is_string() || sentence.get_ref<const std::string&>().size() > longest_text)
        return misread(at + "a sentence is no text");
      room.sentences.push_back(sentence.get<std::string>());
    }
    rooms.push_back(std::move(room));
  }
  return rooms;
}

Result<Scene> furnished(const RoomToEdit& room, const AssetLibrary& library) {
  const auto designer = make_rule_designer();
  PlanRequest request;
  request.prompt = room.prompt;
  request.seed = room.seed;
  const auto plan = designer->plan(request);
  if (!plan) return plan.error();
  BuildOptions options;
  options.seed = room.seed;
  auto made = generate(*plan, *designer, library, KindTable::built_in(), options);
  if (!made) return made.error();
  return std::move(made->scene);
}

/// The rooms, one after the other, and what is said of them.
class Insertions {
 public:
  Insertions(const Context& context, const AssetLibrary& library, Renderer& renderer, fs::path folder)
      : context_(context), library_(library), renderer_(renderer), folder_(std::move(folder)) {}

  Status add(const RoomToEdit& room) {
    const fs::path inside = "room-" + std::to_string(++rooms_);
    auto scene = furnished(room, library_);
    if (!scene) return scene.error();
    if (auto status = make_folder(folder_ / inside); !status) return status;
    if (auto status = write_file(folder_ / inside / "scene.json", dump_json(to_json(*scene))); !status) return status;
    auto session = Session::open(folder_ / inside / "scene.json", library_, KindTable::built_in());
    if (!session) return session.error();
    report_ += "\n## " + room.prompt + "\n\n| step | what came of it | from above |\n|---|---|---|\n";
    if (auto status = tell_step(*session, inside, 0, "as it was furnished", ""); !status) return status;
    int step = 0;
    for (const auto& sentence : room.sentences) {
      if (context_.cancel.cancelled()) return Error{Error::Kind::cancelled, "interrupted"};
      const std::string outcome = carried_out(*session, sentence);
      if (auto status = tell_step(*session, inside, ++step, sentence, outcome); !status) return status;
    }
    return session->save();
  }

  std::string report() const {
    return "# Edits by sentence\n\n" + std::to_string(done_) + " of " + std::to_string(asked_) + " done, " +
           std::to_string(repaired_) + " of them with neighbours that made way.\n" + report_;
  }

 private:
  std::string carried_out(Session& session, const std::string& sentence) {
    ++asked_;
    const auto understood = understand(session, sentence);
    if (!understood) return "not understood: " + understood.error().message;
    const auto report = session.apply(understood->operations, {sentence});
    if (!report) return "not possible: " + report.error().message;
    ++done_;
    repaired_ += report->repairs.empty() ? 0 : 1;
    std::string text = join(report->changes, "; ");
    for (const auto& move : report->repairs)
      text += "; " + move.object + " made way by " + format_number(move.distance(), 2) + " m";
    return text;
  }

  Status tell_step(Session& session, const fs::path& inside, int step, const std::string& asked,
                   const std::string& outcome) {
    if (!context_.quiet) std::fprintf(stderr, "room %d, %d: %s: %s\n", rooms_, step, printable(asked).c_str(), printable(outcome).c_str());
    const fs::path picture = inside / (std::to_string(step) + ".png");
    View view;
    view.kind = View::Kind::top;
    view.pixels = pixels;
    const auto image = renderer_.render(session.scene(), session.models(), view);
    if (!image) return image.error();
    report_ += "| " + asked + " | " + outcome + " | ![](" + picture.generic_string() + ") |\n";
    return write_png(folder_ / picture, *image);
  }

  const Context& context_;
  const AssetLibrary& library_;
  Renderer& renderer_;
  fs::path folder_;
  std::string report_;
  int rooms_ = 0, asked_ = 0, done_ = 0, repaired_ = 0;
};

}  // namespace

Result<int> run_insertions(const Context& context, const InsertionsOptions& options) {
  const auto suite = read_suite(options.suite);
  if (!suite) return suite.error();
  std::error_code code;
  if (fs::exists(options.output, code) && !fs::is_empty(options.output, code)) {
    if (!options.force) return Error{Error::Kind::io, options.output + ": is not empty; choose another folder or --force"};
    for (std::size_t room = 1; room <= suite->size(); ++room)
      fs::remove(fs::path(options.output) / ("room-" + std::to_string(room)) / "scene.journal", code);
  }
  auto library = open_all_libraries(options.libraries, context);
  if (!library) return library.error();
  auto renderer = make_osmesa_renderer();
  if (!renderer) return renderer.error();
  Insertions insertions(context, **library, **renderer, options.output);
  for (const auto& room : *suite)
    if (auto status = insertions.add(room); !status) return status.error();
  if (auto status = write_file(fs::path(options.output) / "report.md", insertions.report()); !status)
    return status.error();
  return exit_ok;
}

}  // namespace roomgen::cli
