#include "book.h"

#include <algorithm>

#include "base/resource.h"

namespace roomgen::book {

namespace {

constexpr std::size_t most_designs = 2000;

}  // namespace

const Result<Book>& built_in_book() {
  static const Result<Book> book = []() -> Result<Book> {
    Book found;
    for (const auto path : resources("data/designs/")) {
      const auto json = parse_json(*resource(path), std::string(path));
      if (!json) return json.error();
      auto design = parse_design(*json, std::string(path));
      if (!design) return design.error();
      found.designs.push_back(*std::move(design));
    }
    return found;
  }();
  return book;
}

Result<Book> read_book(const std::filesystem::path& folder) {
  std::error_code failure;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failure))
    if (entry.path().extension() == ".json" && paths.size() < most_designs) paths.push_back(entry.path());
  if (failure)
    return Error{Error::Kind::not_found, folder.string() + ": cannot be listed: " + failure.message()};
  std::sort(paths.begin(), paths.end());
  Book book;
  for (const auto& path : paths) {
    auto design = read_design(path);
    if (design) book.designs.push_back(*std::move(design));
    else book.problems.push_back(design.error().message);
  }
  if (book.designs.empty())
    return Error{Error::Kind::invalid_input,
                 folder.string() + ": no file of this folder is a design (docs/designs.md)" +
                     (book.problems.empty() ? "" : ": " + book.problems.front())};
  return book;
}

}  // namespace roomgen::book
