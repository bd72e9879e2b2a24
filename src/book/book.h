#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "design.h"

namespace roomgen::book {

/// Designs, those that go before others first.
struct Book {
  std::vector<Design> designs;
  std::vector<std::string> problems;  ///< files that are no designs, and why: the others are used
};

/// data/designs.
const Result<Book>& built_in_book();
/// The *.json files of a folder, by name. Fails where there is no such folder or none of them is a design.
Result<Book> read_book(const std::filesystem::path& folder);

}  // namespace roomgen::book
