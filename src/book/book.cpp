#include "book.h"

#include <algorithm>

#include "base/resource.h"

namespace roomgen::book {

namespace {

constexpr std::size_t most_designs = 2000;
constexpr std::string_view folder_of_designs = "data/designs/";
constexpr std::string_view plain_design = "data/designs/any-room.json";

Result<Design> built_in(std::string_view path) {
  const auto json = parse_json(*resource(path), std::string(path));
  if (!json) return json.error();
  return parse_design(*json, std::string(path));
}

bool is_for(std::string_view path, const std::string& room_type) {
  const auto rooms = brief::rooms_of_design(*resource(path));
  return std::any_of(rooms.begin(), rooms.end(),
                     [&](const auto& room) { return meant_room(room) == room_type; });
}

}  // namespace

std::string meant_room(const std::string& name) {
  static const brief::RoomNames names = brief::all_room_names(*brief::built_in_room_kinds());
  const std::string plain = brief::room_name(name);
  const auto known = names.find(plain);
  return known == names.end() ? plain : known->second;
}

std::vector<std::string_view> built_in_names() {
  return resources(folder_of_designs);
}

Result<std::vector<Design>> built_in_designs(const std::string& room_type) {
  std::vector<std::string_view> paths;
  for (const auto path : built_in_names())
    if (path == plain_design || is_for(path, room_type)) paths.push_back(path);
  if (paths.size() < 2 && room_type != "room") paths = built_in_names();
  std::vector<Design> designs;
  for (const auto path : paths) {
    auto design = built_in(path);
    if (!design) return design.error();
    designs.push_back(*std::move(design));
  }
  return designs;
}

Result<Book> read_book(const std::filesystem::path& folder) {
  std::error_code failure;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failure))
    if (entry.path().extension() == ".json" && paths.size() < most_designs)
      paths.push_back(entry.path());
  if (failure)
    return Error{Error::Kind::not_found,
                 folder.string() + ": cannot be listed: " + failure.message()};
  std::sort(paths.begin(), paths.end());
  Book book;
  for (const auto& path : paths) {
    auto design = read_design(path);
    if (design)
      book.designs.push_back(*std::move(design));
    else
      book.problems.push_back(design.error().message);
  }
  if (book.designs.empty())
    return Error{Error::Kind::invalid_input,
                 folder.string() + ": no file of this folder is a design (docs/designs.md)" +
                     (book.problems.empty() ? "" : ": " + book.problems.front())};
  return book;
}

}  // namespace roomgen::book
