// "Facing" is said by use: who sits at a desk that faces the door looks at the door.
#include "catch.h"
#include "roomgen/create/create.h"
#include "roomgen/design/designer.h"
#include "roomgen/generate/generate.h"
#include "scene/room_part.h"

using namespace roomgen;

namespace {

Scene room_of_words(const std::string& prompt, std::uint64_t seed) {
  PlanRequest request;
  request.prompt = prompt;
  request.seed = seed;
  const auto designer = make_rule_designer();
  const auto plan = designer->plan(request);
  REQUIRE(plan);
  BuildOptions options;
  options.seed = seed;
  const auto library = create::make_created_library();
  auto made = generate(*plan, *designer, *library, KindTable::built_in(), options);
  REQUIRE(made);
  return made->scene;
}

// Does a ray from the middle of the thing along this turn of its front meet the part of the room?
bool looks_at(const Scene& scene, const Object& object, double turn, const std::string& part) {
  const auto target = part_of_room(scene.room, part);
  REQUIRE(target);
  return ray_hit(*target, object.position.head<2>(), front_direction(object.yaw + turn)) >= 0.0;
}

}  // namespace

TEST_CASE("Who sits at a desk that faces the door looks at the door, and a sofa that faces it does so itself") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    INFO("seed " << seed);
    const Scene office = room_of_words("An office with a desk facing the door and an office chair.", seed);
    const Object* desk = find_object(office, "desk-0");
    REQUIRE(desk);
    CHECK(looks_at(office, *desk, pi, "door-0"));
    for (const auto& object : office.objects)
      if (object.category == "office chair") {
        CHECK(Footprint(footprint(*desk)).to_local(object.position.head<2>()).y() < 0.0);  // on the sitter's side
        CHECK(front_direction(object.yaw).dot(front_direction(desk->yaw + pi)) > 0.9);
      }
    for (const auto& verdict : office.requirements)
      if (verdict.requirement.relation == RelationKind::used_facing) CHECK(verdict.compliance == Compliance::met);
    const Scene lounge = room_of_words("A living room with a sofa facing the door.", seed);
    const Object* sofa = find_object(lounge, "sofa-0");
    REQUIRE(sofa);
    CHECK(looks_at(lounge, *sofa, 0.0, "door-0"));
  }
}
