// What the evaluator remembers must never show: after every move it says what a new one says.

#include <cmath>

#include "box_stock.h"
#include "catch.h"
#include "lab/annealing/bounds.h"
#include "lab/annealing/moves.h"

using namespace roomgen;
using namespace roomgen::lab;
using namespace roomgen::lab::annealing;

namespace {

/// A program with its room, ready for moves.
struct Trial {
  ConstraintProgram program;
  Room room;
  Stock stock;
  std::vector<const Kind*> kinds;
  std::vector<Article> articles;
  std::vector<std::vector<int>> articles_of_kind;
  Compiled compiled;
  std::vector<Bound> bounds;

  explicit Trial(const std::string& path) : program(*read_program(path)) {
    const KindTable& table = KindTable::built_in();
    std::vector<std::string> notes;
    room = *room_of(program, 3, notes);
    stock = box_stock(program, table);
    for (const auto& [name, objects] : stock.articles) {
      kinds.push_back(&table.get(name));
      articles_of_kind.emplace_back();
      for (const auto& object : objects) {
        articles_of_kind.back().push_back(static_cast<int>(articles.size()));
        articles.push_back({object, kinds.back(), static_cast<int>(kinds.size()) - 1});
      }
    }
    Compiler compiler(program, kinds, table, ProgramVocabulary::built_in(), Random(1));
    compiler.compile();
    bounds = make_bounds(program, compiler, compiler.compiled(), kinds, table, ProgramVocabulary::built_in());
    compiled = compiler.take();
  }
};

bool agree(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(a)); }

}  // namespace

TEST_CASE("Incremental and full evaluation agree after every move") {
  // ROOMGEN_MOVES=1000000 for the long run.
  const char* wanted = std::getenv("ROOMGEN_MOVES");
  const int steps = wanted ? std::atoi(wanted) : 4000;
  for (const auto& path : example_programs()) {
    INFO(path);
    Trial trial(path);
    World world(trial.room, KindTable::built_in(), trial.articles, trial.stock.models, trial.compiled.language.relations);
    Evaluator remembering(trial.compiled, world);
    Random random(11);
    Moves moves(world, remembering, trial.bounds, trial.articles_of_kind, trial.compiled.language, random);
    int taken = 0, taken_back = 0;
    for (int step = 0; step < steps; ++step) {
      world.mark();
      const auto kind = static_cast<MoveKind>(random.integer(0, static_cast<int>(move_kinds) - 1));
      const auto moved = moves.propose(random.chance(0.3) ? MoveKind::add : kind, 0.5);
      if (moved && world.admits(*moved)) (void)remembering.worth();
      const bool keep = moved && world.admits(*moved) && random.chance(0.6);
      if (!keep) world.undo();
      ++(keep ? taken : taken_back);
      const Worth known = remembering.worth();
      Evaluator fresh(trial.compiled, world);
      const Worth full = fresh.worth();
      if (!agree(known.violation, full.violation) || !agree(known.loss, full.loss)) {
        FAIL("step " << step << ": " << known.violation << ", " << known.loss << " against " << full.violation << ", "
                     << full.loss);
      }
    }
    CHECK(taken > steps / 20);
    CHECK(taken_back > steps / 20);
  }
}

TEST_CASE("A move that is taken back leaves nothing behind") {
  for (const auto& path : example_programs()) {
    INFO(path);
    Trial trial(path);
    World world(trial.room, KindTable::built_in(), trial.articles, trial.stock.models, trial.compiled.language.relations);
    Evaluator evaluator(trial.compiled, world);
    Random random(5);
    Moves moves(world, evaluator, trial.bounds, trial.articles_of_kind, trial.compiled.language, random);
    const auto state = [&] {
      std::vector<double> numbers;
      world.things().each([&](Slot slot) {
        const Item& item = world.item(slot);
        for (const double number : {static_cast<double>(slot), item.object.position.x(), item.object.position.y(),
                                    item.object.position.z(), item.object.yaw, item.object.size.x(),
                                    static_cast<double>(item.article), static_cast<double>(item.stance.count),
                                    item.body.footprint.center().x()})
          numbers.push_back(number);
      });
      return numbers;
    };
    for (int step = 0; step < 3000; ++step) {
      world.mark();
      const auto before = state();
      const auto kind = static_cast<MoveKind>(random.integer(0, static_cast<int>(move_kinds) - 1));
      const auto moved = moves.propose(kind, 0.5);
      if (moved && world.admits(*moved) && random.chance(0.5)) continue;
      world.undo();
      REQUIRE(state() == before);
    }
  }
}

TEST_CASE("What is known of use zones and ways is what a new look finds") {
  for (const auto& path : example_programs()) {
    INFO(path);
    Trial trial(path);
    const auto empty = [&] {
      return World(trial.room, KindTable::built_in(), trial.articles, trial.stock.models,
                   trial.compiled.language.relations);
    };
    World world = empty();
    Evaluator evaluator(trial.compiled, world);
    Random random(7);
    Moves moves(world, evaluator, trial.bounds, trial.articles_of_kind, trial.compiled.language, random);
    int unreachable = 0, useless = 0;
    for (int step = 0; step < 1500; ++step) {
      world.mark();
      const auto kind = static_cast<MoveKind>(random.integer(0, static_cast<int>(move_kinds) - 1));
      const auto moved = moves.propose(random.chance(0.3) ? MoveKind::add : kind, 0.5);
      if (random.chance(0.5)) (void)world.useless();
      if (random.chance(0.2)) (void)world.is_reachable();
      if (!moved || !world.admits(*moved) || random.chance(0.3)) world.undo();
      if (random.chance(0.6)) continue;
      World anew = empty();
      world.things().each([&](Slot slot) { anew.add_at(slot, world.item(slot).article, world.item(slot).stance, -1); });
      REQUIRE(world.useless() == anew.useless());
      REQUIRE(world.is_reachable() == anew.is_reachable());
      unreachable += !world.is_reachable(), useless += world.useless();
    }
    CHECK(unreachable + useless > 0);
  }
}
