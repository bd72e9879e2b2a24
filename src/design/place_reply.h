#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "roomgen/design/designer.h"

namespace roomgen::design {

struct PlaceReply {
  PlaceAdvice advice;
  /// Answers for other things, by their ids in order, to be read in their turn.
  std::vector<std::pair<std::string, std::string>> others = {};
  std::vector<std::string> repairs;  ///< what was understood otherwise than it was written, or is lost
};

struct PlaceReplyContext {
  const Scene& scene;        ///< what is placed already
  const Object& object;      ///< whose place was asked for
  bool paper_frame = false;  ///< locations are [down from the top, left from the right], metres
  std::vector<std::string> later = {};  ///< ids of which "next" may name one
};

/// What a model answered about one object: {"reasoning", "constraints", "location", "facing"}, or
/// what comes near to it. Relations only name what is there, the location lies in the room. Errors
/// (invalid_input) say exactly what is wrong, in words meant for the model, so that they can be
/// sent back.
Result<PlaceReply> read_place_reply(std::string_view text, const PlaceReplyContext& context);

}  // namespace roomgen::design
