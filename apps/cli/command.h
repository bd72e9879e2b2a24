#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>

#include "roomgen/base/cancel.h"
#include "roomgen/base/result.h"

namespace roomgen::cli {

enum ExitCode { exit_ok = 0, exit_failure = 1, exit_usage = 2, exit_interrupted = 130 };

/// What every command shares. A command parses into its own options, then leaves in `run` what main
/// shall do; an error it returns becomes one line on stderr and exit code 1 (130 if cancelled).
struct Context {
  bool json = false;   ///< print a summary for scripts on stdout
  bool quiet = false;  ///< no progress
  CancelToken cancel;  ///< set by Ctrl-C
  std::function<Result<int>()> run;
};

/// Why a run that was stopped wrote nothing: a room that is not whole takes the place of none that is.
inline Error older_stays(const std::filesystem::path& path) {
  return {Error::Kind::cancelled, "interrupted; the older room in " + path.string() + " stays"};
}

}  // namespace roomgen::cli
