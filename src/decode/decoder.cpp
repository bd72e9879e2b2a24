#include "decoder.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>

#include "base/child_process.h"
#include "bytes.h"
#include "image_decode.h"
#include "import_limits.h"
#include "model_bytes.h"
#include "roomgen/base/text.h"
#include "wire.h"

namespace roomgen::decode {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto most_time = 30s;            // by the clock, for machines that have much else to do
constexpr auto most_start_time = 10s;      // until a new process says that it is ready
constexpr auto glance = 20ms;              // between two looks at the clock and the cancel token
constexpr auto farewell = 500ms;           // for a process that crashed to be gone
constexpr std::size_t most_wants = 1000;   // files that one mesh may ask for
constexpr std::size_t most_warnings = 100;
constexpr std::size_t piece = 1 << 20;
constexpr std::size_t most_text_bytes = 1000;
// Of memory: what each decoder may take, and one at a time of the whole program (confinement_posix.cpp allows no more).
constexpr std::size_t usual_memory = std::size_t{512} << 20, most_memory = std::size_t{1536} << 20;
constexpr std::string_view crashed = "its reader crashed";

Error cancelled() { return {Error::Kind::cancelled, "reading meshes was stopped"}; }

// What a decoder says is for people, and may be anybody's words.
std::string plain(std::string_view text) { return printable(text.substr(0, most_text_bytes)); }

// A running decoder while it works on one mesh: every wait ends at the job's limits.
class Conversation {
 public:
  Conversation(detail::ChildProcess& process, const DecoderOptions& options, std::chrono::seconds most)
      : process_(process),
        options_(options),
        most_(most),
        began_(Clock::now()),
        used_(process.processor_time()) {}

  Status send(MessageKind kind, std::string_view body) {
    if (auto status = send_bytes(header_of(kind, body.size())); !status) return status;
    return send_bytes(body);
  }

  Result<Message> receive() {
    auto bytes = receive_bytes(header_bytes);
    if (!bytes) return bytes.error();
    const auto header = header_from(*bytes);
    if (!header) return Error{Error::Kind::limit, "its reader answered nonsense"};
    auto body = receive_bytes(header->size);
    if (!body) return body.error();
    return Message{header->kind, *std::move(body)};
  }

 private:
  Status in_time() const {
    if (options_.cancel.cancelled()) return cancelled();
    if (process_.processor_time() - used_ > std::chrono::duration<double>(options_.seconds))
      return Error{Error::Kind::limit, "takes more than " + format_number(options_.seconds) +
                                           " s of processor time to read"};
    if (Clock::now() - began_ > most_)
      return Error{Error::Kind::limit, "takes more than " + std::to_string(most_.count()) + " s to read"};
    return {};
  }

  Error gone() const {
    const std::string how = process_.end(farewell);
    return {Error::Kind::limit, std::string(crashed) + (how.empty() ? how : ": " + how)};
  }

  Status send_bytes(std::string_view bytes) {
    while (!bytes.empty()) {
      const auto count = process_.send(bytes.substr(0, piece), glance);
      if (!count) return gone();
      bytes.remove_prefix(*count);
      if (auto status = in_time(); !status) return status;
    }
    return {};
  }

  // Grows with what comes, whatever was announced.
  Result<std::string> receive_bytes(std::size_t size) {
    std::string bytes;
    while (bytes.size() < size) {
      const std::size_t have = bytes.size();
      bytes.resize(have + std::min(piece, size - have));
      const auto count = process_.receive(bytes.data() + have, bytes.size() - have, glance);
      bytes.resize(have + count.value_or(0));
      if (!count) return gone();
      if (auto status = in_time(); !status) return status.error();
    }
    return bytes;
  }

  detail::ChildProcess& process_;
  const DecoderOptions& options_;
  std::chrono::seconds most_;
  Clock::time_point began_;
  std::chrono::nanoseconds used_;
};

Error failure_from(std::string_view body) {
  ByteReader reader(body);
  const bool limit = reader.take<std::uint32_t>() == static_cast<std::uint32_t>(Error::Kind::limit);
  body.remove_prefix(std::min(body.size(), sizeof(std::uint32_t)));
  return {limit ? Error::Kind::limit : Error::Kind::invalid_input, plain(body)};
}

// Only what the library lists, whatever the decoder wants.
Status hand_out(Conversation& conversation, const FileTree& tree, const std::string& name) {
  if (!tree.contains(name)) return conversation.send(MessageKind::absent, "no such file");
  const auto bytes = tree.read(name);
  return bytes ? conversation.send(MessageKind::content, *bytes)
               : conversation.send(MessageKind::absent, bytes.error().message);
}

// Libraries that were denied memory say so or crash.
bool may_lack_memory(const Error& error) {
  return error.kind == Error::Kind::limit &&
         (error.message.find(too_much_memory) != std::string::npos ||
          error.message.starts_with(crashed));
}

// Who holds it may let a decoder take most_memory.
std::mutex& turn_for_most_memory() {
  static std::mutex turn;
  return turn;
}

}  // namespace

struct Decoder::Impl {
  struct Running {
    detail::ChildProcess process;
    std::string held;
    std::vector<const FileTree*> told;  // whose names it knows
  };

  DecoderOptions options;
  std::optional<Running> running;

  static Result<Running> start(const DecoderOptions& options);
  Status ensure_running();
  void allow_memory(std::size_t bytes) const;
  template <typename Ask>
  auto ask_again_with_more(const Ask& ask) -> decltype(ask());
  Result<std::uint32_t> ensure_told(const FileTree& tree);
  Result<Model> ask(const FileTree& tree, const std::string& mesh, const ImportOptions& import);
  Result<Image> ask(std::string_view picture, int max_side);
  Error failed(const Error& error, const std::string& what);
};

Result<Decoder::Impl::Running> Decoder::Impl::start(const DecoderOptions& options) {
  auto program = options.program.empty() ? find_decoder() : Result<std::filesystem::path>(options.program);
  if (!program) return program.error();
  auto process = detail::ChildProcess::start(*program);
  if (!process) return process.error();
  const auto ready = Conversation(*process, options, most_start_time).receive();
  if (!ready && ready.error().kind == Error::Kind::cancelled) return ready.error();
  if (!ready || ready->kind != MessageKind::ready)
    return Error{Error::Kind::unavailable,
                 program->string() + " does not answer" + (ready ? "" : " (" + ready.error().message + ")")};
  if (options.require_sandbox && ready->body.find("calls") == std::string::npos)
    return Error{Error::Kind::unavailable,
                 "this machine or this build cannot filter the system calls of " + program->string() +
                     ", which --require-sandbox asks for"};
  return Running{*std::move(process), ready->body, {}};
}

Status Decoder::Impl::ensure_running() {
  if (running) return {};
  auto started = start(options);
  if (!started) return started.error();
  running = *std::move(started);
  allow_memory(usual_memory);
  return {};
}

// Under a sanitizer it has no limits.
void Decoder::Impl::allow_memory(std::size_t bytes) const {
  if (running->held.find("limits") != std::string::npos) running->process.allow_memory(bytes);
}

// Several decoders at work together take little more than the largest of their files does, and no file is refused that
// would be read alone. The process ends with it: what it took does not come back otherwise.
template <typename Ask>
auto Decoder::Impl::ask_again_with_more(const Ask& ask) -> decltype(ask()) {
  auto answer = ask();
  if (answer || !may_lack_memory(answer.error())) return answer;
  const std::lock_guard turn(turn_for_most_memory());
  running.reset();
  if (auto status = ensure_running(); !status) return status.error();
  allow_memory(most_memory);
  answer = ask();
  running.reset();
  return answer;
}

Result<std::uint32_t> Decoder::Impl::ensure_told(const FileTree& tree) {
  auto& told = running->told;
  const auto known = std::find(told.begin(), told.end(), &tree);
  const auto number = static_cast<std::uint32_t>(known - told.begin());
  if (known != told.end()) return number;
  Conversation conversation(running->process, options, most_time);
  if (auto status = conversation.send(MessageKind::files, join(tree.names, "\n")); !status)
    return status.error();
  told.push_back(&tree);
  return number;
}

Result<Model> Decoder::Impl::ask(const FileTree& tree, const std::string& mesh,
                                 const ImportOptions& import) {
  if (auto status = ensure_running(); !status) return status.error();
  const auto library = ensure_told(tree);
  if (!library) return library.error();
  Conversation conversation(running->process, options, most_time);
  const Job job{*library, mesh, static_cast<std::uint32_t>(import.max_texture_side), import.max_triangles};
  if (auto status = conversation.send(MessageKind::decode, bytes_of(job)); !status) return status.error();
  std::size_t wants = 0, warnings = 0;
  while (true) {
    auto message = conversation.receive();
    if (!message) return message.error();
    if (message->kind == MessageKind::model) return model_from(message->body, import);
    if (message->kind == MessageKind::failed) return failure_from(message->body);
    if (message->kind == MessageKind::want && ++wants <= most_wants) {
      if (auto status = hand_out(conversation, tree, message->body); !status) return status.error();
    } else if (message->kind == MessageKind::warning && ++warnings <= most_warnings) {
      log(import.log, LogLevel::warning, plain(message->body));
    } else {
      return Error{Error::Kind::limit, "its reader asks for too much"};
    }
  }
}

Result<Image> Decoder::Impl::ask(std::string_view picture, int max_side) {
  if (auto status = ensure_running(); !status) return status.error();
  Conversation conversation(running->process, options, most_time);
  const PictureJob job{static_cast<std::uint32_t>(max_side), picture};
  if (auto status = conversation.send(MessageKind::picture, bytes_of(job)); !status) return status.error();
  const auto message = conversation.receive();
  if (!message) return message.error();
  if (message->kind == MessageKind::image) return image_from(message->body, max_side);
  if (message->kind == MessageKind::failed) return failure_from(message->body);
  return Error{Error::Kind::limit, "its reader answers nonsense"};
}

// Only a decoder that gave its reason itself goes on: of any other, nobody knows what state it is in.
Error Decoder::Impl::failed(const Error& error, const std::string& what) {
  const bool says_why = error.message.starts_with(what + ": ");
  if (!says_why) running.reset();
  const bool of_the_file = error.kind == Error::Kind::limit || error.kind == Error::Kind::invalid_input;
  return says_why || !of_the_file ? error : with_context(error, what);
}

Decoder::Decoder(DecoderOptions options)
    : impl_(std::make_unique<Impl>(Impl{std::move(options), std::nullopt})) {}
Decoder::Decoder(Decoder&&) noexcept = default;
Decoder::~Decoder() = default;

Result<Model> Decoder::decode(const FileTree& tree, const std::string& mesh,
                              const ImportOptions& options) {
  if (impl_->options.in_process) return import_mesh(tree, mesh, options);
  auto model = impl_->ask_again_with_more([&] { return impl_->ask(tree, mesh, options); });
  return model ? std::move(model) : impl_->failed(model.error(), mesh);
}

Result<Image> Decoder::decode_picture(std::string_view bytes, int max_side) {
  if (impl_->options.in_process) return decode_image(bytes, max_side);
  auto image = impl_->ask_again_with_more([&] { return impl_->ask(bytes, max_side); });
  return image ? std::move(image) : impl_->failed(image.error(), "picture");
}

Result<std::vector<std::string>> decoder_confinement(const DecoderOptions& options) {
  const auto running = Decoder::Impl::start(options);
  if (!running) return running.error();
  const auto says = [&](const char* word, const char* held, const char* not_held) {
    return std::string(running->held.find(word) != std::string::npos ? held : not_held);
  };
  return std::vector<std::string>{
      says("limits", "memory, processor time, stack and files written: limited",
           "memory: not limited (a build with a sanitizer)"),
      says("calls", "system calls: reading, writing and memory only (seccomp)",
           "system calls: not filtered (no libseccomp when built, or none in this kernel)"),
      says("files", "files: none can be opened (Landlock)",
           "files: not closed by Landlock (not in this kernel)")};
}

}  // namespace roomgen::decode
