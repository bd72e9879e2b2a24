#pragma once

#include <string>
#include <vector>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"
#include "roomgen/chat/chat_model.h"
#include "roomgen/chat/prompts.h"

namespace roomgen::create {

/// 1 (bad) to 5 (as good as bought), and one sentence why.
struct Score {
  int points = 0;
  std::string reason;
};

/// The three rubrics that people judged objects by (papers: primitives, section 5.2).
struct Scores {
  Score structure;  ///< does it hold together and stand, as a thing that could be built?
  Score realism;    ///< does it look like one whole thing of its kind?
  Score alignment;  ///< is it what the words say?

  double mean() const { return (structure.points + realism.points + alignment.points) / 3.0; }
};

struct JudgeOptions {
  int answers = 3;  ///< asked for at most, when answers cannot be used
  int tokens = 1024;
  CancelToken cancel = {};
};

/// What a model that sees pictures says of an object. `views`: whole PNG files of it from several
/// sides, at least one. Fails as ChatModel::chat() does, and with invalid_input when no answer can
/// be used.
Result<Scores> judge(ChatModel& model, const Prompts& prompts, const std::string& prompt,
                     const std::vector<std::string>& views, const JudgeOptions& options = {});

}  // namespace roomgen::create
