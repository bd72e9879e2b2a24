#include "serve.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <vector>

#include "bytes.h"
#include "image_decode.h"
#include "import_mesh.h"
#include "model_bytes.h"
#include "wire.h"

namespace roomgen::decode {

namespace {

bool read_whole(int channel, char* into, std::size_t size) {
  while (size > 0) {
    const auto count = ::read(channel, into, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    into += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool write_whole(int channel, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = ::write(channel, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool send(int channel, MessageKind kind, std::string_view body) {
  return write_whole(channel, header_of(kind, body.size())) && write_whole(channel, body);
}

std::optional<Message> receive(int channel) {
  std::string bytes(header_bytes, '\0');
  if (!read_whole(channel, bytes.data(), bytes.size())) return std::nullopt;
  const auto header = header_from(bytes);
  if (!header) return std::nullopt;
  Message message{header->kind, std::string(header->size, '\0')};
  if (!read_whole(channel, message.body.data(), message.body.size())) return std::nullopt;
  return message;
}

// The library's files as the program gives them out.
FileTree remote_tree(int channel, std::string_view names) {
  FileTree tree;
  while (!names.empty()) {
    const std::size_t end = std::min(names.find('\n'), names.size());
    tree.names.emplace_back(names.substr(0, end));
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  tree.read = [channel](const std::string& name) -> Result<std::string> {
    std::optional<Message> answer;
    if (send(channel, MessageKind::want, name)) answer = receive(channel);
    if (!answer) return Error{Error::Kind::io, name + ": nobody answers"};
    if (answer->kind == MessageKind::content) return std::move(answer->body);
    return Error{Error::Kind::not_found, answer->body};
  };
  return tree;
}

bool send_failure(int channel, const Error& error) {
  std::string failure;
  put(failure, static_cast<std::uint32_t>(error.kind));
  return send(channel, MessageKind::failed, failure + error.message);
}

bool answer(int channel, const PictureJob& job) {
  constexpr std::uint32_t most_side = 1 << 14;
  const auto image = decode_image(job.bytes, static_cast<int>(std::clamp(job.max_side, 1u, most_side)));
  return image ? send(channel, MessageKind::image, bytes_of(*image)) : send_failure(channel, image.error());
}

bool answer(int channel, const FileTree& tree, const Job& job) {
  ImportOptions options;
  options.max_texture_side = static_cast<int>(job.max_texture_side);
  options.max_triangles = job.max_triangles;
  options.log = [channel](LogLevel, std::string_view text) { send(channel, MessageKind::warning, text); };
  const auto model = import_mesh(tree, job.mesh, options);
  return model ? send(channel, MessageKind::model, bytes_of(*model)) : send_failure(channel, model.error());
}

}  // namespace

int serve(int channel, const std::string& held) {
  if (!send(channel, MessageKind::ready, held)) return 0;
  std::vector<FileTree> libraries;
  while (const auto message = receive(channel)) {
    if (message->kind == MessageKind::files) {
      libraries.push_back(remote_tree(channel, message->body));
    } else if (message->kind == MessageKind::picture) {
      const auto job = picture_job_from(message->body);
      if (!job || !answer(channel, *job)) return 1;
    } else {
      const auto job = message->kind == MessageKind::decode ? job_from(message->body) : std::nullopt;
      if (!job || job->library >= libraries.size()) return 1;
      if (!answer(channel, libraries[job->library], *job)) return 1;
    }
  }
  return 0;
}

}  // namespace roomgen::decode
