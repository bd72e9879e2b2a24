#include "endpoint.h"

#include "catch.h"
#include "support/contains.h"

using namespace roomgen;

TEST_CASE("A base URL leads to the resource for chats") {
  const auto url = [](const char* base, ChatProtocol protocol) {
    const auto parsed = parse_base_url(base);
    return parsed ? chat_endpoint(*parsed, protocol).url() : parsed.error().message;
  };
  const auto openai = ChatProtocol::openai, anthropic = ChatProtocol::anthropic;
  CHECK(url("https://api.openai.com/v1", openai) == "https://api.openai.com/v1/chat/completions");
  CHECK(url("HTTP://LocalHost:8080/", openai) == "http://localhost:8080/chat/completions");
  CHECK(url("https://a.b/v1/chat/completions", openai) == "https://a.b/v1/chat/completions");
  CHECK(url("https://a.b/x?api-version=3#top", openai) ==
        "https://a.b/x/chat/completions?api-version=3");
  CHECK(url("https://api.anthropic.com", anthropic) == "https://api.anthropic.com/v1/messages");
  CHECK(url("https://api.anthropic.com/v1/", anthropic) == "https://api.anthropic.com/v1/messages");
  CHECK(url("http://[::1]:80", openai) == "http://[::1]:80/chat/completions");
}

TEST_CASE("A base URL that cannot be one is refused") {
  for (const char* base : {"", "localhost:8080", "ftp://a.b", "https://", "https://:80/v1",
                           "https://a.b:port/", "https://a b/", "https://a.b/\n", "file:///etc"}) {
    INFO(base);
    const auto parsed = parse_base_url(base);
    REQUIRE_FALSE(parsed);
    CHECK(contains_text(parsed.error().message, "expected something like https://"));
  }
  const auto secret = parse_base_url("https://user:password@a.b/");
  REQUIRE_FALSE(secret);
  CHECK_FALSE(contains_text(secret.error().message, "password@"));
}

TEST_CASE("The protocol is told from the host") {
  CHECK(protocol_of(*parse_base_url("https://api.anthropic.com")) == ChatProtocol::anthropic);
  CHECK(protocol_of(*parse_base_url("https://notanthropic.com")) == ChatProtocol::openai);
  CHECK(protocol_of(*parse_base_url("https://anthropic.com.evil.test")) == ChatProtocol::openai);
}

TEST_CASE("This machine has several names") {
  for (const char* base : {"http://localhost", "http://127.0.0.1:8", "http://127.9.9.9",
                           "http://[::1]:80", "http://a.localhost", "http://127.1", "http://0x7f000001"})
    CHECK(parse_base_url(base)->is_loopback());
  for (const char* base : {"http://localhost.evil.test", "http://127.evil.test", "http://10.0.0.1"})
    CHECK_FALSE(parse_base_url(base)->is_loopback());
}

TEST_CASE("Messages show neither query nor fragment") {
  CHECK(parse_base_url("https://a.b/v1?key=s#t")->shown() == "https://a.b/v1");
}
