#pragma once

#include "call.h"
#include "roomgen/design/designer.h"

namespace roomgen::design {

/// What was made of answers so far; what they leave open is added from the next one.
struct ReadChoices {
  std::vector<AssetChoice> choices;   ///< in the order of the offers
  std::vector<std::string> repairs;   ///< what was understood otherwise than it was written
  std::vector<std::string> problems;  ///< what could not be used or is missing, each with its place
};

/// Reads {"choices": [{"item", "take", "words", "size_cm", "paint", "why"}, ...]}, or what comes
/// near to it, over the `earlier` choices. Fails where it holds nothing that could be a choice.
Result<ReadChoices> read_choices(std::string_view text, const ChoiceRequest& request,
                                 const std::vector<AssetChoice>& earlier = {});

/// Asks which assets shall be taken; once more for what was wrong or missing, which stands in
/// `notes` too. What is then still open has no choice.
Result<std::vector<AssetChoice>> ask_for_assets(const ChoiceRequest& request, const Call& call,
                                                std::vector<std::string>& notes);

}  // namespace roomgen::design
