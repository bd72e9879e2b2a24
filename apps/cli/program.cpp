#include "program.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "print.h"
#ifdef ROOMGEN_HAS_ASSETS
#include "roomgen/assets/catalogue.h"
#endif

namespace roomgen::cli {

namespace {

CancelToken* interrupted = nullptr;

// The first Ctrl-C asks the work to stop with what is whole; a second one ends the program.
void on_interrupt(int signal) {
  if (interrupted && !interrupted->cancelled()) return interrupted->cancel();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// The number of a stream that the caller has closed would be that of the first file that is opened, and messages would go
// into it.
void open_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) == -1) (void)!::open("/dev/null", O_RDWR);
}

int exit_code_of(const Error& error) {
  switch (error.kind) {
    case Error::Kind::cancelled:
      return exit_interrupted;
    case Error::Kind::not_understood:
      return exit_usage;
    default:
      return exit_failure;
  }
}

// What goes to a full disk or a closed pipe is lost when it is flushed, not when it is printed.
bool all_was_written() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return true;
  std::fputs("roomgen: the output could not be written whole\n", stderr);
  return false;
}

// What no command expects: memory has ended, or there is a fault in the program itself.
Result<int> run_held(const Context& context) {
  try {
    return context.run();
  } catch (const std::bad_alloc&) {
    return Error{Error::Kind::limit, "there is not enough memory for this; what was there before is as it was"};
  } catch (const std::exception& fault) {
    return Error{Error::Kind::io, std::string("stopped at a fault of its own, please report it: ") + fault.what()};
  }
}

// With --verbose, what holds the process that reads meshes.
void print_confinement() {
#ifdef ROOMGEN_HAS_ASSETS
  const auto report = assets::decoder_report({});
  if (!report) {
    std::printf("meshes cannot be read: %s\n", one_line(report.error().message).c_str());
    return;
  }
  std::puts("the process that reads meshes:");
  for (const auto& line : *report) std::printf("  %s\n", printable(line).c_str());
#endif
}

}  // namespace

int run_program(int argc, char** argv, void (*add_commands)(CLI::App& app, Context& context)) {
  open_closed_streams();
  Context context;
  CLI::App app("roomgen furnishes 3D rooms from a sentence.", "roomgen");
  bool version = false, verbose = false;
  app.add_flag("--version", version, "What this is; with --verbose, how it reads what strangers made");
  app.add_flag("--verbose", verbose)->group("");
  app.require_subcommand(0, 1);
  app.fallthrough();
  app.add_flag("--json", context.json, "Print a summary for scripts");
  app.add_flag("--quiet", context.quiet, "No progress");
  add_commands(app, context);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help
      app.exit(error);
      return all_was_written() ? exit_ok : exit_failure;
    }
    std::fprintf(stderr, "roomgen: %s\n", one_line(error.what()).c_str());
    return exit_usage;
  }

  if (version) {
    std::printf("roomgen %s\n", ROOMGEN_VERSION);
    if (verbose) print_confinement();
    return all_was_written() ? exit_ok : exit_failure;
  }
  if (!context.run) {
    std::fputs("roomgen: what shall be done? roomgen generate \"a small kitchen\" furnishes a room, "
               "roomgen --help lists all commands\n", stderr);
    return exit_usage;
  }

  interrupted = &context.cancel;
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  const auto result = run_held(context);
  if (result) return all_was_written() ? *result : exit_failure;
  std::fprintf(stderr, "roomgen: %s\n", one_line(result.error().message).c_str());
  return exit_code_of(result.error());
}

}  // namespace roomgen::cli
