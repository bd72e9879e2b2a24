#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "roomgen/chat/chat_model.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"

namespace roomgen::cli {

/// Who plans the room and suggests places.
struct DesignerOptions {
  std::string designer = "rules";
  std::string book, design;  ///< of the designer by book: a folder, a file
  std::string reader;  ///< who reads the wish: rules or model; empty: who designs
  std::string model, base_url, protocol, key_file, prompts, prices;
  std::string mode = "fused", frame = "plan", fusion = "scaled", order = "plan", steps = "groups";
  std::string choose = "on", make = "model";
  std::string record, replay, picture = "jpeg", preset;
  bool cache_answers = false, no_fallback = false;
  std::optional<int> max_calls;
  std::optional<long long> max_tokens;
  std::optional<double> max_dollars;
  int plan_tokens = ModelDesignerOptions().plan_tokens;
  int place_tokens = ModelDesignerOptions().place_tokens;
  double lost_step = FusionOptions().lost_step;
  double seconds_per_call = 300.0;
  std::optional<double> idle_seconds;  ///< else by how near the endpoint is
  int thinking = 0;
  std::string improve = "minimal", repair = "on";

  bool reads_by_model() const { return (reader.empty() ? designer : reader) == "model"; }
  ModelMode model_mode() const;
  double idle() const;
  bool paper_frame() const { return frame == "paper"; }
};

/// Adds --designer and how a language model is reached.
void add_chat_options(CLI::App& command, DesignerOptions& options);
/// Adds --thinking, for commands whose models write programs.
void add_thinking_option(CLI::App& command, DesignerOptions& options);
/// Adds --reader, for commands that read a wish.
void add_reader_option(CLI::App& command, DesignerOptions& options);
/// These, and what a model is asked while it designs a room.
void add_designer_options(CLI::App& command, DesignerOptions& options);

/// --improve, --repair and --preset: what a preset fixes is told where it contradicts.
void add_finish_options(CLI::App& command, DesignerOptions& options);
/// A model that is named designs, unless something else is told.
void let_model_design(const CLI::App& command, DesignerOptions& options);
/// What --preset stands for; options that were given count as well.
void apply_preset(DesignerOptions& options);

/// A designer with what it needs to live.
struct ComposedDesigner {
  std::unique_ptr<ChatModel> model;       ///< null for rules
  const LimitedModel* limited = nullptr;  ///< part of `model`, unless answers are replayed
  std::unique_ptr<Designer> designer;
  std::unique_ptr<Reader> reader;  ///< null where rules read
  /// The pictures that the model was shown, PNG or JPEG, in order.
  std::shared_ptr<std::vector<std::string>> shown = std::make_shared<std::vector<std::string>>();
};

/// The rules, or the model that the options name with recording, replay, cache and limits around
/// it. `cache_folder` is where answers are kept.
Result<ComposedDesigner> compose_designer(const DesignerOptions& options, const Context& context,
                                          const std::string& cache_folder);

/// A picture as the options want it sent.
Result<std::string> encode_for(const DesignerOptions& options, const Image& picture);

/// The model alone, for commands that ask it other things. Null where neither designer nor reader
/// is one.
struct ComposedModel {
  std::unique_ptr<ChatModel> model;
  const LimitedModel* limited = nullptr;
  Prompts prompts;
};
Result<ComposedModel> compose_model(const DesignerOptions& options, const Context& context,
                                    const std::string& cache_folder);

/// Who reads wishes: null for rules.
std::unique_ptr<Reader> compose_reader(const DesignerOptions& options, ChatModel* model,
                                       const LimitedModel* limited, Prompts prompts);

/// What the mode makes of the fusion: without a suggestion there is nothing to weigh. And what is moved
/// besides.
void apply(const DesignerOptions& options, BuildOptions& build);

}  // namespace roomgen::cli
