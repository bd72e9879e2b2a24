#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace roomgen::decode {

/// What program and decoder say to each other: a header, the kind and the number of bytes that follow, then
/// these. After `ready` the program tells the names of a library's files, of any number of them, and asks for meshes one by one;
/// the decoder asks for files in between, and ends with a model or the reason why there is none. Pictures that stand alone
/// are asked for with all their bytes.
enum class MessageKind : std::uint32_t {
  ready = 1,  ///< decoder: what holds it (Confinement), names separated by blanks
  files,      ///< program: the names of all files of one library more, a line each
  decode,     ///< program: a Job
  want,       ///< decoder: the name of a file
  content,    ///< program: its bytes
  absent,     ///< program: why it cannot be read
  warning,    ///< decoder: for people
  model,      ///< decoder: model_bytes.h
  failed,     ///< decoder: the kind of the error (4 bytes), then its message
  picture,    ///< program: a PictureJob
  image,      ///< decoder: model_bytes.h
};

struct Header {
  MessageKind kind;
  std::size_t size;
};

inline constexpr std::size_t header_bytes = 8;
inline constexpr std::size_t most_message_bytes = std::size_t{1} << 30;

struct Message {
  MessageKind kind;
  std::string body;
};

std::string header_of(MessageKind kind, std::size_t size);
/// None for an unknown kind, or too many bytes.
std::optional<Header> header_from(std::string_view bytes);

/// What a decoder is asked for.
struct Job {
  std::uint32_t library = 0;  ///< in the order of the `files` messages
  std::string mesh;
  std::uint32_t max_texture_side = 0;
  std::uint64_t max_triangles = 0;
};

std::string bytes_of(const Job& job);
std::optional<Job> job_from(std::string_view bytes);

struct PictureJob {
  std::uint32_t max_side = 0;
  std::string_view bytes;  ///< of a PNG or JPEG file
};

std::string bytes_of(const PictureJob& job);
/// What it names lies within `bytes`.
std::optional<PictureJob> picture_job_from(std::string_view bytes);

}  // namespace roomgen::decode
