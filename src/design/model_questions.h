#pragma once

#include <set>
#include <string>
#include <string_view>

#include "brief/brief.h"
#include "roomgen/chat/chat_model.h"
#include "roomgen/design/designer.h"
#include "scene_text.h"

namespace roomgen::design {

/// What a model is asked, in the words of the prompt templates: for the plan of a room, and for the
/// place of one thing (with that of others on the same carrier). Replies are read in plan_reply.h
/// and place_reply.h.
class ModelQuestions {
 public:
  /// `options` must outlive it.
  ModelQuestions(Prompts prompts, const ModelDesignerOptions& options)
      : prompts_(std::move(prompts)), options_(options) {}

  /// `brief` is what the wish says.
  Result<ChatRequest> to_plan(const PlanRequest& request, const brief::Brief& brief) const;
  /// What a designer knows besides the request.
  struct Known {
    std::string idea;                ///< what the room shall be like
    std::set<std::string> answered;  ///< whose places have been said already
    std::vector<std::string> news;   ///< what stands otherwise than was said, and was not told yet
  };
  /// Without pictures.
  Result<ChatRequest> to_place(const PlaceRequest& request, const Known& known) const;

 private:
  Result<ChatRequest> make_question(std::string_view name, const Prompts::Slots& system,
                                    const Prompts::Slots& user) const;
  Result<Prompts::Slots> system_slots(const SceneText& text) const;
  std::string refusals(const PlaceRequest& request, const SceneText& text) const;
  std::string order(const PlaceRequest& request) const;

  Prompts prompts_;
  const ModelDesignerOptions& options_;
};

/// "a picture", "3 pictures": those of a wish.
std::string counted_pictures(const PlanRequest& request);

}  // namespace roomgen::design
