#include "designers.h"

#include <algorithm>

#include <filesystem>

#include "no_fallback.h"
#include "print.h"
#include "roomgen/base/file.h"
#include "roomgen/kinds/kind_table.h"
#include "roomgen/render/pictures.h"
#ifdef ROOMGEN_HAS_AGENT
#include "http.h"
#endif

namespace roomgen::cli {

namespace {

namespace fs = std::filesystem;

#ifdef ROOMGEN_HAS_AGENT
Result<std::unique_ptr<ChatModel>> open_endpoint(const DesignerOptions& options,
                                                 const Context& context) {
  if (options.model.empty())
    return Error{Error::Kind::invalid_input,
                 "--designer model and --reader model need --model NAME, as the endpoint calls it"};
  HttpModelOptions http;
  http.model = options.model;
  if (!options.base_url.empty()) http.base_url = options.base_url;
  if (options.protocol == "openai") http.protocol = ChatProtocol::openai;
  if (options.protocol == "anthropic") http.protocol = ChatProtocol::anthropic;
  if (options.protocol == "anthropic" && options.base_url.empty())
    http.base_url = "https://api.anthropic.com";
  http.key_file = options.key_file;
  // Who thinks is silent for as long as the call may take.
  http.limits.idle = HttpLimits::Seconds(options.thinking > 0 ? options.seconds_per_call : options.idle());
  http.limits.call = HttpLimits::Seconds(options.seconds_per_call);
  http.retry.total = RetryPolicy::Seconds(options.seconds_per_call);
  if (!context.quiet)
    http.log = [](LogLevel, std::string_view message) { warn(message); };
  return load_http_model(http);
}
#else
Result<std::unique_ptr<ChatModel>> open_endpoint(const DesignerOptions&, const Context&) {
  return Error{Error::Kind::unavailable,
               "this build speaks to no language model: cpr was not found when it was configured "
               "(third_party/README.md); --designer rules and --replay work"};
}
#endif

Result<PriceTable> read_prices(const DesignerOptions& options) {
  if (options.prices.empty()) return PriceTable::built_in();
  const auto text = read_file(options.prices);
  if (!text) return text.error();
  return PriceTable::parse(*text, options.prices);
}

// From the inside out: HTTP, limits, cache, recording.
Status open_model(const DesignerOptions& options, const Context& context,
                  const std::string& cache_folder, ComposedModel& composed) {
  if (!options.replay.empty()) {
    auto replay = make_replaying_model(options.replay);
    if (!replay) return replay.error();
    composed.model = *std::move(replay);
    return {};
  }
  auto endpoint = open_endpoint(options, context);
  if (!endpoint) return endpoint.error();
  const auto prices = read_prices(options);
  if (!prices) return prices.error();
  auto limited = make_limited_model(*std::move(endpoint),
                                    {options.max_calls, options.max_tokens, options.max_dollars},
                                    *prices, options.model);
  if (!limited) return limited.error();
  composed.limited = limited->get();
  composed.model = *std::move(limited);
  if (options.cache_answers)
    composed.model =
        make_caching_model(std::move(composed.model), fs::path(cache_folder) / "answers",
                           options.model + " at " + options.base_url);
  if (options.record.empty()) return {};
  auto recording = make_recording_model(std::move(composed.model), options.record);
  if (!recording) return recording.error();
  composed.model = *std::move(recording);
  return {};
}

// Small enough that a whole room and a part of it take no more than 200 KB.
Result<std::string> encode_small_jpeg(const Image& image) {
  constexpr std::size_t most_bytes = 140'000;
  Result<std::string> jpeg = encode_jpeg(image, 85);
  for (const int quality : {72, 58, 45, 30})
    if (jpeg && jpeg->size() > most_bytes) jpeg = encode_jpeg(image, quality);
  return jpeg;
}

// Keeps what is shown.
Result<std::string> encode_shown(const DesignerOptions& options, const Image& image,
                                 std::vector<std::string>& shown) {
  auto encoded = encode_for(options, image);
  if (encoded) shown.push_back(*encoded);
  return encoded;
}

}  // namespace

ModelMode DesignerOptions::model_mode() const {
  if (mode == "constraints") return ModelMode::constraints;
  return mode == "image" ? ModelMode::image : ModelMode::fused;
}

// A model of one's own reads long questions before its first byte.
double DesignerOptions::idle() const {
  constexpr double far_away = 30.0, near = 300.0;
  constexpr std::string_view own[] = {"localhost", "127.", "[::1]", "10.", "192.168."};
  const std::string url = lower(base_url);
  const std::string host = url.substr(url.find("://") == url.npos ? 0 : url.find("://") + 3);
  int second = 0;  // 172.16.0.0 to 172.31.255.255 (RFC 1918)
  const bool is_private = std::sscanf(host.c_str(), "172.%d.", &second) == 1 && second >= 16 && second <= 31;
  const bool is_near =
      is_private || std::any_of(std::begin(own), std::end(own), [&](auto name) { return host.starts_with(name); });
  return idle_seconds.value_or(is_near ? near : far_away);
}

namespace {

constexpr const char* designer_group = "Designer";

CLI::Option* add_text(CLI::App& command, const char* name, std::string& value, const char* help) {
  return command.add_option(name, value, help)->group(designer_group);
}

}  // namespace

void add_chat_options(CLI::App& command, DesignerOptions& options) {
  add_text(command, "--designer", options.designer,
           "book: works offline, by the designs of a book; rules: works offline; model: asks a "
           "language model")
      ->check(CLI::IsMember({"book", "rules", "model"}))
      ->capture_default_str();
  add_text(command, "--book", options.book,
           "Folder of further designs, which go before the built-in ones (docs/designs.md)");
  add_text(command, "--design", options.design, "A file with the design that the room shall have");
  add_text(command, "--model", options.model, "Name of the model at its endpoint");
  add_text(command, "--base-url", options.base_url,
           "Endpoint, as in http://localhost:8080/v1 (default: OpenAI's). The key comes from "
           "ROOMGEN_API_KEY, OPENAI_API_KEY or ANTHROPIC_API_KEY");
  add_text(command, "--protocol", options.protocol, "openai or anthropic (default: by the host)")
      ->check(CLI::IsMember({"openai", "anthropic"}));
  add_text(command, "--key-file", options.key_file, "A file of mode 600 that holds the key");
  add_text(command, "--prompts", options.prompts, "Folder with prompts of your own (names as in prompts/)");
  add_text(command, "--record", options.record, "Append all questions and answers to this file");
  add_text(command, "--replay", options.replay, "Take the answers from a recording; no network");
  add_text(command, "--picture", options.picture, "How pictures are sent: jpeg (small) or png")
      ->check(CLI::IsMember({"jpeg", "png"}))
      ->capture_default_str();
  command
      .add_flag("--cache-answers", options.cache_answers, "Ask no question twice (the user's cache folder)")
      ->group(designer_group);
  command.add_option("--max-calls", options.max_calls, "Calls of the model for one room")->group(designer_group);
  command.add_option("--max-tokens", options.max_tokens, "Tokens for one room, in and out")->group(designer_group);
  command.add_option("--max-dollars", options.max_dollars, "Money for one room (data/prices.json)")->group(designer_group);
  add_text(command, "--prices", options.prices, "A price table of your own, in the form of data/prices.json");
  command
      .add_option("--idle-seconds", options.idle_seconds, "Longest silence of the endpoint, for models that think without a word (default: 30; 300 on this "
                  "machine or its network)")
      ->group(designer_group)
      ->check(CLI::PositiveNumber);
  command
      .add_option("--call-seconds", options.seconds_per_call, "Longest time for one question, retries included")
      ->group(designer_group)
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void add_thinking_option(CLI::App& command, DesignerOptions& options) {
  command
      .add_option("--thinking", options.thinking,
                  "Tokens that the model may think before each answer, where its endpoint has that (default: as it does)")
      ->group(designer_group)
      ->check(CLI::Range(0, 1'000'000));
}

void add_reader_option(CLI::App& command, DesignerOptions& options) {
  add_text(command, "--reader", options.reader,
           "Who reads the wish: rules, or model (default: who designs)")
      ->check(CLI::IsMember({"rules", "model"}));
}

void add_designer_options(CLI::App& command, DesignerOptions& options) {
  add_chat_options(command, options);
  command
      .add_flag("--no-fallback", options.no_fallback,
                "No rules take over from the model: without a plan of its own there is an error, and the room ends where it does")
      ->group(designer_group);
  add_text(command, "--mode", options.mode, "What the model sees and says: constraints (text only), image, fused")
      ->check(CLI::IsMember({"constraints", "image", "fused"}))
      ->capture_default_str();
  add_text(command, "--steps", options.steps, "What one answer of the model is about: groups (the whole room, then what stands, hangs and lies on things), or "
           "objects one by one, as always with --mode other than fused, --frame paper and --order model")
      ->check(CLI::IsMember({"groups", "objects"}))
      ->capture_default_str();
  add_text(command, "--frame", options.frame,
           "Coordinates of the marks: plan (x right, y up) or paper (x down, y left)")
      ->check(CLI::IsMember({"plan", "paper"}))
      ->capture_default_str();
  add_text(command, "--fusion", options.fusion, "How rankings are made: scaled, or ordinal as in the paper")
      ->check(CLI::IsMember({"scaled", "paper"}))
      ->capture_default_str();
  command
      .add_option("--lost-step", options.lost_step, "Ranks that one lost constraint costs, with --fusion scaled")
      ->group(designer_group)
      ->check(CLI::Range(1.0, 1e9))
      ->capture_default_str();
  add_text(command, "--order", options.order, "Which object comes next: as planned, or as the model says")
      ->check(CLI::IsMember({"plan", "model"}))
      ->capture_default_str();
  add_text(command, "--choose", options.choose,
           "Whether the model chooses what each thing shall be, before anything is placed")
      ->check(CLI::IsMember({"off", "on"}))
      ->capture_default_str();
  add_text(command, "--make", options.make,
           "Who makes what the model wants to be made: the model itself, or rules")
      ->check(CLI::IsMember({"model", "rules"}))
      ->capture_default_str();
  command
      .add_option("--plan-tokens", options.plan_tokens,
                  "Longest plan, in tokens; what a model thinks before it answers counts too")
      ->group(designer_group)
      ->check(CLI::Range(100, 1'000'000))
      ->capture_default_str();
  command.add_option("--place-tokens", options.place_tokens, "Longest answer about one place")
      ->group(designer_group)
      ->check(CLI::Range(50, 1'000'000))
      ->capture_default_str();
}

void add_finish_options(CLI::App& command, DesignerOptions& options) {
  const std::string group = "Finish";
  command
      .add_option("--improve", options.improve,
                  "What the improvement at the end may move: nothing; what a model or person placed only "
                  "for what was asked for (minimal); everything (free)")
      ->check(CLI::IsMember({"off", "minimal", "free"}))
      ->capture_default_str()
      ->group(group);
  command.add_option("--repair", options.repair, "Whether others make way for what finds no place")
      ->check(CLI::IsMember({"off", "on"}))
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--preset", options.preset,
                  "paper: ordinal ranks, the paper's frame, near from 0.5 m, the grid alone, no "
                  "improvement, no repair")
      ->check(CLI::IsMember({"paper"}))
      ->group(group);
}

void let_model_design(const CLI::App& command, DesignerOptions& options) {
  const bool is_told = command.count("--designer") + command.count("--reader") > 0;
  if (!options.model.empty() && !is_told) options.designer = "model";
}

void apply_preset(DesignerOptions& options) {
  if (options.preset != "paper") return;
  options.fusion = options.frame = "paper";
  options.improve = options.repair = options.choose = "off";
}

void apply(const DesignerOptions& options, BuildOptions& build) {
  constexpr double paper_near = 0.5;  // metres (RoomGen, appendix)
  build.repair = options.repair == "on";
  build.improvement = options.improve == "off"    ? Improvement::off
                      : options.improve == "free" ? Improvement::free
                                                  : Improvement::minimal;
  if (options.preset == "paper") {
    build.place.grid = GridUse::only;
    build.place.least_near = paper_near;
  }
  FusionOptions& fusion = build.place.fusion;
  fusion.ordinal_ranks = options.fusion == "paper";
  fusion.lost_step = options.lost_step;
  if (options.designer == "model" && options.model_mode() != ModelMode::fused) fusion.alpha = 1.0;
}

Result<std::string> encode_for(const DesignerOptions& options, const Image& picture) {
  return options.picture == "jpeg" ? encode_small_jpeg(picture) : encode_png(picture);
}

Result<ComposedModel> compose_model(const DesignerOptions& options, const Context& context,
                                    const std::string& cache_folder) {
  auto prompts = options.prompts.empty() ? Result<Prompts>(Prompts::built_in())
                                         : Prompts::from_folder(options.prompts);
  if (!prompts) return prompts.error();
  ComposedModel composed{nullptr, nullptr, *std::move(prompts)};
  if (options.designer != "model" && !options.reads_by_model()) return composed;
  if (auto status = open_model(options, context, cache_folder, composed); !status)
    return status.error();
  return composed;
}

std::unique_ptr<Reader> compose_reader(const DesignerOptions& options, ChatModel* model,
                                       const LimitedModel* limited, Prompts prompts) {
  if (!model || !options.reads_by_model()) return nullptr;
  ModelReaderOptions reading;
  reading.tokens = std::max(reading.tokens, options.plan_tokens);
  reading.no_fallback = options.no_fallback;
  if (limited) reading.budget_is_spent = [limited] { return limited->refused(); };
  return make_model_reader(*model, std::move(prompts), KindTable::built_in(), std::move(reading));
}

Result<ComposedDesigner> compose_designer(const DesignerOptions& options, const Context& context,
                                          const std::string& cache_folder) {
  ComposedDesigner composed;
  auto model = compose_model(options, context, cache_folder);
  if (!model) return model.error();
  composed.model = std::move(model->model);
  composed.limited = model->limited;
  composed.reader = compose_reader(options, composed.model.get(), composed.limited, model->prompts);
  if (options.designer == "book" || !options.book.empty() || !options.design.empty()) {
    auto book = make_book_designer(
        {options.book, options.design, [](LogLevel, std::string_view message) { warn(message); }});
    if (!book) return book.error();
    composed.designer = *std::move(book);
    return composed;
  }
  if (options.designer != "model") {
    composed.designer = make_rule_designer();
    return composed;
  }
  ModelDesignerOptions model_options;
  model_options.mode = options.model_mode();
  model_options.steps = options.steps == "objects" ? ModelSteps::objects : ModelSteps::groups;
  model_options.paper_frame = options.paper_frame();
  model_options.plan_tokens = options.plan_tokens;
  model_options.place_tokens = options.place_tokens;
  model_options.chooses_assets = options.choose == "on";
  model_options.makes_assets = options.make == "model";
  model_options.chooses_order = options.order == "model";
  model_options.encode_picture = [options, shown = composed.shown](const Image& image) {
    return encode_shown(options, image, *shown);
  };
  if (!context.quiet)
    model_options.log = [](LogLevel, std::string_view message) { warn(message); };
  if (const LimitedModel* limited = composed.limited)
    model_options.budget_is_spent = [limited] { return limited->refused(); };
  composed.designer =
      make_model_designer(*composed.model, options.no_fallback ? make_no_fallback() : make_rule_designer(), std::move(model->prompts),
                          KindTable::built_in(), std::move(model_options));
  return composed;
}

}  // namespace roomgen::cli
