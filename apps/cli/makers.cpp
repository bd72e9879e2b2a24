#include "makers.h"

#include "made.h"
#include "roomgen/render/pictures.h"

namespace roomgen::cli {

void add_maker_options(CLI::App& command, MakerOptions& options) {
  add_designer_options(command, options.designer);
  const std::string group = "Designer";
  command
      .add_option("--answers", options.answers,
                  "How often the model is asked for one step while its answers cannot be used")
      ->group(group)
      ->check(CLI::Range(1, 10))
      ->capture_default_str();
  command
      .add_option("--answer-tokens", options.answer_tokens,
                  "Longest answer, in tokens (default: 512 to 8192, by step)")
      ->group(group)
      ->check(CLI::Range(50, 1'000'000));
  command
      .add_flag("--judge", options.judge,
                "Show the model (which must see pictures) what was made and ask for points; with "
                "--designer rules it only judges")
      ->group(group);
}

Result<ComposedMakers> ComposedMakers::compose(const MakerOptions& options, const Context& context,
                                               const std::string& cache_folder) {
  ComposedMakers makers;
  makers.options_ = options;
  auto making = compose_model(options.designer, context, cache_folder);
  if (!making) return making.error();
  makers.making_ = *std::move(making);
  if (!options.judge || makers.making_.model) return makers;
  DesignerOptions judging = options.designer;
  judging.designer = "model";
  auto judge = compose_model(judging, context, cache_folder);
  if (!judge) return with_context(judge.error(), "--judge");
  makers.judging_ = *std::move(judge);
  return makers;
}

std::unique_ptr<create::Maker> ComposedMakers::maker(create::Variant variant,
                                                     const CancelToken& cancel) {
  auto rules = create::make_rule_maker();
  if (!making_.model) return rules;
  create::ModelMakerOptions options;
  options.variant = variant;
  options.cancel = cancel;
  options.answers = options_.answers;
  if (const auto tokens = options_.answer_tokens)
    options.classify_tokens = options.decompose_tokens = options.generate_tokens = *tokens;
  if (const LimitedModel* limited = making_.limited)
    options.budget_is_spent = [limited] { return limited->refused(); };
  return create::make_model_maker(*making_.model, std::move(rules), making_.prompts,
                                  std::move(options));
}

Result<create::Scores> ComposedMakers::judge(const std::string& prompt, const Model& model,
                                             const CancelToken& cancel) {
  const auto pictures = draw_views(model);
  if (!pictures) return pictures.error();
  std::vector<std::string> views;
  for (const auto& picture : *pictures) {
    auto png = encode_png(picture);
    if (!png) return png.error();
    views.push_back(*std::move(png));
  }
  ComposedModel& composed = judging_ ? *judging_ : making_;
  create::JudgeOptions options;
  options.answers = options_.answers;
  if (options_.answer_tokens) options.tokens = *options_.answer_tokens;
  options.cancel = cancel;
  return create::judge(*composed.model, composed.prompts, prompt, views, options);
}

}  // namespace roomgen::cli
