// Times objects made from words by rules, in-process: the first sentences of a list, several times
// each. Prints tables in Markdown. Milliseconds are processor time of the one thread that works, so
// that a busy machine does not change them much.
//
//   bench_create [--count N] [--runs N] [FILE]

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "create/validate.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/create/create.h"
#include "roomgen/create/maker.h"
#include "roomgen/export/exporter.h"
#include "roomgen/shape/evaluate.h"
#ifdef ROOMGEN_HAS_RENDER
#include "roomgen/render/pictures.h"
#endif

namespace {

using namespace roomgen;

double now() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

template <typename Do>
auto timed(double& sum, const Do& what) {
  const double start = now();
  auto result = what();
  sum += now() - start;
  return result;
}

/// Where the time goes, milliseconds.
struct Stages {
  double words = 0.0, program = 0.0, validation = 0.0, shape = 0.0, file = 0.0;
  double all() const { return words + program + validation + shape + file; }
};

// The maker by rules, with a clock in its hand.
class TimedMaker final : public create::Maker {
 public:
  Result<create::Verdict> classify(const std::string& prompt) override {
    return timed(words, [&] { return rules_->classify(prompt); });
  }
  Result<std::vector<create::Description>> decompose(const std::string& prompt) override {
    return timed(words, [&] { return rules_->decompose(prompt); });
  }
  Result<shape::Program> generate(const create::MakeRequest& request) override {
    auto made = timed(program, [&] { return rules_->generate(request); });
    if (made) programs.push_back(*made);
    return made;
  }
  bool wants_examples() const override { return rules_->wants_examples(); }
  std::vector<std::string> take_notes() override { return rules_->take_notes(); }

  double words = 0.0, program = 0.0;
  std::vector<shape::Program> programs;

 private:
  std::unique_ptr<create::Maker> rules_ = create::make_rule_maker();
};

ExportOptions glb_options() {
  ExportOptions options;
#ifdef ROOMGEN_HAS_RENDER
  options.encode_image = encode_texture;
#endif
  return options;
}

create::ValidateOptions validation_of(const create::CreatedObject& object) {
  create::ValidateOptions options;
  if (object.mount == Mount::wall) options.footing = create::Footing::wall;
  if (object.mount == Mount::ceiling) options.footing = create::Footing::ceiling;
  return options;
}

struct Row {
  std::string name;
  std::vector<double> milliseconds;
  std::size_t triangles = 0, repairs = 0;
  int sound = 0, objects = 0;
  Stages stages;
};

// Validation is timed by itself, once more on the same programs; what is left of the whole is
// evaluation.
void run(const std::string& prompt, Row& row) {
  TimedMaker maker;
  double whole = 0.0;
  Stages stages;
  const auto creation = timed(whole, [&] { return create::create(prompt, maker); });
  if (!creation || creation->objects.empty()) return;
  for (const auto& object : creation->objects)
    (void)timed(stages.file, [&] {
      return make_glb(object.program.name, to_model(object.shape), glb_options());
    });
  for (const auto& program : maker.programs)
    (void)timed(stages.validation, [&] {
      return create::validate(program, validation_of(creation->objects.front()));
    });
  stages.words = maker.words;
  stages.program = maker.program;
  stages.shape = std::max(0.0, whole - maker.words - maker.program - stages.validation);
  const auto count = static_cast<double>(creation->objects.size());
  row.milliseconds.push_back((whole + stages.file) / count);
  row.stages.words += stages.words, row.stages.program += stages.program;
  row.stages.validation += stages.validation, row.stages.shape += stages.shape;
  row.stages.file += stages.file;
  row.triangles = row.repairs = 0;
  row.sound = 0, row.objects = static_cast<int>(creation->objects.size());
  for (const auto& object : creation->objects) {
    row.triangles += triangle_count(object.shape);
    row.repairs += object.repairs.size();
    row.sound += object.soundness.sound();
  }
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

double worst(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

void print(const Row& row) {
  std::printf("| %s | %.1f | %.1f | %zu | %zu | %d / %d |\n", row.name.c_str(),
              median(row.milliseconds), worst(row.milliseconds), row.triangles, row.repairs,
              row.sound, row.objects);
}

void print_shares(const Stages& stages) {
  std::printf("\n| stage | share |\n|---|---|\n");
  const std::pair<const char*, double> shares[] = {{"reading the words", stages.words},
                                                   {"the program", stages.program},
                                                   {"validation", stages.validation},
                                                   {"meshes and textures", stages.shape},
                                                   {"GLB", stages.file}};
  for (const auto& [name, part] : shares)
    std::printf("| %s | %.0f %% |\n", name, 100.0 * part / std::max(1e-9, stages.all()));
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t count = 20;
  int runs = 5;
  std::string file = ROOMGEN_BENCH_DATA "/create/prompts.json";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--count" && i + 1 < argc)
      count = std::strtoul(argv[++i], nullptr, 10);
    else if (argument == "--runs" && i + 1 < argc)
      runs = std::atoi(argv[++i]);
    else
      file = argument;
  }
  const auto text = read_file(file, 1u << 24);
  const auto prompts = text ? parse_json(*text, file) : Result<Json>(text.error());
  if (!prompts) {
    std::fprintf(stderr, "%s\n", prompts.error().message.c_str());
    return 1;
  }

  double first = 0.0;
  auto maker = create::make_rule_maker();
  (void)timed(first, [&] { return create::create("a stool", *maker); });
  std::printf(
      "The first object of a process, with the kinds and words that are read then: %.1f ms\n\n",
      first);
  std::printf("| sentence | median ms an object | worst ms | triangles | repairs | sound |\n");
  std::printf("|---|---|---|---|---|---|\n");
  Row all;
  all.name = "all";
  for (std::size_t k = 0; k < std::min(count, prompts->size()); ++k) {
    Row row;
    row.name = (*prompts)[k].value("prompt", "");
    for (int i = 0; i < runs; ++i) run(row.name, row);
    print(row);
    all.milliseconds.insert(all.milliseconds.end(), row.milliseconds.begin(),
                            row.milliseconds.end());
    all.triangles += row.triangles, all.repairs += row.repairs;
    all.sound += row.sound, all.objects += row.objects;
    all.stages.words += row.stages.words, all.stages.program += row.stages.program;
    all.stages.validation += row.stages.validation, all.stages.shape += row.stages.shape;
    all.stages.file += row.stages.file;
  }
  print(all);
  print_shares(all.stages);
}
