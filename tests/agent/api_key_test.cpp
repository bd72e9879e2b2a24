#include "api_key.h"

#include <sys/stat.h>

#include <cstdlib>

#include "asking.h"
#include "catch.h"
#include "roomgen/base/file.h"
#include "support/contains.h"

using namespace roomgen;

namespace {

const auto remote = *parse_base_url("https://models.example/v1");
const auto local = *parse_base_url("http://localhost:8080/v1");

std::string key_of(const Result<ApiKey>& key) {
  return key ? key->reveal() : "?";
}

std::filesystem::path key_file(const TemporaryFolder& folder, const std::string& bytes,
                               mode_t mode) {
  const auto path = folder / "key";
  REQUIRE(write_file(path, bytes));
  ::chmod(path.c_str(), mode);
  return path;
}

}  // namespace

TEST_CASE("The key is that of the protocol, unless the program's own variable is set") {
  const Environment environment("OPENAI_API_KEY", "sk-openai");
  CHECK(key_of(read_api_key(ChatProtocol::openai, remote, {})) == "sk-openai");
  CHECK_FALSE(read_api_key(ChatProtocol::anthropic, remote, {}));
  ::setenv("ROOMGEN_API_KEY", "sk-own", 1);
  CHECK(key_of(read_api_key(ChatProtocol::openai, remote, {})) == "sk-own");
  CHECK(key_of(read_api_key(ChatProtocol::anthropic, remote, {})) == "sk-own");
  ::setenv("ROOMGEN_API_KEY", "", 1);
  CHECK(key_of(read_api_key(ChatProtocol::openai, remote, {})) == "");
}

TEST_CASE("Without a key only this machine can be asked") {
  const Environment environment("");
  CHECK(key_of(read_api_key(ChatProtocol::openai, local, {})) == "");
  const auto missing = read_api_key(ChatProtocol::anthropic, remote, {});
  REQUIRE_FALSE(missing);
  CHECK(missing.error().kind == Error::Kind::unavailable);
  CHECK(contains_text(missing.error().message, "set ANTHROPIC_API_KEY"));
}

TEST_CASE("A key does not cross the network in clear text") {
  const Environment environment;
  const auto key = read_api_key(ChatProtocol::openai, *parse_base_url("http://gpu-box:8000"), {});
  REQUIRE_FALSE(key);
  CHECK(contains_text(key.error().message, "use https"));
  CHECK(key_of(read_api_key(ChatProtocol::openai, local, {})) == secret);
}

TEST_CASE("A key file is read if nobody else can") {
  const Environment environment("");
  const TemporaryFolder folder;
  CHECK(key_of(read_api_key(ChatProtocol::openai, remote, key_file(folder, "sk-file\n", 0600))) ==
        "sk-file");
  const auto loose =
      read_api_key(ChatProtocol::openai, remote, key_file(folder, "sk-file\n", 0640));
  REQUIRE_FALSE(loose);
  CHECK(contains_text(loose.error().message, "mode 640"));
  CHECK(contains_text(loose.error().message, "chmod 600 "));
  CHECK_FALSE(contains_text(loose.error().message, "sk-file"));
}

TEST_CASE("A key file that holds no key is refused") {
  const Environment environment("");
  const TemporaryFolder folder;
  const auto error_of = [&](const std::filesystem::path& path) {
    const auto key = read_api_key(ChatProtocol::openai, remote, path);
    return key ? "" : key.error().message;
  };
  CHECK(contains_text(error_of(key_file(folder, "\n", 0600)), "is empty"));
  CHECK(contains_text(error_of(key_file(folder, std::string(5000, 'k'), 0600)), "too long"));
  CHECK(contains_text(error_of(folder / "none"), "cannot read the key"));
  CHECK(contains_text(error_of(folder.path()), "no regular file"));
}

TEST_CASE("A key that would break the header is refused without being shown") {
  const Environment environment("OPENAI_API_KEY", "sk-first\r\nX-Evil: 1");
  const auto key = read_api_key(ChatProtocol::openai, remote, {});
  REQUIRE_FALSE(key);
  CHECK(contains_text(key.error().message, "OPENAI_API_KEY: a key has no blanks"));
  CHECK_FALSE(contains_text(key.error().message, "sk-first"));
}

TEST_CASE("Scrubbing removes every occurrence of a key, and no short words") {
  CHECK(ApiKey("sk-12345678").scrub("a sk-12345678sk-12345678 b") == "a ****** b");
  CHECK(ApiKey("bed").scrub("a bed") == "a bed");
  CHECK(ApiKey().scrub("a bed") == "a bed");
}
