#include "glb_file.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>

#include "roomgen/base/file.h"

namespace roomgen::detail {

namespace {

static_assert(std::endian::native == std::endian::little, "GLB is little-endian");

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

// glTF 2.0, section 4.4: a header of 12 bytes, the JSON chunk, the binary chunk.
struct GlbChunks {
  std::string_view json, binary;
};

std::optional<GlbChunks> chunks_of(std::string_view bytes) {
  constexpr std::size_t header = 12, chunk_header = 8;
  if (bytes.size() < header + chunk_header || bytes.substr(0, 4) != "glTF") return std::nullopt;
  GlbChunks chunks;
  std::size_t at = header;
  const auto take = [&](std::string_view kind) -> std::string_view {
    if (bytes.size() - at < chunk_header) return {};
    const std::size_t length = word_at(bytes, at);
    if (bytes.substr(at + 4, 4) != kind || length > bytes.size() - at - chunk_header) return {};
    const auto content = bytes.substr(at + chunk_header, length);
    at += chunk_header + length;
    return content;
  };
  chunks.json = take("JSON");
  chunks.binary = take(std::string_view("BIN\0", 4));
  if (chunks.json.empty()) return std::nullopt;
  return chunks;
}

}  // namespace

Result<GlbFile> read_glb_file(const std::filesystem::path& path) {
  auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  const auto chunks = chunks_of(*bytes);
  if (!chunks) return Error{Error::Kind::invalid_input, path.string() + ": is no GLB file"};
  auto json = parse_json(chunks->json, path.string());
  if (!json) return json.error();
  const std::size_t begin = chunks->binary.empty() ? 0 : static_cast<std::size_t>(chunks->binary.data() - bytes->data());
  return GlbFile{*std::move(json), *std::move(bytes), begin, chunks->binary.size()};
}

std::string text_in_extras(const JsonReader& owner, std::string_view key) {
  const JsonReader extras = owner["extras"];
  if (!extras.is_object()) return {};
  const JsonReader text = extras[key];
  return text.is_string() ? text.raw()->get<std::string>() : std::string();
}

}  // namespace roomgen::detail
