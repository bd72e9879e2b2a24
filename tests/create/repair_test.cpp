// Sound programs with one or two components moved, lifted, stretched or shrunk at random.
#include <chrono>
#include <functional>
#include <iostream>
#include <map>

#include "base/random.h"
#include "programs.h"
#include "sampled_contacts.h"

using namespace roomgen;
using create::Soundness;

namespace {

void collect(std::vector<shape::Component>& components, std::vector<shape::Component*>& all) {
  for (auto& component : components) {
    all.push_back(&component);
    if (auto* group = std::get_if<shape::Group>(&component.solid)) collect(group->components, all);
  }
}

std::string damage(shape::Program& program, Random& random) {
  std::vector<shape::Component*> all;
  collect(program.components, all);
  shape::Component& component = *random.pick(all);
  switch (random.integer(0, 3)) {
    case 0: {
      const Vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      component.at += random.uniform(0.01, 0.25) * way.normalized();
      return component.name + " shifted";
    }
    case 1:
      component.at.z() += random.uniform(-0.2, 0.3);
      return component.name + " lifted";
    case 2:
      component.scale[random.integer(0, 2)] *= random.uniform(0.5, 0.95);
      return component.name + " shrunk along an axis";
    default:
      component.scale *= random.uniform(0.5, 1.3);
      return component.name + " scaled";
  }
}

bool never_worse(const Soundness& before, const Soundness& after) {
  return after.pieces <= before.pieces && after.grounded >= before.grounded &&
         after.stable >= before.stable &&
         after.open_connections.size() <= before.open_connections.size();
}

// Bodies of one component differ by their places only.
bool copies_alike(const shape::Program& program) {
  const auto shape = shape::evaluate(program);
  REQUIRE(shape);
  std::map<std::vector<std::size_t>, double> volumes;
  for (const auto& body : shape->bodies) {
    const double volume = shape::volume(body.mesh);
    const auto [known, is_new] = volumes.emplace(body.source, volume);
    if (!is_new && std::abs(known->second - volume) > 1e-3 * std::abs(volume) + 1e-9) return false;
  }
  return true;
}

struct Tally {
  int cases = 0, damaged = 0, repaired = 0, sampled = 0;
  double longest = 0.0;
};

const std::map<std::string, std::function<shape::Program()>>& kinds() {
  static const std::map<std::string, std::function<shape::Program()>> all = {
      {"bar stool", [] { return example("bar-stool"); }},
      {"bar stool, three legs",
       [] {
         return example("bar-stool", {{"legs", 3.0}});
       }},
      {"chair", [] { return example("chair"); }},
      {"chair, turned",
       [] {
         return example("chair", {{"legs", std::string("turned")}});
       }},
      {"lamp", [] { return example("floor-lamp"); }},
      {"sofa", [] { return example("sofa"); }},
      {"shelf",
       [] {
         return example("bookshelf", {{"books", std::string("none")}});
       }},
      {"curved table", [] { return curved_table(); }},
      {"curved table, nothing declared", [] { return curved_table(false); }},
      {"turned table", [] { return turned_table(); }},
      {"dresser", [] { return dresser(); }},
      {"runged stool", [] { return runged_stool(); }}};
  return all;
}

void damage_and_repair(const shape::Program& sound, Random& random, int times, Tally& tally) {
  shape::Program broken = sound;
  std::string what;
  for (int k = 0; k < times; ++k) what += damage(broken, random) + "; ";
  const auto start = std::chrono::steady_clock::now();
  const auto result = create::validate(broken);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  tally.longest = std::max(tally.longest, took.count());
  REQUIRE(result);
  ++tally.cases;
  INFO(what);
  CHECK(never_worse(result->before, result->after));
  if (result->before.sound() && result->before.open_connections.empty()) return;
  ++tally.damaged;
  CHECK(copies_alike(result->program));
  if (!result->after.sound()) {
    std::string left;
    for (const auto& problem : result->after.problems) left += problem + "; ";
    UNSCOPED_INFO(sound.name << ": " << what << " -> " << left);
    return;
  }
  ++tally.repaired;
  const auto shape = shape::evaluate(result->program);
  REQUIRE(shape);
  tally.sampled += pieces_by_sampling(*shape) == 1;
  const auto again = create::inspect(shape::Program(result->program));
  REQUIRE(again);
  CHECK(again->sound());
}

void run(int seeds, int times, double wanted) {
  Tally all;
  for (const auto& [name, make] : kinds()) {
    const shape::Program sound = make();
    Tally tally;
    for (int seed = 0; seed < seeds; ++seed) {
      Random random(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(times));
      damage_and_repair(sound, random, times, tally);
    }
    std::cout << name << ": " << tally.repaired << " of " << tally.damaged << " repaired, "
              << tally.sampled << " whole by sampling, at most " << 1000 * tally.longest << " ms\n";
    all.damaged += tally.damaged;
    all.repaired += tally.repaired;
    all.sampled += tally.sampled;
    CHECK(tally.repaired >= 0.85 * tally.damaged);
  }
  CHECK(all.repaired >= wanted * all.damaged);
  CHECK(all.sampled == all.repaired);
}

}  // namespace

TEST_CASE("One damaged component is repaired") {
  run(8, 1, 0.95);
}

TEST_CASE("Two damaged components are repaired mostly") {
  run(6, 2, 0.85);
}
