#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <future>
#include <memory>
#include <string>

#include "add_commands.h"
#include "libraries.h"
#include "line_source.h"
#include "mcp/server.h"
#include "mcp/tools.h"
#include "tool_commands.h"

namespace roomgen::cli {

namespace {

struct McpCommand {
  std::string root = ".";
  bool no_pictures = false;
  LibraryOptions libraries;
};

/// The program's standard output for the protocol alone: what else is printed goes to standard error.
class ProtocolOutput {
 public:
  ProtocolOutput() : file_(::dup(STDOUT_FILENO)) {
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    std::signal(SIGPIPE, SIG_IGN);  // a client that is gone is noticed at its end of input
  }
  ~ProtocolOutput() { ::close(file_); }

  void write(std::string_view line) const {
    while (!line.empty()) {
      const auto count = ::write(file_, line.data(), line.size());
      if (count < 0 && errno != EINTR) return;
      if (count > 0) line.remove_prefix(static_cast<std::size_t>(count));
    }
  }

 private:
  int file_;
};

// Signals that end the program are for the thread that reads.
std::future<void> started_work(mcp::Server& server) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  auto work = std::async(std::launch::async, [&server] {
    while (server.work()) {
    }
  });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return work;
}

void read_messages(mcp::Server& server, const CancelToken& stopped) {
  LineSource source(STDIN_FILENO, mcp::max_message_bytes);
  for (std::string line;;) {
    switch (source.next(line, stopped)) {
      case LineSource::Event::line:
        server.take(line);
        break;
      case LineSource::Event::too_long:
        server.refuse_long_line();
        break;
      case LineSource::Event::end:
        return;
    }
  }
}

// What was asked before the input ended is still answered, unless a signal comes.
Result<int> serve(mcp::Server& server, const CancelToken& stopped) {
  auto work = started_work(server);
  read_messages(server, stopped);
  server.close();
  do {
    if (stopped.cancelled()) server.stop();
  } while (work.wait_for(std::chrono::milliseconds(50)) == std::future_status::timeout);
  return stopped.cancelled() ? exit_interrupted : exit_ok;
}

Result<int> run(const Context& context, const McpCommand& command) {
  auto root = mcp::RootFolder::open(command.root);
  if (!root) return root.error();
  const ProtocolOutput output;
  mcp::Workplace place{*std::move(root), make_later_library(command.libraries, context), !command.no_pictures};
  place.renew_library();
  mcp::Server server(mcp::offer_of(place, ROOMGEN_VERSION), [&](const std::string& line) { output.write(line); });
  return serve(server, context.cancel);
}

}  // namespace

void add_mcp_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<McpCommand>();
  auto* sub = add_tool_command(app, "mcp");
  sub->add_option("--root", command->root, "The folder that the agent may read and write; nothing outside")
      ->capture_default_str();
  sub->add_flag("--no-pictures", command->no_pictures,
                "Leave out the pictures in the rooms' folders; answers have them still");
  add_library_options(*sub, command->libraries);
  sub->callback([command, &context] { context.run = [command, &context] { return run(context, *command); }; });
}

}  // namespace roomgen::cli
