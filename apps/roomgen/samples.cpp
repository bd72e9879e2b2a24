#include "samples.h"

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "print.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/evaluate/report.h"
#include "varied.h"

namespace roomgen::cli {

namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 30;  // of a file of layouts
constexpr std::size_t most_lines_told = 10;

// Beside the layouts, which say of each thing no more than where it stands.
std::filesystem::path scene_beside(const std::string& layouts) {
  return std::filesystem::path(layouts).replace_extension(".scene.json");
}

Json samples_json(const SampleWish& wish, const Samples& samples, double seconds) {
  Json json = {{"output", wish.output},
               {"objects", samples.scene.objects.size()},
               {"unplaced", samples.scene.unplaced.size()},
               {"wanted", wish.options.count},
               {"layouts", samples.layouts.size()},
               {"drawn", samples.drawn},
               {"constraints", samples.constraints},
               {"seconds", rounded(seconds)}};
  json["distinct"] = samples.drawn == 0 ? 0.0
                                        : rounded(static_cast<double>(samples.layouts.size()) /
                                                  static_cast<double>(samples.drawn));
  return json;
}

std::string samples_text(const SampleWish& wish, const Samples& samples, double seconds) {
  const double found = static_cast<double>(samples.layouts.size());
  const double share = samples.drawn == 0 ? 0.0 : 100.0 * found / static_cast<double>(samples.drawn);
  return std::to_string(samples.layouts.size()) + " of " + std::to_string(wish.options.count) +
         " distinct layouts were found: " + format_number(share, 1) + " % of " + std::to_string(samples.drawn) +
         " drawn (" + format_number(seconds, 2) + " s, " + format_number(found / std::max(seconds, 1e-9), 0) +
         " a second)";
}

// Beside the lines: on stdout only if they are not there.
void tell(const Context& context, const SampleWish& wish, const Samples& samples, double seconds) {
  std::FILE* stream = wish.output.empty() ? stderr : stdout;
  if (context.json) {
    std::fputs(dump_json(samples_json(wish, samples, seconds)).c_str(), stream);
    return;
  }
  std::fprintf(stream, "%s\n", printable(samples_text(wish, samples, seconds)).c_str());
  for (const auto& missing : samples.scene.unplaced) std::fprintf(stream, "  %s\n", printable(missing.reason).c_str());
}

Status write_lines(const SampleWish& wish, const std::string& lines) {
  if (!wish.output.empty()) return write_file(wish.output, lines);
  if (std::fwrite(lines.data(), 1, lines.size(), stdout) == lines.size() && std::fflush(stdout) == 0) return {};
  return Error{Error::Kind::io, "the layouts could not be written to stdout"};
}

struct LineCounts {
  std::size_t layouts = 0, faulty = 0;
  int least_held = 0, most_held = 0;
  std::vector<std::string> told;
};

Status check_line(const std::string& text, const Varied& varied, const std::string& source, LineCounts& counts) {
  const auto json = parse_json(text, source);
  if (!json) return json.error();
  const auto scene = scene_of_layout(*json, varied.scene, source);
  if (!scene) return scene.error();
  const auto report = examine(*scene, varied.models, KindTable::built_in());
  const int held = report.relations_held();
  if (json->value("held", held) != held)
    return Error{Error::Kind::invalid_input, source + ": /held: " + std::to_string(held) + " constraints hold"};
  counts.least_held = counts.layouts == 0 ? held : std::min(counts.least_held, held);
  counts.most_held = std::max(counts.most_held, held);
  ++counts.layouts;
  if (report.violations.empty()) return {};
  ++counts.faulty;
  if (counts.told.size() < most_lines_told)
    counts.told.push_back("  " + source + ": " + to_text(report.violations.front()));
  return {};
}

void print_counts(const Context& context, const std::string& file, const LineCounts& counts) {
  if (context.json) {
    const Json json = {{"file", file}, {"layouts", counts.layouts}, {"faulty", counts.faulty},
                       {"held", {counts.least_held, counts.most_held}}};
    std::fputs(dump_json(json).c_str(), stdout);
    return;
  }
  std::printf("%s: %zu layouts, %zu with faults; %d to %d constraints held\n", printable(file).c_str(), counts.layouts,
              counts.faulty, counts.least_held, counts.most_held);
  print_lines(counts.told);
}

}  // namespace

Result<int> write_samples(const Context& context, const SampleWish& wish) {
  const auto varied = read_varied(wish.file, wish.models, context);
  if (!varied) return varied.error();
  const auto start = std::chrono::steady_clock::now();
  const KindTable& kinds = KindTable::built_in();
  const auto samples = varied->problem ? sample(*varied->problem, varied->models, kinds, wish.options)
                                       : sample(varied->scene, varied->models, kinds, wish.options);
  if (!samples) return samples.error();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::string lines;
  for (std::size_t i = 0; i < samples->layouts.size(); ++i) lines += json_line(to_json(*samples, i)) + "\n";
  if (auto written = write_lines(wish, lines); !written) return written.error();
  if (varied->is_made && !wish.output.empty())
    if (auto written = write_file(scene_beside(wish.output), dump_json(to_json(varied->scene))); !written)
      return written.error();
  tell(context, wish, *samples, elapsed.count());
  if (context.cancel.cancelled()) return exit_interrupted;
  const bool whole = samples->scene.unplaced.empty() && samples->layouts.size() == wish.options.count;
  return samples->layouts.empty() || (wish.strict && !whole) ? exit_failure : exit_ok;
}

Result<int> check_samples(const Context& context, const std::string& file, const std::string& varied_file,
                          const ModelOptions& models) {
  if (varied_file.empty())
    return Error{Error::Kind::invalid_input, file + ": layouts are checked with --of and the problem or scene "
                                                    "that they were drawn from"};
  const auto varied = read_varied(varied_file, models, context);
  if (!varied) return varied.error();
  const auto text = read_file(file, most_bytes);
  if (!text) return text.error();
  LineCounts counts;
  std::size_t number = 0;
  for (const auto& line : split(*text, '\n')) {
    ++number;
    if (line.empty()) continue;
    if (auto sound = check_line(line, *varied, file + ":" + std::to_string(number), counts); !sound)
      return sound.error();
  }
  print_counts(context, file, counts);
  return counts.faulty == 0 ? exit_ok : exit_failure;
}

}  // namespace roomgen::cli
