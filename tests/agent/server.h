#pragma once

#include <nlohmann/json.hpp>
#include <sys/types.h>

#include <string>
#include <vector>

#include "roomgen/base/json.h"
#include "support/temporary_folder.h"

/// Whether the tests can have a server at all.
bool has_python();

/// server.py at work on a free port of this machine, until its owner goes.
class Server {
 public:
  enum class Security { none, self_signed };

  explicit Server(Security security = Security::none);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  int port() const { return port_; }
  /// The base URL of a scenario.
  std::string url(const std::string& scenario) const;
  /// The requests so far, as server.py writes them down.
  std::vector<roomgen::Json> requests() const;
  std::size_t count() const { return requests().size(); }

 private:
  TemporaryFolder folder_;
  Security security_;
  pid_t pid_ = -1;
  int input_ = -1;
  int port_ = 0;
};

/// Skips the rest of a test where there is no Python.
#define REQUIRE_PYTHON()                                  \
  do {                                                    \
    if (!has_python()) {                                  \
      WARN("skipped: no python3 to run the server with"); \
      return;                                             \
    }                                                     \
  } while (false)
