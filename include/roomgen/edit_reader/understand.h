#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/chat/chat_model.h"
#include "roomgen/edit/session.h"

namespace roomgen {

/// What a sentence asks for.
struct Understanding {
  std::vector<edit::Operation> operations;
  std::vector<std::string>
      remarks;  ///< words that were taken to ask for nothing: "it is draughty there"
};

/// A language model that is asked what sentences mean.
struct ModelEditing {
  ChatModel& model;
  Prompts prompts = Prompts::built_in();
  std::vector<std::string> pictures =
      {};  ///< of the room with coordinate marks: whole PNG or JPEG files
  int tokens = 2048;                       ///< longest answer
  int answers = 2;  ///< how often it is asked while its answers cannot be used
  CancelToken cancel = {};
};

/// What a sentence asks for, by rules. not_understood, saying what is not or between what it cannot decide.
Result<Understanding> understand(const Session& session, std::string_view sentence);
/// The same, by asking a model. What it answers can be done: an answer that cannot goes back to it once.
/// Fails as the model does (ChatModel::chat) if it gives none.
Result<Understanding> understand(Session& session, std::string_view sentence,
                                 const ModelEditing& editing);

/// A designer that looks at a finished room and changes what is not good yet.
struct Reviewing {
  ChatModel& model;
  Prompts prompts = Prompts::built_in();
  /// Draws what it sees: whole PNG or JPEG files, the room from above with marks first.
  std::function<Result<std::vector<std::string>>(Session&)> pictures = {};
  int rounds = 2;     ///< at most; fewer where it has nothing to change
  int tokens = 4096;  ///< longest answer
  int answers = 2;    ///< how often it is asked while its answers cannot be used
  CancelToken cancel = {};
};

struct ReviewRound {
  std::string judgement;             ///< the model's
  std::vector<std::string> changes;  ///< what was done, in words
  std::vector<std::string> refused;  ///< operations that cannot be done, and why
};

/// Shows a room and its requirements to a model and does what it answers, operation by operation, each one
/// step of undo; what cannot be done is told it in the next round. Fails as the model does if it gives no answer
/// in the first round; then nothing is changed.
Result<std::vector<ReviewRound>> review(Session& session, const Reviewing& reviewing);

}  // namespace roomgen
