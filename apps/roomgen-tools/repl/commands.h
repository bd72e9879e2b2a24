#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "open_scene.h"

namespace roomgen::repl {

/// What a line is answered.
struct Answer {
  std::vector<std::string> lines;
  Json data = Json::object();
  bool ends = false;  ///< no line is wanted after this one
};

/// What lines work on.
struct Desk {
  OpenScene scene;
  bool draws = true;  ///< the room's pictures follow each change
  int pixels = 1024;
  std::string by = "person";
  cli::Tell tell;
  cli::PictureDrawer drawer = {};
};

using Words = std::vector<std::string>;

/// A word that is no sentence. `run` answers nothing when what follows the word does not belong to it: then the
/// line is read as a sentence ("undo that").
struct Command {
  std::string name, arguments, about;
  std::function<std::optional<Result<Answer>>(Desk&, const Words& arguments)> run;
};
const std::vector<Command>& commands();

/// A command, operations as JSON, or a sentence that asks for a change.
Result<Answer> answer(Desk& desk, const std::string& line);

/// What sentences may name: ids and kinds of things in the room, its doors and windows.
std::vector<std::string> names_in(const Scene& scene);

}  // namespace roomgen::repl
