// The key is for the endpoint alone.
#include <filesystem>

#include "asking.h"
#include "catch.h"
#include "roomgen/base/file.h"
#include "roomgen/chat/chat_model.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

// Everything that a user could see, keep or pass on.
class Trail {
 public:
  void add(const std::string& text) { text_ += text + "\n"; }
  void add_files(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (auto bytes = read_file(entry.path())) add(*bytes);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::unique_ptr<ChatModel> recorded_model(const HttpModelOptions& options,
                                          const TemporaryFolder& folder) {
  auto model = make_http_model(options);
  REQUIRE(model);
  auto caching = make_caching_model(*std::move(model), folder / "cache", options.base_url);
  auto recording = make_recording_model(std::move(caching), folder / "recording.jsonl");
  REQUIRE(recording);
  return *std::move(recording);
}

}  // namespace

TEST_CASE("The key appears in no error, reply, log, recording or cache") {
  REQUIRE_PYTHON();
  const Environment environment;
  const Server server;
  const TemporaryFolder folder;
  Trail trail;
  for (const char* scenario : {"ok", "401", "404", "413", "429", "500", "html", "truncated",
                               "not-utf8", "gateway", "cut", "echo", "echo-error"}) {
    auto options = quick_options(server.url(scenario));
    options.log = [&](LogLevel, std::string_view line) { trail.add(std::string(line)); };
    const auto model = recorded_model(options, folder);
    const auto asked = ask(*model, question_with_schema());
    trail.add(asked.error());
    trail.add(asked.text());
  }
  trail.add_files(folder.path());
  CHECK(contains_text(trail.text(), "your key is ***"));
  CHECK(contains_text(trail.text(), "Incorrect API key provided: ***"));
  // Nor a beginning that a quotation was cut at.
  CHECK_FALSE(contains_text(trail.text(), secret.substr(0, 8)));
  CHECK(server.requests()[0]["headers"]["authorization"] == "Bearer " + secret);
}
