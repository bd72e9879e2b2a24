#include "conversation.h"
#include "roomgen/shape/primitives.h"

using namespace conversation;

namespace {

// Two boards on each other; the second one inside out.
const std::string two_boards = R"({"vertices": [
   [-0.2, -0.15, 0], [0.2, -0.15, 0], [0.2, 0.15, 0], [-0.2, 0.15, 0],
   [-0.2, -0.15, 0.2], [0.2, -0.15, 0.2], [0.2, 0.15, 0.2], [-0.2, 0.15, 0.2],
   [-0.2, -0.15, 0.198], [0.2, -0.15, 0.198], [0.2, 0.15, 0.198], [-0.2, 0.15, 0.198],
   [-0.2, -0.15, 0.4], [0.2, -0.15, 0.4], [0.2, 0.15, 0.4], [-0.2, 0.15, 0.4]],
  "triangles": [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4],
    [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6], [3, 0, 4], [3, 4, 7],
    [8, 9, 10, 11], [12, 15, 14, 13], [8, 12, 13, 9], [9, 13, 14, 10], [10, 14, 15, 11],
    [11, 15, 12, 8]],
  "parts": [{"label": "base", "first": 0, "count": 12, "color": "oak"},
            {"label": "seat", "first": 12, "count": 6, "color": "#101010"}]})";

struct Direct {
  explicit Direct(std::vector<std::string> answers) : talk(replies(answers), options()) {}

  static std::vector<Result<ChatReply>> replies(const std::vector<std::string>& answers) {
    std::vector<Result<ChatReply>> result;
    for (const auto& answer : answers) result.push_back(reply_saying(answer));
    return result;
  }
  static ModelMakerOptions options() {
    ModelMakerOptions result;
    result.variant = Variant::direct;
    return result;
  }
  Result<shape::Shape> mesh() {
    MakeRequest request;
    request.description = Conversation::stool();
    return talk.maker->generate_mesh(request);
  }
  Conversation talk;
};

// What the model is told of an answer that cannot be used.
std::string objection(const std::string& answer) {
  Direct direct({answer, two_boards});
  REQUIRE(direct.mesh());
  REQUIRE(direct.talk.script->questions.size() == 2);
  return direct.talk.question(1);
}

}  // namespace

TEST_CASE("Triangles become a shape of one body a part") {
  Direct direct({two_boards});
  const auto shape = direct.mesh();
  REQUIRE(shape);
  REQUIRE(shape->bodies.size() == 2);
  CHECK(shape->bodies[0].label == "base");
  CHECK(shape->bodies[1].label == "seat");
  CHECK(shape->materials.size() == 2);
  for (const auto& body : shape->bodies) {
    CHECK(body.mesh.triangles.size() == 12);
    CHECK(shape::is_closed(body.mesh));
    CHECK(shape::volume(body.mesh) > 0.0);
    CHECK(body.mesh.normals.size() == body.mesh.positions.size());
  }
  CHECK((shape::bounds(*shape).size() - Vec3(0.4, 0.3, 0.4)).norm() < 1e-5);
  CHECK(direct.talk.script->questions[0].schema["properties"].contains("triangles"));
}

TEST_CASE("Triangles that no part has are a part of their own, gaps are said") {
  Direct direct({R"({"vertices": [[0, 0, 0], [0.5, 0, 0], [0, 0.5, 0.5]], "faces": [[0, 1, 2]]})"});
  const auto shape = direct.mesh();
  REQUIRE(shape);
  REQUIRE(shape->bodies.size() == 1);
  CHECK(shape->bodies[0].label == "stool");
  CHECK(mentions(direct.talk.maker->take_notes(), "gaps"));
}

TEST_CASE("What is wrong with triangles is told with its place") {
  const std::string corners = R"({"vertices": [[0, 0, 0], [0.5, 0, 0], [0, 0.5, 0.5]], )";
  CHECK(contains_text(objection(corners + R"("triangles": [[0, 1, 3]]})"),
                      "/triangles/0/2: there is no vertex 3; there are 3"));
  CHECK(contains_text(objection(corners + R"("triangles": [[0, 1, -1]]})"), "/triangles/0/2"));
  CHECK(contains_text(objection(corners + R"("triangles": [[0, 1]]})"), "/triangles/0"));
  CHECK(contains_text(objection(corners + R"("triangles": [[0, 1, 1]]})"), "area"));
  CHECK(contains_text(objection(corners + R"("triangles": [[0, 1, 2]],
      "parts": [{"label": "a", "first": 0, "count": 9}]})"),
                      "/parts/0/count"));
  CHECK(contains_text(objection(corners + R"("triangles": [[0, 1, 2]],
      "parts": [{"label": "a", "first": 0, "count": 1}, {"label": "b", "first": 0, "count": 1}]})"),
                      "share"));
  CHECK(contains_text(objection(R"({"vertices": [[0, 0, NaN]], "triangles": [[0, 0, 0]]})"),
                      "/vertices/0"));
  CHECK(
      contains_text(objection(R"({"vertices": [[0, 0, 1e300]], "triangles": []})"), "/vertices/0"));
  CHECK(contains_text(
      objection(R"({"vertices": [[0, 0, 0], [15, 0, 0], [0, 5, 0]], "triangles": [[0, 1, 2]]})"),
      "15 m large"));
}

TEST_CASE("More triangles than a thing may have are refused") {
  std::string many = R"({"vertices": [[0, 0, 0], [0.5, 0, 0], [0, 0.5, 0.5]], "triangles": [)";
  for (int k = 0; k < 20'001; ++k) many += k ? ",[0,1,2]" : "[0,1,2]";
  CHECK(contains_text(objection(many + "]}"), "more than 20000"));
}

TEST_CASE("Triangles are no program, and cannot change one") {
  Direct direct({});
  MakeRequest request;
  CHECK(direct.talk.maker->generate(request).error().kind == Error::Kind::invalid_input);
  const shape::Program earlier;
  request.earlier = &earlier;
  CHECK(direct.talk.maker->generate_mesh(request).error().kind == Error::Kind::invalid_input);
  CHECK(direct.talk.script->questions.empty());
}

TEST_CASE("Where no triangles come the fallback's program is meshed") {
  Direct direct({"no", "no", "no"});
  const auto shape = direct.mesh();
  REQUIRE(shape);
  CHECK(shape->bodies.front().label == "body");
}
