#include "server.h"

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "roomgen/base/file.h"
#include "roomgen/base/json.h"

namespace {

const std::string here = ROOMGEN_SOURCE_DIR "/tests/agent/";

void run_python(std::vector<std::string> words, int input, int output) {
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  ::dup2(input, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::execvp(argv[0], argv.data());
  ::_exit(127);
}

// The port, which is the first line that the server prints.
int read_port(int descriptor) {
  std::string line;
  char c = 0;
  while (::read(descriptor, &c, 1) == 1 && c != '\n') line += c;
  return std::atoi(line.c_str());
}

}  // namespace

bool has_python() {
  return std::system("command -v python3 >/dev/null 2>&1") == 0;
}

Server::Server(Security security) : security_(security) {
  std::vector<std::string> words = {"python3", "-S", here + "server.py", folder_ / "log"};
  if (security == Security::self_signed) words.push_back(here + "self_signed.pem");
  int input[2], output[2];
  if (::pipe2(input, O_CLOEXEC) != 0 || ::pipe2(output, O_CLOEXEC) != 0) return;
  pid_ = ::fork();
  if (pid_ == 0) run_python(words, input[0], output[1]);
  ::close(input[0]);
  ::close(output[1]);
  input_ = input[1];
  port_ = read_port(output[0]);
  ::close(output[0]);
}

Server::~Server() {
  ::close(input_);  // it ends with its standard input
  ::waitpid(pid_, nullptr, 0);
}

std::string Server::url(const std::string& scenario) const {
  const char* scheme = security_ == Security::none ? "http" : "https";
  return std::string(scheme) + "://127.0.0.1:" + std::to_string(port_) + "/" + scenario + "/v1";
}

std::vector<roomgen::Json> Server::requests() const {
  std::vector<roomgen::Json> requests;
  const auto log = roomgen::read_file(folder_ / "log");
  if (!log) return requests;
  std::istringstream lines(*log);
  for (std::string line; std::getline(lines, line);) requests.push_back(roomgen::Json::parse(line));
  return requests;
}
