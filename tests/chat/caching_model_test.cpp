#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/chat/chat_model.h"
#include "support/scripted_model.h"
#include "support/temporary_folder.h"

using namespace roomgen;

namespace {

std::unique_ptr<ChatModel> cached(const TemporaryFolder& folder,
                                  std::shared_ptr<ScriptedModel::Script> script,
                                  const std::string& source = "tiny-1 at home") {
  return make_caching_model(std::make_unique<ScriptedModel>(std::move(script)),
                            folder / "deep" / "cache", source);
}

}  // namespace

TEST_CASE("A question is asked once, and kept for the next run") {
  const TemporaryFolder folder;
  const auto script = make_script({reply_saying("first"), reply_saying("second")});
  CHECK(text_of(cached(folder, script)->chat(asking("bed?"))) == "first");
  const auto kept = cached(folder, script)->chat(asking("bed?"));
  REQUIRE(kept);
  CHECK(kept->text == "first");
  CHECK(kept->input_tokens + kept->output_tokens == 0);
  CHECK(kept->attempts == 0);
  CHECK(script->questions.size() == 1);
  CHECK(text_of(cached(folder, script)->chat(asking("sofa?"))) == "second");
  CHECK(names_in(folder / "deep/cache").size() == 2);
}

TEST_CASE("Another model's answers are not used") {
  const TemporaryFolder folder;
  const auto script = make_script({reply_saying("first"), reply_saying("second")});
  CHECK(text_of(cached(folder, script)->chat(asking("bed?"))) == "first");
  CHECK(text_of(cached(folder, script, "huge-9")->chat(asking("bed?"))) == "second");
}

TEST_CASE("Errors are not kept") {
  const TemporaryFolder folder;
  const auto script = make_script({Error{Error::Kind::io, "broken"}, reply_saying("second")});
  const auto model = cached(folder, script);
  CHECK_FALSE(model->chat(asking("bed?")));
  CHECK(text_of(model->chat(asking("bed?"))) == "second");
}

TEST_CASE("A kept answer that was damaged is asked for again") {
  const TemporaryFolder folder;
  const auto script = make_script({reply_saying("first"), reply_saying("second")});
  const auto model = cached(folder, script);
  CHECK(text_of(model->chat(asking("bed?"))) == "first");
  const auto file = folder / "deep/cache" / names_in(folder / "deep/cache").front();
  REQUIRE(write_file(file, "{\"text\": 3}"));
  CHECK(text_of(model->chat(asking("bed?"))) == "second");
  CHECK(text_of(model->chat(asking("bed?"))) == "second");
}

TEST_CASE("A cache that cannot be written is only slower") {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder / "deep", "a file, where a folder should be"));
  const auto script = make_script({reply_saying("first"), reply_saying("second")});
  const auto model = cached(folder, script);
  CHECK(text_of(model->chat(asking("bed?"))) == "first");
  CHECK(text_of(model->chat(asking("bed?"))) == "second");
}
