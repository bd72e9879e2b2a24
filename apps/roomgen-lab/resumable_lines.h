#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "roomgen/base/file.h"
#include "roomgen/base/json.h"

namespace roomgen::cli {

/// The results of an experiment's folder, results.jsonl: a line that says what the experiment is, then one for each
/// result. Each line is written when its result is there, so that an interrupted experiment goes on from there.
class ResumableLines {
 public:
  struct Line {
    std::string where;  ///< "out/results.jsonl: line 3"
    Json json;
  };

  /// Reads what is there of the same experiment; a last line that is half written is dropped. Anything else in the
  /// folder is refused, unless `force` says to start anew.
  static Result<ResumableLines> open(const std::filesystem::path& folder, const Json& head, bool force);

  const std::vector<Line>& earlier() const { return earlier_; }
  Status add(const Json& result);

 private:
  Status read(const Json& head);

  std::filesystem::path path_;
  std::optional<AppendedFile> file_;
  std::vector<Line> earlier_;
};

}  // namespace roomgen::cli
