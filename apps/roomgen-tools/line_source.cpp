#include "line_source.h"

#include <sys/select.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace roomgen::cli {

namespace {

// The signals that end the program are let in only while nothing else is done, so that none is missed between a
// look at the flag and the wait.
class SignalsHeldBack {
 public:
  SignalsHeldBack() {
    sigset_t ending;
    sigemptyset(&ending);
    sigaddset(&ending, SIGINT);
    sigaddset(&ending, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  ~SignalsHeldBack() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  /// False when a signal came first.
  bool wait_for(int file) const {
    fd_set files;
    FD_ZERO(&files);
    FD_SET(file, &files);
    return ::pselect(file + 1, &files, nullptr, nullptr, nullptr, &before_) > 0;
  }

 private:
  sigset_t before_;
};

}  // namespace

bool LineSource::read_more(const CancelToken& stopped) {
  const SignalsHeldBack held_back;
  char bytes[65536];
  while (!stopped.cancelled()) {
    const auto count = held_back.wait_for(file_) ? ::read(file_, bytes, sizeof bytes) : -1;
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    buffer_.append(bytes, static_cast<std::size_t>(count));
    return true;
  }
  return false;
}

LineSource::Event LineSource::next(std::string& line, const CancelToken& stopped) {
  while (true) {
    const auto newline = buffer_.find('\n', searched_);
    if (newline != std::string::npos) {
      const bool was_skipped = skipping_ || newline > max_bytes_;
      line = was_skipped ? std::string() : buffer_.substr(0, newline);
      buffer_.erase(0, newline + 1);
      searched_ = 0;
      skipping_ = false;
      return was_skipped ? Event::too_long : Event::line;
    }
    searched_ = buffer_.size();
    if (buffer_.size() > max_bytes_) {
      skipping_ = true;
      buffer_.clear();
      searched_ = 0;
    }
    if (read_more(stopped)) continue;
    // A last line without its newline.
    if (stopped.cancelled() || (buffer_.empty() && !skipping_)) return Event::end;
    line = std::move(buffer_);
    buffer_.clear();
    searched_ = 0;
    const bool was_skipped = skipping_;
    skipping_ = false;
    return was_skipped ? Event::too_long : Event::line;
  }
}

}  // namespace roomgen::cli
