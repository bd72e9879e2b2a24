#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/sha256.h"
#include "catch.h"
#include "chat/chat_question.h"
#include "roomgen/base/file.h"
#include "roomgen/base/json.h"
#include "roomgen/chat/chat_model.h"
#include "support/contains.h"
#include "support/file_size_limit.h"
#include "support/scripted_model.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

using Answers = std::vector<Result<ChatReply>>;

// Asks a recorded model all questions, each of which gets the next answer.
void record(const std::filesystem::path& file, const std::vector<ChatRequest>& questions,
            Answers answers) {
  auto recording =
      make_recording_model(std::make_unique<ScriptedModel>(make_script(std::move(answers))), file);
  REQUIRE(recording);
  for (const auto& question : questions) (void)(*recording)->chat(question);
}

std::unique_ptr<ChatModel> replay(const std::filesystem::path& file) {
  auto model = make_replaying_model(file);
  REQUIRE(model);
  return *std::move(model);
}

std::string error_of(const Result<ChatReply>& reply) {
  return reply ? "" : reply.error().message;
}

// Why a replay of one question has no answer to another.
std::string miss(const ChatRequest& recorded, const ChatRequest& asked) {
  const TemporaryFolder folder;
  record(folder / "r", {recorded}, {reply_saying("here")});
  const auto reply = replay(folder / "r")->chat(asked);
  if (!reply) CHECK(reply.error().kind == Error::Kind::unavailable);
  return error_of(reply);
}

}  // namespace

TEST_CASE("A replay gives back what was recorded") {
  const TemporaryFolder folder;
  ChatReply reply = reply_saying("by the \"window\"\nor so, Küche");
  reply.attempts = 3;
  record(folder / "r", {asking("bed?")}, {reply});
  const auto again = replay(folder / "r")->chat(asking("bed?"));
  REQUIRE(again);
  CHECK(again->text == reply.text);
  CHECK(again->model == reply.model);
  CHECK(again->input_tokens == reply.input_tokens);
  CHECK(again->output_tokens == reply.output_tokens);
  CHECK(again->seconds == reply.seconds);
  CHECK(again->attempts == reply.attempts);
}

TEST_CASE("The same question again gets the next answer, and then the last one") {
  const TemporaryFolder folder;
  record(folder / "r", {asking("bed?"), asking("sofa?"), asking("bed?")},
         {reply_saying("first"), reply_saying("other"), reply_saying("second")});
  const auto model = replay(folder / "r");
  CHECK(text_of(model->chat(asking("bed?"))) == "first");
  CHECK(text_of(model->chat(asking("bed?"))) == "second");
  CHECK(text_of(model->chat(asking("bed?"))) == "second");
  CHECK(text_of(model->chat(asking("sofa?"))) == "other");
}

TEST_CASE("Errors are replayed too, cancelled calls are not recorded") {
  const TemporaryFolder folder;
  record(folder / "r", {asking("bed?"), asking("bed?")},
         {Error{Error::Kind::cancelled, "stopped"}, Error{Error::Kind::limit, "too long"}});
  const auto reply = replay(folder / "r")->chat(asking("bed?"));
  REQUIRE_FALSE(reply);
  CHECK(reply.error().kind == Error::Kind::limit);
  CHECK(reply.error().message == "too long");
}

TEST_CASE("A recording grows by whole lines, and keeps images as hashes only") {
  const TemporaryFolder folder;
  auto request = asking("bed?");
  request.messages.back().images = {"PNG bytes"};
  record(folder / "r", {request}, {reply_saying("a")});
  record(folder / "r", {request}, {reply_saying("b")});
  const auto text = *read_file(folder / "r");
  CHECK(std::count(text.begin(), text.end(), '\n') == 2);
  CHECK(text.back() == '\n');
  CHECK(contains_text(text, sha256_hex("PNG bytes")));
  CHECK_FALSE(contains_text(text, "PNG bytes"));
}

TEST_CASE("A recording that cannot be written fails the call, not the answer in silence") {
  const TemporaryFolder folder;
  CHECK_FALSE(make_recording_model(nullptr, folder / "no" / "such" / "folder"));
  auto model = make_recording_model(
      std::make_unique<ScriptedModel>(make_script({reply_saying("a")})), folder / "recording");
  REQUIRE(model);
  const FileSizeLimit limit(0);
  CHECK(contains_text(error_of((*model)->chat(asking("bed?"))), "recording: cannot write"));
}

TEST_CASE("A miss shows the first message that differs, on both sides") {
  const std::string message = miss(asking("Objects so far: bed at 1.25, 2.00. Where next?"),
                                   asking("Objects so far: bed at 1.35, 2.00. Where next?"));
  CHECK(contains_text(message, "in line 1, differs in message 2 (user)"));
  CHECK(contains_text(message, "bed at 1.25"));
  CHECK(contains_text(message, "bed at 1.35"));
  CHECK(is_one_line(message));
}

TEST_CASE("A miss names what differs beside the texts") {
  auto other = asking("bed?");
  other.temperature = 0.5;
  CHECK(contains_text(miss(asking("bed?"), other), "temperature: recorded \"0.0\", asked \"0.5\""));
  other = asking("bed?");
  other.messages.back().images = {"x"};
  CHECK(contains_text(miss(asking("bed?"), other), "message 2 (user): other images"));
  other = asking("bed?");
  other.schema = {{"type", "object"}};
  CHECK(contains_text(miss(asking("bed?"), other), "schema: recorded \"null\""));
  other = asking("bed?");
  other.messages.push_back({ChatMessage::Role::assistant, "There.", {}});
  CHECK(contains_text(miss(asking("bed?"), other),
                      "message 3 (assistant): was not recorded: \"There.\""));
  CHECK(contains_text(miss(other, asking("bed?")), "message 3 (assistant): was recorded"));
}

TEST_CASE("A miss compares with the nearest of the recorded questions") {
  const TemporaryFolder folder;
  record(folder / "r", {asking("Place the sofa"), asking("Place the bed at 1"), asking("x")},
         {reply_saying("1"), reply_saying("2"), reply_saying("3")});
  const auto reply = replay(folder / "r")->chat(asking("Place the bed at 2"));
  CHECK(contains_text(error_of(reply), "in line 2, "));
}

TEST_CASE("An empty recording has no nearest question") {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "r", ""));
  CHECK(contains_text(error_of(replay(folder / "r")->chat(asking("bed?"))), "no recorded answer"));
}

TEST_CASE("A recording that is none is refused with the line") {
  const TemporaryFolder folder;
  CHECK_FALSE(make_replaying_model(folder / "none"));
  record(folder / "good", {asking("bed?")}, {reply_saying("a")});
  const auto good = *read_file(folder / "good");
  for (const std::string bad :
       {"{", "[]", "{\"key\": 3}", "{\"key\": \"a\", \"request\": {}}",
        "{\"key\": \"a\", \"request\": {}, \"error\": {\"kind\": \"odd\", \"message\": \"\"}}"}) {
    INFO(bad);
    REQUIRE(write_file(folder / "r", good + bad + "\n"));
    const auto model = make_replaying_model(folder / "r");
    REQUIRE_FALSE(model);
    CHECK(contains_text(model.error().message, "line 2"));
  }
}

TEST_CASE("Everything but the cancel token makes another question") {
  const auto key = [](const ChatRequest& request) { return question_key(question_json(request)); };
  const auto base = asking("bed?");
  CHECK(key(base) == key(asking("bed?")));
  std::vector<ChatRequest> others(6, base);
  others[0].messages[1].text += " ";
  others[1].messages[1].images = {"x"};
  others[2].messages[0].role = ChatMessage::Role::user;
  others[3].schema = Json::object();
  others[4].max_tokens = 99;
  others[5].temperature = 0.1;
  for (const auto& other : others) CHECK(key(other) != key(base));
}

TEST_CASE("A recording keeps each picture once, under the name that its lines have for it") {
  const TemporaryFolder folder;
  ChatRequest question = asking("where?");
  question.messages.back().images = {"\x89PNG one", "\xff\xd8 two", "\x89PNG one"};
  record(folder / "r", {question, question}, {reply_saying("here"), reply_saying("there")});
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "r.pictures")) {
    ++count;
    const auto bytes = read_file(entry.path());
    REQUIRE(bytes);
    CHECK(entry.path().stem() == sha256_hex(*bytes));
    CHECK(read_file(folder / "r")->find(entry.path().stem().string()) != std::string::npos);
  }
  CHECK(count == 2);
  record(folder / "plain", {asking("where?")}, {reply_saying("here")});
  CHECK_FALSE(std::filesystem::exists(folder / "plain.pictures"));
}
