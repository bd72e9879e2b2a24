#pragma once

#include <string>

#include "command.h"
#include "designers.h"

namespace roomgen::cli {

/// What `roomgen benchmark run` is told (docs/questions.md).
struct BenchmarkRunOptions {
  std::string set, output, cache;
  int frames = 24;        ///< pictures with a question at most
  bool evidence = false;  ///< only the frames that show the answer
  bool video = false;     ///< tour.mp4 instead of frames, if the endpoint takes it
  int limit = 0;          ///< questions; 0: all
  int answer_tokens = 1024;
  int thinking = 0;  ///< tokens besides, for models that think before they answer
  bool force = false;
  DesignerOptions model;
};

/// Asks a model every question with frames or the video of its scene, and scores the answers. What is answered already is kept.
Result<int> run_benchmark(const Context& context, const BenchmarkRunOptions& options);

/// Scores answers.jsonl ({"id", "answer"} a line) to the questions of a file.
Result<int> score_answers(const Context& context, const std::string& questions, const std::string& answers,
                          const std::string& output);

}  // namespace roomgen::cli
