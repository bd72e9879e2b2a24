#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "command.h"
#include "designers.h"
#include "roomgen/create/maker.h"
#include "roomgen/geometry/model.h"

namespace roomgen::cli {

/// Who makes objects from words, and who judges them.
struct MakerOptions {
  DesignerOptions designer;
  int answers = 3;                   ///< asked for at most, for one step
  std::optional<int> answer_tokens;  ///< bound on each answer; by step unless said
  bool judge = false;
};

/// --designer and what belongs to it, --answers, --answer-tokens, --judge.
void add_maker_options(CLI::App& command, MakerOptions& options);

/// The models that the options ask for, with what they need to live.
class ComposedMakers {
 public:
  static Result<ComposedMakers> compose(const MakerOptions& options, const Context& context,
                                        const std::string& cache_folder);

  bool asks_a_model() const { return making_.model != nullptr; }
  bool judges() const { return options_.judge; }
  /// The calls, tokens or money that were granted.
  bool budget_is_spent() const { return making_.limited && making_.limited->refused(); }
  /// One that knows nothing of what was asked before. Lives no longer than this.
  std::unique_ptr<create::Maker> maker(create::Variant variant, const CancelToken& cancel);
  /// What the model says of pictures of the thing. Precondition: judges().
  Result<create::Scores> judge(const std::string& prompt, const Model& model,
                               const CancelToken& cancel);

 private:
  MakerOptions options_;
  ComposedModel making_;                  ///< no model for rules
  std::optional<ComposedModel> judging_;  ///< a model that only judges what rules make
};

}  // namespace roomgen::cli
