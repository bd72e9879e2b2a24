#include "line_editor.h"

#ifdef ROOMGEN_LIBEDIT
#include <dlfcn.h>
#include <histedit.h>
#endif

#include <clocale>
#include <cstdio>

#include "roomgen/base/file.h"
#include "roomgen/base/text.h"

namespace roomgen::repl {

#ifdef ROOMGEN_LIBEDIT

namespace {

#define ROOMGEN_LIBEDIT_FUNCTIONS(each)                                                                  \
  each(el_init) each(el_end) each(el_set) each(el_get) each(el_gets) each(el_line) each(el_insertstr)    \
  each(el_source) each(history_init) each(history_end) each(history)

struct Libedit {
#define ROOMGEN_DECLARE(name) decltype(&::name) name = nullptr;
  ROOMGEN_LIBEDIT_FUNCTIONS(ROOMGEN_DECLARE)
#undef ROOMGEN_DECLARE
};

Error cannot_load() {
  const char* reason = dlerror();
  return {Error::Kind::unavailable, std::string("libedit cannot be used: ") + (reason ? reason : "no reason given")};
}

// Stays loaded until the program ends.
Result<Libedit> load_libedit() {
  void* handle = dlopen(ROOMGEN_LIBEDIT, RTLD_NOW | RTLD_LOCAL);
  if (!handle) return cannot_load();
  Libedit edit;
#define ROOMGEN_FIND(name)                                                   \
  edit.name = reinterpret_cast<decltype(&::name)>(dlsym(handle, #name));     \
  if (!edit.name) return cannot_load();
  ROOMGEN_LIBEDIT_FUNCTIONS(ROOMGEN_FIND)
#undef ROOMGEN_FIND
  return edit;
}

constexpr int kept_lines = 1000;

char prompt[] = "> ";
char* prompt_of(EditLine*) { return prompt; }

}  // namespace

struct LineEditor::Impl {
  Impl(const Libedit& functions, Complete the_complete, std::filesystem::path file)
      : edit(functions), complete(std::move(the_complete)), history_file(std::move(file)) {}
  ~Impl() {
    HistEvent event;
    if (history) {
      if (make_folder(history_file.parent_path())) edit.history(history, &event, H_SAVE, history_file.c_str());
      edit.history_end(history);
    }
    if (line) edit.el_end(line);
  }

  bool begin() {
    std::setlocale(LC_CTYPE, "");  // what a character is; numbers stay as they are
    line = edit.el_init("roomgen", stdin, stdout, stderr);
    history = edit.history_init();
    if (!line || !history) return false;
    HistEvent event;
    edit.history(history, &event, H_SETSIZE, kept_lines);
    edit.history(history, &event, H_SETUNIQUE, 1);
    edit.history(history, &event, H_LOAD, history_file.c_str());
    edit.el_set(line, EL_CLIENTDATA, this);
    edit.el_set(line, EL_PROMPT, prompt_of);
    edit.el_set(line, EL_EDITOR, "emacs");
    edit.el_set(line, EL_HIST, edit.history, history);
    edit.el_set(line, EL_ADDFN, "roomgen-complete", "Complete", complete_line);
    edit.el_set(line, EL_BIND, "^I", "roomgen-complete", nullptr);
    // At the prompt Ctrl-C drops the line.
    edit.el_set(line, EL_SETTY, "-d", "-isig", nullptr);
    edit.el_set(line, EL_BIND, "^C", "em-kill-line", nullptr);
    edit.el_source(line, nullptr);
    return true;
  }

  static unsigned char complete_line(EditLine* line, int) {
    static const Result<Libedit> functions = load_libedit();
    Impl* self = nullptr;
    functions->el_get(line, EL_CLIENTDATA, &self);
    return self->complete_here();
  }

  unsigned char complete_here() {
    const LineInfo* info = edit.el_line(line);
    const auto found = complete(std::string_view(info->buffer, static_cast<std::size_t>(info->cursor - info->buffer)));
    if (found.choices.empty()) return CC_REFRESH_BEEP;
    if (!found.insert.empty())
      return edit.el_insertstr(line, found.insert.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
    std::printf("\n%s\n", printable(join(found.choices, "  ")).c_str());
    return CC_REDISPLAY;
  }

  Libedit edit;
  Complete complete;
  std::filesystem::path history_file;
  EditLine* line = nullptr;
  History* history = nullptr;
};

Result<LineEditor> LineEditor::open(Complete complete, const std::filesystem::path& history_file) {
  const auto functions = load_libedit();
  if (!functions) return functions.error();
  auto impl = std::make_unique<Impl>(*functions, std::move(complete), history_file);
  if (!impl->begin()) return Error{Error::Kind::unavailable, "libedit does not work on this terminal"};
  return LineEditor(std::move(impl));
}

std::optional<std::string> LineEditor::next() {
  int count = 0;
  const char* text = impl_->edit.el_gets(impl_->line, &count);
  if (!text || count <= 0) return std::nullopt;
  std::string written(trim(std::string_view(text, static_cast<std::size_t>(count))));
  HistEvent event;
  if (!written.empty()) impl_->edit.history(impl_->history, &event, H_ENTER, written.c_str());
  return written;
}

#else

struct LineEditor::Impl {};

Result<LineEditor> LineEditor::open(Complete, const std::filesystem::path&) {
  return Error{Error::Kind::unavailable, "this roomgen was built without libedit"};
}

std::optional<std::string> LineEditor::next() { return std::nullopt; }

#endif

LineEditor::LineEditor(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LineEditor::LineEditor(LineEditor&&) noexcept = default;
LineEditor::~LineEditor() = default;

}  // namespace roomgen::repl
