#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "brief/room_kinds.h"
#include "design.h"

namespace roomgen::book {

/// The kind of room that a name stands for: "doctor's office" is a clinic room. A name that no kind
/// has stands for itself.
std::string meant_room(const std::string& name);

/// The designs of data/designs for a kind of room; where there are none, all. With them comes the
/// plain one, for rooms that no design is of. They are read anew each time: few are of one kind.
Result<std::vector<Design>> built_in_designs(const std::string& room_type);
/// All of them by their names in data/designs.
std::vector<std::string_view> built_in_names();

/// A folder of designs.
struct Book {
  std::vector<Design> designs;
  std::vector<std::string> problems;  ///< files that are no designs, and why: the others are used
};

/// The *.json files of a folder, by name. Fails where there is no such folder or none of them is a
/// design.
Result<Book> read_book(const std::filesystem::path& folder);

}  // namespace roomgen::book
