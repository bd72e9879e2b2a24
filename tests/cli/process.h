#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "support/temporary_folder.h"

const std::string test_data = ROOMGEN_TEST_DATA;

/// How a run of the program ended.
struct Ended {
  int code = -1;    ///< exit code; -1 when a signal ended it
  int signal = 0;
  std::string out, err;
};

/// The roomgen program at work.
class Process {
 public:
  explicit Process(const std::vector<std::string>& arguments);
  void interrupt() const;
  Ended wait();

 private:
  TemporaryFolder folder_;
  pid_t pid_ = -1;
};

Ended run(const std::vector<std::string>& arguments);

/// Exit code 1 or 2 and one line on stderr that starts with the program's name; nothing on stdout.
bool failed_in_one_line(const Ended& ended, int code);
