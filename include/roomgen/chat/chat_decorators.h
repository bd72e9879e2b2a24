#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "roomgen/base/result.h"
#include "roomgen/chat/chat_model.h"
#include "roomgen/chat/price_table.h"

namespace roomgen {

// Chat models around chat models. Each owns the one inside. What they keep of a question is its
// text and the SHA-256 of its images; keys and addresses never reach them. The usual order, from
// the inside out: HTTP, limits, cache, recording. So only what is really asked counts against the
// limits, and a recording holds everything that was answered.

/// Appends every question with its answer, or with the error it met, to a file of JSON lines. A
/// line is written whole, and before the answer is returned; a call whose line cannot be written
/// fails with io. Cancelled calls leave no line. Fails if the file cannot be opened.
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

/// What has been used. Calls count whether they succeeded or not; tokens are the endpoint's, or
/// estimated from the text where it counts none. An answer that was too long or too slow was worked
/// for all the same, and counts as the worst it could be; other failures count no tokens.
struct ChatTotals {
  int calls = 0;
  long long input_tokens = 0;
  long long output_tokens = 0;
  std::optional<double> dollars;  ///< nothing if no price is known
  double seconds = 0.0;
};

/// Refuses a call with Error::Kind::limit, before it is made, if at worst (an answer of max_tokens)
/// it would go beyond a limit.
class LimitedModel final : public ChatModel {
 public:
  LimitedModel(std::unique_ptr<ChatModel> inner, const ChatLimits& limits,
               std::optional<Price> price);

  Result<ChatReply> chat(const ChatRequest& request) override;
  const ChatTotals& totals() const { return totals_; }
  /// Has a call been refused for its limits?
  bool refused() const { return refused_; }

 private:
  long long estimated_input(const ChatRequest& request) const;
  std::optional<Error> refusal(const ChatRequest& request) const;
  void count(const ChatRequest& request, const ChatReply& reply);
  void count_worst(const ChatRequest& request);
  void add(long long input_tokens, long long output_tokens);

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

}  // namespace roomgen
