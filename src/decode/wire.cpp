#include "wire.h"

#include <algorithm>

#include "bytes.h"

namespace roomgen::decode {

namespace {

constexpr std::size_t most_path_bytes = 1 << 16;

}  // namespace

std::string header_of(MessageKind kind, std::size_t size) {
  std::string bytes;
  put(bytes, kind);
  put(bytes, static_cast<std::uint32_t>(size));
  return bytes;
}

std::optional<Header> header_from(std::string_view bytes) {
  ByteReader reader(bytes);
  const auto kind = reader.take<MessageKind>();
  const auto size = reader.take<std::uint32_t>();
  const bool known = kind >= MessageKind::ready && kind <= MessageKind::image;
  if (!reader.whole() || !known || size > most_message_bytes) return std::nullopt;
  return Header{kind, size};
}

std::string bytes_of(const Job& job) {
  std::string bytes;
  put(bytes, job.library);
  put(bytes, job.max_texture_side);
  put(bytes, job.max_triangles);
  put_text(bytes, job.mesh);
  return bytes;
}

std::optional<Job> job_from(std::string_view bytes) {
  ByteReader reader(bytes);
  Job job;
  job.library = reader.take<std::uint32_t>();
  job.max_texture_side = reader.take<std::uint32_t>();
  job.max_triangles = reader.take<std::uint64_t>();
  job.mesh = reader.take_text(most_path_bytes);
  return reader.whole() && reader.at_end() ? std::optional(job) : std::nullopt;
}

std::string bytes_of(const PictureJob& job) {
  std::string bytes;
  put(bytes, job.max_side);
  bytes += job.bytes;
  return bytes;
}

std::optional<PictureJob> picture_job_from(std::string_view bytes) {
  ByteReader reader(bytes);
  PictureJob job;
  job.max_side = reader.take<std::uint32_t>();
  job.bytes = bytes.substr(std::min(bytes.size(), sizeof job.max_side));
  return reader.whole() ? std::optional(job) : std::nullopt;
}

}  // namespace roomgen::decode
