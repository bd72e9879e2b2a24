#pragma once

#include <memory>
#include <optional>

#include "any_plan.h"
#include "roomgen/chat/chat_model.h"
#include "workplace.h"

namespace roomgen::mcp {

/// Answers that an agent gives before it is asked, by the name of the question's form. The first
/// question without one is kept; it and all others are not answered.
class GivenAnswers final : public ChatModel {
 public:
  Result<ChatReply> chat(const ChatRequest& request) override;

  std::map<std::string, std::string> answers;
  std::optional<ChatRequest> asked;
};

/// An agent in the place of the language model that designs rooms: its "brief", "design", "choices"
/// and "places" are the model's answers, and what it leaves open is decided by rules.
struct AgentDesign {
  std::unique_ptr<GivenAnswers> given = std::make_unique<GivenAnswers>();
  std::unique_ptr<Reader> reader = {};  ///< null: rules read
  std::unique_ptr<Designer> designer = {};
};
/// `chooses`: it is asked what things shall be, whether it has said so or not.
AgentDesign agent_design(const Json& arguments, bool chooses);

/// The plan that the arguments tell: a file, "things", or a wish, by a design of the agent's or by
/// rules.
Result<cli::AnyPlan> wanted_plan(const Workplace& place, const ToolCall& call, AgentDesign& agent);

/// What of the agent's choices and places could not be used or followed, by the steps of the room.
std::vector<std::string> notes_on_answers(const Json& arguments, const Generation& made);

}  // namespace roomgen::mcp
