#pragma once

#include <string>

namespace roomgen::decode {

/// Gives up what reading meshes does not need, for good: other files, memory without end, system calls but
/// those for reading, writing and memory. Returns what could be enforced: of "limits", "calls", "files",
/// with blanks between.
std::string confine();

}  // namespace roomgen::decode
