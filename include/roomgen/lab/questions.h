#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/json.h"
#include "roomgen/base/result.h"
#include "roomgen/scene/scene.h"
#include "roomgen/lab/frames.h"
#include "roomgen/lab/tour.h"

namespace roomgen::lab {

/// A question about a scene that its tour's frames can answer, with the true answer (docs/questions.md).
struct SpatialQuestion {
  std::string id;
  std::string task;         ///< "measurement", "perspective", "spatiotemporal", "relation", "control"
  std::string form;         ///< "height": an entry of data/questions/forms.json
  std::string text;
  std::vector<std::string> choices;  ///< empty: the answer is a number
  std::size_t right = 0;             ///< of the choices
  std::string unit;                  ///< of a number: "m", "m2", or "" for a count
  double number = 0.0;
  double tolerance = 0.0;            ///< that an answer may be off and still count as exact, in the unit
  std::vector<std::size_t> frames;   ///< those that show it, in their order
  std::vector<std::string> objects;  ///< ids of those that it is about, sorted
  Json arguments;                    ///< what the text's places stand for, for who checks the answer
  Json complexity;                   ///< of the scene, and of the benchmark's cell if it is of one
};

struct QuestionOptions {
  std::vector<std::string> tasks;  ///< none: all of them
  int per_form = 4;                ///< questions of each form at most
  std::uint64_t seed = 0;
  Json complexity;                 ///< an object; added to what is known of the scene
  std::string prefix;              ///< of ids
};

/// Questions of all forms that the scene and its frames have true and unambiguous answers to, shuffled. Equal
/// arguments give equal questions. Fails on unknown tasks, and if the frames are not of this scene.
Result<std::vector<SpatialQuestion>> make_questions(const Scene& scene, const ModelTable& models, const KindTable& kinds,
                                             const std::vector<FrameRecord>& frames,
                                             const QuestionOptions& options = {});

/// The tasks that questions may be of.
std::vector<std::string> question_tasks();

/// A line of questions.jsonl (docs/question.schema.json), and the whole file.
Json to_json(const SpatialQuestion& question);
Result<std::vector<SpatialQuestion>> read_questions(const std::filesystem::path& path);

/// How good an answer in words is, each from 0 to 1.
struct AnswerScore {
  bool read = false;      ///< a number or a choice was found in it
  double exact = 0.0;     ///< 1: the right choice, or a number within the tolerance
  /// Of numbers: the share of the thresholds 0.50, 0.55, ..., 0.95 for which |answer - truth| / |truth| < 1 - threshold
  /// (VSI-Bench, Yang et al. 2025); of choices `exact`.
  double mean_relative = 0.0;
  /// Of numbers: max(0, 1 - |answer - truth| / max(|truth|, 1)) for counts, with 0.001 in place of 1 for measures
  /// (InfiniBench's code); of choices `exact`.
  double relative = 0.0;
};
/// Reads the last line that has a choice (its letter or its text) or a number.
AnswerScore score_answer(const SpatialQuestion& question, std::string_view answer);

}  // namespace roomgen::lab
