#include "process.h"

#include <fcntl.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>

#include "roomgen/base/file.h"

Process::Process(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {ROOMGEN_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const std::string out = folder_ / "out", err = folder_ / "err";
  pid_ = ::fork();
  if (pid_ != 0) return;
  ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
  ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

void Process::interrupt() const { ::kill(pid_, SIGINT); }

Ended Process::wait() {
  int status = 0;
  ::waitpid(pid_, &status, 0);
  Ended ended;
  if (WIFEXITED(status)) ended.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
  if (auto text = roomgen::read_file(folder_ / "out")) ended.out = *text;
  if (auto text = roomgen::read_file(folder_ / "err")) ended.err = *text;
  return ended;
}

Ended run(const std::vector<std::string>& arguments) { return Process(arguments).wait(); }

bool failed_in_one_line(const Ended& ended, int code) {
  return ended.code == code && ended.out.empty() && ended.err.rfind("roomgen: ", 0) == 0 &&
         std::count(ended.err.begin(), ended.err.end(), '\n') == 1 && ended.err.back() == '\n';
}
