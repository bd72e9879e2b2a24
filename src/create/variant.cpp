#include <nlohmann/json.hpp>

#include "roomgen/create/maker.h"

namespace roomgen::create {

namespace {

constexpr std::array<std::pair<Variant, const char*>, 4> variant_names = {
    {{Variant::full, "full"},
     {Variant::no_validation, "no-validation"},
     {Variant::no_decomposition, "no-decomposition"},
     {Variant::direct, "direct"}}};

Json score_json(const Score& score) {
  return {{"points", score.points}, {"reason", score.reason}};
}

}  // namespace

const char* name(Variant variant) {
  for (const auto& [known, text] : variant_names)
    if (known == variant) return text;
  return "";
}

std::optional<Variant> variant_named(std::string_view name) {
  for (const auto& [variant, text] : variant_names)
    if (name == text) return variant;
  return std::nullopt;
}

Json to_json(const Scores& scores) {
  return {{"structure", score_json(scores.structure)},
          {"realism", score_json(scores.realism)},
          {"alignment", score_json(scores.alignment)}};
}

}  // namespace roomgen::create
