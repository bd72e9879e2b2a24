#include <algorithm>
#include <utility>

#include "roomgen/base/text.h"
#include "roomgen/chat/chat_model.h"

namespace roomgen {

namespace {

// Rough, and rather too many: English takes four bytes a token, other languages fewer.
constexpr long long bytes_per_token = 3;
constexpr long long tokens_per_image = 2000;

long long estimated_tokens(std::size_t bytes) {
  return static_cast<long long>(bytes) / bytes_per_token + 1;
}

long long estimated_by_size(const ChatRequest& request) {
  long long tokens = request.schema.is_null() ? 0 : estimated_tokens(request.schema.dump().size());
  for (const auto& message : request.messages)
    tokens += estimated_tokens(message.text.size()) +
              tokens_per_image * static_cast<long long>(message.images.size());
  return tokens;
}

Error limit_error(const std::string& used, const std::string& limit) {
  return {Error::Kind::limit,
          "the next question might go beyond the limit of " + limit + ": " + used + " used so far"};
}

// What a model thinks is paid for like what it says.
long long longest_answer(const ChatRequest& request) {
  return static_cast<long long>(request.max_tokens) + request.thinking;
}

// What a question took of a model that does not say so itself. An answer that was too long or too
// slow was worked for.
ChatUse use_of(const Result<ChatReply>& reply) {
  if (!reply && reply.error().kind == Error::Kind::limit) return {};
  ChatUse use;
  use.input_tokens = use.output_tokens = 0;
  if (!reply) return use;
  use.seconds = reply->seconds;
  if (reply->input_tokens + reply->output_tokens > 0) {
    use.input_tokens = reply->input_tokens;
    use.output_tokens = reply->output_tokens;
  } else {
    use = {{}, {}, reply->text.size(), reply->seconds};
  }
  return use;
}

}  // namespace

LimitedModel::LimitedModel(std::unique_ptr<ChatModel> inner, const ChatLimits& limits,
                           std::optional<Price> price)
    : inner_(std::move(inner)), limits_(limits), price_(price) {
  if (price_) totals_.dollars = 0.0;
}

Result<ChatReply> LimitedModel::chat(const ChatRequest& request) {
  if (auto status = admit(request); !status) return status.error();
  bool is_metered = false;
  ChatRequest metered = request;
  metered.meter.admit = [&] { return is_metered = true, admit(request); };
  metered.meter.count = [&](const ChatUse& use) { count(request, use); };
  auto reply = inner_->chat(metered);
  if (!is_metered) count(request, use_of(reply));
  return reply;
}

Status LimitedModel::admit(const ChatRequest& request) {
  auto status = within_limits(request);
  refused_ = refused_ || !status;
  return status;
}

long long LimitedModel::estimated_input(const ChatRequest& request) const {
  return static_cast<long long>(correction_ * static_cast<double>(estimated_by_size(request)));
}

Status LimitedModel::within_limits(const ChatRequest& request) const {
  if (limits_.calls && totals_.calls >= *limits_.calls)
    return limit_error(std::to_string(totals_.calls), std::to_string(*limits_.calls) + " calls");
  const long long input = estimated_input(request);
  const long long used = totals_.input_tokens + totals_.output_tokens;
  if (limits_.tokens && used + input + longest_answer(request) > *limits_.tokens)
    return limit_error(std::to_string(used), std::to_string(*limits_.tokens) + " tokens");
  if (limits_.dollars && price_ &&
      *totals_.dollars + price_->of(input, longest_answer(request)) > *limits_.dollars)
    return limit_error(format_number(*totals_.dollars, 4),
                       format_number(*limits_.dollars, 4) + " dollars");
  return {};
}

void LimitedModel::count(const ChatRequest& request, const ChatUse& use) {
  const long long at_worst = longest_answer(request);
  const long long by_text =
      use.answer_bytes ? std::min(at_worst, estimated_tokens(*use.answer_bytes)) : at_worst;
  const long long input = use.input_tokens.value_or(estimated_input(request));
  const long long output = use.output_tokens.value_or(by_text);
  ++totals_.calls;
  if (!use.input_tokens || !use.output_tokens) ++totals_.estimated_calls;
  totals_.input_tokens += input;
  totals_.output_tokens += output;
  totals_.seconds += use.seconds;
  if (price_) *totals_.dollars += price_->of(input, output);
  const auto estimate = static_cast<double>(estimated_by_size(request));
  correction_ = std::max(correction_, static_cast<double>(input) / estimate);
}

Result<std::unique_ptr<LimitedModel>> make_limited_model(std::unique_ptr<ChatModel> inner,
                                                         const ChatLimits& limits,
                                                         const PriceTable& prices,
                                                         const std::string& model) {
  const auto price = prices.find(model);
  if (limits.dollars && !price)
    return Error{
        Error::Kind::invalid_input,
        "no price is known for the model \"" + model +
            "\", so money cannot be limited: limit calls or tokens, or give a price table"};
  return std::make_unique<LimitedModel>(std::move(inner), limits, price);
}

}  // namespace roomgen
