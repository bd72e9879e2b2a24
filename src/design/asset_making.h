#pragma once

#include <map>

#include "call.h"
#include "roomgen/design/designer.h"

namespace roomgen::design {

/// The programs of an answer by the request's things: {"things": [{"item": "3", "program": {…}}]},
/// or what comes near to it. Repairs say what could not be used, with its place. Fails where there
/// is none in a first answer, and no list in a later one.
Result<Reading<std::map<std::size_t, std::string>>> read_programs(std::string_view text,
                                                           const MakingRequest& request);

/// Asks for the programs of all things at once, or which of those written before shall be others.
Result<std::map<std::size_t, std::string>> ask_for_programs(const MakingRequest& request, const Call& call,
                                                     std::vector<std::string>& notes);

}  // namespace roomgen::design
