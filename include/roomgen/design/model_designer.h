#pragma once

#include <functional>
#include <memory>
#include <string>

#include "roomgen/chat/chat_model.h"
#include "roomgen/design/designer.h"
#include "roomgen/kinds/kind_table.h"

namespace roomgen {

/// What the model sees and says of each object (papers: RoomGen, section 4.4.1). The fusion's alpha
/// belongs to it: 1 for the first two, where there is no suggestion to follow.
enum class ModelMode {
  constraints,  ///< the room as text without places; constraints come back
  image,        ///< the room as text and picture; constraints come back
  fused,        ///< the same, and a location besides
};

struct ModelDesignerOptions {
  ModelMode mode = ModelMode::fused;
  /// The frame of the picture's marks and of the answers: the scene's own, or x down from the top
  /// and y left from the right, as the paper has it.
  bool paper_frame = false;
  bool chooses_order = false;  ///< each answer also says which thing shall come next
  int answers = 3;  ///< asked for at most, for one plan or object, when answers cannot be used
  /// Longest answers, in tokens; what a model thinks before it answers counts too.
  int plan_tokens = 4096;
  int place_tokens = 1024;
  /// Makes a PNG or JPEG of a picture; without it no picture is shown.
  std::function<Result<std::string>(const Image&)> encode_picture;
  /// True when the calls, tokens or money that were granted are spent: then the designer fails with
  /// limit.
  std::function<bool()> budget_is_spent;
};

/// A designer that asks a language model. Answers are repaired where they are clear; else the model
/// is asked again with the reason; else `fallback` decides and the advice says so. A model that
/// cannot be reached when the plan is asked for is an error; later the fallback takes over for
/// good.
///
/// The model must outlive the designer.
std::unique_ptr<Designer> make_model_designer(ChatModel& model, std::unique_ptr<Designer> fallback,
                                              Prompts prompts, const KindTable& categories,
                                              ModelDesignerOptions options = {});

}  // namespace roomgen
