#include "tours.h"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "roomgen/base/file.h"

namespace roomgen::cli {

using namespace lab;

Status read_picture_size(const std::string& text, int& width, int& height) {
  char rest = 0;
  if (std::sscanf(text.c_str(), "%4dx%4d%c", &width, &height, &rest) == 2) return {};
  return Error{Error::Kind::invalid_input, "--size " + text + ": write it as WIDTHxHEIGHT, 640x480"};
}

Result<Tour> read_tour(const std::string& folder, const Scene& scene) {
  const std::string path = (std::filesystem::path(folder) / "tour.json").string();
  const auto text = read_file(path);
  if (!text) return Error{text.error().kind, text.error().message + ": `roomgen tour` makes it"};
  const auto json = parse_json(*text, path);
  if (!json) return json.error();
  auto tour = tour_from_json(*json, path);
  if (!tour) return tour.error();
  for (const auto& view : tour->views)
    if (!find_object(scene, view.target))
      return Error{Error::Kind::invalid_input, path + ": is a tour of another scene, which has a " + view.target};
  return tour;
}

}  // namespace roomgen::cli
