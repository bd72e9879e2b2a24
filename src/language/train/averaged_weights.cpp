#include "averaged_weights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "linear_model.h"

namespace roomgen::language {

namespace {

constexpr double scale = 256.0;  // of the weights that are written
constexpr double greatest = 32767.0;

struct Slot {
  std::uint32_t feature = 0;
  std::size_t first = 0, many = 0;
};

void append(std::string& to, std::size_t value, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i) to += static_cast<char>(value >> (8 * i) & 0xff);
}

}  // namespace

void AveragedWeights::know(std::uint32_t feature) {
  if (feature == 0) return;  // marks a free slot
  weights_.try_emplace(feature, Weights{std::vector<double>(labels_), std::vector<double>(labels_),
                                        std::vector<int>(labels_)});
}

void AveragedWeights::add_to(std::span<double> sums, std::uint32_t feature) const {
  const auto found = weights_.find(feature);
  if (found == weights_.end()) return;
  for (std::size_t label = 0; label < labels_; ++label) sums[label] += found->second.now[label];
}

void AveragedWeights::change(std::uint32_t feature, std::size_t label, double by) {
  const auto found = weights_.find(feature);
  if (found == weights_.end()) return;
  Weights& weights = found->second;
  weights.sum[label] += weights.now[label] * (steps_ - weights.since[label]);
  weights.since[label] = steps_;
  weights.now[label] += by;
}

int AveragedWeights::averaged(const Weights& weights, std::size_t label) const {
  const double sum = weights.sum[label] + weights.now[label] * (steps_ - weights.since[label]);
  return static_cast<int>(std::lround(std::clamp(scale * sum / std::max(1, steps_), -greatest, greatest)));
}

std::string AveragedWeights::bytes(std::string_view magic) const {
  std::map<std::uint32_t, std::vector<std::pair<std::size_t, int>>> features;
  for (const auto& [feature, weights] : weights_)
    for (std::size_t label = 0; label < labels_; ++label)
      if (const int value = averaged(weights, label); value != 0) features[feature].push_back({label, value});
  std::size_t count = 1;
  while (2 * count < 3 * features.size()) count *= 2;
  std::vector<Slot> slots(count);
  std::string values_of_all;
  for (const auto& [feature, values] : features) {
    std::size_t slot = feature & (count - 1);
    while (slots[slot].feature != 0) slot = (slot + 1) & (count - 1);
    slots[slot] = {feature, values_of_all.size() / LinearModel::weight_size, values.size()};
    for (const auto& [label, value] : values) {
      append(values_of_all, label, 1);
      append(values_of_all, static_cast<std::size_t>(value) & 0xffff, 2);
    }
  }
  std::string bytes(magic);
  append(bytes, count, 4);
  for (const Slot& slot : slots) {
    append(bytes, slot.feature, 4);
    append(bytes, slot.first, 3);
    append(bytes, slot.many, 1);
  }
  return bytes + values_of_all;
}

LearningOrder::LearningOrder(std::size_t count) : order_(count) { std::iota(order_.begin(), order_.end(), 0); }

// std::shuffle differs between libraries.
const std::vector<std::size_t>& LearningOrder::next() {
  for (std::size_t i = order_.size(); i-- > 1;) {
    state_ = state_ * 1664525u + 1013904223u;
    std::swap(order_[i], order_[(state_ >> 8) % (i + 1)]);
  }
  return order_;
}

}  // namespace roomgen::language
