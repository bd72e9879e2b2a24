// Decoders that are not ours: whatever they answer, the program goes on.
#include <sys/stat.h>

#include <chrono>
#include <fstream>

#include "catch.h"
#include "decode/decoder.h"
#include "decode/import_limits.h"
#include "decode/wire.h"
#include "meshes.h"
#include "roomgen/base/file.h"
#include "support/temporary_folder.h"

using namespace roomgen;
using decode::header_of;
using decode::MessageKind;

namespace {

namespace fs = std::filesystem;

std::string message(MessageKind kind, const std::string& body) {
  return header_of(kind, body.size()) + body;
}

// A program that says these bytes to whoever asks, and then waits or ends.
fs::path decoder_that_says(const TemporaryFolder& folder, const std::string& bytes, const std::string& then) {
  std::ofstream(folder / "bytes", std::ios::binary) << bytes;
  std::ofstream(folder / "decoder") << "#!/bin/sh\ncat '" << (folder / "bytes").string() << "' >&0\n" << then << "\n";
  ::chmod((folder / "decoder").c_str(), 0700);
  return folder / "decoder";
}

Result<Model> answer_of(const std::string& bytes, const std::string& then = "cat >/dev/null") {
  const TemporaryFolder folder;
  const auto tree = tree_of({{"cube.obj", cube_obj()}, {"secret.txt", "secret"}});
  decode::Decoder decoder({.program = decoder_that_says(folder, bytes, then)});
  return decoder.decode(tree, "cube.obj", {});
}

const std::string ready = message(MessageKind::ready, "limits calls files");

}  // namespace

TEST_CASE("A decoder that is none, says nothing or ends at once is told as missing") {
  const auto tree = tree_of({{"cube.obj", cube_obj()}});
  for (const char* program : {"/nonexistent/decoder", "/", "/bin/true", "/bin/cat"}) {
    const auto model = decode::Decoder({.program = program}).decode(tree, "cube.obj", {});
    INFO(program);
    REQUIRE_FALSE(model);
    CHECK(model.error().kind == Error::Kind::unavailable);
  }
}

TEST_CASE("Answers that are nonsense are refused") {
  for (const std::string& bytes :
       {ready, ready + "rubbish", ready + std::string(100, '\xff'), ready + message(MessageKind::ready, ""),
        ready + message(MessageKind::model, ""), ready + message(MessageKind::model, std::string(1000, '\xff')),
        ready + header_of(MessageKind::model, decode::most_message_bytes) + "short",
        ready + message(MessageKind::decode, "x")}) {
    const auto model = answer_of(bytes, "exit 0");
    REQUIRE_FALSE(model);
    CHECK(model.error().message.starts_with("cube.obj: "));
  }
}

TEST_CASE("What a decoder says for people cannot steer their terminal") {
  const auto model = answer_of(ready + message(MessageKind::failed, std::string(4, '\0') + "cube.obj: \x1b[31mred\r"));
  REQUIRE_FALSE(model);
  CHECK(model.error().message.find('\x1b') == std::string::npos);
  CHECK(model.error().message.find('\r') == std::string::npos);
}

TEST_CASE("A decoder that asks without end is stopped") {
  std::string bytes = ready;
  for (int i = 0; i < 5000; ++i) bytes += message(MessageKind::want, "cube.obj");
  const auto model = answer_of(bytes);
  REQUIRE_FALSE(model);
  CHECK(model.error().message.find("asks for too much") != std::string::npos);
}

TEST_CASE("A mesh for which its reader lacks memory is read once more with all that one may have") {
  const TemporaryFolder folder;
  const auto file = [&](const char* name) { return " '" + (folder / name).string() + "'"; };
  const std::string said = std::string{static_cast<char>(Error::Kind::limit), '\0', '\0', '\0'} + "cube.obj: " +
                           std::string(decode::too_much_memory);
  std::ofstream(folder / "ready", std::ios::binary) << ready;
  std::ofstream(folder / "failed", std::ios::binary) << message(MessageKind::failed, said);
  // Once it hears something, it writes down what it may take (in KiB).
  std::ofstream(folder / "decoder") << "#!/bin/sh\ncat" << file("ready") << " >&0\nhead -c 1 >/dev/null\nulimit -v >>" << file("limits")
                                    << "\ncat" << file("failed") << " >&0\ncat >/dev/null\n";
  ::chmod((folder / "decoder").c_str(), 0700);
  const auto tree = tree_of({{"cube.obj", cube_obj()}});
  decode::Decoder decoder({.program = folder / "decoder"});
  for (const std::string& limits : {"524288\n1572864\n", "524288\n1572864\n524288\n1572864\n"}) {
    const auto model = decoder.decode(tree, "cube.obj", {});
    REQUIRE_FALSE(model);
    CHECK(model.error().kind == Error::Kind::limit);
    CHECK(*read_file(folder / "limits") == limits);
  }
}

TEST_CASE("A decoder gets files of the library only") {
  const TemporaryFolder folder;
  // It sends back what it was given for a file outside; the answer of the program says that there is none.
  const auto tree = tree_of({{"cube.obj", cube_obj()}});
  const std::string bytes = ready + message(MessageKind::want, "../../etc/passwd") + message(MessageKind::want, "/etc/passwd");
  const auto program = decoder_that_says(folder, bytes, "head -c 4000 >'" + (folder / "heard").string() + "'");
  auto options = decode::DecoderOptions{.program = program};
  options.cancel = options.cancel.within(std::chrono::seconds(2));
  CHECK_FALSE(decode::Decoder(options).decode(tree, "cube.obj", {}));
  std::ifstream stream(folder / "heard", std::ios::binary);
  const std::string heard((std::istreambuf_iterator<char>(stream)), {});
  CHECK(heard.find("root:") == std::string::npos);
}
