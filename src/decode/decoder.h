#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "import_mesh.h"
#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"

namespace roomgen::decode {

struct DecoderOptions {
  std::filesystem::path program{};  ///< empty: find_decoder()
  bool in_process = false;        ///< reads meshes here, for files that are trusted
  bool require_sandbox = false;   ///< fails where system calls cannot be filtered
  double seconds = 5.0;           ///< of processor time for one mesh; the largest of the known ones takes 0.3
  CancelToken cancel{};
};

/// What holds a decoder on this machine, for people, a line each: "system calls: only reading, writing and
/// memory".
Result<std::vector<std::string>> decoder_confinement(const DecoderOptions& options);

/// Reads meshes that anybody may have made, in a process of its own: it gets bytes of the library's files
/// over one channel and nothing else, and what it answers is checked. A mesh that makes it crash, run for
/// too long (DecoderOptions::seconds, or half a minute by the clock), or grow beyond 1.5 GB costs only itself: the
/// next one gets a new process. However many decoders there are, one at a time may grow beyond 0.5 GB. For one thread
/// at a time.
class Decoder {
 public:
  explicit Decoder(DecoderOptions options);
  Decoder(Decoder&&) noexcept;
  ~Decoder();

  /// What import_mesh() says; `tree` must outlive the decoder. Error::Kind::limit when the file was too much for the process (a crash, too
  /// long, too large), unavailable when there can be no process.
  Result<Model> decode(const FileTree& tree, const std::string& mesh, const ImportOptions& options);
  /// What decode_image() says, in the same way, of a picture that belongs to no mesh.
  Result<Image> decode_picture(std::string_view bytes, int max_side);

 private:
  friend Result<std::vector<std::string>> decoder_confinement(const DecoderOptions& options);
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Where roomgen-decode is: what the environment variable ROOMGEN_DECODER names, else beside the running
/// program, in the library folder of its installation, or where this library was installed or built.
Result<std::filesystem::path> find_decoder();

}  // namespace roomgen::decode
