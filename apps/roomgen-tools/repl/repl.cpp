#include <unistd.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "add_commands.h"
#include "libraries.h"
#include "line_source.h"
#include "print.h"
#include "repl/commands.h"
#include "repl/line_editor.h"
#include "room_options.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "tool_commands.h"

namespace roomgen::cli {

namespace {

constexpr std::size_t longest_line = 100'000;

/// Where lines come from: a person at a terminal, or a file or pipe, which sees no prompt.
class Lines {
 public:
  virtual ~Lines() = default;
  /// Nothing at the end.
  virtual std::optional<Result<std::string>> next() = 0;
};

class PipedLines final : public Lines {
 public:
  PipedLines(const char* prompt, const CancelToken& stopped) : prompt_(prompt), stopped_(stopped) {}
  std::optional<Result<std::string>> next() override {
    std::fputs(prompt_, stdout);
    std::fflush(stdout);
    std::string line;
    const auto event = source_.next(line, stopped_);
    if (event == LineSource::Event::end) return std::nullopt;
    if (event == LineSource::Event::line) return line;
    return Error{Error::Kind::not_understood, "a line of more than " + std::to_string(longest_line) + " bytes"};
  }

 private:
  const char* prompt_;
  CancelToken stopped_;
  LineSource source_{STDIN_FILENO, longest_line};
};

class EditedLines final : public Lines {
 public:
  explicit EditedLines(repl::LineEditor editor) : editor_(std::move(editor)) {}
  std::optional<Result<std::string>> next() override {
    auto line = editor_.next();
    if (!line) return std::nullopt;
    return *std::move(line);
  }

 private:
  repl::LineEditor editor_;
};

repl::Completion completion(repl::Desk& desk, std::string_view written) {
  std::vector<std::string> names;
  for (const auto& command : repl::commands()) names.push_back(command.name);
  const auto session = desk.scene.session();
  return repl::complete(written, names, session ? repl::names_in((*session)->scene()) : names);
}

std::unique_ptr<Lines> lines_for(repl::Desk& desk, const RoomOptions& command, const CancelToken& stopped,
                                 bool is_terminal) {
  if (!is_terminal) return std::make_unique<PipedLines>("", stopped);
  const std::filesystem::path cache = cache_folder(command.libraries);
  auto editor = repl::LineEditor::open([&desk](std::string_view written) { return completion(desk, written); },
                                       cache / "repl_history");
  if (editor) return std::make_unique<EditedLines>(*std::move(editor));
  desk.tell(editor.error().message + "; there is neither completion nor history");
  return std::make_unique<PipedLines>("> ", stopped);
}

int code_of(const Error& error) { return error.kind == Error::Kind::not_understood ? exit_usage : exit_failure; }

/// Prints answers: to a terminal all, to a pipe what went wrong on standard error with the line's number, with
/// --json an object a line.
class Printer {
 public:
  Printer(bool json, bool is_terminal) : json_(json), is_terminal_(is_terminal) {}

  void print(const Result<repl::Answer>& answer, std::size_t number) const {
    if (json_) print_json(answer);
    else if (answer) print_lines(answer->lines);
    else if (is_terminal_) std::printf("%s\n", printable(answer.error().message).c_str());
    else std::fprintf(stderr, "roomgen: line %zu: %s\n", number, printable(answer.error().message).c_str());
    std::fflush(stdout);
  }

 private:
  static void print_json(const Result<repl::Answer>& answer) {
    Json json = {{"ok", answer.ok()}};
    if (answer) json.update(answer->data);
    else json.update({{"error", answer.error().message}, {"understood", code_of(answer.error()) != exit_usage}});
    std::printf("%s\n", json_line(json).c_str());
  }

  bool json_, is_terminal_;
};

// Nothing for an empty line and for a remark.
std::optional<Result<repl::Answer>> answer_to(repl::Desk& desk, const Result<std::string>& written) {
  if (!written) return written.error();
  const std::string line(trim(*written));
  if (line.empty() || line.front() == '#') return std::nullopt;
  return repl::answer(desk, line);
}

// The code of the first line that failed, so that scripts notice; a person has seen it.
int converse(repl::Desk& desk, Lines& lines, const Printer& printer, const CancelToken& stopped, bool is_terminal) {
  int code = exit_ok;
  for (std::size_t number = 1; !stopped.cancelled(); ++number) {
    const auto written = lines.next();
    if (!written) break;
    const auto answer = answer_to(desk, *written);
    if (!answer) continue;
    if (*answer && (*answer)->ends) break;
    printer.print(*answer, number);
    if (!*answer && code == exit_ok && !is_terminal) code = code_of(answer->error());
  }
  return stopped.cancelled() ? exit_interrupted : code;
}

Result<int> run(const Context& context, const RoomOptions& command) {
  const bool is_terminal = ::isatty(STDIN_FILENO) && ::isatty(STDOUT_FILENO);
  const auto library = make_later_library(command.libraries, context);
  const Tell tell = warn;
  auto scene = repl::OpenScene::open(command.scene, *library, {.repair = command.may_repair(), .tell = tell, .cancel = context.cancel});
  if (!scene) return scene.error();
  repl::Desk desk{*std::move(scene), !command.no_pictures, command.pixels, command.by, tell};
  const auto lines = lines_for(desk, command, context.cancel, is_terminal);
  if (is_terminal && !context.quiet) std::puts("Say what to change; help lists the commands, Ctrl-D ends.");
  return converse(desk, *lines, Printer(context.json, is_terminal), context.cancel, is_terminal);
}

}  // namespace

void add_repl_command(CLI::App& app, Context& context) {
  auto command = std::make_shared<RoomOptions>();
  auto* sub = add_tool_command(app, "repl");
  add_scene(*sub, *command);
  add_repair_option(*sub, *command);
  add_file_options(*sub, *command);
  sub->callback([command, &context] { context.run = [command, &context] { return run(context, *command); }; });
}

}  // namespace roomgen::cli
