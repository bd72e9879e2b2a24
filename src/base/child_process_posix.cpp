#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <thread>
#include <vector>

#include "child_process.h"

namespace roomgen::detail {

namespace {

// What a program needs to find its libraries, and what sanitizers of such a build are told.
std::vector<std::string> environment_of_child() {
  std::vector<std::string> result = {"LC_ALL=C"};
  for (const char* name : {"LD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS"})
    if (const char* value = std::getenv(name)) result.push_back(std::string(name) + "=" + value);
  return result;
}

// The files that a child begins with: the channel as its input, nothing to write to.
class FileActions {
 public:
  explicit FileActions(int channel) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_adddup2(&actions_, channel, STDIN_FILENO);
    ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }
  ~FileActions() { ::posix_spawn_file_actions_destroy(&actions_); }
  const ::posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  ::posix_spawn_file_actions_t actions_;
};

// True once something can be done; false when the time is over.
bool wait_for(int channel, short event, std::chrono::milliseconds patience) {
  ::pollfd wanted{channel, event, 0};
  return ::poll(&wanted, 1, static_cast<int>(patience.count())) > 0;
}

// 0 for "not now", none for "never again".
std::optional<std::size_t> amount(::ssize_t moved) {
  if (moved > 0) return static_cast<std::size_t>(moved);
  const bool later = moved < 0 && (errno == EAGAIN || errno == EINTR);
  return later ? std::optional<std::size_t>(0) : std::nullopt;
}

// A process that crashes loses its channel a moment before it can be waited for.
bool ended_within(::pid_t id, std::chrono::milliseconds patience, int& status) {
  constexpr std::chrono::milliseconds step(5);
  for (auto waited = std::chrono::milliseconds(0);; waited += step) {
    if (::waitpid(id, &status, WNOHANG) == id) return true;
    if (waited >= patience) return false;
    std::this_thread::sleep_for(step);
  }
}

}  // namespace

Result<ChildProcess> ChildProcess::start(const std::filesystem::path& program) {
  const auto failure = [&](int code) {
    return Error{Error::Kind::unavailable, program.string() + " cannot be run: " + std::strerror(code)};
  };
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return failure(errno);
  Descriptor ours(ends[0]);
  const Descriptor theirs(ends[1]);
  const FileActions actions(theirs.number());
  auto variables = environment_of_child();
  std::vector<char*> environment;
  for (auto& variable : variables) environment.push_back(variable.data());
  environment.push_back(nullptr);
  std::string name = program.string();
  std::array<char*, 2> arguments = {name.data(), nullptr};
  ::pid_t id = 0;
  const int code =
      ::posix_spawn(&id, name.c_str(), actions.get(), nullptr, arguments.data(), environment.data());
  if (code != 0) return failure(code);
  return ChildProcess(id, std::move(ours));
}

ChildProcess::~ChildProcess() { (void)end(); }

std::optional<std::size_t> ChildProcess::send(std::string_view bytes,
                                              std::chrono::milliseconds patience) const {
  if (!wait_for(channel_.number(), POLLOUT, patience)) return 0;
  return amount(::send(channel_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT));
}

std::optional<std::size_t> ChildProcess::receive(char* into, std::size_t size,
                                                 std::chrono::milliseconds patience) const {
  if (!wait_for(channel_.number(), POLLIN, patience)) return 0;
  return amount(::recv(channel_.number(), into, size, MSG_DONTWAIT));
}

std::chrono::nanoseconds ChildProcess::processor_time() const {
  ::clockid_t clock;
  ::timespec used{};
  if (id_ == 0 || ::clock_getcpuclockid(static_cast<::pid_t>(id_), &clock) != 0 ||
      ::clock_gettime(clock, &used) != 0)
    return {};
  return std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec);
}

void ChildProcess::allow_memory(std::size_t bytes) const {
  ::rlimit bound{};
  const auto id = static_cast<::pid_t>(id_);
  if (id == 0 || ::prlimit(id, RLIMIT_AS, nullptr, &bound) != 0) return;
  bound.rlim_cur = std::min<::rlim_t>(bytes, bound.rlim_max);
  (void)::prlimit(id, RLIMIT_AS, &bound, nullptr);
}

std::string ChildProcess::end(std::chrono::milliseconds patience) {
  const auto id = static_cast<::pid_t>(std::exchange(id_, 0));
  if (id == 0) return {};
  (void)channel_.close();
  int status = 0;
  if (!ended_within(id, patience, status)) {
    ::kill(id, SIGKILL);
    while (::waitpid(id, &status, 0) < 0 && errno == EINTR) {
    }
    return {};
  }
  if (WIFSIGNALED(status))
    return "signal " + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) + ")";
  return "exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace roomgen::detail
