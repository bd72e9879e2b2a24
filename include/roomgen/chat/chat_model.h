#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen {

/// One message of a conversation.
struct ChatMessage {
  enum class Role { system, user, assistant };
  Role role = Role::user;
  std::string text;                 ///< UTF-8
  std::vector<std::string> images;  ///< whole PNG, JPEG or MP4 files, shown after the text; only from the user
};

/// "system", "user" or "assistant".
const char* name(ChatMessage::Role role);

/// What one request to an endpoint took. A request whose answer never came whole has neither tokens
/// nor bytes: it may have been worked for all the same.
struct ChatUse {
  std::optional<long long> input_tokens;    ///< as the endpoint counts them
  std::optional<long long> output_tokens;
  std::optional<std::size_t> answer_bytes;  ///< of an answer whose tokens nobody counted
  double seconds = 0.0;
};

/// Whoever pays for a question hears of every request that is sent for it: of those repeated too,
/// and of those whose answers are of no use.
struct ChatMeter {
  std::function<Status()> admit;              ///< before each request; an error ends the question
  std::function<void(const ChatUse&)> count;  ///< after each one that reached the endpoint
};

/// What a model is asked. Two requests with equal fields, `cancel` and `meter` aside, are the same
/// question.
struct ChatRequest {
  std::vector<ChatMessage> messages;
  /// JSON schema of the answer, for models that can be held to one; null when prose is fine. The
  /// messages say the same in words, for those that cannot.
  Json schema;
  std::string schema_name = "answer";
  int max_tokens = 4096;  ///< of the answer
  double temperature = 0.0;
  /// Tokens that the model may spend on thinking before it answers, beside max_tokens; 0: as the endpoint does it unasked.
  int thinking = 0;
  CancelToken cancel;  ///< ends the call at once
  ChatMeter meter;     ///< for models that may send several requests; may be empty
};

struct ChatReply {
  std::string text;
  std::string model;           ///< as the endpoint names it
  long long input_tokens = 0;  ///< as the endpoint counts them, over all attempts
  long long output_tokens = 0;
  double seconds = 0.0;  ///< all attempts and the waits between them
  int attempts = 1;
  bool cut_off = false;  ///< it ended where ChatRequest::max_tokens were spent
};

/// A language model, or whoever plays one. Wrappers add recording, replay, caching and limits (below).
class ChatModel {
 public:
  virtual ~ChatModel() = default;

  /// Fails with
  ///   unavailable    the endpoint cannot be used at all (no such host, wrong key, unknown model):
  ///                  asking again will not help
  ///   io             this call failed, after the retries that make sense; another one may succeed
  ///   limit          a bound on time, size, calls, tokens or money was reached
  ///   invalid_input  the model takes no pictures: the question may be asked without them
  ///   cancelled      the request's token was set
  virtual Result<ChatReply> chat(const ChatRequest& request) = 0;
};

/// US dollars for a million tokens.
struct Price {
  double input = 0.0;
  double output = 0.0;

  double of(long long input_tokens, long long output_tokens) const {
    return (input * static_cast<double>(input_tokens) +
            output * static_cast<double>(output_tokens)) /
           1e6;
  }
};

/// What models cost, by the beginnings of their names.
class PriceTable {
 public:
  /// data/prices.json, compiled in.
  static PriceTable built_in();
  /// A table in the form of data/prices.json; `source` names it in errors.
  static Result<PriceTable> parse(std::string_view text, const std::string& source);

  /// The entry with the longest name that `model` is a version of: "gpt-4o" is for gpt-4o and
  /// gpt-4o-2024-08-06, not for gpt-4o-audio. A vendor before a slash (openai/gpt-4o) is ignored.
  std::optional<Price> find(std::string_view model) const;

 private:
  struct Entry {
    std::string name;
    Price price;
  };
  std::vector<Entry> entries_;
};

// Chat models around chat models. Each owns the one inside. What they keep of a question is its
// text and the SHA-256 of its images; keys and addresses never reach them. The usual order, from
// the inside out: HTTP, limits, cache, recording. So only what is really asked counts against the
// limits, and a recording holds everything that was answered.

/// Appends every question with its answer, or with the error it met, to a file of JSON lines. A
/// line is written whole, and before the answer is returned; a call whose line cannot be written
/// fails with io. Cancelled calls leave no line. Fails if the file cannot be opened. The pictures of the
/// questions are kept beside it, in the folder `file`.pictures, each once, named by the SHA-256 that
/// the line has for it: with the answers they are data to train on.
Result<std::unique_ptr<ChatModel>> make_recording_model(std::unique_ptr<ChatModel> inner,
                                                        const std::filesystem::path& file);

/// Answers from a recording, and contacts nobody. A question that was recorded several times gets
/// the answers in their order, then the last one again. One that was not recorded fails with
/// unavailable; the message shows where it differs from the nearest recorded one.
Result<std::unique_ptr<ChatModel>> make_replaying_model(const std::filesystem::path& file);

/// Keeps answers in `folder`, a file each, and asks no question twice. `source` says who answers
/// (model and address): another one's answers are not used. A kept answer comes back with no
/// tokens, seconds or attempts, for it took none. Errors are not kept; files that cannot be read or
/// written are as if absent.
std::unique_ptr<ChatModel> make_caching_model(std::unique_ptr<ChatModel> inner,
                                              const std::filesystem::path& folder,
                                              std::string source);

/// Bounds on a conversation; no value, no bound.
struct ChatLimits {
  std::optional<int> calls;
  std::optional<long long> tokens;  ///< input and output
  std::optional<double> dollars;
};

/// What has been used, over every request that reached the endpoint, whatever came of it.
/// Tokens are the endpoint's; where it counts none they are estimated from the text, and for an
/// answer that was too long or too slow, and was worked for all the same, as the worst it could
/// be. A question that was refused (429, 500) took none, unless the endpoint says so.
struct ChatTotals {
  int calls = 0;
  int estimated_calls = 0;  ///< of these, those whose tokens are estimated
  long long input_tokens = 0;
  long long output_tokens = 0;
  std::optional<double> dollars;  ///< nothing if no price is known
  double seconds = 0.0;
};

/// Refuses a request with Error::Kind::limit, before it is sent, if at worst (an answer of
/// max_tokens) it would go beyond a limit. Models that send several requests for one question
/// are metered (ChatRequest::meter); of others each question is one request, and a failure
/// takes no tokens unless it is one of Error::Kind::limit.
class LimitedModel final : public ChatModel {
 public:
  LimitedModel(std::unique_ptr<ChatModel> inner, const ChatLimits& limits,
               std::optional<Price> price);

  Result<ChatReply> chat(const ChatRequest& request) override;
  const ChatTotals& totals() const { return totals_; }
  /// Has a request been refused for its limits?
  bool refused() const { return refused_; }

 private:
  long long estimated_input(const ChatRequest& request) const;
  Status admit(const ChatRequest& request);
  Status within_limits(const ChatRequest& request) const;
  void count(const ChatRequest& request, const ChatUse& use);

  std::unique_ptr<ChatModel> inner_;
  ChatLimits limits_;
  std::optional<Price> price_;
  ChatTotals totals_;
  bool refused_ = false;
  double correction_ = 1.0;  ///< of estimates, as answers show them too low: images differ by model
};

/// `model` is what the table is asked for. Fails with invalid_input for a limit on money without a
/// known price.
Result<std::unique_ptr<LimitedModel>> make_limited_model(std::unique_ptr<ChatModel> inner,
                                                         const ChatLimits& limits,
                                                         const PriceTable& prices,
                                                         const std::string& model);

/// What language models are told: the Markdown files of prompts/, whose {{slots}} are filled for
/// each question. They are compiled in; a folder may hold other versions of some of them.
class Prompts {
 public:
  using Slots = std::map<std::string, std::string, std::less<>>;

  static Prompts built_in();
  /// Files of the folder that are called like those of prompts/ (plan-system.md) replace the
  /// built-in ones. Fails for a folder that cannot be read or holds none of them, and for a slot that
  /// the built-in version does not have, since nothing would fill it.
  static Result<Prompts> from_folder(const std::filesystem::path& folder);

  /// The text of "place-user" with its slots filled. Precondition: `slots` has a value for each
  /// slot of the text; fails with invalid_input and the slot's name otherwise. Values are not
  /// searched for slots.
  Result<std::string> render(std::string_view name, const Slots& slots) const;

  /// SHA-256 over all texts: which prompts a trace belongs to.
  std::string version() const;

 private:
  std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace roomgen
