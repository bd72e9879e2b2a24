// bench_edit_sentences ROOMS < CASES.jsonl: what the offline reader takes sentences for, many in one process.
// A case has "id", "scene" (ROOMS/SCENE/scene.json) and "sentence". A line of JSON for each: "id", and "operations" or "error".

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "roomgen/edit/session.h"
#include "roomgen/edit_reader/understand.h"

namespace {

using namespace roomgen;

/// Reading needs no furniture.
class NoFurniture final : public AssetLibrary {
 public:
  Result<std::vector<AssetMatch>> search(const AssetQuery&) const override { return std::vector<AssetMatch>{}; }
  Result<std::shared_ptr<const Model>> load(const AssetRef&) const override {
    return Error{Error::Kind::not_found, "there is no furniture"};
  }
};

Json answer(const Session& session, const std::string& sentence) {
  const auto understood = understand(session, sentence);
  if (!understood) return {{"error", understood.error().message}};
  Json operations = Json::array();
  for (const auto& operation : understood->operations) operations.push_back(edit::to_json(operation));
  return {{"operations", operations}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "bench_edit_sentences ROOMS < CASES.jsonl\n"), 2;
  const NoFurniture library;
  std::map<std::string, Session> sessions;
  for (std::string line; std::getline(std::cin, line);) {
    const Json one = Json::parse(line);
    const std::string scene = one.at("scene");
    auto open = sessions.find(scene);
    if (open == sessions.end()) {
      auto session = Session::open(std::filesystem::path(argv[1]) / scene / "scene.json", library, KindTable::built_in(),
                                   {.look_only = true});
      if (!session) return std::fprintf(stderr, "%s\n", session.error().message.c_str()), 1;
      open = sessions.emplace(scene, *std::move(session)).first;
    }
    Json said = answer(open->second, one.at("sentence"));
    said["id"] = one.at("id");
    std::puts(said.dump().c_str());
  }
  return 0;
}
