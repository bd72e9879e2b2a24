#pragma once

#include <string>
#include <vector>

namespace roomgen::design {

/// What was noticed while an answer was read.
struct ReplyNotes {
  std::vector<std::string> all;   ///< in order: what was understood otherwise than it was written, and what is lost
  std::vector<std::string> lost;  ///< of these, what was said and had to be left aside

  void repair(std::string note) { all.push_back(std::move(note)); }
  void lose(std::string note) {
    all.push_back(note);
    lost.push_back(std::move(note));
  }
};

}  // namespace roomgen::design
