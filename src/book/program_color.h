#pragma once

#include <string>

namespace roomgen::book {

/// A colour that shape programs know, for a word of a palette: "dusty blue" is "#8fa5b8", "pale
/// ash" as ash. What nobody knows stays as it is.
std::string program_color(const std::string& words);

}  // namespace roomgen::book
