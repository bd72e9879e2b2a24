#pragma once

#include <memory>
#include <string>
#include <vector>

#include "catch.h"
#include "roomgen/create/maker.h"
#include "support/contains.h"
#include "support/scripted_model.h"

/// What the tests of makers that ask a model share.
namespace conversation {

using namespace roomgen;
using namespace roomgen::create;

/// Answers everything with a box, and says so.
class BoxMaker final : public Maker {
 public:
  Result<Verdict> classify(const std::string&) override { return Verdict{true, "by rules"}; }
  Result<std::vector<Description>> decompose(const std::string& prompt) override {
    Description box;
    box.prompt = prompt;
    box.noun = "box";
    return std::vector{box};
  }
  Result<shape::Program> generate(const MakeRequest&) override {
    shape::Program program;
    program.name = "box";
    shape::Component component;
    component.name = "body";
    component.solid = shape::Box{{0.5, 0.4, 0.3}, 0.0};
    program.components = {component};
    return program;
  }
  std::vector<std::string> take_notes() override { return {"a box was made"}; }
};

struct Conversation {
  explicit Conversation(std::vector<Result<ChatReply>> answers, ModelMakerOptions options = {})
      : script(make_script(std::move(answers))),
        model(script),
        maker(make_model_maker(model, std::make_unique<BoxMaker>(), Prompts::built_in(),
                               std::move(options))) {}

  Result<shape::Program> generate(const Description& description = stool()) {
    MakeRequest request;
    request.description = description;
    return maker->generate(request);
  }
  const std::string& question(std::size_t turn) const {
    return script->questions.at(turn).messages.back().text;
  }
  static Description stool() {
    Description wanted;
    wanted.prompt = "a stool on four legs";
    wanted.noun = "stool";
    return wanted;
  }

  std::shared_ptr<ScriptedModel::Script> script;
  ScriptedModel model;
  std::unique_ptr<Maker> maker;
};

inline bool mentions(const std::vector<std::string>& notes, std::string_view part) {
  for (const auto& note : notes)
    if (contains_text(note, part)) return true;
  return false;
}

inline PartWish part(const std::string& label, std::optional<int> count = std::nullopt) {
  PartWish wish;
  wish.label = label;
  wish.count = count;
  return wish;
}

/// A sound stool of 40 x 40 x 45 cm.
inline const std::string good_stool = R"({"format": "roomgen-shape", "version": 1, "name": "stool",
  "let": [["h", 0.42]],
  "materials": {"wood": {"color": "oak", "pattern": "grain"}},
  "components": [
    {"name": "leg", "label": "leg", "box": {"size": [0.04, 0.04, "h"]}, "at": [0.17, -0.17, 0],
     "operations": [{"mirror": "x"}, {"mirror": "y"}], "material": "wood"},
    {"name": "seat", "label": "seat", "box": {"size": [0.4, 0.4, 0.032], "bevel": 0.005},
     "at": [0, 0, "h - 0.002"], "material": "wood"}],
  "connections": [["leg", "floor"], ["leg", "seat"]]})";

}  // namespace conversation
