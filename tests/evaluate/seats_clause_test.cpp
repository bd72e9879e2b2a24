// Seats for so many people, against sums of their own on random scenes.
#include "base/random.h"
#include "catch.h"
#include "evaluate/clauses.h"
#include "roomgen/kinds/kind_table.h"
#include "scene/attribute_names.h"
#include "support/rooms.h"

using namespace roomgen;

TEST_CASE("So many can sit as chairs, and lengths of 0.6 m of wider seats, are there") {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    Scene scene = rooms::scene(rooms::box(12, 8), {rooms::thing("bed-0", "bed", {1.6, 2.0, 0.5}, {2, 2}),
                                                   rooms::thing("table-0", "table", {1.6, 0.9, 0.75}, {5, 5})});
    int seats = 0;
    for (int i = random.integer(0, 6); i > 0; --i, ++seats)
      scene.objects.push_back(rooms::thing("chair-" + std::to_string(i), "dining chair", {0.45, 0.5, 0.9}, {1.0 + i, 6}));
    for (int i = random.integer(0, 2); i > 0; --i) {
      const int for_so_many = random.integer(1, 4);
      scene.objects.push_back(rooms::thing("sofa-" + std::to_string(i), "sofa", {0.6 * for_so_many + 0.1, 0.9, 0.8}, {4.0 * i, 3}));
      seats += for_so_many;
    }
    Requirement asked;
    asked.kind = Requirement::Kind::room;
    asked.attribute = seats_for_people;
    asked.at_least = true;
    asked.amount = random.integer(1, 12);
    INFO(seats << " seats for " << asked.amount);
    CHECK((judge_seats(asked, scene, KindTable::built_in()).compliance == Compliance::met) == (seats >= asked.amount));
  }
}
