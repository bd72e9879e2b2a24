#include "video.h"

#include <cstdio>
#include <cstdlib>

#include "roomgen/base/file.h"
#include "roomgen/base/text.h"

#ifdef _WIN32
#define popen _popen
#define pclose _pclose
constexpr const char* pipe_mode = "wb";
constexpr const char* nowhere = "NUL";
#else
#include <csignal>
constexpr const char* pipe_mode = "w";
constexpr const char* nowhere = "/dev/null";
#endif

namespace roomgen::lab::detail {

namespace {

namespace fs = std::filesystem;

bool has_ffmpeg() {
  const std::string ask = std::string("ffmpeg -version >") + nowhere + " 2>&1";
  return std::system(ask.c_str()) == 0;
}

// For a shell: nothing in it is special.
std::string quoted(const std::string& text) {
#ifdef _WIN32
  return "\"" + text + "\"";
#else
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
#endif
}

// A pipe that breaks is an error of ours, not the end of the program.
class IgnoredPipeSignal {
 public:
#ifndef _WIN32
  IgnoredPipeSignal() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~IgnoredPipeSignal() { std::signal(SIGPIPE, before_); }

 private:
  void (*before_)(int);
#endif
};

Status feed(std::FILE* pipe, const std::vector<fs::path>& pictures) {
  for (const auto& picture : pictures) {
    const auto bytes = read_file(picture);
    if (!bytes) return bytes.error();
    if (std::fwrite(bytes->data(), 1, bytes->size(), pipe) != bytes->size())
      return Error{Error::Kind::io, "ffmpeg takes no more pictures"};
  }
  return {};
}

Status run_ffmpeg(const fs::path& path, const std::vector<fs::path>& pictures, double per_second) {
  // Sides of H.264 are even.
  const std::string command = "ffmpeg -y -loglevel error -f image2pipe -c:v mjpeg -framerate " +
                              format_number(per_second) +
                              " -i - -vf \"crop=trunc(iw/2)*2:trunc(ih/2)*2\" -c:v libx264 -preset veryfast -pix_fmt yuv420p -f mp4 " +
                              quoted(path.string()) + " 2>" + nowhere;
  const IgnoredPipeSignal ignored;
  std::FILE* pipe = popen(command.c_str(), pipe_mode);
  if (!pipe) return Error{Error::Kind::unavailable, "ffmpeg cannot be started"};
  const Status fed = feed(pipe, pictures);
  const bool ended_well = pclose(pipe) == 0;
  if (!fed) return fed;
  if (!ended_well) return Error{Error::Kind::unavailable, "ffmpeg made no video: it may lack libx264"};
  return {};
}

}  // namespace

Status write_video(const fs::path& path, const std::vector<fs::path>& pictures, double per_second) {
  if (!has_ffmpeg()) return Error{Error::Kind::unavailable, "ffmpeg is not installed"};
  return replace_file(path, [&](const fs::path& aside) { return run_ffmpeg(aside, pictures, per_second); });
}

}  // namespace roomgen::lab::detail
