#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "completion.h"
#include "roomgen/base/result.h"

namespace roomgen::repl {

/// Lines that a person writes at a prompt, with editing, completion by Tab and a history that is kept
/// from one time to the next (libedit, loaded when a prompt is first shown).
class LineEditor {
 public:
  using Complete = std::function<Completion(std::string_view written)>;

  /// unavailable where there is no libedit.
  static Result<LineEditor> open(Complete complete, const std::filesystem::path& history_file);
  LineEditor(LineEditor&&) noexcept;
  ~LineEditor();

  /// Nothing at the end of the input (Ctrl-D).
  std::optional<std::string> next();

 private:
  struct Impl;
  explicit LineEditor(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace roomgen::repl
