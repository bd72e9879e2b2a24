#include "edited_rooms.h"

#include <cstdio>
#include <fstream>
#include <sstream>

#include "roomgen/assets/catalogue.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "warm_library.h"

namespace roomgen::bench {

namespace {

constexpr std::uint64_t seed_of_rooms = 1, seed_of_full_room = 2;

/// A warm library that owns the one below.
class OwnedWarmLibrary final : public AssetLibrary {
 public:
  explicit OwnedWarmLibrary(std::unique_ptr<AssetLibrary> library) : library_(std::move(library)), warm_(*library_) {}

  Result<std::vector<AssetMatch>> search(const AssetQuery& query) const override { return warm_.search(query); }
  Result<std::shared_ptr<const Model>> load(const AssetRef& ref) const override { return warm_.load(ref); }

 private:
  std::unique_ptr<AssetLibrary> library_;
  WarmLibrary warm_;
};

Scene furnished(const std::string& prompt, std::uint64_t seed, const AssetLibrary& library) {
  const auto designer = make_rule_designer();
  PlanRequest request;
  request.prompt = prompt;
  request.seed = seed;
  const auto plan = designer->plan(request);
  if (!plan) return {};
  BuildOptions options;
  options.seed = seed;
  auto room = generate(*plan, *designer, library, KindTable::built_in(), options);
  return room ? std::move(room->scene) : Scene();
}

}  // namespace

std::unique_ptr<AssetLibrary> open_furniture() {
  std::vector<std::shared_ptr<const AssetLibrary>> libraries;
  auto catalogue = assets::open_catalogue({});
  if (catalogue) libraries.push_back(create::make_finishing_library(*std::move(catalogue)));
  else std::fprintf(stderr, "%s; everything is made of words\n", catalogue.error().message.c_str());
  libraries.push_back(create::make_finishing_library(create::make_created_library()));
  return std::make_unique<OwnedWarmLibrary>(make_first_of(std::move(libraries)));
}

std::vector<Scene> rooms_to_edit(const AssetLibrary& library) {
  std::vector<Scene> rooms;
  std::ifstream lines(ROOMGEN_BENCH_DATA "/edits/rooms.txt");
  for (std::string line; std::getline(lines, line);) rooms.push_back(furnished(line, seed_of_rooms, library));
  return rooms;
}

Scene full_room(const AssetLibrary& library) {
  std::stringstream prompt;
  prompt << std::ifstream(ROOMGEN_BENCH_DATA "/rooms/full-living-room.txt").rdbuf();
  return furnished(prompt.str(), seed_of_full_room, library);
}

}  // namespace roomgen::bench
