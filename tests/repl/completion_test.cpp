#include "repl/completion.h"

#include "catch.h"

using roomgen::repl::complete;

namespace {

const std::vector<std::string> commands = {"check", "undo", "help"};
const std::vector<std::string> phrases = {"chair", "chair-0", "chair-1", "desk-0", "floor lamp", "floor lamp-0"};

std::vector<std::string> choices(const std::string& written) { return complete(written, commands, phrases).choices; }
std::string insert(const std::string& written) { return complete(written, commands, phrases).insert; }

}  // namespace

TEST_CASE("A word is completed as far as it is clear, and the only choice gets a blank") {
  CHECK(insert("und") == "o ");
  CHECK(insert("move de") == "sk-0 ");
  CHECK(insert("move ch") == "air");
  CHECK(insert("move chair") == "");
  CHECK(choices("move chair") == std::vector<std::string>{"chair", "chair-0", "chair-1"});
  CHECK(insert("MOVE DE") == "sk-0 ");
  CHECK(insert("zzz") == "");
  CHECK(choices("zzz").empty());
}

TEST_CASE("Commands only begin a line, and names of several words are completed as one") {
  CHECK(choices("ch") == std::vector<std::string>{"chair", "chair-0", "chair-1", "check"});
  CHECK(choices("remove ch").size() == 3);
  CHECK(insert("put the floor l") == "amp");
  CHECK(insert("floor lamp-") == "0 ");
  CHECK(choices("move ").size() == phrases.size());
  CHECK(choices("").size() == phrases.size() + commands.size());
}
