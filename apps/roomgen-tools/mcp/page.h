#pragma once

#include <string>
#include <vector>

#include "offer.h"

/// Answers that a model can read whole: long reports page by page, and no answer without an end.
namespace roomgen::mcp {

/// A report of lists.
struct Report {
  Json data;                       ///< has the lists among other members
  std::vector<std::string> lists;  ///< their names, in the order of the lines
  std::vector<std::string> head;   ///< what every page begins with
  std::vector<std::string> lines;  ///< one for each element of each list
};

/// Bytes of lines and elements on a page.
inline constexpr std::size_t page_bytes = 40'000;

/// The elements after the first `skip`, as many as a page holds but one at least. If there are more,
/// "next" in the data is what to skip then, and the text says so. invalid_input if there are not so
/// many.
Result<ToolAnswer> page_of(const Report& report, std::size_t skip);

/// Bytes of the texts, and of the data, of whatever a tool answers.
inline constexpr std::size_t answer_bytes = 60'000;

/// For what is no report: texts end at a line, lists of the data after their first elements. How many
/// are missing is said in the text and by "cut" in the data: {"changes": 2900}.
void keep_within_bounds(ToolAnswer& answer);

}  // namespace roomgen::mcp
