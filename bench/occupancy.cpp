// How much of a room full of furniture finds a place: one by one, with repairs, and by the search for a whole layout, over
// the share of the floor that all things would cover (RoomGen, figure 3). Prints a table in Markdown, with the seconds that each took for all rooms of a line.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "base/random.h"
#include "roomgen/evaluate/report.h"
#include "roomgen/solve/solve.h"

namespace {

using namespace roomgen;

constexpr int rooms_for_each = 20;
constexpr double first_share = 0.2, last_share = 0.7, step = 0.1;

struct Usual {
  const char* category;
  Vec2 size;
};
// As they come in a living room that is a bedroom too: large things are not always first.
const Usual furniture[] = {{"cabinet", {0.9, 0.45}},   {"armchair", {0.8, 0.8}}, {"sideboard", {1.4, 0.45}},
                           {"bookshelf", {0.8, 0.3}},  {"sofa", {1.9, 0.85}},    {"dresser", {1.1, 0.5}},
                           {"bed", {1.4, 2.0}},        {"desk", {1.2, 0.6}},     {"wardrobe", {1.2, 0.6}},
                           {"coffee table", {0.9, 0.5}}};

/// A room with a door in which things at the walls, and some in the middle, would cover this share of the floor.
Problem crowded_room(double share, Random random) {
  Problem problem;
  problem.name = "crowded";
  problem.room.type = "living room";
  Vec2 size = Vec2::Zero();
  for (int axis = 0; axis < 2; ++axis) size[axis] = random.uniform(3.0, 4.5);
  problem.room.polygon.points = {{0, 0}, {size.x(), 0}, size, {0, size.y()}};
  Opening door;
  door.id = "door-0";
  door.from = 0.2, door.to = 1.1;
  problem.room.openings = {door};
  double covered = 0.0;
  for (int i = 0; covered < share * size.prod(); ++i) {
    const Usual& usual = furniture[random.integer(0, static_cast<int>(std::size(furniture)) - 1)];
    PlacementTask task;
    task.object.category = usual.category;
    task.object.id = task.object.category + "-" + std::to_string(i);
    task.object.size = {usual.size.x(), usual.size.y(), 0.8};
    if (task.object.category != "coffee table") task.object.relations = {{RelationKind::edge, ""}};
    covered += usual.size.prod();
    problem.tasks.push_back(std::move(task));
  }
  return problem;
}

using Search = std::function<std::size_t(const Problem&)>;  // how many things it places

Search solving(const SolveOptions& options) {
  return [options](const Problem& room) {
    const auto solution = solve(room, ModelTable(), KindTable::built_in(), options);
    return solution ? solution->scene.objects.size() : 0;
  };
}

std::string share_placed(const std::vector<Problem>& rooms, const Search& search) {
  double placed = 0.0, wanted = 0.0;
  const auto start = std::chrono::steady_clock::now();
  for (const auto& room : rooms) {
    wanted += static_cast<double>(room.tasks.size());
    placed += static_cast<double>(search(room));
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  char text[80];
  std::snprintf(text, sizeof text, "%.1f %% (%.1f s)", 100.0 * placed / wanted, time.count());
  return text;
}

}  // namespace

int main() {
  SolveOptions one_by_one, repaired, whole;
  one_by_one.layout_search = repaired.layout_search = false;
  one_by_one.rounds = 0;
  const std::pair<const char*, Search> searches[] = {{"one by one", solving(one_by_one)},
                                                     {"with repairs", solving(repaired)},
                                                     {"whole layout, then repairs", solving(whole)}};
  std::string head = "| things would cover |", rule = "|---|";
  for (const auto& [name, search] : searches) head += std::string(" ") + name + " |", rule += "---|";
  std::printf("%s\n%s\n", head.c_str(), rule.c_str());
  for (double share = first_share; share < last_share + 1e-9; share += step) {
    std::vector<Problem> rooms;
    for (int i = 0; i < rooms_for_each; ++i)
      rooms.push_back(crowded_room(share, Random(7).fork(std::to_string(share) + " " + std::to_string(i))));
    std::printf("| %.0f %% |", 100.0 * share);
    for (const auto& [name, search] : searches) {
      std::printf(" %s |", share_placed(rooms, search).c_str());
      std::fflush(stdout);
    }
    std::printf("\n");
  }
}
