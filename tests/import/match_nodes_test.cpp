// Nodes that other programs have renamed, copied or stripped of what they do not know.
#include "catch.h"
#include "roomgen/import/import.h"
#include "support/furnished_room.h"

using namespace roomgen;

namespace {

Scene scene_of(const std::vector<std::string>& ids) {
  Scene scene;
  for (const auto& id : ids) scene.objects.push_back(test::box(id, {1, 1, 1}, {0, 0, 0}));
  return scene;
}

SceneNode node(const std::string& name, const std::string& id = "") {
  return {name, id, Eigen::Matrix4d::Identity()};
}

// The names of the nodes found for the objects, "-" where there is none.
std::vector<std::string> found(const Scene& scene, const std::vector<SceneNode>& nodes) {
  const auto matched = match_nodes(scene, nodes);
  INFO((matched ? "" : matched.error().message));
  REQUIRE(matched);
  REQUIRE(matched->nodes.size() == scene.objects.size());
  std::vector<std::string> names;
  for (const auto* one : matched->nodes) names.push_back(one ? one->name : "-");
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("A node is found by its id, else by its name, else by what three.js makes of that") {
  const Scene scene = scene_of({"office chair-0", "desk-0", "table.1: [x]"});
  CHECK(found(scene, {node("a", "desk-0"), node("b", "table.1: [x]"), node("c", "office chair-0")}) ==
        Names{"c", "a", "b"});
  CHECK(found(scene, {node("desk-0"), node("office chair-0"), node("table.1_ _x_")}) ==
        Names{"office chair-0", "desk-0", "table.1_ _x_"});
  CHECK(found(scene, {node("table1___x_"), node("office_chair-0")}) ==
        Names{"office_chair-0", "-", "table1___x_"});
  // A file of an earlier version, and what three.js made of it.
  CHECK(found(scene, {node("table.1: [x]")}) == Names{"-", "-", "table.1: [x]"});
  CHECK(found(scene, {node("table1_x")}) == Names{"-", "-", "table1_x"});
}

TEST_CASE("An id says more than a name") {
  const Scene scene = scene_of({"chair-0", "chair-1"});
  CHECK(found(scene, {node("chair-1", "chair-0"), node("chair-0", "chair-1")}) ==
        Names{"chair-1", "chair-0"});
  CHECK(found(scene, {node("chair-1", "chair-0")}) == Names{"chair-1", "-"});
  // What is no id of this scene says nothing.
  CHECK(found(scene, {node("chair-1", "sofa-7")}) == Names{"-", "chair-1"});
}

TEST_CASE("Names that three.js writes alike are not confused") {
  const Scene scene = scene_of({"side table-0", "side_table-0"});
  CHECK(found(scene, {node("side_table-0")}) == Names{"side_table-0", "-"});
  CHECK(found(scene, {node("side_table-0_2"), node("side_table-0")}) ==
        Names{"side_table-0", "side_table-0_2"});
}

TEST_CASE("Copies are told from what they are copies of, and what cannot be told is refused") {
  const Scene scene = scene_of({"bar stool-0"});
  const std::vector<SceneNode> copied = {node("bar stool-0.001", "bar stool-0"),
                                         node("bar_stool-0", "bar stool-0")};
  CHECK(found(scene, copied) == Names{"bar_stool-0"});
  const auto matched = match_nodes(scene, copied);
  REQUIRE(matched->copies.size() == 1);
  CHECK(matched->copies[0].name == "bar stool-0.001");
  CHECK(matched->copies[0].of == "bar stool-0");
  const std::vector<SceneNode> unclear = {node("a", "bar stool-0"), node("b", "bar stool-0")};
  CHECK(match_nodes(scene, unclear).error().message.find("two nodes are bar stool-0: a and b") == 0);
  const std::vector<SceneNode> twice = {node("bar stool-0"), node("bar stool-0")};
  CHECK_FALSE(match_nodes(scene, twice));
}
