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

}  // namespace

LimitedModel::LimitedModel(std::unique_ptr<ChatModel> inner, const ChatLimits& limits,
                           std::optional<Price> price)
    : inner_(std::move(inner)), limits_(limits), price_(price) {
  if (price_) totals_.dollars = 0.0;
}

Result<ChatReply> LimitedModel::chat(const ChatRequest& request) {
  if (auto error = refusal(request)) return refused_ = true, *error;
  ++totals_.calls;
  auto reply = inner_->chat(request);
  if (reply)
    count(request, *reply);
  else if (reply.error().kind == Error::Kind::limit)
    count_worst(request);
  return reply;
}

long long LimitedModel::estimated_input(const ChatRequest& request) const {
  return static_cast<long long>(correction_ * static_cast<double>(estimated_by_size(request)));
}

std::optional<Error> LimitedModel::refusal(const ChatRequest& request) const {
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
  return std::nullopt;
}

void LimitedModel::count(const ChatRequest& request, const ChatReply& reply) {
  totals_.seconds += reply.seconds;
  const bool counted = reply.input_tokens + reply.output_tokens > 0;
  const long long input = counted ? reply.input_tokens : estimated_input(request);
  const long long output = counted ? reply.output_tokens : estimated_tokens(reply.text.size());
  add(input, output);
  const auto estimate = static_cast<double>(estimated_by_size(request));
  correction_ = std::max(correction_, static_cast<double>(input) / estimate);
}

void LimitedModel::count_worst(const ChatRequest& request) {
  add(estimated_input(request), longest_answer(request));
}

void LimitedModel::add(long long input_tokens, long long output_tokens) {
  totals_.input_tokens += input_tokens;
  totals_.output_tokens += output_tokens;
  if (price_) *totals_.dollars += price_->of(input_tokens, output_tokens);
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
