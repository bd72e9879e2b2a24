#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "roomgen/chat/chat_model.h"
#include "roomgen/chat/prompts.h"
#include "roomgen/create/maker.h"
#include "roomgen/shape/evaluate.h"

namespace roomgen::create {

struct ModelMakerOptions {
  Variant variant = Variant::full;
  /// Kinds that a decomposition may name as the nearest (Description::kind).
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

}  // namespace roomgen::create
