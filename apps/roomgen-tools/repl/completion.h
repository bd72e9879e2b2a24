#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace roomgen::repl {

/// What a line may go on with.
struct Completion {
  std::string insert;                ///< that all choices have in common after what is written
  std::vector<std::string> choices;  ///< whole phrases, sorted; empty: none is known
};

/// Completes the end of what is written by one of the phrases, which may be of several words ("floor lamp");
/// commands only begin a line. The only choice is followed by a blank.
Completion complete(std::string_view written, const std::vector<std::string>& commands,
                    const std::vector<std::string>& phrases);

}  // namespace roomgen::repl
