#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/chat/chat_model.h"
#include "roomgen/create/maker.h"
#include "roomgen/shape/evaluate.h"

namespace roomgen::create {

struct ModelMakerOptions {
  Variant variant = Variant::full;
  /// Kinds that a decomposition may name as the nearest (Description::kind); empty: all that are built in.
  std::vector<std::string> kinds = {};
  int answers = 3;  ///< asked for at most, for one step, when answers cannot be used
  /// Longest answers, in tokens; what a model thinks before it answers counts too.
  int classify_tokens = 512;
  int decompose_tokens = 4096;
  int generate_tokens = 8192;
  CancelToken cancel = {};  ///< of classify() and decompose(); requests have their own
  /// True when the calls, tokens or money that were granted are spent: then the steps fail with
  /// limit.
  std::function<bool()> budget_is_spent = {};
};

/// A maker that asks a language model. Answers are repaired where they are clear; else the model is
/// asked again with the exact error; else the fallback answers and take_notes() says so. A program
/// that can be used but is not what was described is asked for once more. A model that cannot be
/// reached before it ever answered is an error; later, and after three failures in a row, the
/// fallback takes over for good.
/// In Variant::direct generate() fails with invalid_input: there is no program. `fallback` is not
/// null; the model must outlive the maker.
std::unique_ptr<Maker> make_model_maker(ChatModel& model, std::unique_ptr<Maker> fallback,
                                             Prompts prompts, ModelMakerOptions options = {});

/// 1 (bad) to 5 (as good as bought), and one sentence why.
struct Score {
  int points = 0;
  std::string reason;
};

/// The three rubrics that people judged objects by (papers: primitives, section 5.2).
struct Scores {
  Score structure;  ///< does it hold together and stand, as a thing that could be built?
  Score realism;    ///< does it look like one whole thing of its kind?
  Score alignment;  ///< is it what the words say?

  double mean() const { return (structure.points + realism.points + alignment.points) / 3.0; }
};

struct JudgeOptions {
  int answers = 3;  ///< asked for at most, when answers cannot be used
  int tokens = 1024;
  CancelToken cancel = {};
};

/// What a model that sees pictures says of an object. `views`: whole PNG files of it from several
/// sides, at least one. Fails as ChatModel::chat() does, and with invalid_input when no answer can
/// be used.
Result<Scores> judge(ChatModel& model, const Prompts& prompts, const std::string& prompt,
                     const std::vector<std::string>& views, const JudgeOptions& options = {});

}  // namespace roomgen::create
