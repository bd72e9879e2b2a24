#pragma once

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

}  // namespace roomgen
